"""The jersey in the picture: what of it is seen from where, what a lowered head hides, and blobs that are lost."""

from math import pi
from typing import Any

import numpy as np
import pytest

from soccer_env.perception.legged.sketch import OPPONENTS, TEAMMATES
from tests.perception.legged.staged_picture import Scene

FRONT, SIDE, REAR = pi, 0.5 * pi, 0.0  # [rad] headings of a robot on the +x axis
FLANK, CHEST = 0.06, 0.055  # [m] heights of the stickers
FOCAL = 81.2  # [px] for heights, at 88x72
FOCAL_X = 80.0  # [px] for widths


def views(
    headings: np.ndarray, away: float = 1.0, tilt: Any = 0.0, look_at: bool = False, **sensors: float
) -> list[np.ndarray]:
    """Return the pieces of an opponent at each heading, its head at some tilts; the camera may look at its head."""
    scene = Scene(len(headings), **sensors)
    scene.put(1, away, 0.0, headings, tilt=tilt)
    if look_at:
        scene.look_at(0, away, 0.0, 0.15)
    pieces, found = scene.draw()
    return [row[:count] for row, count in zip(pieces[:, OPPONENTS], found[:, OPPONENTS], strict=True)]


def front_of_a_head(tilt: np.ndarray, **sensors: float) -> list[np.ndarray]:
    """Return the pieces of an opponent that faces the camera, its head at some tilts."""
    return views(np.full(len(tilt), FRONT), 0.5, tilt, True, **sensors)


def largest(pieces: np.ndarray) -> tuple[float, float]:
    """Return width and height [px] of the largest piece."""
    piece = pieces[pieces["area"].argmax()]
    return piece["left"] - piece["right"], piece["high"] - piece["low"]


def around(pieces: np.ndarray) -> tuple[float, float]:
    """Return width and height [px] of the box round all pieces."""
    return pieces["left"].max() - pieces["right"].min(), pieces["high"].max() - pieces["low"].min()


@pytest.mark.parametrize("size", [largest, around])
def test_ms37_the_width_of_a_jersey_depends_on_the_view_and_its_height_hardly_does(size) -> None:  # type: ignore[no-untyped-def]
    seen = views(np.linspace(0.0, 2.0 * pi, 360, endpoint=False), away=1.5)
    width, height = np.transpose([size(pieces) for pieces in seen])
    assert height.std() / height.mean() < 0.08
    assert width.std() / width.mean() > 2.0 * height.std() / height.mean()


@pytest.mark.parametrize(("heading", "pan", "stickers"), [
    (FRONT, 0.0, 3), (REAR, 0.0, 3), (FRONT + 0.8, 0.0, 6), (FRONT, 0.7, 4), (SIDE, -0.7, 4),
])  # fmt: skip
def test_ms37_several_stickers_are_seen_and_only_those_that_face_the_camera(heading, pan, stickers) -> None:
    scene = Scene(1)
    scene.put(1, 1.0, 0.0, heading, pan)
    assert scene.draw()[1][0, OPPONENTS] == stickers


@pytest.mark.parametrize(
    ("heading", "apart", "side"), [(FRONT, 0.05, 0.105), (REAR, 0.05, 0.1245), (SIDE, 0.119, 0.0792)]
)
def test_ms37_each_side_of_the_trunk_has_two_stickers_of_one_height(heading: float, apart: float, side: float) -> None:
    pieces = views(np.array([heading]), away=1.2)[0]
    trunk = pieces[pieces["high"] < 0.0]
    middles = 0.5 * (trunk["left"] + trunk["right"])
    depth = 1.2 - 0.142 - side
    assert len(trunk) == 2
    assert abs(middles[0] - middles[1]) == pytest.approx(apart * FOCAL_X / depth, rel=0.01)
    assert np.ptp(trunk["high"] - trunk["low"]) < 0.01
    assert len(views(np.array([heading]), away=1.2, trunk_stickers=1)[0]) == len(pieces) - 1


def test_ms37_a_player_appears_slightly_smaller_head_on() -> None:
    plain, large = (views(np.array([FRONT + 0.6]), jersey=jersey)[0] for jersey in (1.0, 1.3))
    assert large["high"] - large["low"] == pytest.approx(1.3 * (plain["high"] - plain["low"]), rel=0.03)
    assert large["area"] == pytest.approx(1.69 * plain["area"], rel=0.03)
    front, side = (largest(pieces)[1] for pieces in views(np.array([FRONT, SIDE])))
    # Distances of chest and flank from the camera, 0.142 m ahead of the own origin, 0.203 m high.
    assert front == pytest.approx(CHEST * FOCAL / (1.0 - 0.142 - 0.105), rel=0.01)
    assert side == pytest.approx(FLANK * FOCAL / (1.0 - 0.142 - 0.0775), rel=0.01)
    assert 0.85 < front / side < 1.0


def test_ms37_without_its_head_stickers_a_player_is_half_as_high() -> None:
    pieces = views(np.array([FRONT, SIDE]), away=1.5)
    for row in pieces:
        trunk = row[row["high"] < 0.0]  # below the height of the camera
        assert len(trunk) < len(row) and around(trunk)[1] / around(row)[1] == pytest.approx(0.4, abs=0.05)


def test_team_mates_and_opponents_are_told_apart() -> None:
    scene = Scene(1, robots=3)
    scene.put(1, 1.0, 0.3, FRONT)
    scene.put(2, 1.0, -0.3, FRONT)
    percept = scene.look()[0, 0]
    assert percept["opponents"]["right"][0] > 0 > percept["teammates"]["left"][0]
    assert scene.draw()[1][0, TEAMMATES] >= 2


def test_ms50_a_lowered_head_hides_a_part_of_the_jersey() -> None:
    up, level, down = front_of_a_head(np.array([0.2, 0.0, -0.6]))
    assert len(up) == len(level) == 3 and len(down) == 2  # chest and brow; chest alone
    chest, part = (largest(row)[1] for row in (level, down))
    assert 0.2 * chest < part < 0.6 * chest  # it looks "much farther than it actually was"
    assert largest(up)[1] == pytest.approx(chest, rel=0.05)
    seen = front_of_a_head(np.radians([-29.0, -31.0]))
    assert [len(row) for row in seen] == [3, 2]
    low = front_of_a_head(np.radians([-31.0]), head_down=np.radians(60.0))[0]
    assert len(low) == 3 and largest(low)[1] > largest(seen[1])[1]


def test_ms50_from_the_side_a_lowered_head_hides_its_own_stickers_alone() -> None:
    scene = Scene(2)
    scene.put(1, 0.9, 0.0, SIDE, tilt=[0.0, -0.9])
    pieces, found = scene.draw()
    assert found[0, OPPONENTS] > 2 and found[1, OPPONENTS] == 2
    assert pieces[0, OPPONENTS, 0]["area"] == pytest.approx(pieces[1, OPPONENTS, 0]["area"])


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
