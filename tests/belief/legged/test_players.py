"""What a legged robot makes of jersey-coloured blobs: players, their places, a slot for each."""

from math import atan2, cos, hypot, sin

import pytest

from soccer_env.belief.odometry import move_point
from soccer_env.optics.head_camera import camera_place, direction_of_pixel, focal_y
from tests.belief.legged.staged_players import (
    AHEAD,
    FACTORS,
    LEFT,
    RIGHT,
    STICKER_HEIGHT,
    Blob,
    Onlooker,
    near,
    places,
    player,
)

FOCAL = focal_y(Onlooker().sensors[0])


def away(robot: Onlooker, slot: int = 0) -> float:
    """Return the range from the camera to an opponent [m]."""
    track, (ahead, left, _) = robot.opponents[slot], camera_place(robot.pan, robot.tilt, robot.sensors[0])
    return hypot(track["x"] - ahead, track["y"] - left)


# Slots


def test_ms28_all_players_of_both_teams_are_remembered() -> None:
    """MS28: three foes and two pals, in slots of their own; each seen in another direction of the head."""
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
    """MS28: in the first slot, whoever was there before."""
    robot = Onlooker(slots="nearest")
    robot.look([robot.show(*LEFT), robot.show(0.6, -0.1)], [robot.show(*AHEAD)])
    assert places(robot.opponents) == [near((0.6, -0.1))] and places(robot.teammates) == [near(AHEAD)]
    robot.look([robot.show(*LEFT)])
    assert places(robot.opponents) == [near(LEFT)] and robot.opponents["present"].tolist() == [1, 0, 0]
    assert places(robot.teammates) == [near(AHEAD)]


def test_several_players_in_one_view_take_several_slots() -> None:
    robot = Onlooker()
    for _ in range(30):
        robot.look([robot.show(*LEFT), robot.show(*RIGHT)])
    assert sorted(places(robot.opponents)) == [near(RIGHT), near(LEFT)]
    assert (robot.memories["teammates"], robot.memories["opponents"]) == (0, 2)


def test_more_players_than_slots_drop_the_smallest() -> None:
    robot = Onlooker(opponents=2)
    blobs = [player(-30, 0, 4), player(-10, 0, 6), player(10, 0, 5), player(30, 0, 7)]
    robot.settings["grouping"] = 0.5
    robot.look(blobs)
    assert robot.memories["opponents"][0] == 4
    assert sorted(robot.opponents["distance"]) == sorted(reference(robot, blob)[1] for blob in (blobs[3], blobs[1]))


def reference(robot: Onlooker, blob: Blob) -> tuple[float, float]:
    """Return bearing and distance [rad, m] of the player of a blob, by head angles, pixel and the front table."""
    left, right, high, low, _ = blob
    bearing, _ = direction_of_pixel(0.5 * (left + right), 0.5 * (high + low), robot.pan, robot.tilt, robot.sensors[0])
    ahead, aside, _ = camera_place(robot.pan, robot.tilt, robot.sensors[0])
    found = FOCAL * STICKER_HEIGHT / (high - low)
    x, y = ahead + found * cos(bearing), aside + found * sin(bearing)
    return atan2(y, x), hypot(x, y)


@pytest.mark.parametrize(("teammates", "opponents"), [(1, 0), (0, 1), (11, 11)])
def test_any_number_of_slots_will_do(teammates: int, opponents: int) -> None:
    for slots in ("all", "nearest"):
        robot = Onlooker(teammates, opponents, slots=slots)
        for _ in range(3):
            robot.look([robot.show(*AHEAD)], [robot.show(*RIGHT)], forward=0.01, turn=0.1)
        assert len(places(robot.opponents)) == min(opponents, 1)
        assert len(places(robot.teammates)) == min(teammates, 1)


# Places


@pytest.mark.parametrize(("pan", "tilt"), [(0.0, 0.0), (0.7, -0.3), (-1.5, 0.4)])
def test_a_player_lies_where_head_and_pixel_point_at_the_range_of_its_height(pan: float, tilt: float) -> None:
    robot = Onlooker()
    robot.pan, robot.tilt = pan, tilt
    blob = player(-13.0, 6.0, 5, 9)
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
    """MS33: the width counts for nothing."""
    table = f"player_{view}" + ("_all" if mode == "combined" else "")
    for height, width in ((4, 4), (4, 12), (9, 3)):
        robot = Onlooker(player_view=view, player_blob=mode)
        robot.look([player(0.0, 0.0, height, width)])
        assert away(robot) == pytest.approx(FACTORS[table] * FOCAL * STICKER_HEIGHT / height)


def test_ms34_the_range_does_not_jump_when_head_stickers_vanish() -> None:
    """MS34: the box round all blobs shrinks, the largest blob does not."""
    chest, head = player(0.0, 0.0, 6), player(6.0, 8.0, 4)
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
        robot.look([player(0.0, 0.0, 12)], infrared=reading)
        assert away(robot) == pytest.approx(expected, abs=1e-6)
    robot.look([player(0.0, 0.0, 12)], infrared=0.0)  # no reading
    assert away(robot) == pytest.approx(by_size)
    robot.settings["player_infrared"] = 0
    robot.look([player(0.0, 0.0, 12)], infrared=0.2)
    assert away(robot) == pytest.approx(by_size)


def test_ms35_the_infrared_tells_of_nobody_beside_the_beam() -> None:
    """MS35: "if this player is centered": what is 6 px to either side is in the beam up to 6 px from the centre."""
    by_size, by_beam = FOCAL * STICKER_HEIGHT / 12, 0.3 + 0.105
    for u, v, expected in ((6, 0, by_beam), (7, 0, by_size), (-6, 0, by_beam), (0, 6, by_beam), (0, -7, by_size)):
        robot = Onlooker()
        robot.look([player(u, v, 12)], infrared=0.3)
        assert away(robot) == pytest.approx(expected, abs=1e-6)
    robot = Onlooker(player_blob="combined")
    robot.look([player(20.0, 0.0, 12), player(-6.0, 0.0, 6)], infrared=0.3)  # the beam passes between
    assert away(robot) == pytest.approx(by_beam, abs=1e-6)
