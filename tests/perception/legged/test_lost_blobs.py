"""Blobs that are lost: whole players and single stickers that a frame misses, and regions that are too small."""

from math import pi

import numpy as np
import pytest

from soccer_env.perception.legged.sketch import OPPONENTS, TEAMMATES
from tests.perception.legged.staged_picture import Scene


def test_ms37_a_frame_that_misses_a_player_misses_all_its_stickers_and_nobody_elses() -> None:
    scene = Scene(1, robots=4, player_miss=0.3)
    scene.robots["team"][0, 1:] = [1, 1, 0]
    for r, bearing in ((1, 0.3), (2, -0.3), (3, 0.0)):
        scene.put(r, 1.2 * np.cos(bearing), 1.2 * np.sin(bearing), bearing + pi)
    whole = [scene.draw()[1][0, kind] for kind in (OPPONENTS, TEAMMATES)]
    assert whole == [6, 3]
    seen = []
    for _ in range(3000):
        percept = scene.look()[0, 0]
        foes, mates = (percept[name][percept[name]["area"] > 0] for name in ("opponents", "teammates"))
        left = (foes["right"] > 0).sum()
        seen.append((left, len(foes) - left, len(mates)))
    left, right, mates = np.transpose(seen)
    assert set(left) == set(right) == set(mates) == {0, 2}  # the chest, whose stickers touch from here, and the brow
    for here in (left, right, mates):
        assert (here > 0).mean() == pytest.approx(0.7, abs=0.03)
    both = ((left > 0) & (right > 0)).mean()
    assert both == pytest.approx(0.49, abs=0.03)  # one draw a player


def test_ms37_a_single_sticker_that_is_missed_leaves_one_of_its_height() -> None:
    scene = Scene(1, sticker_miss=0.3)
    scene.put(1, 1.0, 0.0, pi)
    blobs = [scene.look()[0, 0]["opponents"].copy() for _ in range(500)]
    heights = [int(blob["high"].max() - blob["low"].min()) for row in blobs if len(blob := row[row["high"] < 0]) == 1]
    assert len(heights) > 100 and set(heights) == {6}  # 5.5 cm at 75 cm


@pytest.mark.parametrize("resolution", ["88x72", "176x144"])
@pytest.mark.parametrize("kind", ["ball", "sticker", "landmark"])
def test_ms14_regions_below_the_least_area_are_dropped_whatever_their_colour(kind: str, resolution: str) -> None:
    finer = 4 if resolution == "176x144" else 1
    scene = Scene(60, robots=2, resolution=resolution, least_area=20.0)
    away = np.linspace(0.4, 2.6, 60)
    scene.put(0, -1.3, 0.0)
    if kind == "landmark":
        scene.put(0, 0.6 - 0.7 * away, 0.6)
    if kind == "ball":
        scene.put_ball(-1.3 + away, 0.0)
    if kind == "sticker":
        scene.put(1, -1.3 + away, 0.0, 0.5 * pi, tilt=-0.9)
    colour = {"ball": "ball", "sticker": "opponents", "landmark": "landmarks"}[kind]
    areas = scene.look()[:, 0][colour]["area"].astype(int)
    assert areas[areas > 0].min() >= 20 * finer
    with_all = Scene(60, robots=2, resolution=resolution, least_area=0.0)
    with_all.balls[:], with_all.robots[:] = scene.balls, scene.robots
    smallest = with_all.look()[:, 0][colour]["area"].astype(int)
    assert smallest[smallest > 0].min() < 20 * finer and (areas > 0).sum() < (smallest > 0).sum()


def test_ms14_the_stickers_of_a_head_are_lost_from_afar() -> None:
    """MS14: 5 x 3.5 cm are two pixels at 2.4 m from the camera."""
    scene = Scene(40)
    away = np.linspace(1.6, 3.2, 40)
    scene.put(0, -1.5, 0.0)
    scene.put(1, -1.5 + 0.142 + away - 0.11, 0.0, pi)
    blobs = scene.look()[:, 0]["opponents"]
    heads = ((blobs["area"] > 0) & (blobs["high"] > 0)).any(axis=1)
    assert heads[away < 1.9].all() and not heads[away > 3.0].any()
