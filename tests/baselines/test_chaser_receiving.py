"""How the chaser on wheels meets a ball, turns with it and drives past it.

It gives way to a ball that comes, presses softly where an opponent is, turns about a ball that it has, and pushes
nothing on that it passes.
"""

from math import cos, sin

import numpy as np
import pytest

from soccer_env.baselines.chaser.team import MEMORY, team
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.skills import approaching
from soccer_env.skills.approaching import GIVE_TIME, MEET, MET, PASSED, run_into_ball
from soccer_env.skills.attacking import ball_comes_to_me
from soccer_env.skills.carrying import PRESSED, SLOW, pushing_speed, turn_to_goal
from soccer_env.skills.moves import BRAKE_SHARE, TURNING, turn_by
from soccer_env.skills.sight import SIGHT
from soccer_env.types import COMMAND
from tests.scenes.staging import MIDDLE

K = constants_of(find_league(MIDDLE))[0]


def seen(**values: float) -> np.void:
    """Return what a player at the middle sees, of a ball 1 m ahead of it."""
    sight = np.zeros(1, SIGHT)[0]
    sight["ball_x"], sight["touch"] = 1.0, 0.29
    for name, value in values.items():
        sight[name] = value
    return sight


@pytest.mark.parametrize(
    ("vx", "vy", "comes"), [(-1.0, 0.0, True), (1.0, 0.0, False), (-0.3, 0.0, False), (-1.0, 1.0, False)]
)
def test_a_ball_comes_that_rolls_fast_enough_and_not_wide(vx, vy, comes):
    assert bool(ball_comes_to_me(seen(ball_vx=vx, ball_vy=vy), K)) == comes
    assert bool(ball_comes_to_me(seen(ball_vx=vx, ball_vy=-vy), K)) == comes


@pytest.mark.parametrize(
    ("ahead", "left", "mate", "slow"),
    [(0.99, 0.0, 0, True), (1.01, 0.0, 0, False), (0.99, 0.0, 1, False)]
    + [(cos(bearing), sin(bearing), 0, abs(bearing) < 1.04) for bearing in (-3.1, -1.5, -1.0, 1.0, 1.5, 3.1)],
)
def test_the_ball_is_pushed_slowly_against_an_opponent_that_is_at_it_but_not_along_one(ahead, left, mate, slow):
    sight = seen(others=1)
    away = PRESSED if abs(left) == 0.0 else 0.9 * PRESSED
    sight["other_x"][0], sight["other_y"][0], sight["mate"][0] = 1.0 + away * ahead, away * left, mate
    assert (pushing_speed(sight, K, 1.0, 0.0) == SLOW) == slow


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_who_tackles_a_ball_that_is_carried_past_runs_along_with_it(side):
    """The limit is on the speed towards each other: one on its own speed would leave it behind."""
    sight = seen(cosine=1.0, pace=1.0, distance=0.29, ball_vy=1.2 * side)
    command = np.zeros(1, COMMAND)[0]
    command["forward"], command["left"] = 1.0, 0.5 * side
    run_into_ball(command, sight, K, 1.0, 0.0)
    vx, vy = command["forward"] * K["drive_forward"], command["left"] * K["drive_sideways"]
    assert np.hypot(vx, vy - 1.2 * side) == pytest.approx(MET)
    assert vx > 0.0 and vy * side > 1.0


@pytest.mark.parametrize("gap", [0.0, 0.1, 1.0])
def test_a_ball_that_lies_still_is_met_slowly(gap):
    sight, command = seen(cosine=1.0, pace=1.0, distance=0.29 + gap), np.zeros(1, COMMAND)[0]
    command["forward"] = 1.0
    run_into_ball(command, sight, K, 1.0, 0.0)
    assert command["forward"] * K["drive_forward"] == pytest.approx(min(MET + gap / GIVE_TIME, MEET))


def turns(sight: np.void, last: float, side: float) -> tuple[float, float]:
    """Return turn [rad/s] and speed to the left [m/s] that follow a turn of `last` [rad/s], for a goal aside."""
    command, memory = np.zeros(1, COMMAND)[0], np.zeros(1, MEMORY)[0]
    memory["turn"] = last / K["drive_turn"]
    turn_to_goal(command, sight, memory, K, team().settings[1], 0.0, side)
    return command["turn"] * K["drive_turn"], command["left"] * K["drive_sideways"]


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_it_turns_about_the_ball_that_it_has(side):
    turn, left = turns(seen(cosine=1.0, now_cosine=1.0, pace=1.0, elapsed=0.5), 0.0, side)
    assert turn * side > 1.0 and left == pytest.approx(-turn * 0.29)  # the ball's place moves by left + turn x 0.29


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("pace", [1.0, 0.5])
def test_a_turn_about_the_ball_takes_less_than_the_motors_give(pace, side):
    """On a circle of radius r the wheels accelerate by w^2 r across and r dw/dt along it, each by the same share."""
    share = team().settings["circle_share"][1] * K["drive_acceleration"] * pace * pace
    sight, turn, rates = seen(cosine=1.0, now_cosine=1.0, pace=pace, elapsed=K["dt"]), 0.0, [0.0]
    for _ in range(50):
        turn, left = turns(sight, turn, side)
        rates.append(turn * side)
        assert left == pytest.approx(-turn * 0.29)
    assert rates[-1] ** 2 * 0.29 == pytest.approx(share)
    assert np.diff(rates).max() / K["dt"] * 0.29 == pytest.approx(share) and np.diff(rates).min() >= -1e-12
    assert 2.0**0.5 * share < K["drive_acceleration"]


PLAY = team().settings[1]
MATCHES = 64


def turn_at(speed: float, bearing: float) -> float:
    """Return the turn [rad/s] that a robot of this speed [m/s] asks for to face a bearing [rad]."""
    sight, command = np.zeros(1, SIGHT)[0], np.zeros(1, COMMAND)[0]
    sight["vy"], sight["pace"] = speed, 1.0
    turn_by(command, sight, K, PLAY, bearing)
    return float(command["turn"] * K["drive_turn"])


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("speed", [0.5, 1.5, 2.5])
def test_a_turn_at_speed_leaves_acceleration_to_brake_with(speed, side):
    """MH01: who turns by w at speed v bends its way in its own frame by v w."""
    assert turn_at(speed, 3.0 * side) * speed == pytest.approx(TURNING * K["drive_acceleration"] * side)
    assert turn_at(speed, 0.001 * side) == pytest.approx(0.001 * side / PLAY["settle"])
    assert turn_at(0.0, 3.0 * side) == pytest.approx(K["drive_turn"] * side)


@pytest.mark.parametrize("rolls", [-1.0, 0.0, 1.0])
@pytest.mark.parametrize("gap", [0.0, 0.1, 0.5])
def test_a_ball_that_is_passed_is_approached_only_as_fast_as_the_gap_lets_brake(gap, rolls):
    sight, command = np.zeros(1, SIGHT)[0], np.zeros(1, COMMAND)[0]
    sight["touch"], sight["cosine"], sight["ball_vx"] = 0.29, 1.0, rolls
    sight["distance"] = sight["ball_x"] = 0.29 + PASSED + gap
    command["forward"], command["left"] = 1.0, 0.5
    approaching.limit_closing_speed(command, sight, K, PLAY)
    most = min(gap / PLAY["settle"], np.sqrt(2.0 * BRAKE_SHARE * K["drive_acceleration"] * gap))
    assert command["forward"] * K["drive_forward"] == pytest.approx(min(K["drive_forward"], rolls + most))
    assert command["left"] == pytest.approx(0.5), "past the ball it is as fast as before"
