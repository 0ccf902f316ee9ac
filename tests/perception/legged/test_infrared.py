"""The infrared ranger measures what its beam meets first, and knows what it cannot measure."""

from math import asin, cos, inf, pi, sin, sqrt

import numpy as np
import pytest

from soccer_env.perception.legged.infrared import beam_direction
from tests.perception.legged.staged_beam import LEAGUE, BeamScene, aim_at

RADIUS = LEAGUE.ball.radius


def way_to(place: BeamScene, x: float, y: float, z: float) -> float:
    """Return how far a point [m] is from the camera."""
    return float(np.linalg.norm(place.camera() - np.array([x, y, z])))


def test_a_level_beam_meets_the_goal_or_flies_over_the_boards_and_one_that_points_down_meets_the_carpet() -> None:
    place = BeamScene()
    assert place.path() == pytest.approx(1.8 - place.camera()[0], abs=1e-12)  # the back of the goal
    place.put(0, 1.2, 0.0, 0.0, 0.7)  # through the mouth at x = 1.5 m, to the side at y = 0.3 m
    assert place.path() == pytest.approx((0.3 - place.camera()[1]) / sin(0.7))
    place.put(0, 0.0, 0.6)
    assert place.path() == inf  # the boards are lower than the camera
    for tilt in (-0.3, -0.8, -1.3):
        place.put(0, 0.0, 0.0, 0.7, 0.4, tilt)
        assert place.path() == pytest.approx(place.camera()[2] / sin(-tilt), rel=1e-12)


@pytest.mark.parametrize("bearing", [0.0, 0.6, -1.2])
@pytest.mark.parametrize("distance", [0.2, 0.4, 0.8])
def test_the_path_to_a_ball_at_the_beam_ends_on_its_surface(distance: float, bearing: float) -> None:
    place = BeamScene()
    x, y = distance * cos(bearing), distance * sin(bearing)
    place.balls["x"], place.balls["y"] = x, y
    aim_at(place, x, y, RADIUS)
    to_centre = way_to(place, x, y, RADIUS)
    assert place.path() == pytest.approx(to_centre - RADIUS, rel=1e-12)


def test_a_beam_misses_the_ball_past_its_edge_and_meets_boards_at_their_height_and_not_above() -> None:
    place = BeamScene()
    place.balls["x"], place.balls["y"] = 0.6, 0.0
    aim_at(place, 0.6, 0.0, RADIUS)
    away = way_to(place, 0.6, 0.0, RADIUS)
    edge = asin(RADIUS / away)
    assert place.path(lateral=0.99 * edge) < away
    assert place.path(lateral=1.01 * edge) > away  # the carpet behind it
    assert place.path(vertical=1.02 * edge) > away
    place = BeamScene()
    place.put(0, 0.0, 0.6, pi / 2)
    aim_at(place, 0.0, 1.0, 0.09)
    assert place.path() == pytest.approx(way_to(place, 0.0, 1.0, 0.09))
    aim_at(place, 0.0, 1.0, 0.11)
    assert place.path() == pytest.approx(place.camera()[2] / sin(-place.robots["tilt"][0, 0]))  # carpet, outside
    place.put(0, 1.0, 0.7, 0.0)
    aim_at(place, 1.5, 0.7, 0.05)  # beside the goal
    assert place.path() == pytest.approx(way_to(place, 1.5, 0.7, 0.05))


def test_a_beam_meets_trunk_head_and_legs_of_a_robot_and_passes_between_the_legs() -> None:
    body = LEAGUE.body
    rump = body.tip_radius - body.hind_x
    place = BeamScene()
    place.put(1, 0.6, 0.0)  # seen from behind
    for target, part in (((0.6 - rump, 0.0, 0.10), "trunk"), ((0.6 + body.hind_x, body.hind_y, 0.02), "leg")):
        aim_at(place, *target)
        assert place.path() == pytest.approx(way_to(place, *target), abs=0.025), part
    aim_at(place, 0.6 - rump, 0.0, 0.03)
    camera = place.camera()
    assert place.path() == pytest.approx(camera[2] / sin(-place.robots["tilt"][0, 0]))  # the carpet under its trunk
    place.put(1, 0.6, 0.0, pi)  # seen from ahead, its head held high
    aim_at(place, 0.46, 0.0, 0.22)
    assert place.path() == pytest.approx(0.6 - 0.075 - 0.0666 - place.camera()[0], abs=0.005)
    place.put(1, 0.6, 0.0, pi, 0.0, -1.0)  # with its head down the chest is bare, higher up there is nothing
    aim_at(place, 0.46, 0.0, 0.24)
    assert place.path() > 1.0


