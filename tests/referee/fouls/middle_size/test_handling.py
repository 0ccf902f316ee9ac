"""How much of the ball may lie within a robot, how far it may go back with it, and how far dribble."""

import pytest

from soccer_env.match.staging import put_ball
from soccer_env.referee.fouls.middle_size.handling import share_within
from soccer_env.types import AWAY, HOME, Foul
from tests.scenes.referee import Referee

HULL, DIAMETER = 0.235, 0.22  # [m] the line that touches the tips of the guide; the ball
each_team = pytest.mark.parametrize("team", [HOME, AWAY])


@pytest.mark.parametrize("share", [0.0, 0.25, 1.0 / 3.0, 0.5])
def test_the_share_of_the_ball_within_the_hull_follows_from_where_it_lies(share):
    assert share_within(Referee().k, HULL + DIAMETER * (0.5 - share), 0.1) == pytest.approx(share, abs=1e-9)


def test_a_ball_beside_the_guide_or_behind_the_robot_lies_outside():
    k = Referee().k
    assert share_within(k, 0.2, 0.151) == share_within(k, 0.2, -0.151) == share_within(k, -0.3, 0.0) == 0.0


def test_at_the_kicker_the_ball_lies_within_by_a_quarter():
    assert share_within(Referee().k, 0.18 + 0.11, 0.0) == pytest.approx(0.055 / 0.22)


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


def test_who_lets_the_ball_out_begins_anew():
    referee = held(0.5)
    for _ in range(2):
        put_ball(referee.match, HULL, 0.0)
        assert not any(referee.wait(0.4))
        put_ball(referee.match, HULL + DIAMETER * 0.3, 0.0)
        assert referee.look() == 0


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


def test_handling_can_be_switched_off():
    assert not any(held(0.5, handling=False).wait(2.0)) and not any(with_ball(-1.0, handling=False).wait(2.0))
