"""What the vision makes of a picture: four blobs of each colour, noise, misses, mergers, and what is no ball."""

from math import pi

import numpy as np
import pytest

from soccer_env.perception.legged.sketch import BALL, OPPONENTS, PATCHES
from tests.perception.legged.staged_picture import Scene

COLOURS = ("ball", "teammates", "opponents", "own_goal", "opponent_goal")


def arc(robots: int, away: float = 1.2, **sensors: float) -> Scene:
    """Return a scene with opponents side by side before robot 0, each farther away than the one before."""
    scene = Scene(1, robots, **sensors)
    scene.robots["team"][:, 1:] = 1
    for r in range(1, robots):
        angle = 0.42 * (1.0 - 2.0 * (r - 1) / max(robots - 2, 1)) if robots > 2 else 0.0
        reach = away + 0.2 * r
        scene.put(r, reach * np.cos(angle), reach * np.sin(angle), angle + pi)
    return scene


def test_ms04_four_largest_blobs_of_each_colour_largest_first() -> None:
    scene = arc(4, away=0.7, jersey=0.8)  # small stickers do not touch
    scene.robots["heading"][0, 1:] += 0.9  # oblique: chest and flank of each, and the head's stickers
    found = scene.draw()[1][0, OPPONENTS]
    assert found > 4
    areas = scene.look()["opponents"]["area"][0, 0].astype(int)
    assert (areas > 0).all() and (np.diff(areas) <= 0).all()
    pieces = np.sort(scene.draw()[0]["area"][0, OPPONENTS, :found])[::-1]
    assert areas == pytest.approx(pieces[:4], rel=0.35)  # whole pixels
    assert areas[3] > 0.65 * pieces[4]


def test_ms04_fewer_blobs_leave_the_rest_empty() -> None:
    scene = Scene(1)
    scene.put_ball(0.8, 0.0)
    for _ in range(2):
        ball = scene.look()["ball"][0, 0]
        assert ball["area"][0] > 20 and ball[1:].tobytes() == bytes(3 * ball.itemsize)
    scene.put_ball(-0.8, 0.0)
    assert scene.look()["ball"][0, 0].tobytes() == bytes(4 * ball.itemsize)


def test_blobs_are_whole_pixels_of_the_right_size() -> None:
    scene = Scene(60)
    scene.put_ball(np.linspace(0.4, 2.0, 60), 0.0)
    scene.look_at(0, scene.balls["x"], 0.0, 0.05)
    pieces, blobs = scene.draw()[0][:, BALL, 0], scene.look()["ball"][:, 0, 0]
    for one, other in (("left", "right"), ("high", "low")):
        true, counted = pieces[one] - pieces[other], blobs[one].astype(int) - blobs[other]
        assert abs(counted - true).max() <= 0.5 + 1e-9
        middle, seen = 0.5 * (pieces[one] + pieces[other]), 0.5 * (blobs[one].astype(int) + blobs[other])
        assert abs(seen - middle).max() <= 0.5 + 1e-9
    box = (blobs["left"].astype(int) - blobs["right"]) * (blobs["high"].astype(int) - blobs["low"])
    assert blobs["area"] / box == pytest.approx(pi / 4, abs=0.05)


def test_dither_flickers_by_its_deviation_and_not_on_average_by_a_bell_curve_that_is_nearly_normal() -> None:
    scene = Scene(1, dither=0.45)
    scene.put_ball(0.7, 0.02)
    piece = scene.draw()[0][0, BALL, 0]
    frames = np.array([scene.look()["ball"][0, 0, 0].copy() for _ in range(4000)])
    width, height = frames["left"].astype(float) - frames["right"], frames["high"].astype(float) - frames["low"]
    spread = np.sqrt(0.45**2 + 1 / 12)  # of the flicker and of whole pixels
    for sizes, true in ((width, piece["left"] - piece["right"]), (height, piece["high"] - piece["low"])):
        assert sizes.mean() == pytest.approx(true, abs=0.03)
        assert sizes.std() == pytest.approx(spread, rel=0.06)
    middles, middle = 0.5 * (frames["left"] + frames["right"]), 0.5 * (piece["left"] + piece["right"])
    assert middles.mean() == pytest.approx(middle, abs=0.03)
    assert abs(np.corrcoef(width, height)[0, 1]) < 0.06


def test_the_scale_of_sizes_is_drawn_once_for_each_robot() -> None:
    scene = Scene(1500, scale_error=0.03)
    scene.put_ball(0.45, 0.0)
    scene.look_at(0, 0.45, 0.0)
    scene.look()
    first = scene.states["scale"][:, 0].copy()
    assert (first.mean(), first.std()) == pytest.approx((1.0, 0.03), abs=0.003)
    blob = scene.look(3)["ball"][:, 0, 0]
    assert (scene.states["scale"][:, 0] == first).all()
    width = blob["left"].astype(float) - blob["right"]
    assert np.corrcoef(width, first)[0, 1] > 0.8


