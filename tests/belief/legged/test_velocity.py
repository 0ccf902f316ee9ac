"""How fast the ball seems to come, and how fast it rolls."""

from math import atan2, cos, hypot, sin

import numpy as np
import pytest

from soccer_env.belief.odometry import move_point
from tests.belief.legged.staged_ball import Watcher

SLOW = 0.01  # [m/s, rad/s] what a pixel of the fine camera makes of two readings


def roll(robot: Watcher, frames: int, x: float, y: float, vx: float, vy: float) -> None:
    """Show a ball that rolls past a standing robot, from x, y [m] with vx, vy [m/s]."""
    for _ in range(frames):
        robot.see(x, y)
        x, y = x + vx * robot.dt, y + vy * robot.dt


def readings(robot: Watcher, frames: int, vx: float) -> list[int]:
    """Return the frames in which the radial velocity of a ball changes that speeds up towards the robot."""
    changed, last, x = [], 0.0, 1.5
    for _ in range(frames):
        x += vx * robot.dt
        vx *= 1.005
        robot.see(x, 0.0)
        if robot.ball["radial"] != last:
            changed.append(robot.frame)
        last = robot.ball["radial"]
    return changed


def test_ms17_a_velocity_every_third_of_a_second() -> None:
    frames = readings(Watcher(), 161, -0.05)
    assert len(frames) == 29  # of 30 readings the first has none to compare with
    assert set(np.diff(frames)) == {5, 6}
    assert set(np.diff(readings(Watcher(velocity_interval=0.125), 40, -0.05))) == {2}
    assert set(np.diff(readings(Watcher(velocity_interval=0.0), 40, -0.05))) == {1}


def test_ms17_it_is_the_difference_of_places_by_the_time_between() -> None:
    robot = Watcher()
    for step in range(64):
        robot.see(1.5 - 0.2 * robot.dt * step, 0.0)
        if robot.frame > 16:  # whether 5 or 6 frames lie between them
            assert robot.ball["radial"] == pytest.approx(-0.2, abs=SLOW)


def stand_still(robot: Watcher, frames: int, missed: int = 0) -> None:
    """Show a ball that lies 1.2 m ahead for some frames, and none for some more."""
    for frame in range(frames + missed):
        robot.look(*([robot.blob(1.2, 0.0)] if frame < frames else []))


def after_a_gap(robot: Watcher, missed: int) -> float:
    """Return the radial velocity at the first reading after frames in which the ball was not seen.

    It is seen up to frame 16, the reading at 1 s, and lies 0.3 m nearer when it is found again.
    """
    stand_still(robot, 17, missed)
    robot.see(0.9, 0.0)
    while robot.memories["sampled"][0] == 16:  # to the next reading
        robot.see(0.9, 0.0)
    return float(robot.ball["radial"])


def test_ms17_after_more_than_a_second_and_a_half_the_place_is_only_stored() -> None:
    """MS17: 0.3 m in 1.4 s is a velocity, in 2 s it is none; 1.5 s after the last reading all velocities are 0."""
    assert after_a_gap(Watcher(), 17) == pytest.approx(-0.3 / (22 / 16), abs=SLOW)
    robot = Watcher()
    assert after_a_gap(robot, 31) == 0.0
    roll(robot, 12, 0.9, 0.0, -0.3, 0.0)
    assert robot.ball["radial"] < -0.2
    assert after_a_gap(Watcher(velocity_gate=False), 31) == pytest.approx(-0.15, abs=SLOW)
    robot = Watcher()
    roll(robot, 33, 1.2, 0.0, -0.3, 0.1)
    assert robot.ball["radial"] < -0.2 and robot.ball["vy"] > 0.05
    for _ in range(24):
        robot.miss()
    assert robot.ball["radial"] < -0.2
    for _ in range(5):
        robot.miss()
    assert [robot.ball[name] for name in ("radial", "angular", "vx", "vy")] == [0.0] * 4


@pytest.mark.parametrize(("seen", "missed", "sampled"), [(17, 0, 16), (17, 6, 16), (20, 3, 22)])
def test_ms17_a_ball_that_was_not_seen_for_a_third_of_a_second_gives_no_reading(seen, missed, sampled) -> None:
    """MS17: the reading at frame 22 is stored if the ball was seen 3 frames ago, and is not if it was 6 ago."""
    robot = Watcher()
    stand_still(robot, seen, missed)
    assert robot.memories["sampled"][0] == sampled