def test_the_nearest_of_several_robots_is_met_and_none_beside_the_beam_or_behind() -> None:
    place = BeamScene(robots=4)
    for r, (x, y) in enumerate(((0.6, 0.30), (0.6, -0.30), (-0.5, 0.0)), start=1):
        place.put(r, x, y, 1.0)
    assert place.path() == pytest.approx(1.8 - place.camera()[0])
    for r, x in enumerate((1.1, 0.5, 0.8), start=1):
        place.put(r, x, 0.0, pi / 2)
    aim_at(place, 0.5 - 0.0775, 0.0, 0.12)
    assert place.path() == pytest.approx(0.4225 - place.camera()[0], abs=0.03)
    place.robots["active"][:, 2] = 0
    assert place.path() > 0.45


def test_ms05_readings_outside_the_window_are_discarded() -> None:
    away = np.array([0.02, 0.08, 0.099, 0.101, 0.4, 0.8, 0.899, 0.901, 1.3])
    place = BeamScene(9)
    place.robots["x"][:, 0] = 1.8 - place.camera()[0] - away  # ahead of a goal's back
    assert place.readings()[:, 0] == pytest.approx([0, 0, 0, 0.101, 0.4, 0.8, 0.899, 0, 0], abs=1e-9)
    wide = BeamScene(9, infrared_near=0.0, infrared_far=2.0)
    wide.robots["x"][:, 0] = place.robots["x"][:, 0]
    assert wide.readings()[:, 0] == pytest.approx(away, abs=1e-9)


@pytest.mark.parametrize("distance", [0.15, 0.4, 0.6])
def test_the_error_of_a_reading_grows_as_the_law_says(distance: float) -> None:
    place = BeamScene(4000, infrared_noise=0.004, infrared_growth=0.018)
    place.robots["x"][:, 0] = 1.8 - BeamScene().camera()[0] - distance
    found = place.readings()[:, 0]
    expected = sqrt(0.004**2 + (0.018 * (distance / 0.4) ** 3) ** 2)
    assert (found > 0.0).all() and found.std() == pytest.approx(expected, rel=0.05)
    assert found.mean() == pytest.approx(distance, abs=0.1 * expected)


def test_the_beam_strays_by_the_pointing_noise() -> None:
    place = BeamScene(4000, infrared_pointing=0.03)
    place.put(0, 0.0, 0.0, 0.0, 0.0, -0.8)
    found = place.readings()[:, 0]
    assert np.arcsin(place.camera()[2] / found).std() == pytest.approx(0.03, rel=0.05)
    ahead, left, up = beam_direction(0.4, -0.7, 0.02, -0.01)
    axis = beam_direction(0.4, -0.7, 0.0, 0.0)
    assert ahead**2 + left**2 + up**2 == pytest.approx(1.0)
    assert np.arccos(np.dot(axis, (ahead, left, up))) == pytest.approx(np.hypot(0.02, 0.01), rel=1e-3)


def test_who_is_out_measures_nothing_nothing_far_reads_as_near_and_all_in_one_place_break_nothing() -> None:
    place, far = BeamScene(), BeamScene(4000, infrared_noise=0.004, infrared_growth=0.018)
    place.put(0, 0.0, 0.0, 0.0, 0.0, -0.8)
    assert place.readings()[0, 0] > 0.0
    place.robots["active"][:, 0] = 0
    assert place.readings()[0, 0] == 0.0
    far.robots["x"][:, 0] = -0.3  # the goal's back is 2 m away
    assert not far.readings()[:, 0].any()
    place = BeamScene(2, robots=6)
    place.robots["x"], place.balls["x"], place.robots["tilt"][1] = 0.0, 0.0, -1.4
    assert np.isfinite(place.readings()).all()
