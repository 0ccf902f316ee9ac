"""From blobs to a place: which blob is the ball, in which direction, how far."""

from math import atan2, cos, hypot, pi, radians, sin, sqrt, tan
from typing import Any

import numpy as np
import pytest

from soccer_env.optics.head_camera import camera_place, direction_of_pixel
from tests.belief.legged.staged_ball import LEAGUE, Watcher

RADIUS = LEAGUE.ball.radius
CAMERA_AHEAD = 0.075 + 0.0666 * cos(-0.3) - 0.048 * sin(-0.3)  # [m] neck and camera at tilt -0.3


def camera_height(tilt: float) -> float:
    """Return the height of the camera [m], by the kinematics of CMPack'02."""
    return 0.155 + 0.048 * cos(tilt) + 0.0666 * sin(tilt)


def test_ms08_the_bearing_is_head_angle_plus_place_in_the_picture() -> None:
    robot = Watcher(infrared_override=False)
    for pan in (-1.0, 0.0, 0.4):
        robot.head = pan, -0.1
        robot.look((2, -2, 2, -2, 16))  # 4 px of 5120 px focal length: tens of metres away
        assert robot.ball["bearing"] == pytest.approx(pan, abs=2e-3)
    robot.head = 0.0, 0.0
    robot.look((1002, 998, -98, -102, 16))
    assert robot.ball["bearing"] == pytest.approx(atan2(1000.0, robot.focal[0]), abs=2e-3)


def test_ms08_bearing_and_distance_count_from_the_body_not_from_the_camera() -> None:
    """MS08: the neck carries the camera ahead and aside; a ball near it is nearer to it than to the body."""
    robot = Watcher()
    for x, y in ((0.6, 0.0), (0.4, 0.3), (0.35, -0.25), (1.5, 0.8)):
        robot.see(x, y)
        assert robot.ball["distance"] == pytest.approx(hypot(x, y), abs=4e-3)
        assert robot.ball["bearing"] == pytest.approx(atan2(y, x), abs=2e-3)


