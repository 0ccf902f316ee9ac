"""Who drives into an opponent off the ball, or into a goalkeeper; and how much of the ball may lie within a robot."""

from math import pi

import pytest

from soccer_env.match.staging import put_ball
from soccer_env.referee.fouls.middle_size.handling import ball_share_within
from soccer_env.types import AWAY, HOME, Foul, Phase
from tests.scenes.referee import Referee
from tests.scenes.staging import record_each_step, robot_actions

CONTACT = 0.448  # [m] between robots, the tips of one at the back of the other
each_team = pytest.mark.parametrize("team", [HOME, AWAY])


def behind(speed, away=0.0, **changes):
    """Return a referee before whom robot 1 drives into the back of robot 4, which drives away."""
    referee = Referee(**changes)
    put_ball(referee.match, -2.0, -2.0)
    referee.put(1, 1.0, 0.0, 0.0, speed)
    referee.put(4, 1.0 + CONTACT - 0.005, 0.0, 0.0, away)
    return referee


@each_team
@pytest.mark.parametrize(("speed", "foul"), [(0.29, 0), (0.31, Foul.CHARGING)])
def test_driving_into_an_opponent_for_two_seconds_is_a_foul(speed, foul, team):
    referee = behind(speed, team=team)
    fouls = referee.wait(1.98, collides=(1, 4)) + [referee.look(collides=(1, 4))]
    assert fouls == [0] * 99 + [foul]
    assert referee.deeds["foul"][referee.rows[4]] == 0
    if foul:
        assert referee.events["foul_team"] == team and referee.record["restart_team"] == 1 - team


@pytest.mark.parametrize(("speed", "away", "foul"), [(1.99, 0.0, 0), (2.01, 0.0, 1), (2.5, 0.6, 0), (2.5, 0.4, 1)])
def test_a_hard_blow_is_a_foul_at_once_and_who_drives_away_softens_it(speed, away, foul):
    referee = behind(speed, away)
    assert (referee.look(collides=(1, 4)) == Foul.CHARGING) == bool(foul)


def test_who_is_in_contact_already_strikes_no_hard_blow_and_each_is_judged_by_its_own_speed():
    referee = behind(1.0)
    assert referee.look(collides=(1, 4)) == 0
    referee.put(1, 1.0, 0.0, 0.0, 2.5)
    assert referee.look(collides=(1, 4)) == 0
    referee.wait(0.02)  # apart for as long as it drove into it
    assert referee.look(collides=(1, 4)) == 0
    referee.wait(0.04)
    assert referee.look(collides=(1, 4)) == Foul.CHARGING
    referee = behind(0.0)
    referee.put(4, 1.0 + CONTACT - 0.005, 0.0, pi, 1.0)
    fouls = referee.wait(3.0, collides=(1, 4))
    assert Foul.CHARGING in fouls and referee.robots["charging"][referee.rows[1]] == 0.0


@pytest.mark.parametrize(("gap", "foul"), [(-0.005, Foul.CHARGING), (0.015, 0)])
def test_who_touches_only_others_charges_nobody_however_near(gap, foul):
    referee = behind(2.5)
    referee.put(4, 1.0 + CONTACT + gap, 0.0)
    referee.put(2, 1.0 - CONTACT + 0.005, 0.0)
    assert referee.look(collides=(1, 2, 4)) == foul


def test_the_robot_nearest_to_the_ball_may_fight_for_it_and_who_runs_into_another_is_seen_by_a_whole_step():
    referee = behind(2.5)
    put_ball(referee.match, 1.0, 0.59)
    assert not any(referee.wait(3.0, collides=(1, 4)))
    referee.put(2, 1.0, 1.0)  # a mate is nearer
    assert referee.look(collides=(1, 4)) == Foul.CHARGING
    referee = behind(2.5)
    put_ball(referee.match, 1.0, 0.61)
    assert referee.look(collides=(1, 4)) == Foul.CHARGING
    referee = behind(0.0)
    referee.put(1, 0.0, 0.0, 0.0, 2.6)
    referee.match.rebuild()
    actions = robot_actions(referee.match, referee.rows[1], 1.0)
    assert Foul.CHARGING in record_each_step(referee.match, lambda: referee.events["foul"], 0.0, actions, 25)


def test_time_out_of_contact_is_taken_off_and_mates_may_push_each_other():
    referee = behind(1.0)
    for _ in range(3):
        assert not any(referee.wait(1.5, collides=(1, 4)))
        referee.wait(1.5)
    assert referee.robots["charging"][referee.rows[1]] == 0.0
    referee = behind(2.5)
    referee.put(4, 4.0, 0.0)
    referee.put(2, 1.0 + CONTACT - 0.005, 0.0)
    assert not any(referee.wait(3.0, collides=(1, 2)))


def before_keeper(x, speed=1.0, **changes):
    """Return a referee before whom robot 1 is in contact with the others' goalkeeper, which stands at x."""
    referee = Referee(**changes)
    referee.put(3, x, 0.0)
    referee.put(1, x - CONTACT + 0.005, 0.0, 0.0, speed)
    put_ball(referee.match, x - 0.3, 0.3)
    return referee


@each_team
@pytest.mark.parametrize(("x", "foul"), [(5.49, 0), (5.51, Foul.KEEPER_CHARGE)])
def test_driving_into_the_goalkeeper_in_its_goal_area_is_a_foul_at_once_even_for_the_ball(x, foul, team):
    referee = before_keeper(x, team=team)
    assert referee.look(collides=(1, 3)) == foul


