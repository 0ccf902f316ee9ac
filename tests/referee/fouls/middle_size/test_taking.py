"""Who takes a restart does not touch the ball again, no goal falls straight from an indirect one; free kicks."""

import numpy as np
import pytest

from soccer_env.match.staging import put_ball
from soccer_env.referee.fouls.middle_size.book import free_kick_spot
from soccer_env.types import AWAY, HOME, Foul, Phase
from tests.scenes.referee import Referee
from tests.scenes.staging import record_each_step, stand

RESTARTS = (Phase.KICK_OFF, Phase.THROW_IN, Phase.GOAL_KICK, Phase.CORNER_KICK, Phase.FREE_KICK)
each_team = pytest.mark.parametrize("team", [HOME, AWAY])
LEFT = 0.2  # [s] out of contact: the taker has left the ball


def taken(phase=Phase.CORNER_KICK, **changes):
    """Return a restart that robot 1 has taken with one touch, the ball in play."""
    referee = Referee(**changes)
    referee.restart(phase, 3.0, 2.0)
    referee.look(touches=(1,))
    referee.record["phase"] = Phase.PLAY
    return referee


@each_team
@pytest.mark.parametrize("phase", RESTARTS)
def test_a_second_touch_by_the_taker_is_a_free_kick_for_the_others_where_it_stands(phase, team):
    referee = taken(phase, team=team)
    referee.put(1, 2.0, 1.0)
    referee.wait(LEFT)
    assert referee.look(touches=(1,)) == Foul.SECOND_TOUCH
    assert referee.events["foul_team"] == team and referee.deeds["foul"][referee.rows[1]] == Foul.SECOND_TOUCH
    assert referee.record["phase"] == Phase.FREE_KICK and referee.record["restart_team"] == 1 - team
    assert (referee.record["restart_x"], referee.record["restart_y"]) == (2.0, 1.0)


def test_a_second_touch_in_a_shoot_out_ends_the_kick_and_a_foul_lets_everybodys_clocks_begin_anew():
    referee = taken(Phase.PENALTY_KICK)
    referee.record["shoot_out"], referee.record["phase_clock"] = 1, 2.0
    referee.wait(LEFT)
    assert referee.look(touches=(1,)) == Foul.SECOND_TOUCH
    assert referee.events["restart"] == 0 and referee.record["phase_clock"] == 10.0
    referee = taken()
    referee.wait(LEFT)
    clocks = ("charging", "handling", "backed", "dribbled", "area_clock", "crowd_clock", "near_clock")
    for name in clocks:
        referee.robots[name] = 0.4
    assert referee.look(touches=(1,)) == Foul.SECOND_TOUCH
    assert [name for name in clocks if referee.robots[name].any()] == []


@pytest.mark.parametrize("toucher", [2, 4])
def test_once_a_mate_or_an_opponent_has_touched_it_the_taker_may_again(toucher):
    referee = taken()
    referee.wait(LEFT)
    assert referee.look(touches=(toucher,)) == 0
    referee.wait(LEFT)
    assert referee.look(touches=(1,)) == 0


def test_a_kick_is_a_touch_though_the_ball_is_gone_at_once_and_the_rule_can_be_switched_off():
    referee, off = taken(), taken(second_touch=False)
    referee.wait(LEFT)
    assert referee.look(kicks=(1,)) == Foul.SECOND_TOUCH
    off.wait(1.0)
    assert off.look(touches=(1,)) == 0


@pytest.mark.parametrize(("steps", "foul"), [(9, 0), (10, Foul.SECOND_TOUCH)])
def test_contact_that_breaks_off_for_a_moment_is_the_same_touch(steps, foul):
    referee = taken()
    for _ in range(steps):  # of 20 ms
        referee.look()
    assert referee.look(touches=(1,)) == foul


@pytest.mark.parametrize(("away", "foul"), [(0.49, 0), (0.51, Foul.SECOND_TOUCH)])
def test_in_one_touch_the_ball_may_be_pushed_half_a_metre(away, foul):
    referee = taken()
    put_ball(referee.match, 3.0 - away, 2.0)
    assert referee.look(touches=(1,)) == foul


def test_touches_before_the_ball_is_in_play_do_not_count_and_a_dropped_ball_has_no_taker():
    referee = Referee()
    referee.restart(Phase.THROW_IN, 0.0, 4.0)
    assert referee.look(touches=(1,)) == 0
    referee.wait(1.0)
    assert referee.look(touches=(1,)) == 0 and referee.record["taker"] == referee.rows[1]
    referee = Referee()
    referee.restart(Phase.THROW_IN, 0.0, 4.0)
    referee.record["phase"] = Phase.PLAY
    referee.look(touches=(1,))
    assert referee.record["taker"] == -1 and referee.record["indirect"] == 0
    referee.record["phase"], referee.record["restart_team"] = Phase.DROP_BALL, -1
    referee.look(touches=(1,))
    assert referee.record["taker"] == -1


def ball_in_goal(referee, end):
    """Lay the ball into the goal at an end of the pitch and let a whole step pass."""
    put_ball(referee.match, end * (6.0 + 0.12), 0.0)
    referee.match.rebuild()
    referee.match.step(stand(referee.match))
    return referee.events


