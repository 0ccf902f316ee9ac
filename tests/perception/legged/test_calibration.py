"""The tables from sizes to ranges are those of the pinhole, and give back where things are."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.optics.head_camera import camera_place
from soccer_env.perception.legged.calibration import CALIBRATION, calibrate
from soccer_env.perception.legged.sketch import BALL, OPPONENTS
from tests.perception.legged.staged_picture import Scene
from tests.scenes.staging import LEGGED

LEAGUE = find_league(LEGGED)
TABLES = calibrate(LEAGUE)
FOCAL_X, FOCAL_Y = 80.04, 81.24  # [px] at 88x72, from 57.6 x 47.8 degrees
RADIUS = 0.042  # [m] of the ball


def compare(name: str, sizes: np.ndarray, ranges: np.ndarray) -> None:
    """Compare the table with the ranges at which sizes [px], from large to small, were whole."""
    whole = np.arange(int(np.ceil(sizes[-1])), int(sizes[0]) + 1)
    assert len(whole) > 5
    assert TABLES[name][0, whole] == pytest.approx(np.interp(whole, sizes[::-1], ranges[::-1]), rel=0.02)


def test_ms09_the_range_of_a_ball_is_that_of_the_pinhole() -> None:
    for name, focal in (("ball_width", FOCAL_X), ("ball_height", FOCAL_Y)):
        for size in (3, 5, 8, 12, 20, 30):
            away = RADIUS / np.sin(np.arctan(0.5 * size / focal))  # along the line of sight
            range_, tilt = away, 0.0
            for _ in range(30):  # the camera looks down at the ball, which moves it
                drop = camera_place(0.0, tilt, LEAGUE.sensors.record().view(np.recarray)[0])[2] - RADIUS
                range_ = np.sqrt(away**2 - drop**2)
                tilt = -np.arctan2(drop, range_)
            assert TABLES[name][0, size] == pytest.approx(range_, rel=0.01)


def test_ms09_one_pixel_is_five_or_ten_centimetres_in_some_cases_and_ms33_the_front_view_errs_to_the_near_side():
    ranges = TABLES["ball_width"][0, 4:30]
    steps = -np.diff(ranges)
    middles = 0.5 * (ranges[1:] + ranges[:-1])
    assert np.interp(0.05, steps[::-1], middles[::-1]) == pytest.approx(0.58, abs=0.06)  # "5 or 10 cm in some cases"
    assert np.interp(0.10, steps[::-1], middles[::-1]) == pytest.approx(0.82, abs=0.08)
    far = TABLES["player_front"][0] > 0.45  # [m] nearer by, the chest is much nearer than the flank
    assert (TABLES["player_front"][0, far] < TABLES["player_side"][0, far]).all()
    assert TABLES["player_front"][0, 5] == pytest.approx(0.105 + 0.055 * FOCAL_Y / 5.0, rel=0.02)
    assert TABLES["player_side"][0, 5] == pytest.approx(0.0775 + 0.06 * FOCAL_Y / 5.0, rel=0.02)


def test_ms09_a_noiseless_ball_is_where_the_table_says() -> None:
    ranges = np.linspace(0.2, 2.9, 100)
    scene = Scene(100)
    scene.put_ball(1.0, 0.0)
    for _ in range(8):  # the head's tilt moves the camera
        eyes = np.array([scene.camera(m)[0] for m in range(100)])
        scene.put_ball(eyes + ranges, 0.0)
        scene.look_at(0, scene.balls["x"], 0.0, RADIUS)
    ball = scene.draw()[0][:, BALL, 0]
    compare("ball_width", ball["left"] - ball["right"], ranges)
    compare("ball_height", ball["high"] - ball["low"], ranges)


@pytest.mark.parametrize(("view", "heading"), [("front", pi), ("side", 0.5 * pi), ("side", -0.5 * pi)])
def test_ms33_a_noiseless_player_is_where_the_table_of_its_view_says(view: str, heading: float) -> None:
    ranges = np.linspace(0.6, 2.8, 300)
    scene = Scene(300)
    scene.put(1, ranges + 0.1416, 0.0, heading)  # the camera, head level, is 0.1416 m ahead
    pieces, found = scene.draw()
    rows = [row[:count] for row, count in zip(pieces[:, OPPONENTS], found[:, OPPONENTS], strict=True)]
    stickers = [row[row["area"].argmax()] for row in rows]
    compare(f"player_{view}", np.array([sticker["high"] - sticker["low"] for sticker in stickers]), ranges)
    compare(f"player_{view}_all", np.array([row["high"].max() - row["low"].min() for row in rows]), ranges)


@pytest.mark.parametrize("layer", ["44x36", "88x72", "176x144"])
@pytest.mark.parametrize("jersey", [0.7, 1.3])
def test_ranges_never_grow_with_the_size(layer: str, jersey: float) -> None:
    tables = changed(resolution=layer, jersey=jersey)
    for name in CALIBRATION.names or ():
        table = tables[name][0]
        assert np.isfinite(table).all() and (table > 0.0).all() and (np.diff(table) <= 0.0).all(), name


def changed(**settings: object) -> np.ndarray:
    """Return the tables of the league with other settings of its sensors."""
    return calibrate(replace(LEAGUE, sensors=LEAGUE.sensors.changed(settings)))


def test_a_league_is_calibrated_once_with_the_sizes_of_its_pixels_and_of_its_jersey() -> None:
    fine, large = changed(resolution="176x144"), changed(jersey=1.3)
    for name in CALIBRATION.names or ():
        assert fine[name][0, 8:60:2] == pytest.approx(TABLES[name][0, 4:30], rel=0.01), name
    for name in ("player_front", "player_side"):
        assert (large[name][0, 3:20] > 1.1 * TABLES[name][0, 3:20]).all()
    assert (large["ball_width"] == TABLES["ball_width"]).all()
    assert calibrate(LEAGUE) is calibrate(LEAGUE)
    assert np.isfinite(changed(jersey=0.0)["player_front"]).all()  # there is nothing to calibrate by
