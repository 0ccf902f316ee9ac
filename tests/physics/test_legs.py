"""Legs that get at the ball and at other legs: off by default, growing with step, angle and contact, left as right."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.physics.legs import LEGS, push_size
from soccer_env.staging import patient
from tests.scenes.staging import LEGGED, asking, put, put_ball, stage

LOST = 0.10  # [m] from chest to ball


def league_with(legs: float) -> League:
    league = patient(LEGGED)
    return replace(league, drive=replace(league.drive, leg_disturbance=legs))


def pushed(legs: float, step: float, angle: float = 0.0, seconds: float = 12.0, matches: int = 60) -> Match:
    """Return matches in which a robot has pushed its ball with steps [m] at an angle [rad] off ahead."""
    league = league_with(legs)
    match = stage(league, matches, seed=4)
    put(match, 0, -1.2, 0.0, 0.0)
    put_ball(match, -1.2 + league.body.front + league.ball.radius + 0.001, 0.0)
    match.rebuild()
    speed = step / (league.drive.gait_steps * league.dt)
    forward, left = speed * np.cos(angle) / league.drive.forward, speed * np.sin(angle) / league.drive.sideways
    for _ in range(round(seconds * league.control_rate)):
        match.step(asking(match, forward=forward, left=left))
    return match


def lost(match: Match) -> float:
    robot, ball, league = match.robots[:, 0], match.balls, match.league
    away = np.hypot(ball["x"] - robot["x"], ball["y"] - robot["y"])
    return float((away - league.body.front - league.ball.radius > LOST).mean())


def test_ms51_longer_steps_kick_the_ball_away() -> None:
    assert lost(pushed(1.0, 0.035)) == 0.0
    assert lost(pushed(1.0, 0.045)) > 0.5
    assert lost(pushed(0.0, 0.045)) == 0.0  # a body of one piece keeps it


def test_ms51_steps_far_aside_lose_the_ball() -> None:
    assert lost(pushed(1.0, 0.035, np.deg2rad(40.0), 6.0)) == 0.0
    assert lost(pushed(1.0, 0.035, np.deg2rad(60.0), 6.0)) > 0.3
    assert lost(pushed(0.0, 0.035, np.deg2rad(60.0), 6.0)) == 0.0  # a body of one piece keeps it


def test_ms51_pushes_grow_with_step_angle_and_contact() -> None:
    assert push_size(0.035, np.deg2rad(45.0), False) == 0.0
    assert push_size(0.040, 0.0, False) == pytest.approx(0.2)
    assert push_size(0.030, np.deg2rad(60.0), False) == pytest.approx(0.8 * np.deg2rad(15.0))
    assert push_size(0.030, 0.0, True) == pytest.approx(0.1)


def interlocked(legs: float, angle: float) -> float:
    """Return the share of time in which a robot that walks into another one has no walk, by its angle [rad]."""
    league = league_with(legs)
    match = stage(league, 60, seed=4)
    put(match, 0, -0.3, 0.0, 0.0)
    put(match, 1, -0.04, 0.0, np.pi)
    put_ball(match, 1.0, 0.8)
    match.rebuild()
    held, speed = [], 0.06
    forward, left = speed * np.cos(angle) / league.drive.forward, speed * np.sin(angle) / league.drive.sideways
    for _ in range(4 * league.drive.gait_steps):
        match.step(asking(match, forward=forward, left=left))
        held.append(match.robots["target"]["forward"][:, 0] == 0.0)
    return float(np.mean(held[league.drive.gait_steps :]))


def test_ms51_legs_interlock_with_a_robot_ahead_the_less_the_farther_aside_a_step_goes() -> None:
    assert interlocked(0.0, 0.0) == 0.0
    assert interlocked(1.0, 0.0) > interlocked(1.0, np.deg2rad(40.0)) > 0.0
    assert interlocked(1.0, np.deg2rad(65.0)) == 0.0


def test_without_disturbance_nothing_is_drawn() -> None:
    assert find_league(LEGGED).drive.leg_disturbance == 0.0
    off, on = pushed(0.0, 0.045, matches=2), pushed(1.0, 0.045, matches=2)
    fresh = stage(LEGGED, 2, seed=4)
    assert (off.robots["noise"][:, :, LEGS] == fresh.robots["noise"][:, :, LEGS]).all()
    assert (on.robots["noise"][:, 0, LEGS] != fresh.robots["noise"][:, 0, LEGS]).all()


def test_the_variant_with_such_legs_differs_by_them_alone() -> None:
    league, variant = find_league(LEGGED), find_league("legged-2001-legs")
    assert variant.drive.leg_disturbance == 1.0
    assert replace(variant, name=league.name, drive=league.drive) == league


def test_a_mirrored_robot_pushes_the_ball_to_the_other_side() -> None:
    ways = []
    for hand in (1.0, -1.0):
        match = stage(league_with(1.0), 20, seed=4)
        match.matches["handedness"] = hand
        put(match, 0, -1.2, 0.0, 0.0)
        put_ball(match, -1.2 + match.league.body.front + match.league.ball.radius + 0.001, 0.0)
        match.rebuild()
        for _ in range(48):
            match.step(asking(match, forward=0.8, left=0.3 * hand))
        ways.append((match.balls["x"].copy(), match.balls["y"].copy()))
    np.testing.assert_allclose(ways[0][0], ways[1][0], atol=1e-9)
    np.testing.assert_allclose(ways[0][1], -ways[1][1], atol=1e-9)
    assert np.ptp(ways[0][1]) > 0.01