@each_team
@pytest.mark.parametrize("phase", RESTARTS)
def test_no_goal_falls_straight_from_a_restart(phase, team):
    referee = taken(phase, team=team)
    events = ball_in_goal(referee, 1.0)
    assert events["goal"] == -1 and events["annulled"] == 1
    assert events["restart"] == Phase.GOAL_KICK and events["restart_team"] == 1 - team
    assert referee.record["score"].tolist() == [0, 0]


@each_team
def test_an_own_goal_straight_from_a_restart_is_a_corner_kick(team):
    referee = taken(Phase.GOAL_KICK, team=team)
    events = ball_in_goal(referee, -1.0)
    assert events["annulled"] == 1 and events["goal"] == -1
    assert events["restart"] == Phase.CORNER_KICK and events["restart_team"] == 1 - team
    assert np.sign(referee.record["restart_x"]) == -1.0


@pytest.mark.parametrize("toucher", [2, 3])
def test_it_counts_once_anybody_else_has_touched_the_ball(toucher):
    referee = taken()
    referee.look(touches=(toucher,))
    assert ball_in_goal(referee, 1.0)["goal"] == HOME


@pytest.mark.parametrize("phase", RESTARTS)
def test_a_switch_for_each_restart_lets_its_goals_count_and_in_the_simple_rules_all_do(phase):
    for changes in ({f"direct_{phase.name.lower()}": True}, {"rules": "simple"}):
        assert ball_in_goal(taken(phase, **changes), 1.0)["goal"] == HOME


@pytest.mark.parametrize(("foul", "place"), [
    ((1.0, 2.0), (1.0, 2.0)),
    ((5.49, 0.0), (5.49, 0.0)),  # the goal area is 0.5 x 3 m
    ((5.51, 0.7), (5.5, 0.7)), ((-5.8, -1.49), (-5.5, -1.49)), ((-5.7, -1.51), (-5.7, -1.51)),
    ((6.3, 2.0), (5.8, 2.0)), ((1.0, -4.4), (1.0, -3.8)),
])  # fmt: skip
def test_it_is_taken_where_the_foul_was_on_the_pitch_and_out_of_the_goal_areas(foul, place):
    assert free_kick_spot(Referee().k, *foul) == pytest.approx(place)


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


def test_who_steps_away_has_a_second_again_and_an_opponent_that_touches_too_early_has_it_taken_again():
    referee = Referee()
    referee.restart(Phase.FREE_KICK, 0.0, 0.0)
    for _ in range(2):
        referee.put(4, 0.7, 0.0)
        assert not any(referee.wait(0.9))
        referee.put(4, 0.9, 0.0)
        assert referee.look() == 0
    referee = Referee()
    referee.restart(Phase.FREE_KICK, 1.0, 1.0)
    assert referee.look(touches=(4,)) == Foul.DISTANCE
    assert referee.events["restart"] == Phase.FREE_KICK and referee.record["restart_team"] == HOME
    assert referee.robots["fouls"].tolist() == [0, 0, 0, 0, 1, 0]
    assert (referee.record["restart_x"], referee.record["restart_y"]) == (1.0, 1.0)


def test_the_goalkeeper_may_stay_in_its_goal_area_and_mates_where_they_like_and_all_with_the_switch_off():
    referee, off = Referee(), Referee(distances=False)
    referee.restart(Phase.FREE_KICK, 5.5, 0.0)
    referee.put(3, 5.8, 0.0)
    referee.put(2, 5.5, 0.5)
    assert not any(referee.wait(3.0)) and referee.look(touches=(2,)) == 0
    referee.put(3, 5.4, 0.5)
    assert any(referee.wait(1.1))
    off.restart(Phase.FREE_KICK, 0.0, 0.0)
    off.put(4, 0.5, 0.0)
    assert not any(off.wait(3.0)) and off.look(touches=(4,)) == 0


@pytest.mark.parametrize(("x", "y", "foul"), [
    (5.85, 0.4, 0), (5.95, -0.9, 0), (5.70, 0.4, Foul.DISTANCE), (5.85, 1.03, Foul.DISTANCE),
    (-5.85, 0.4, Foul.DISTANCE),
])  # fmt: skip
@each_team
def test_an_opponent_on_its_own_goal_line_between_the_posts_is_not_put_back_at_a_free_kick(x, y, foul, team):
    """FIFA's Law 13."""
    referee = Referee(team=team)
    referee.restart(Phase.FREE_KICK, 5.3 if x > 0.0 else -5.3, 0.5)
    robot = referee.put(4, x, y)
    assert referee.wait(1.02)[-3:].count(foul) > 0 or foul == 0
    assert (robot["x"] == x and robot["y"] == y) == (foul == 0) and robot["fouls"] == (foul != 0)


def test_after_ten_seconds_everybody_may_play_the_ball():
    referee = Referee()
    referee.restart(Phase.FREE_KICK, 0.0, 0.0)
    referee.record["phase_clock"] = 0.0
    referee.match.rebuild()
    assert record_each_step(referee.match, lambda: referee.events["in_play"], steps=501).tolist().index(1) == 499
