"""What a legged robot makes of jersey-coloured blobs: which are stickers of one player, where it is, a slot for each.

+--+                +-----+
|B |- - - gap - - - |  A  |       one player if the gap is less than three times the size of A
+--+                +-----+
"""

import itertools
from math import atan2, cos, hypot, sin

import numpy as np
import pytest

from soccer_env.belief.legged.grouping import (
    blob_size,
    box_of_player,
    is_larger,
    largest_blob_of_player,
    largest_ungrouped_blob,
)
from soccer_env.belief.legged.surface import surface_distance
from soccer_env.belief.odometry import move_point
from soccer_env.optics.head_camera import camera_place, direction_of_pixel, focal_y
from soccer_env.records.percepts import BLOB, BLOBS
from tests.belief.legged import staged_players
from tests.belief.legged.staged_players import AHEAD, LEFT, RIGHT, STICKER_HEIGHT, Onlooker, full_blob, near, places

FOCAL = focal_y(Onlooker().sensors[0])


def away(robot: Onlooker, slot: int = 0) -> float:
    """Return the range from the camera to an opponent [m]."""
    track, (ahead, left, _) = robot.opponents[slot], camera_place(robot.pan, robot.tilt, robot.sensors[0])
    return hypot(track["x"] - ahead, track["y"] - left)


def test_ms28_all_players_of_both_teams_are_remembered() -> None:
    robot = Onlooker()
    for pan in (-1.2, 0.0, 1.2):
        robot.pan = pan
        foe = move_point(0.9, 0.0, 0.0, 0.0, -pan)
        robot.look([robot.show(*foe)], [] if pan == 0.0 else [robot.show(0.7 * foe[0], 0.7 * foe[1])])
    assert robot.opponents["present"].tolist() == [1, 1, 1] and robot.teammates["present"].tolist() == [1, 1]
    assert robot.tracks["teammate"].tolist() == [[1, 1, 0, 0, 0]]
    for slot, pan in enumerate((-1.2, 0.0, 1.2)):
        assert robot.opponents["bearing"][slot] == pytest.approx(pan, abs=0.05)
        assert robot.opponents["distance"][slot] == pytest.approx(0.9, abs=0.08)


def test_ms28_the_old_memory_knows_the_nearest_of_the_moment() -> None:
    robot = Onlooker(slots="nearest")
    robot.look([robot.show(*LEFT), robot.show(0.6, -0.1)], [robot.show(*AHEAD)])
    assert places(robot.opponents) == [near((0.6, -0.1))] and places(robot.teammates) == [near(AHEAD)]
    robot.look([robot.show(*LEFT)])
    assert places(robot.opponents) == [near(LEFT)] and robot.opponents["present"].tolist() == [1, 0, 0]
    assert places(robot.teammates) == [near(AHEAD)]


def test_several_players_in_one_view_take_several_slots_and_more_than_slots_drop_the_smallest() -> None:
    robot = Onlooker()
    for _ in range(30):
        robot.look([robot.show(*LEFT), robot.show(*RIGHT)])
    assert sorted(places(robot.opponents)) == [near(RIGHT), near(LEFT)]
    assert (robot.memories["teammates"], robot.memories["opponents"]) == (0, 2)
    robot = Onlooker(opponents=2)
    blobs = [full_blob(-30, 0, 4), full_blob(-10, 0, 6), full_blob(10, 0, 5), full_blob(30, 0, 7)]
    robot.settings["grouping"] = 0.5
    robot.look(blobs)
    assert robot.memories["opponents"][0] == 4
    assert sorted(robot.opponents["distance"]) == sorted(reference(robot, blob)[1] for blob in (blobs[3], blobs[1]))


def reference(robot: Onlooker, blob: staged_players.Blob) -> tuple[float, float]:
    """Return bearing and distance [rad, m] of the player of a blob, by head angles, pixel and the front table."""
    left, right, high, low, _ = blob
    bearing, _ = direction_of_pixel(0.5 * (left + right), 0.5 * (high + low), robot.pan, robot.tilt, robot.sensors[0])
    ahead, aside, _ = camera_place(robot.pan, robot.tilt, robot.sensors[0])
    found = FOCAL * STICKER_HEIGHT / (high - low)
    x, y = ahead + found * cos(bearing), aside + found * sin(bearing)
    return atan2(y, x), hypot(x, y)