@pytest.mark.parametrize("name", ["ball", "player", "sticker", "landmark"])
def test_frames_miss_their_share_of_each_kind(name: str) -> None:
    scene = Scene(1, **{f"{name}_miss": 0.3})
    scene.put_ball(0.8, 0.15)
    scene.put(1, 1.0, -0.2, pi)
    scene.robots["pan"][0, 0] = 0.15
    seen = {colour: 0 for colour in (*COLOURS, "landmarks")}
    for _ in range(2000):
        percept = scene.look()[0, 0]
        for colour in seen:
            seen[colour] += int((percept[colour]["area"] > 0).any())
    kinds = {"ball": ["ball"], "player": ["opponents"], "sticker": [], "landmark": ["opponent_goal", "landmarks"]}
    missed = kinds[name]
    stickers = scene.draw()[1][0, OPPONENTS]
    for colour in ("ball", "opponents", "opponent_goal", "landmarks"):
        expected = 1.0 - 0.3**stickers if (colour, name) == ("opponents", "sticker") else 1.0
        assert seen[colour] / 2000 == pytest.approx(0.7 if colour in missed else expected, abs=0.04)


@pytest.mark.parametrize(("jersey", "blobs"), [(1.0, 3), (2.0, 1)])
def test_stickers_that_touch_in_the_picture_are_one_blob(jersey: float, blobs: int) -> None:
    scene = Scene(1, jersey=jersey)
    scene.put(1, 1.0, -0.1, 0.5 * pi)  # flank and head from the side, 5 cm apart, or next to nothing
    pieces, found = scene.draw()
    *flank, head = pieces[0, OPPONENTS, : found[0, OPPONENTS]]
    seen = scene.look()["opponents"][0, 0]
    assert (seen["area"] > 0).sum() == blobs
    if blobs == 1:
        assert int(seen["high"][0]) - int(seen["low"][0]) == pytest.approx(head["high"] - flank[0]["low"], abs=0.6)
        assert seen["area"][0] == pytest.approx(sum(one["area"] for one in flank) + head["area"], rel=0.1)


def panorama(scene: Scene) -> np.ndarray:
    """Return the areas (M,) of all patches that robot 0 sees when it turns once round."""
    total = np.zeros(len(scene.matches))
    for heading in np.arange(0.0, 2.0 * pi, 0.1):
        scene.robots["heading"][:, 0] = heading
        total += scene.seen_area(PATCHES)
    return total


def test_patches_stand_off_the_field_at_places_of_the_match_above_the_boards_and_behind_bodies() -> None:
    scene = Scene(50, patches=2.0)
    total = panorama(scene)
    assert (total > 0.0).mean() > 0.9  # few stand above the picture wherever one looks
    assert (panorama(scene) == total).all()
    scene.matches["episode"] = 1
    assert (panorama(scene) != total).mean() > 0.9
    assert panorama(Scene(5)).max() == 0.0
    low = {"patches": 8.0, "patch_low": 0.03, "patch_high": 0.03, "patch_size": 0.05, "patch_away": 0.3}
    assert panorama(Scene(20, board_height=0.10, **low)).max() == 0.0  # behind the boards all of them
    assert panorama(Scene(20, board_height=0.0, **low)).min() > 0.0
    scene = Scene(60, patches=8.0, patch_low=0.3, patch_high=0.3)
    free = scene.seen_area(PATCHES)
    scene.put(1, 0.30, 0.0, 0.5 * pi, tilt=0.6)  # a head right before the camera
    assert (scene.seen_area(PATCHES) <= free).all() and scene.seen_area(PATCHES).sum() < free.sum()


def test_patches_do_not_move_from_frame_to_frame_nor_across_the_field() -> None:
    scene, sights = Scene(30, patches=4.0), []
    for x in (-0.5, 0.5):
        scene.put(0, x, 0.0)
        pieces, found = scene.draw()
        shown = [(m, piece) for m in range(30) for piece in pieces[m, PATCHES, : found[m, 5]]]
        sights.append([(m, 0.5 * (piece["left"] + piece["right"])) for m, piece in shown])
    before, after = ([u for m, u in sight if (np.array(sight)[:, 0] == m).sum() == 1] for sight in sights)
    assert len(before) > 5 and len(after) > 3
    scene.put(0, 0.5, 0.0)
    again = scene.draw()
    assert (again[1] == found).all() and (again[0] == pieces).all()


def test_stickers_show_orange_spots_in_their_share_of_frames() -> None:
    scene = Scene(1, red_as_orange=0.1)
    scene.put(1, 0.8, 0.0, pi)
    stickers = scene.draw()[1][0, OPPONENTS]
    frames = [scene.look()[0, 0].copy() for _ in range(3000)]
    spots = [frame["ball"].copy() for frame in frames if frame["ball"]["area"][0] > 0]
    assert stickers == 3 and len(spots) / 3000 == pytest.approx(1.0 - 0.9**3, abs=0.025)
    box = scene.draw()[0][0, OPPONENTS, :stickers]
    for spot in spots[:50]:
        assert spot["left"][0] <= box["left"].max() + 1.0 and spot["right"][0] >= box["right"].min() - 1.0
        assert spot["high"][0] <= box["high"].max() + 1.0 and spot["low"][0] >= box["low"].min() - 1.0
