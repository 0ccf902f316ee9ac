"""How a stuck player of sacks-2001 gets free: ten steps back, then aside or round, then to the ball again."""

from math import atan2, cos, pi, sin

import numpy as np
import pytest

from soccer_env.baselines.sacks_2001.memory import APPROACH, BACK, ROTATE, SIDESTEP
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from tests.scenes.sacks_mind import LEAGUE, Mind

STEP = LEAGUE.drive.gait_steps * LEAGUE.dt  # [s]
GOAL = LEAGUE.pitch.length / 2
BEFORE_STUCK = 9 / 3.0 + 0.05  # [s]


def stuck(bearing: float = 0.0, distance: float = 0.5, **settings: float) -> Mind:
    """Return a player that has just begun to recover."""
    mind = Mind(**settings)
    mind.see_ball(distance, bearing)
    for _ in range(100):
        mind.think()
        if mind.memory["behaviour"] == BACK:
            return mind
    raise AssertionError("it never noticed")


@pytest.mark.parametrize("steps", [10, 3])
def test_ms23_a_stuck_robot_takes_ten_steps_back_then_one_aside_then_goes_to_the_ball(steps: int) -> None:
    mind = stuck() if steps == 10 else stuck(back_steps=steps)
    commands = mind.think(steps * STEP - 2.5 * LEAGUE.dt)
    assert (commands[:, 0] == -1.0).all() and (commands[:, 1:4] == 0.0).all()
    assert mind.memory["behaviour"] == BACK
    mind.think(4 * LEAGUE.dt)
    assert mind.memory["behaviour"] == SIDESTEP
    aside = mind.think(SacksSettings().side_steps * STEP - 4 * LEAGUE.dt)
    assert (abs(aside[:, 1]) == 1.0).all() and (aside[:, 0] == 0.0).all()
    mind.think(5 * LEAGUE.dt)
    assert mind.memory["behaviour"] == APPROACH and mind.memory["stuck"] == 0


def test_ms23_it_does_so_again_if_it_is_stuck_again_and_counts_the_tries() -> None:
    mind = stuck()
    mind.think(10 * STEP + SacksSettings().side_steps * STEP + 0.1)
    assert mind.memory["behaviour"] == APPROACH
    mind.think(BEFORE_STUCK + 0.2)
    assert mind.memory["behaviour"] == BACK and mind.memory["tries"] == 2


def test_ms23_without_recovery_it_pushes_on_for_ever() -> None:
    mind = Mind(recovery=False)
    mind.see_ball(0.5)
    commands = mind.think(20.0)
    assert mind.memory["behaviour"] == APPROACH and (commands[:, 0] > 0.9).all()


def test_ms24_the_step_aside_brings_the_ball_between_the_robot_and_the_goal() -> None:
    rng = np.random.default_rng(24)
    for _ in range(40):
        x, y, heading = rng.uniform(-1.0, 0.5), rng.uniform(-0.6, 0.6), rng.uniform(-2.0, 2.0)
        mind = stuck()
        mind.stand_at(x, y, heading)
        mind.think(10 * STEP)
        assert mind.memory["behaviour"] == SIDESTEP
        side = float(mind.memory["side"])
        ball_x, ball_y = x + 0.5 * cos(heading), y + 0.5 * sin(heading)
        to_goal = atan2(-ball_y, GOAL - ball_x)
        off = {
            s: misalignment(x - 0.05 * s * sin(heading), y + 0.05 * s * cos(heading), ball_x, ball_y, to_goal)
            for s in (1.0, -1.0)
        }
        assert off[side] < off[-side] and abs(side) == 1.0


def misalignment(x: float, y: float, ball_x: float, ball_y: float, to_goal: float) -> float:
    """Return the angle [rad] between the way from a place to the ball and that from the ball to the goal."""
    angle = atan2(ball_y - y, ball_x - x) - to_goal
    return abs((angle + pi) % (2.0 * pi) - pi)


@pytest.mark.parametrize("side", [1, -1])
def test_ms25_a_ball_more_than_30_degrees_aside_is_turned_to_instead(side: int) -> None:
    for degrees, behaviour in ((29.0, SIDESTEP), (31.0, ROTATE)):
        mind = stuck(side * degrees * pi / 180.0)
        commands = mind.think(10 * STEP + 0.2)
        assert mind.memory["behaviour"] == behaviour
    assert (np.sign(commands[-2:, 2]) == side).all() and (commands[-2:, :2] == 0.0).all()


def test_ms25_one_that_faces_the_ball_goes_to_it() -> None:
    mind = stuck(2.0)
    mind.think(10 * STEP + 0.5)
    assert mind.memory["behaviour"] == ROTATE
    mind.see_ball(0.5, 0.1)
    mind.think(2 * LEAGUE.dt)
    assert mind.memory["behaviour"] == APPROACH