def square(robot: Watcher, size: int = 200, **frame: Any) -> Any:
    """Return the ball after a square blob in the middle of the picture, its sides `size` [px]."""
    return robot.look((size // 2, size // 2 - size, size // 2, size // 2 - size, 9999), **frame)


def test_ms09_the_range_is_read_from_the_table_of_sizes() -> None:
    robot = Watcher(infrared_override=False)
    for place, found in ((700, 1.25), (8191, 0.05)):
        robot.tables["ball_width"][0, place] = robot.tables["ball_height"][0, place] = found
    for size, found in ((700, 1.25), (20000, 0.05)):
        assert square(robot, size)["distance"] == pytest.approx(CAMERA_AHEAD + found, abs=1e-6)
    for size in (0, 1, 255, 256, 20000):
        assert np.isfinite(square(robot, size)["distance"]) and robot.ball["confidence"] == 100.0


def test_ms10_almost_under_the_head_the_range_is_height_by_angle() -> None:
    """MS10: 60 degrees down a wrong size does not matter, height / tan(60 degrees) is the range; 55 are needed."""
    tilt = -radians(60.0)
    on, off = Watcher(infrared_override=False), Watcher(under_head=False, infrared_override=False)
    for robot in (on, off):
        robot.head = 0.0, tilt
        square(robot)  # so small a ball would be 2 m away
    camera = 0.075 + 0.0666 * cos(tilt) - 0.048 * sin(tilt)
    expected = camera + (camera_height(tilt) - RADIUS) / tan(radians(60.0))
    assert on.ball["distance"] == pytest.approx(expected, abs=1e-6)
    assert off.ball["distance"] > 1.5
    for degrees, near in ((54.0, False), (56.0, True)):
        on.head = 0.0, -radians(degrees)
        assert (square(on)["distance"] < 0.5) == near


def test_ms10_a_ball_straight_below_the_camera_or_behind_it_is_placed() -> None:
    robot = Watcher(infrared_override=False)
    robot.head = 0.0, -radians(82.0)
    camera, _, height = camera_place(*robot.head, robot.sensors[0])
    robot.look((10, -10, -709, -729, 400))  # 8 degrees below the axis
    assert robot.ball["distance"] == pytest.approx(camera, abs=1e-3)
    robot.look((10, -10, -1350, -1370, 400))
    elevation = direction_of_pixel(0.0, -1360.0, *robot.head, robot.sensors[0])[1]
    assert robot.ball["distance"] == pytest.approx(camera - (height - RADIUS) / tan(-elevation), abs=1e-6)


@pytest.mark.parametrize(("share", "cut", "whole"), [((0.4, 1.0), "width", "height"), ((1.0, 0.4), "height", "width")])
def test_ms11_a_ball_cut_in_one_dimension_keeps_its_range(share: tuple[float, float], cut: str, whole: str) -> None:
    """MS11: the closer of the ranges by height and by width; cut to half in both, it seems twice as far away."""

    def seen(size: str, share: tuple[float, float]) -> float:
        robot = Watcher(ball_size=size, infrared_override=False)
        return float(robot.look(robot.blob(0.7, 0.0, share))["distance"])

    assert seen("closer", share) == pytest.approx(0.7, abs=0.01) and seen(whole, share) == pytest.approx(0.7, abs=0.01)
    assert seen(cut, share) > 1.2
    assert seen("closer", (0.5, 0.5)) == pytest.approx(0.7 + (0.7 - CAMERA_AHEAD), abs=0.02)


def look_at_hidden_ball(distance: float, share: float, reading: float = 0.0, **settings: Any) -> float:
    """Return the believed distance of a ball in the beam, of which a share of width and height shows."""
    robot = Watcher(**settings)
    camera, height = CAMERA_AHEAD, camera_height(-0.3)
    for _ in range(20):  # the tilt at which the axis meets the ball's centre
        tilt = atan2(RADIUS - height, distance - camera)
        camera, height = 0.075 + 0.0666 * cos(tilt) - 0.048 * sin(tilt), camera_height(tilt)
    robot.head = 0.0, tilt
    away = hypot(distance - camera, height - RADIUS)
    blob = robot.blob(distance, 0.0, (share, share))
    return float(robot.look(blob, infrared=reading if reading else away - RADIUS)["distance"])


def test_ms12_the_infrared_ranger_wins_over_the_size_of_a_hidden_ball() -> None:
    """MS12: a reading below two thirds of the range by size says so; one above, or none, changes nothing."""
    assert look_at_hidden_ball(0.5, 0.4) == pytest.approx(0.5, abs=2e-3)
    assert look_at_hidden_ball(0.5, 0.4, infrared_override=False) > 0.9
    camera_range, by_size = 0.9 - CAMERA_AHEAD, look_at_hidden_ball(0.9, 1.0, infrared_override=False)
    for reading in (0.7 * camera_range, 0.89):
        assert look_at_hidden_ball(0.9, 1.0, reading) == by_size
    assert look_at_hidden_ball(0.9, 1.0, 0.55 * camera_range) < 0.65
    assert Watcher().see(0.8, 0.0, infrared=0.0)["distance"] == pytest.approx(0.8, abs=2e-3)


@pytest.mark.parametrize("aside", [-1, 1])
def test_ms12_the_beam_must_be_on_the_ball(aside: int) -> None:
    """MS12: a reading beside the blob, "in the center of the camera image" or not, is of something else."""
    robot = Watcher()
    for degrees, wins in ((-0.1, True), (0.1, False), (2.5, False)):
        gap = round(robot.focal[0] * tan(radians(degrees)))
        left, right = (gap + 200, gap) if aside > 0 else (-gap, -gap - 200)
        robot.look((left, right, 100, -100, 9999), infrared=0.3)
        assert (robot.ball["distance"] < 0.6) == wins


def test_the_ranger_alone_measures_a_ball_in_full_view_and_meets_it_beside_its_middle_too() -> None:
    assert look_at_hidden_ball(0.5, 1.0, ball_range="infrared") == pytest.approx(0.5, abs=1e-3)
    assert look_at_hidden_ball(0.5, 1.0, 0.6, ball_range="infrared") > 0.7
    assert look_at_hidden_ball(0.5, 1.0, 0.6) == pytest.approx(0.5, abs=5e-3)
    robot = Watcher(ball_range="infrared")
    robot.head = 0.0, -0.33
    camera, _, height = camera_place(*robot.head, robot.sensors[0])
    x, y = 0.5, 0.025  # the axis passes the ball's centre by about 2.5 cm
    to_x, to_y, to_z = x - camera, y, RADIUS - height
    axis_x, axis_z = cos(-0.33), sin(-0.33)
    along = to_x * axis_x + to_z * axis_z
    off = to_x**2 + to_y**2 + to_z**2 - along**2
    assert 0.02**2 < off < RADIUS**2
    robot.see(x, y, infrared=along - sqrt(RADIUS**2 - off))
    assert (robot.ball["x"], robot.ball["y"]) == pytest.approx((x, y), abs=1e-3)


def test_ms13_what_lies_much_above_the_horizontal_is_no_ball() -> None:
    """MS13: 6 degrees above the horizontal is ignored, 4 are not, wherever in the picture; the next blob is taken."""

    def confidence(tilt: float, *blobs: tuple[int, ...], pan: float = 0.0, **settings: Any) -> float:
        robot = Watcher.coarse(**settings)
        robot.head = pan, radians(tilt)
        return float(robot.look(*blobs)["confidence"])

    middle = (4, -4, 4, -4, 64)
    assert confidence(6.0, middle) == 0.0 and confidence(4.0, middle) == 100.0
    assert confidence(6.0, middle, horizon=False) == 100.0
    assert confidence(-30.0, (4, -4, 34, 26, 64), pan=0.5) == 100.0  # high in the picture of a lowered head
    assert confidence(30.0, (4, -4, -4, -12, 64), pan=0.5) == 0.0
    robot = Watcher.coarse()
    robot.head = 0.0, radians(6.0)
    robot.look(middle, (3, -1, -24, -28, 16))  # 16 degrees below the horizontal
    assert robot.ball["confidence"] == 100.0
    assert robot.ball["distance"] == pytest.approx(1.68, abs=0.3)  # 4 px


SMALL = (2, -2, 2, 0, 8)  # [px] an orange patch: more than the small least area, less than the large one


@pytest.mark.parametrize(("double_area", "confidence"), [(True, 90.0), (False, 100.0)])
def test_ms14_after_a_near_sighting_a_small_patch_is_no_ball(double_area: bool, confidence: float) -> None:
    robot = Watcher.coarse(double_area=double_area, fading=160.0)
    robot.see(0.5, 0.0)
    assert robot.look(SMALL)["confidence"] == confidence


def test_ms14_after_a_far_sighting_or_a_long_time_it_is() -> None:
    """MS14: 0.8 m and a second make the difference; at 176x144 a patch has four times as many pixels as at 88x72."""
    robot = Watcher.coarse(fading=160.0)
    robot.see(1.2, 0.0)
    assert robot.look(SMALL)["confidence"] == 100.0
    robot = Watcher.coarse(odometry="none")
    robot.see(0.5, 0.0)
    for _ in range(16):
        assert robot.look(SMALL)["age"] > 0.0
    assert robot.look(SMALL)["age"] == 0.0
    for resolution, least in ((0, 1), (1, 2), (2, 8)):
        for area in (least - 1, least):
            robot = Watcher(resolution, area_small=2.0, area_large=12.0)
            seen = robot.look((1, -1, -1, -2, area))["confidence"] == 100.0
            assert seen == (area == least and area > 0)


def test_the_largest_blob_is_the_ball_whatever_the_order_and_angles_stay_in_a_turn() -> None:
    robot = Watcher.coarse()
    assert robot.look((12, 9, 0, -3, 9), (-20, -30, 5, -5, 100))["bearing"] < -0.2
    assert Watcher.coarse().look((0, 0, 0, 0, 0))["confidence"] == 0.0
    robot = Watcher()
    robot.head = pi / 2, -0.3
    assert square(robot)["bearing"] == pytest.approx(pi / 2, abs=0.1)
