"""Where a free kick is taken, how far opponents keep off it, and when it is over."""

import numpy as np
import pytest

from soccer_env.match.staging import put_ball
from soccer_env.referee.fouls.middle_size.book import spot
from soccer_env.types import AWAY, HOME, Foul, Phase
from tests.scenes.referee import Referee
from tests.scenes.staging import stand

each_team = pytest.mark.parametrize("team", [HOME, AWAY])


@pytest.mark.parametrize(
    ("foul", "place"),
    [
        ((1.0, 2.0), (1.0, 2.0)),
        ((5.49, 0.0), (5.49, 0.0)),  # the goal area is 0.5 x 3 m
        ((5.51, 0.7), (5.5, 0.7)),
        ((-5.8, -1.49), (-5.5, -1.49)),
        ((-5.7, -1.51), (-5.7, -1.51)),
        ((6.3, 2.0), (5.8, 2.0)),
        ((1.0, -4.4), (1.0, -3.8)),
    ],
)
def test_it_is_taken_where_the_foul_was_on_the_pitch_and_out_of_the_goal_areas(foul, place):
    assert spot(Referee().k, *foul) == pytest.approx(place)


@each_team
def test_opponents_are_a_metre_away_and_the_taker_behind_the_ball_once_it_is_given(team):
    referee = Referee(team=team)
    referee.record["taker"], referee.record["taker_clock"] = referee.rows[4], 1.0
    referee.put(4, 1.0, 0.5)
    put_ball(referee.match, 1.0 + 0.18 + 0.11, 0.5)  # at the kicker of the others' robot
    referee.match.rebuild()
    referee.match.step(stand(referee.match))
    assert referee.events["restart"] == Phase.FREE_KICK and referee.events["restart_team"] == team
    far = np.hypot(referee.robots["x"] - referee.ball["x"], referee.robots["y"] - referee.ball["y"])
    others = referee.robots["team"] != team
    assert (far[others] >= 1.0).all() and far[~others].min() < 0.5
    np.testing.assert_allclose((referee.ball["x"], referee.ball["y"]), (1.0, 0.5), atol=0.01)


@pytest.mark.parametrize(("away", "foul"), [(0.79, Foul.DISTANCE), (0.81, 0)])
@each_team
def test_an_opponent_that_stays_too_near_for_a_second_is_put_back(away, foul, team):
    referee = Referee(team=team)
    referee.restart(Phase.FREE_KICK, 0.0, 0.0)
    robot = referee.put(4, away, 0.0)
    fouls = referee.wait(0.98) + [referee.look()]
    assert fouls == [0] * 49 + [foul]
    assert referee.record["phase"] == Phase.FREE_KICK and referee.events["restart"] == 0
    assert (np.hypot(robot["x"], robot["y"]) >= 1.0) == (foul != 0) == robot["fouls"]  # it is cautioned


def test_who_steps_away_has_a_second_again():
    referee = Referee()
    referee.restart(Phase.FREE_KICK, 0.0, 0.0)
    for _ in range(2):
        referee.put(4, 0.7, 0.0)
        assert not any(referee.wait(0.9))
        referee.put(4, 0.9, 0.0)
        assert referee.look() == 0


def test_an_opponent_that_touches_the_ball_too_early_has_it_taken_again():
    referee = Referee()
    referee.restart(Phase.FREE_KICK, 1.0, 1.0)
    assert referee.look(touches=(4,)) == Foul.DISTANCE
    assert referee.events["restart"] == Phase.FREE_KICK and referee.record["restart_team"] == HOME
    assert referee.robots["fouls"].tolist() == [0, 0, 0, 0, 1, 0]
    assert (referee.record["restart_x"], referee.record["restart_y"]) == (1.0, 1.0)


def test_the_goalkeeper_may_stay_in_its_goal_area_and_mates_where_they_like():
    referee = Referee()
    referee.restart(Phase.FREE_KICK, 5.5, 0.0)
    referee.put(3, 5.8, 0.0)
    referee.put(2, 5.5, 0.5)
    assert not any(referee.wait(3.0)) and referee.look(touches=(2,)) == 0
    referee.put(3, 5.4, 0.5)
    assert any(referee.wait(1.1))


def test_distances_can_be_switched_off():
    referee = Referee(distances=False)
    referee.restart(Phase.FREE_KICK, 0.0, 0.0)
    referee.put(4, 0.5, 0.0)
    assert not any(referee.wait(3.0)) and referee.look(touches=(4,)) == 0


def test_after_ten_seconds_everybody_may_play_the_ball():
    referee = Referee()
    referee.restart(Phase.FREE_KICK, 0.0, 0.0)
    referee.record["phase_clock"] = 0.0
    referee.match.rebuild()
    in_play = []
    for _ in range(501):
        referee.match.step(stand(referee.match))
        in_play.append(int(referee.events["in_play"]))
    assert in_play.index(1) == 499
