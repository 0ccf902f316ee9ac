"""Who takes a restart does not touch the ball again, and no goal falls straight from an indirect one."""

import numpy as np
import pytest

from soccer_env.match.staging import put_ball
from soccer_env.types import AWAY, HOME, Foul, Phase
from tests.scenes.referee import Referee
from tests.scenes.staging import stand

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


def test_a_second_touch_in_a_shoot_out_ends_the_kick():
    referee = taken(Phase.PENALTY_KICK)
    referee.record["shoot_out"], referee.record["phase_clock"] = 1, 2.0
    referee.wait(LEFT)
    assert referee.look(touches=(1,)) == Foul.SECOND_TOUCH
    assert referee.events["restart"] == 0 and referee.record["phase_clock"] == 10.0


def test_a_foul_lets_everybodys_clocks_begin_anew():
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


def test_a_kick_is_a_touch_though_the_ball_is_gone_at_once():
    referee = taken()
    referee.wait(LEFT)
    assert referee.look(kicks=(1,)) == Foul.SECOND_TOUCH


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


def test_before_the_ball_is_in_play_touches_do_not_count():
    referee = Referee()
    referee.restart(Phase.THROW_IN, 0.0, 4.0)
    assert referee.look(touches=(1,)) == 0
    referee.wait(1.0)
    assert referee.look(touches=(1,)) == 0 and referee.record["taker"] == referee.rows[1]


def test_nobody_is_the_taker_of_a_restart_whose_time_ran_out_or_of_a_dropped_ball():
    referee = Referee()
    referee.restart(Phase.THROW_IN, 0.0, 4.0)
    referee.record["phase"] = Phase.PLAY
    referee.look(touches=(1,))
    assert referee.record["taker"] == -1 and referee.record["indirect"] == 0
    referee.record["phase"], referee.record["restart_team"] = Phase.DROP_BALL, -1
    referee.look(touches=(1,))
    assert referee.record["taker"] == -1


def test_the_rule_can_be_switched_off():
    referee = taken(second_touch=False)
    referee.wait(1.0)
    assert referee.look(touches=(1,)) == 0


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
def test_a_switch_for_each_restart_lets_its_goals_count(phase):
    referee = taken(phase, **{f"direct_{phase.name.lower()}": True})
    assert ball_in_goal(referee, 1.0)["goal"] == HOME


def test_in_the_simple_rules_every_restart_is_direct():
    referee = taken(rules="simple")
    assert ball_in_goal(referee, 1.0)["goal"] == HOME