@pytest.mark.parametrize(("radial_from", "radial"), [(None, -0.015), ("raw", -0.06)])
@pytest.mark.parametrize(("angular_from", "angular"), [(None, 0.1), ("filtered", 0.025)])
def test_ms18_the_radial_velocity_is_of_the_filtered_place_the_angular_of_the_raw(
    radial_from: str | None, radial: float, angular_from: str | None, angular: float
) -> None:
    """MS18, footnote 4: one sighting in four moves the filtered place by a quarter, the raw one by all.

    The ball is seen 6 cm nearer and 0.1 rad farther left in the frame of a reading, 5 after the one before.
    """
    told = {"radial_from": radial_from, "angular_from": angular_from}
    robot = Watcher(**{name: source for name, source in told.items() if source})
    for _ in range(16):
        robot.see(1.0, 0.0)
    ball = robot.see(0.94 * cos(0.1), 0.94 * sin(0.1))
    assert (ball["radial"], ball["angular"]) == pytest.approx((radial * 16 / 5, angular * 16 / 5), abs=SLOW)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_ms18_a_bearing_that_passes_straight_behind_turns_by_the_short_way(side: float) -> None:
    """MS18: from 179 degrees left to 179 degrees right is a turn of 2 degrees; each reading says so."""
    robot, told = Watcher(), []
    for frame in range(17):
        put_sighting(robot, side * (2.9 + 0.5 * frame / 16))
        told.append(float(robot.ball["angular"]))
    assert told[6] == 0.0 and told[11:] == pytest.approx([side * 0.5] * 6, abs=SLOW)


def put_sighting(robot: Watcher, bearing: float) -> None:
    """Let the robot remember a ball half a metre away at a bearing, as if it had just seen it, for a frame."""
    robot.miss()
    memory = robot.memories
    memory["known"], memory["seen"] = 1, robot.frame + 1
    memory["x"], memory["y"] = 0.5 * cos(bearing), 0.5 * sin(bearing)


@pytest.mark.parametrize("walk", [(0.0075, 0.0, 0.0), (0.0, 0.005, 0.0), (0.0, 0.0, 0.05), (0.006, -0.003, -0.03)])
def test_a_still_ball_stands_still_over_the_ground_however_the_robot_walks(walk: tuple[float, float, float]) -> None:
    robot = Watcher()
    x, y = 1.2, 0.1
    for _ in range(40):
        x, y = move_point(x, y, *walk)
        robot.see(x, y, forward=walk[0], left=walk[1], turn=walk[2])
    assert (robot.ball["vx"], robot.ball["vy"]) == pytest.approx((0.0, 0.0), abs=SLOW)


def test_ms18_the_moving_robot_sees_it_come_and_turn_and_one_that_is_stuck_sees_it_stay() -> None:
    """MS18: feet that walk against an obstacle do not bring the ball nearer, whatever odometry says."""
    robot, x, y = Watcher(), 1.2, 0.0
    for _ in range(40):
        x, y = move_point(x, y, 0.0075, 0.0, 0.02)
        robot.see(x, y, forward=0.0075, turn=0.02)
    assert robot.ball["radial"] == pytest.approx(-0.12 * cos(robot.ball["bearing"]), abs=0.02)
    assert robot.ball["angular"] == pytest.approx(-0.02 * 16 + 0.12 * y / hypot(x, y) ** 2, abs=0.05)
    robot = Watcher()
    for _ in range(40):
        robot.see(0.8, 0.0, forward=0.0075)
    assert robot.ball["radial"] == pytest.approx(0.0, abs=SLOW)


@pytest.mark.parametrize("turn", [0.0, 0.03, -0.05])
def test_the_velocity_over_the_ground_is_in_the_axes_of_the_robot(turn: float) -> None:
    robot, x, y, heading, robot_x = Watcher(averaged=1), 1.0, 0.3, 0.0, 0.0
    for _ in range(33):
        heading += turn
        dx, dy = x - robot_x, y
        robot.see(cos(heading) * dx + sin(heading) * dy, cos(heading) * dy - sin(heading) * dx, turn=turn)
        x, y = x + 0.2 * robot.dt, y - 0.1 * robot.dt
    expected = cos(heading) * 0.2 - sin(heading) * 0.1, -cos(heading) * 0.1 - sin(heading) * 0.2
    assert (robot.ball["vx"], robot.ball["vy"]) == pytest.approx(expected, abs=0.015)
    robot.miss(turn=0.4)  # it goes on in the same direction of the ground
    now = atan2(robot.ball["vy"], robot.ball["vx"])
    assert now == pytest.approx(atan2(expected[1], expected[0]) - 0.4, abs=0.07)