@pytest.mark.parametrize(("pan", "tilt"), [(0.0, 0.0), (0.7, -0.3), (-1.5, 0.4)])
def test_a_player_lies_where_head_and_pixel_point_at_the_range_of_its_height(pan: float, tilt: float) -> None:
    robot = Onlooker()
    robot.pan, robot.tilt = pan, tilt
    blob = full_blob(-13.0, 6.0, 5, 9)
    robot.look([blob])
    bearing, distance = reference(robot, blob)
    track = robot.opponents[0]
    assert (track["bearing"], track["distance"]) == pytest.approx((bearing, distance), abs=1e-7)  # pan is single
    assert (track["x"], track["y"]) == pytest.approx((distance * cos(bearing), distance * sin(bearing)), abs=1e-7)
    assert [float(track[name]) for name in ("vx", "vy", "heading", "age", "confidence")] == [0, 0, 0, 0, 100]
    assert (track["number"], track["keeper"], track["teammate"]) == (-1, 0, 0)


@pytest.mark.parametrize("mode", ["largest", "combined"])
@pytest.mark.parametrize("view", ["front", "side"])
def test_ms33_ranges_come_from_the_height_table_of_a_view(view: str, mode: str) -> None:
    table = f"player_{view}" + ("_all" if mode == "combined" else "")
    for height, width in ((4, 4), (4, 12), (9, 3)):
        robot = Onlooker(player_view=view, player_blob=mode)
        robot.look([full_blob(0.0, 0.0, height, width)])
        assert away(robot) == pytest.approx(staged_players.FACTORS[table] * FOCAL * STICKER_HEIGHT / height)


def test_ms34_the_range_does_not_jump_when_head_stickers_vanish() -> None:
    """MS34: the box round all blobs shrinks, the largest blob does not."""
    chest, head = full_blob(0.0, 0.0, 6), full_blob(6.0, 8.0, 4)
    found = {}
    for mode in ("largest", "combined"):
        for stickers in ([chest, head], [chest]):
            robot = Onlooker(player_blob=mode)
            robot.look(stickers)
            found[mode, len(stickers)] = away(robot), float(robot.opponents["bearing"][0])
    assert found["largest", 2] == found["largest", 1]
    assert found["combined", 1][0] == pytest.approx(13 / 6 * found["combined", 2][0])
    assert found["combined", 2][1] > 0.02 > found["combined", 1][1]


def test_ms35_a_player_in_the_beam_is_as_far_as_the_infrared_says() -> None:
    """MS35: half a body behind the surface; from 40 cm on the size counts again."""
    robot = Onlooker()
    robot.tilt = -0.3
    by_size = FOCAL * STICKER_HEIGHT / 12
    for reading, expected in ((0.2, 0.2 * cos(0.3) + 0.105), (0.39, 0.39 * cos(0.3) + 0.105), (0.41, by_size)):
        robot.look([full_blob(0.0, 0.0, 12)], infrared=reading)
        assert away(robot) == pytest.approx(expected, abs=1e-6)
    robot.look([full_blob(0.0, 0.0, 12)], infrared=0.0)  # no reading
    assert away(robot) == pytest.approx(by_size)
    robot.settings["player_infrared"] = 0
    robot.look([full_blob(0.0, 0.0, 12)], infrared=0.2)
    assert away(robot) == pytest.approx(by_size)


def test_ms35_the_infrared_tells_of_nobody_beside_the_beam() -> None:
    """MS35: "if this player is centered": what is 6 px to either side is in the beam up to 6 px from the centre."""
    by_size, by_beam = FOCAL * STICKER_HEIGHT / 12, 0.3 + 0.105
    for u, v, expected in ((6, 0, by_beam), (7, 0, by_size), (-6, 0, by_beam), (0, 6, by_beam), (0, -7, by_size)):
        robot = Onlooker()
        robot.look([full_blob(u, v, 12)], infrared=0.3)
        assert away(robot) == pytest.approx(expected, abs=1e-6)
    robot = Onlooker(player_blob="combined")
    robot.look([full_blob(20.0, 0.0, 12), full_blob(-6.0, 0.0, 6)], infrared=0.3)  # the beam passes between
    assert away(robot) == pytest.approx(by_beam, abs=1e-6)


CAMERA, HALF = 0.142, 0.105  # [m] camera ahead of the body's middle; a chest before its own


@pytest.mark.parametrize("bearing", [0.0, 0.7, -1.5])
def test_a_player_is_as_far_as_its_chest_from_the_camera_and_never_nearer_than_nothing(bearing: float) -> None:
    k = Onlooker().constants[0]
    x, y = CAMERA + 0.8 * cos(bearing), 0.8 * sin(bearing)
    assert surface_distance(x, y, k) == pytest.approx(0.8 - HALF) and surface_distance(CAMERA + 0.05, 0.05, k) == 0.0


@pytest.mark.parametrize("reading", [0.15, 0.3, 0.39])
def test_ms35_the_reading_is_the_distance_to_the_surface(reading: float) -> None:
    """MS35: of a player that the ranger has placed the paper's own quantity, the reading, is left."""
    robot = Onlooker()
    robot.look([full_blob(0.0, 0.0, 12)], infrared=reading)
    track = robot.opponents[0]
    assert surface_distance(track["x"], track["y"], robot.constants[0]) == pytest.approx(reading, abs=1e-3)


