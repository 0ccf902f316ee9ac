"""What a legged robot remembers of the ball: it fades, follows the robot's own motion, and is averaged."""

from math import atan2, hypot, inf, pi
from typing import Any

import numpy as np
import pytest

from soccer_env.belief.odometry import move_point
from soccer_env.records.percepts import LEGGED_PERCEPT, POSE_TOLD
from tests.belief.legged.staged_ball import LEAGUE, Watcher

NUMBERS = [name for name in ("distance", "bearing", "filtered_distance", "filtered_bearing", "x", "y", "vx", "vy",
                             "radial", "angular", "confidence")]  # fmt: skip
MILLIMETRES = 4e-3  # [m] what a pixel of the fine camera is worth at 1.5 m


def test_ms02_the_ball_is_kept_in_polar_coordinates_of_the_robot() -> None:
    robot = Watcher(averaged=1)
    robot.see(0.8, 0.0)
    assert (robot.ball["distance"], robot.ball["bearing"]) == pytest.approx((0.8, 0.0), abs=MILLIMETRES)
    robot.see(0.3, 0.4)
    assert (robot.ball["distance"], robot.ball["bearing"]) == pytest.approx((0.5, atan2(0.4, 0.3)), abs=MILLIMETRES)
    assert robot.ball["filtered_bearing"] == pytest.approx(robot.ball["bearing"], abs=1e-6)
    robot.see(0.3, -0.4)
    assert robot.ball["bearing"] < -0.9


def test_ms03_confidence_is_100_when_seen_and_fades_when_not() -> None:
    robot = Watcher()
    assert robot.see(0.8, 0.0)["confidence"] == 100.0
    for frame in range(1, 200):
        robot.miss()
        assert robot.ball["confidence"] == pytest.approx(max(100.0 - 10.0 * frame / 16, 0.0))
        assert robot.ball["age"] == pytest.approx(frame / 16)
    assert robot.see(0.8, 0.0)["confidence"] == 100.0 and robot.ball["age"] == 0.0
    robot = Watcher(fading=20.0)
    robot.see(0.8, 0.0)
    assert robot.miss(skip=10)["confidence"] == pytest.approx(100.0 - 20.0 * 10 / 16)


@pytest.mark.parametrize("body", [{"upright": 0}, {"active": 0}])
def test_a_robot_that_lies_down_or_is_sent_off_does_not_look(body: dict[str, int]) -> None:
    robot = Watcher()
    robot.see(0.8, 0.0)
    for frame in range(1, 33):
        ball = robot.see(0.4, 0.1, **body)
        assert ball["distance"] == pytest.approx(0.8, abs=MILLIMETRES)
        assert ball["confidence"] == pytest.approx(100.0 - 10.0 * frame / 16)


def test_a_robot_that_was_carried_forgets_the_ball_and_one_never_seen_is_somewhere_without_confidence() -> None:
    robot = Watcher()
    for _ in range(20):
        robot.see(0.8, 0.3, forward=0.01)
    robot.miss(pose=POSE_TOLD)
    assert robot.ball["confidence"] == 0.0 and robot.ball["age"] == inf
    assert (robot.ball["vx"], robot.ball["radial"], robot.ball["held"]) == (0.0, 0.0, 0)
    robot.see(0.6, 0.0, pose=POSE_TOLD)  # it may see the ball in the very same frame
    assert robot.filtered_place == pytest.approx((0.6, 0.0), abs=MILLIMETRES)
    assert robot.ball["confidence"] == 100.0
    robot = Watcher()
    for _ in range(16 * 180):  # three minutes
        robot.miss(forward=0.0075, left=-0.002, turn=0.05)
    for name in NUMBERS:
        assert np.isfinite(robot.ball[name])
    assert (robot.ball["confidence"], robot.ball["age"], robot.ball["held"]) == (0.0, inf, 0)
    assert (robot.ball["distance"], robot.ball["bearing"]) == (0.5 * LEAGUE.pitch.length, 0.0)


def walk(robot: Watcher, x: float, y: float, steps: int, forward: float, turn: float) -> tuple[float, float]:
    """Walk without seeing; return where a still ball that was at x, y is then, in the robot frame [m]."""
    for _ in range(steps):
        x, y = move_point(x, y, forward, 0.001, turn)
        robot.miss(forward=forward, left=0.001, turn=turn)
    return x, y


def test_ms15_a_still_ball_is_where_it_was_after_a_walk_out_of_sight() -> None:
    errors = {}
    for odometry in ("full", "rotation", "none"):
        robot = Watcher(odometry=odometry)
        robot.see(0.8, 0.2)
        x, y = walk(robot, *robot.place, 130, 0.0075, 0.006)
        errors[odometry] = hypot(robot.place[0] - x, robot.place[1] - y)
        if odometry == "rotation":
            assert robot.ball["distance"] == pytest.approx(hypot(0.8, 0.2), abs=MILLIMETRES)
            assert robot.ball["bearing"] == pytest.approx(atan2(0.2, 0.8) - 130 * 0.006, abs=MILLIMETRES)
        if odometry == "none":
            assert robot.place == pytest.approx((0.8, 0.2), abs=MILLIMETRES)
    assert errors["full"] < 1e-5 and errors["rotation"] > 0.3 and errors["none"] > 0.3


def test_ms15_after_a_whole_circle_the_ball_is_where_it_was() -> None:
    robot = Watcher()
    for y in (0.2, 0.25, 0.3):
        robot.see(0.8, y)
    raw, filtered = robot.place, robot.filtered_place
    walk(robot, 0.0, 0.0, 160, 0.01, 2.0 * pi / 160)
    assert robot.place == pytest.approx(raw, abs=1e-6)
    assert robot.filtered_place == pytest.approx(filtered, abs=1e-6)


