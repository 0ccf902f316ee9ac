"""Who may not stay in the areas before the goals, and for how long."""

import pytest

from soccer_env.types import AWAY, HOME, Foul, Phase
from tests.scenes.referee import Referee

each_team = pytest.mark.parametrize("team", [HOME, AWAY])
GOAL_AREA, PENALTY_AREA = Foul.GOAL_AREA, Foul.PENALTY_AREA


@each_team
@pytest.mark.parametrize(("index", "x", "y", "foul"), [
    (1, -5.51, 0.0, GOAL_AREA),  # a field player in its own goal area, 0.5 x 3 m
    (1, -5.49, 0.0, 0), (1, -5.6, 1.49, GOAL_AREA), (1, -5.6, 1.51, 0),
    (0, -5.8, 0.0, 0),  # its goalkeeper
    (1, 5.51, 0.0, GOAL_AREA),  # an attacker
    (1, 5.49, 0.0, 0),
    (0, 5.6, 0.0, GOAL_AREA),  # a goalkeeper that attacks
])  # fmt: skip
def test_only_the_goalkeeper_stays_in_a_goal_area(index, x, y, foul, team):
    referee = Referee(team=team)
    referee.put(index, x, y)
    assert not any(referee.wait(9.98)) and referee.look() == foul
    if foul:
        assert referee.record["phase"] == Phase.FREE_KICK and referee.record["restart_team"] == 1 - team
        assert abs(referee.record["restart_x"]) == 5.5


@pytest.mark.parametrize("x", [-5.4, -3.0])  # before it, and far from all areas
def test_who_leaves_the_goal_area_begins_anew(x):
    referee = Referee()
    for _ in range(2):
        referee.put(1, -5.6, 0.0)
        assert not any(referee.wait(9.0))
        referee.put(1, x, 0.0)
        assert referee.look() == 0


@each_team
@pytest.mark.parametrize(("second", "foul"), [((-4.51, 2.49), PENALTY_AREA), ((-4.49, 2.0), 0), ((-4.6, 2.51), 0)])
def test_one_field_player_is_in_its_own_penalty_area_beside_the_goalkeeper(second, foul, team):
    referee = Referee(team=team)
    referee.put(0, -5.8, 0.0)
    referee.put(1, -5.0, 0.0)
    referee.put(2, *second)
    assert not any(referee.wait(9.98)) and referee.look() == foul


@pytest.mark.parametrize(("ball", "guilty"), [(-1.0, 2), (2.0, 1)])
def test_the_one_nearest_to_the_ball_may_stay_and_the_other_is_guilty(ball, guilty):
    referee = Referee()
    referee.put(1, -5.0, 0.0)
    referee.put(2, -5.0, 1.0)
    referee.ball["x"], referee.ball["y"] = -4.0, ball
    referee.wait(10.0)
    assert referee.deeds["foul"].tolist() == [PENALTY_AREA if row == guilty else 0 for row in range(6)]


@pytest.mark.parametrize(("index", "x"), [(0, -4.6), (4, 5.0)])
def test_a_goalkeeper_and_an_opponent_in_its_own_area_crowd_nobody_though_nearer_to_the_ball(index, x):
    referee = Referee()
    referee.put(1, -5.0, 0.0)
    referee.put(index, x, 0.0)
    referee.ball["x"], referee.ball["y"] = x, 1.0
    assert not any(referee.wait(11.0))


def test_opponents_may_stay_in_a_penalty_area():
    referee = Referee()
    referee.put(1, 5.0, 0.0)
    referee.put(2, 5.0, 1.0)
    assert not any(referee.wait(11.0))


@pytest.mark.parametrize("rule", ["goal_area", "penalty_area"])
def test_each_can_be_switched_off(rule):
    referee = Referee(**{rule: False})
    referee.put(1, -5.6, 0.0)
    referee.put(2, -5.0, 1.0)
    referee.ball["x"] = -6.0
    fouls = set(referee.wait(10.5)) - {0}
    assert fouls == ({PENALTY_AREA} if rule == "goal_area" else {GOAL_AREA})


def test_clocks_stand_still_at_restarts():
    referee = Referee()
    referee.put(1, 5.6, 0.0)
    referee.restart(Phase.THROW_IN, 0.0, 4.0)
    assert not any(referee.wait(11.0))