def test_a_goal_in_the_same_step_is_annulled_an_attacker_that_stands_is_not_guilty_and_both_can_be_off():
    referee = before_keeper(5.7)
    put_ball(referee.match, 6.2, 0.5)
    assert referee.look(collides=(1, 3)) == Foul.KEEPER_CHARGE and referee.events["annulled"] == 1
    assert referee.record["phase"] == Phase.FREE_KICK and referee.record["restart_team"] == AWAY
    referee = before_keeper(5.6, speed=0.0)
    referee.put(3, 5.6, 0.0, pi, 2.0)
    assert not any(foul == Foul.KEEPER_CHARGE for foul in referee.wait(2.0, collides=(1, 3)))
    assert before_keeper(5.7, keeper_charge=False).look(collides=(1, 3)) == 0
    assert not any(behind(2.5, charging=False).wait(3.0, collides=(1, 4)))


HULL, DIAMETER = 0.235, 0.22  # [m] the line that touches the tips of the guide; the ball


@pytest.mark.parametrize("share", [0.0, 0.25, 1.0 / 3.0, 0.5])
def test_the_share_of_the_ball_within_the_hull_follows_from_where_it_lies(share):
    assert ball_share_within(Referee().k, HULL + DIAMETER * (0.5 - share), 0.1) == pytest.approx(share, abs=1e-9)


def test_at_the_kicker_the_ball_lies_within_by_a_quarter_and_outside_beside_the_guide_or_behind_the_robot():
    k = Referee().k
    assert ball_share_within(k, 0.18 + 0.11, 0.0) == pytest.approx(0.055 / 0.22)
    assert (
        ball_share_within(k, 0.2, 0.151) == ball_share_within(k, 0.2, -0.151) == ball_share_within(k, -0.3, 0.0) == 0.0
    )


def held(share, team=HOME, **changes):
    """Return a referee before whom robot 1 has a share of the ball within its hull."""
    referee = Referee(team=team, **changes)
    referee.put(1, 0.0, 0.0)
    put_ball(referee.match, HULL + DIAMETER * (0.5 - share), 0.0)
    return referee


@each_team
@pytest.mark.parametrize(("share", "foul"), [(0.33, 0), (0.34, Foul.HANDLING)])
def test_more_than_a_third_for_longer_than_a_stop_takes_is_a_foul(share, foul, team):
    fouls = held(share, team).wait(0.48) + [held(share, team).look()]
    assert not any(fouls)
    assert held(share, team).wait(0.5)[-1] == foul


def test_who_lets_the_ball_out_begins_anew_and_handling_can_be_switched_off():
    referee = held(0.5)
    for _ in range(2):
        put_ball(referee.match, HULL, 0.0)
        assert not any(referee.wait(0.4))
        put_ball(referee.match, HULL + DIAMETER * 0.3, 0.0)
        assert referee.look() == 0
    assert not any(held(0.5, handling=False).wait(2.0)) and not any(with_ball(-1.0, handling=False).wait(2.0))


def with_ball(forward, team=HOME, **changes):
    """Return a referee before whom robot 1 goes with the ball at a speed [m/s]."""
    referee = Referee(team=team, **changes)
    robot = referee.put(1, 0.0, 0.0, 0.0, forward)
    robot["has_ball"] = 1
    put_ball(referee.match, 0.29, 0.0)
    return referee


@each_team
@pytest.mark.parametrize(("seconds", "foul"), [(0.48, 0), (0.54, Foul.HANDLING)])
def test_going_back_with_the_ball_for_more_than_half_a_metre_is_a_foul(seconds, foul, team):
    fouls = with_ball(-1.0, team).wait(seconds)
    assert (foul in fouls) and (foul != 0 or not any(fouls))


@each_team
@pytest.mark.parametrize(("wheels", "foul"), [(0.5, 0), (0.0, 0), (-0.4, 0), (-0.6, Foul.HANDLING)])
def test_a_robot_pushed_back_goes_back_only_as_far_as_its_wheels_drive_back(wheels, foul, team):
    """For a second at 1 m/s: half a metre is free."""
    referee = with_ball(-1.0, team)
    referee.robots["walk"]["forward"][referee.rows[1]] = wheels
    fouls = referee.wait(1.0)
    assert max(fouls) == foul
    assert foul or referee.robots["backed"][referee.rows[1]] == pytest.approx(max(-wheels, 0.0))


@each_team
def test_wheels_that_spin_back_while_it_moves_ahead_with_the_ball_are_no_way_back(team):
    referee = with_ball(1.0, team)
    referee.robots["walk"]["forward"][referee.rows[1]] = -1.0
    assert not any(referee.wait(2.0)) and referee.robots["backed"][referee.rows[1]] == 0.0


def test_a_robot_that_loses_the_ball_begins_anew():
    referee = with_ball(-1.0)
    assert not any(referee.wait(0.4))
    put_ball(referee.match, 2.0, 0.0)
    referee.look()
    put_ball(referee.match, 0.29, 0.0)
    assert not any(referee.wait(0.4))


@pytest.mark.parametrize(("on", "metres", "foul"), [(True, 2.9, 0), (True, 3.1, Foul.DRIBBLE), (False, 9.0, 0)])
def test_dribbling_is_limited_to_three_metres_only_if_asked(on, metres, foul):
    fouls = with_ball(1.0, dribble_limit=on).wait(metres)
    assert (foul in fouls) and (foul != 0 or not any(fouls))
