"""How the chaser on wheels meets a ball and turns with it.

It gives way to a ball that comes, presses softly where an opponent is, and turns about a ball that it has.
"""

import numpy as np
import pytest

from soccer_env.baselines.attacking import comes_to_me
from soccer_env.baselines.carrying import PRESSED, SLOW, line_speed, turn_to_goal
from soccer_env.baselines.chaser import MEMORY, team
from soccer_env.baselines.sight import SIGHT
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
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
    assert bool(comes_to_me(seen(ball_vx=vx, ball_vy=vy), K)) == comes
    assert bool(comes_to_me(seen(ball_vx=vx, ball_vy=-vy), K)) == comes


@pytest.mark.parametrize(("gap", "mate", "slow"), [(-0.01, 0, True), (0.01, 0, False), (-0.01, 1, False)])
def test_the_ball_is_pushed_slowly_while_an_opponent_is_at_it(gap, mate, slow):
    sight = seen(others=1)
    sight["other_x"][0], sight["mate"][0] = 1.0 + PRESSED + gap, mate
    assert (line_speed(sight, K, 1.0, 0.0) == SLOW) == slow


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
