"""A player's surface lies half a body before its middle, and the ranger's reading comes back as it was."""

from math import cos, sin

import pytest

from soccer_env.belief.legged.surface import surface_distance
from tests.belief.legged.staged_players import Onlooker, player

CAMERA, HALF = 0.142, 0.105  # [m] camera ahead of the body's middle; a chest before its own


@pytest.mark.parametrize("bearing", [0.0, 0.7, -1.5])
def test_a_player_is_as_far_as_its_chest_from_the_camera(bearing: float) -> None:
    k = Onlooker().constants[0]
    x, y = CAMERA + 0.8 * cos(bearing), 0.8 * sin(bearing)
    assert surface_distance(x, y, k) == pytest.approx(0.8 - HALF)


def test_nobody_is_nearer_than_nothing() -> None:
    assert surface_distance(CAMERA + 0.05, 0.05, Onlooker().constants[0]) == 0.0


def test_ms35_the_reading_is_the_distance_to_the_surface() -> None:
    """MS35: of a player that the ranger has placed the paper's own quantity, the reading, is left."""
    robot = Onlooker()
    for reading in (0.15, 0.3, 0.39):
        robot.look([player(0.0, 0.0, 12)], infrared=reading)
        track = robot.opponents[0]
        assert surface_distance(track["x"], track["y"], robot.constants[0]) == pytest.approx(reading, abs=1e-3)
