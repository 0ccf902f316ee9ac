"""The jersey in the picture: what of it is seen from where, and what a lowered head hides."""

from math import pi

import numpy as np
import pytest

from soccer_env.perception.legged.sketch import OPPONENTS, TEAMMATES
from tests.perception.legged.staged_picture import Scene

FRONT, SIDE, REAR = pi, 0.5 * pi, 0.0  # [rad] headings of a robot on the +x axis
FLANK, CHEST = 0.06, 0.055  # [m] heights of the stickers
FOCAL = 81.2  # [px] for heights, at 88x72
FOCAL_X = 80.0  # [px] for widths


def views(headings: np.ndarray, away: float = 1.0, **sensors: float) -> list[np.ndarray]:
    """Return the pieces of an opponent at each heading."""
    scene = Scene(len(headings), **sensors)
    scene.put(1, away, 0.0, headings)
    pieces, found = scene.draw()
    return [row[:count] for row, count in zip(pieces[:, OPPONENTS], found[:, OPPONENTS], strict=True)]


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


def test_ms37_a_player_appears_slightly_smaller_head_on() -> None:
    front, side = (largest(pieces)[1] for pieces in views(np.array([FRONT, SIDE])))
    # Distances of chest and flank from the camera, 0.142 m ahead of the own origin, 0.203 m high.
    assert front == pytest.approx(CHEST * FOCAL / (1.0 - 0.142 - 0.105), rel=0.01)
    assert side == pytest.approx(FLANK * FOCAL / (1.0 - 0.142 - 0.0775), rel=0.01)
    assert 0.85 < front / side < 1.0


@pytest.mark.parametrize(("heading", "pan", "stickers"), [
    (FRONT, 0.0, 3), (REAR, 0.0, 3), (FRONT + 0.8, 0.0, 6), (FRONT, 0.7, 4), (SIDE, -0.7, 4),
])  # fmt: skip
def test_ms37_several_stickers_are_seen_and_only_those_that_face_the_camera(
    heading: float, pan: float, stickers: int
) -> None:
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


def test_ms37_the_scale_of_the_jersey_scales_all_stickers() -> None:
    plain, large = (views(np.array([FRONT + 0.6]), jersey=jersey)[0] for jersey in (1.0, 1.3))
    assert large["high"] - large["low"] == pytest.approx(1.3 * (plain["high"] - plain["low"]), rel=0.03)
    assert large["area"] == pytest.approx(1.69 * plain["area"], rel=0.03)


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


def front_of_a_head(tilt: np.ndarray, away: float = 0.5, **sensors: float) -> list[np.ndarray]:
    """Return the pieces of an opponent that faces the camera, its head at some tilts."""
    scene = Scene(len(tilt), **sensors)
    scene.put(1, away, 0.0, FRONT, tilt=tilt)
    scene.look_at(0, away, 0.0, 0.15)
    pieces, found = scene.draw()
    return [row[:count] for row, count in zip(pieces[:, OPPONENTS], found[:, OPPONENTS], strict=True)]


def test_ms50_a_lowered_head_hides_a_part_of_the_jersey() -> None:
    up, level, down = front_of_a_head(np.array([0.2, 0.0, -0.6]))
    assert len(up) == len(level) == 3 and len(down) == 2  # chest and brow; chest alone
    chest, part = (largest(row)[1] for row in (level, down))
    assert 0.2 * chest < part < 0.6 * chest  # it looks "much farther than it actually was"
    assert largest(up)[1] == pytest.approx(chest, rel=0.05)


def test_ms50_the_head_hides_stickers_from_a_set_angle_on() -> None:
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
