"""Robots that are stopped by others: recordings made by hand, each with a known answer."""

import pytest

from soccer_env.leagues import find_league
from soccer_env.train.play.recording import Recording
from soccer_env.train.play.stuck import approaching, blocked
from tests.train.play.recordings import blank, put

LEAGUE = find_league("middle-size-2006")
RATE, BACK = LEAGUE.control_rate, LEAGUE.body.disc_radius - LEAGUE.body.disc_x


def shoved(seconds: float, speed: float, away: float = 0.0) -> Recording:
    """Return a recording in which robot 0 backs into the back of robot 1 and wants 1 m/s, but gets on at `speed`."""
    play = blank(10 * RATE)
    put(play, 0, 2.0, 0.0)
    put(play, 1, 2.0 - 2.0 * BACK - away, 0.0, 3.14159265)
    until = round(seconds * RATE)
    play.robots["target"]["forward"][:until, 0, 0] = -1.0
    play.robots["vx"][:until, 0, 0] = -speed
    return play


def lengths(play: Recording) -> list[float]:
    return list(blocked(play)["blocked"][0].tolist())


def test_who_makes_a_fifth_of_the_walk_it_wants_is_blocked_and_who_makes_a_third_is_not() -> None:
    assert lengths(shoved(3.0, 0.2)) == pytest.approx([3.0])
    assert lengths(shoved(3.0, 0.33)) == []


def test_nobody_is_blocked_by_a_robot_a_centimetre_away() -> None:
    assert lengths(shoved(3.0, 0.2, away=0.01)) == []


def test_who_stands_by_its_own_will_or_to_kick_is_not_blocked() -> None:
    lazy, kicking = shoved(3.0, 0.0), shoved(3.0, 0.0)
    lazy.robots["target"]["forward"] *= 0.1 * LEAGUE.drive.forward
    kicking.robots["kick_clock"] = 0.3
    assert lengths(lazy) == lengths(kicking) == []


def test_half_a_second_of_getting_on_does_not_end_it_and_a_whole_one_does() -> None:
    play = shoved(6.0, 0.0)
    play.robots["vx"][100:125, 0, 0] = -1.0
    assert lengths(play) == pytest.approx([6.0])
    play.robots["vx"][100:150, 0, 0] = -1.0
    assert lengths(play) == pytest.approx([2.0, 3.0])


def test_being_blocked_counts_from_a_second_and_a_half_and_on_the_way_to_the_ball_from_one() -> None:
    short = shoved(1.2, 0.0)
    assert lengths(short) == []
    assert approaching(short)["approaching"][0].tolist() == pytest.approx([1.2])


def test_who_is_near_the_ball_is_not_on_the_way_to_it() -> None:
    play = shoved(3.0, 0.0)
    play.balls["x"][100:110] = 2.34  # for a moment
    assert approaching(play)["approaching"][0].tolist() == []
    assert lengths(play) == pytest.approx([3.0])