def test_ms15_a_dribbled_ball_comes_along() -> None:
    for settings, ahead in (({}, 0.15), ({"odometry_while_dribbling": True}, 0.05)):
        robot = Watcher(**settings)
        robot.see(0.15, 0.01)
        for _ in range(10):
            robot.miss(forward=0.01)
        assert robot.place[0] == pytest.approx(ahead, abs=2e-3)


@pytest.mark.parametrize(("x", "y", "forward"), [(0.15, 0.0, -0.01), (0.24, 0.0, 0.01), (0.08, 0.12, 0.01)])
def test_ms15_other_balls_are_not_dribbled(x: float, y: float, forward: float) -> None:
    """MS15: none that the robot steps back from, none too far ahead, none aside, none that it no longer believes in."""
    robot, unsure = Watcher(), Watcher(fading=50.0)
    robot.see(x, y)
    before = robot.place
    robot.miss(forward=forward)
    assert robot.place == pytest.approx((before[0] - forward, before[1]), abs=1e-6)
    unsure.see(0.15, 0.0)
    for _ in range(80):
        unsure.miss(forward=0.01)
    assert unsure.place[0] == pytest.approx(0.15 - 0.01 * 49, abs=2e-3)


def test_ms16_the_filtered_place_is_the_mean_of_the_last_four_in_cartesian_coordinates() -> None:
    robot, off = Watcher(), Watcher(averaged=1)
    seen = [(0.3, 0.6), (0.3, -0.6), (0.5, 0.4), (0.5, -0.4), (1.0, 0.0)]
    raw = []
    for place in seen:
        robot.see(*place)
        off.see(*place)
        raw.append(robot.place)
        expected = np.mean(raw[-4:], axis=0)
        assert robot.filtered_place == pytest.approx(expected, abs=1e-6)
        assert (robot.ball["x"], robot.ball["y"]) == pytest.approx(expected, abs=1e-6)
        assert off.filtered_place == pytest.approx(off.place, abs=1e-6)
    assert robot.place == pytest.approx((1.0, 0.0), abs=MILLIMETRES)
    assert robot.ball["filtered_distance"] == pytest.approx(hypot(0.575, 0.15), abs=MILLIMETRES)


def test_ms16_sightings_are_averaged_where_they_are_now_and_never_with_stale_ones() -> None:
    """MS16: a robot that walks to a still ball averages no old distances; sightings of over a second ago drop out."""
    robot, still = Watcher(), Watcher(odometry="none")
    for step in range(20):
        for one in (robot, still):
            one.see(0.8 - 0.01 * step, 0.0, forward=0.01)
    assert robot.filtered_place == pytest.approx((0.61, 0.0), abs=1e-3)
    assert still.filtered_place == pytest.approx((0.625, 0.0), abs=1e-3)
    for pause, expected in ((8, 0.9), (18, 0.6)):
        robot = Watcher()
        for _ in range(4):
            robot.see(1.0, 0.0)
        for _ in range(pause):
            robot.miss()
        robot.see(0.6, 0.0)
        assert robot.filtered_place[0] == pytest.approx(expected, abs=MILLIMETRES)


@pytest.mark.parametrize(
    ("x", "y", "held"), [(0.147, 0.0, 1), (0.16, 0.03, 1), (0.12, -0.04, 1), (0.19, 0.0, 0), (0.147, 0.06, 0)]
)
def test_a_ball_between_the_paws_is_held(x: float, y: float, held: int) -> None:
    robot = Watcher()
    assert robot.see(x, y)["held"] == held
    for _ in range(8):
        assert robot.miss()["held"] == held
    assert robot.miss()["held"] == 0  # not seen there for half a second


def draw_stream(frames: int, seed: int) -> Any:
    """Yield percepts of a wild walk with up to four wild blobs in each frame."""
    rng = np.random.default_rng(seed)
    for frame in range(frames):
        percepts = np.zeros(1, LEGGED_PERCEPT)
        body, blobs = percepts["body"], percepts["ball"][0]
        body["frame"], body["handedness"] = frame, 1
        body["upright"], body["active"] = rng.random() < 0.95, rng.random() < 0.98
        body["pose"] = POSE_TOLD if rng.random() < 0.01 else 0
        body["forward"], body["left"], body["turn"] = rng.normal(0.0, [0.01, 0.01, 0.05]) * (rng.random() < 0.8)
        percepts["pan"], percepts["tilt"] = rng.uniform(-1.5, 1.5), rng.uniform(-1.4, 0.7)
        percepts["infrared"] = rng.uniform(0.1, 0.9) if rng.random() < 0.7 else 0.0
        for i in range(rng.integers(0, 5) if rng.random() < 0.8 else 0):
            left, high = rng.integers(-44, 45), rng.integers(-36, 37)
            wide, tall = rng.choice([0, 1, 2, 8, 60, 300], 2)
            blobs[i] = (left, left - wide, high, high - tall, rng.integers(0, 300))
        yield percepts


def test_no_stream_of_percepts_makes_a_number_that_is_none() -> None:
    robot = Watcher.coarse()
    for percepts in draw_stream(1500, 4):
        robot.believe(percepts)
        ball = robot.ball
        assert all(np.isfinite(ball[name]) for name in NUMBERS)
        assert 0.0 <= ball["confidence"] <= 100.0 and ball["distance"] < 20.0 and -pi <= ball["bearing"] <= pi
        assert robot.filtered_place == pytest.approx((ball["x"], ball["y"]), abs=1e-9)
    assert robot.memories.nbytes <= 124
