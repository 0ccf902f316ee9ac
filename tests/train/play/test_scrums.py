"""Scrums and overlap: recordings made by hand, each with a known answer."""

from math import cos, pi, sin

import pytest

from soccer_env.leagues import find_league
from soccer_env.train.play.recording import Recording
from soccer_env.train.play.scrums import overlap_in_play, overlap_in_scrums, overlap_while_placing, scrums
from tests.train.play.recordings import blank, put

LEAGUE = find_league("middle-size-2006")
BACK, RADIUS = LEAGUE.body.disc_radius - LEAGUE.body.disc_x, LEAGUE.ball.radius
DEEP = 0.007  # [m]


def ring(count: int) -> Recording:
    """Return a recording with so many of five robots about the ball, their backs DEEP in it, and two far off."""
    play = blank(10, robots=5)
    for r in range(count):
        angle = 2.0 * pi * r / 3.0
        away = BACK + RADIUS - DEEP
        put(play, r, away * cos(angle), away * sin(angle), angle)
    put(play, 3, 3.0, 3.0)
    put(play, 4, 3.0 - 2.0 * BACK + 0.03, 3.0, pi)  # back to back, 3 cm deep
    return play


def test_three_robots_at_the_ball_are_a_scrum_and_two_are_not() -> None:
    assert scrums(ring(3))["scrum"] == pytest.approx([10 / LEAGUE.control_rate])
    assert scrums(ring(2))["scrum"] == pytest.approx([0.0])


def test_a_scrum_of_the_legged_league_reaches_30_centimetres() -> None:
    legged = find_league("legged-2001")
    for away, expected in ((0.29, 1.0), (0.31, 0.0)):
        play = blank(legged.control_rate, robots=3, league=legged)
        for r in range(3):
            put(play, r, away * cos(r), away * sin(r))
        assert scrums(play)["scrum"] == pytest.approx([expected])


def test_depth_in_a_scrum_is_of_its_own_robots_alone() -> None:
    found = overlap_in_scrums(ring(3))
    assert found["scrum_ball_robot"][0] == pytest.approx([DEEP] * 30)
    assert found["scrum_robot_robot"][0].tolist() == []
    assert overlap_in_scrums(ring(2))["scrum_ball_robot"][0].tolist() == []


def test_depth_in_play_is_of_all_and_while_placing_of_that_time() -> None:
    play = ring(3)
    play.matches["placing"][:4] = 1
    assert overlap_in_play(play)["play_robot_robot"][0] == pytest.approx([0.03] * 6)
    assert overlap_while_placing(play)["placing_robot_robot"][0] == pytest.approx([0.03] * 4)
    assert overlap_while_placing(play)["placing_ball_robot"][0] == pytest.approx([DEEP] * 12)