def picture(*blobs: staged_players.Blob) -> np.ndarray:
    """Return the blobs of one colour."""
    found = np.zeros(BLOBS, BLOB)
    for i, blob in enumerate(blobs):
        found[i] = blob
    return found


def players(blobs: np.ndarray, grouping: float = 3.0) -> list[int]:
    """Return the player, by its largest blob, that each blob belongs to."""
    return [int(largest_blob_of_player(blobs, i, grouping)) for i in range(BLOBS) if blobs["area"][i]]


def box(blobs: np.ndarray, i: int, **settings: str) -> tuple[int, ...]:
    """Return left, right, high, low of the box that stands for a player."""
    return tuple(box_of_player(blobs, i, staged_players.LEAGUE.memory.changed(settings).record()[0]))


def test_ms29_blobs_nearer_than_three_sizes_of_the_larger_are_one_player() -> None:
    """MS29: the gap has to be less than 3 x 10 px; factor 0 makes a player of every blob, 1 misses what 3 joins."""
    large = full_blob(0.0, 0.0, 10)
    for aside in ((29.0, 0.0), (0.0, -29.0)):
        assert players(picture(large, full_blob(*aside, 4))) == [0, 0]
    assert players(picture(large, full_blob(30.0, 0.0, 4))) == [0, 1]
    assert players(picture(large, full_blob(-18.0, 24.0, 4))) == [0, 1]  # 30 px along the diagonal
    blobs = picture(large, full_blob(18.0, 0.0, 4))
    assert players(blobs, 0.0) == players(blobs, 1.0) == [0, 1]
    assert players(blobs, 2.0) == players(blobs, 6.0) == [0, 0]


def test_ms29_size_is_the_mean_of_width_and_height() -> None:
    """MS29, footnote 6: twice as near, everything is twice as large, and players are the same; areas do not count."""
    assert blob_size(picture(full_blob(height=8, width=4))[0]) == 6.0
    near, far = (
        picture(full_blob(0, 0, 4 * n), full_blob(11 * n, 0, 2 * n), full_blob(-13 * n, 0, 2 * n)) for n in (4, 1)
    )
    assert players(near) == players(far) == [0, 0, 2]  # by area the near one would be all one player
    thin, square = full_blob(0.0, 0.0, 4, 40), full_blob(60.0, 0.0, 14)
    assert thin[4] < square[4]
    assert players(picture(square, thin)) == [1, 1]  # 60 < 3 x 22


def test_ms29_a_blob_joins_the_player_of_any_larger_blob() -> None:
    """MS29: each is near the next larger one alone; so a player behind another is taken for part of it."""
    chain = [full_blob(0.0, 0.0, 10), full_blob(25.0, 0.0, 8), full_blob(45.0, 0.0, 6), full_blob(60.0, 0.0, 4)]
    for order in itertools.permutations(range(4)):
        blobs = picture(*(chain[i] for i in order))
        assert players(blobs) == [order.index(0)] * 4
    assert players(picture(chain[0], chain[2])) == [0, 1]  # without the link


def test_players_come_largest_first_with_ties_in_the_order_of_the_vision_and_blobs_of_no_size_are_somebodys() -> None:
    blobs = picture(full_blob(0, 0, 5), full_blob(40, 0, 9), full_blob(-40, 0, 5, 5), full_blob(-10, 0, 6))
    order, done = [], 0
    while (i := largest_ungrouped_blob(blobs, done)) >= 0:
        order.append(i)
        done |= 1 << i
    assert order == [1, 3, 0, 2]
    assert is_larger(blobs, 0, 2) and not is_larger(blobs, 2, 0) and not is_larger(blobs, 0, 0)
    blobs["area"][2] += 1
    assert is_larger(blobs, 2, 0)
    blobs = picture(full_blob(0, 0, 0), full_blob(0, 0, 0), full_blob(2, 0, 0), full_blob(20, 0, 0))
    blobs["area"] = 1
    assert players(blobs) == [0, 0, 0, 3]
    assert largest_ungrouped_blob(picture(), 0) == -1


def test_ms34_the_largest_blob_alone_stands_for_a_player() -> None:
    chest, head, other = full_blob(0.0, 0.0, 10), full_blob(12.0, 14.0, 4), full_blob(-40.0, 0.0, 6)
    blobs = picture(chest, other, head)
    assert box(blobs, 0) == chest[:4]
    assert box(blobs, 0, player_blob="combined") == (head[0], chest[1], head[2], chest[3])
    assert box(blobs, 1) == box(blobs, 1, player_blob="combined") == other[:4]
