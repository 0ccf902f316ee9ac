"""How the chaser on wheels drives past a ball: it turns no faster than lets it brake, and pushes nothing on."""

import numpy as np
import pytest

from soccer_env.baselines.chaser import team
from soccer_env.baselines.chaser.attacking import PASSED, pass_ball
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.skills.moves import BRAKE_SHARE, TURNING, turn_by
from soccer_env.skills.sight import SIGHT
from soccer_env.types import COMMAND
from tests.scenes.staging import MIDDLE, put, put_ball, stage, steps_in

K = constants_of(find_league(MIDDLE))[0]
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
    pass_ball(command, sight, K, PLAY)
    most = min(gap / PLAY["settle"], np.sqrt(2.0 * BRAKE_SHARE * K["drive_acceleration"] * gap))
    assert command["forward"] * K["drive_forward"] == pytest.approx(min(K["drive_forward"], rolls + most))
    assert command["left"] == pytest.approx(0.5), "past the ball it is as fast as before"


@pytest.mark.parametrize("name", ["chaser", "heinemann-2006"])
def test_who_overtakes_a_ball_that_rolls_to_a_line_does_not_knock_it_on(name):
    """Before, who turned as it came ran it over: 0.55 or 0.73 m/s more towards the line in every fourth run."""
    rng = np.random.default_rng(2)
    side, x = np.where(np.arange(MATCHES) % 2, 1.0, -1.0), rng.uniform(-2.0, 2.0, MATCHES)
    behind, aside = rng.uniform(0.6, 1.6, MATCHES), rng.uniform(-0.6, 0.6, MATCHES)
    match = stage(MIDDLE, MATCHES, 2, 1, seed=4, senses="ideal", controllers={"home": name, "away": "still"})
    put_ball(match, x, side * 1.5)
    put(match, 1, x - behind * np.sin(aside), side * (1.5 - behind * np.cos(aside)), rng.uniform(-3.1, 3.1, MATCHES))
    match.balls["vy"], match.robots["vy"][:, 1] = side * rng.uniform(1.0, 1.5, MATCHES), side * 1.5
    match.rebuild()
    knocked = np.zeros(MATCHES)
    for _ in range(steps_in(match, 3.0)):
        before = match.balls["vy"].copy()
        match.step()
        touches = match.robot_events["touch"][:, 1] == 1
        knocked = np.where(touches, np.maximum(knocked, side * (match.balls["vy"] - before)), knocked)
        assert not match.events["out"].any()
    assert np.quantile(knocked, 0.75) < 0.5 and np.quantile(knocked, 0.95) < 0.8
    match.close()
