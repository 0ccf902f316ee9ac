"""Path following stays within the base's limits, ends at its target and keeps off others."""

from math import atan2, cos, hypot, pi, sin
from typing import Any

import numpy as np
import pytest

from soccer_env.baselines.heinemann_2006.driving import bend_between, bend_speed, drive_to, note_crowd, turn_limit
from soccer_env.baselines.heinemann_2006.memory import MEMORY, SCRATCH
from soccer_env.baselines.heinemann_2006.settings import HeinemannSettings, settings_of
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.types import COMMAND
from tests.scenes.staging import MIDDLE

K = constants_of(find_league(MIDDLE))[0]
OMNI, TOP, ACCELERATION, DT = 1, 2.6, 4.0, 0.02
Other = tuple[float, float, float, float]


def drive(others: list[Other], seconds: float = 6.0, target: tuple[float, float] = (3.0, 0.0), **changes: Any) -> Any:
    """Let a base without delay drive from (-3, 0) to a target, facing (0, 4); rows of x, y, vx, vy, heading, gap."""
    play = settings_of(HeinemannSettings(**changes))[OMNI]
    scratch, memory, command = np.zeros(1, SCRATCH)[0], np.zeros(1, MEMORY)[0], np.zeros(1, COMMAND)[0]
    sight = scratch["sight"]
    sight["pace"], sight["elapsed"], sight["ball_x"], sight["ball_y"] = 1.0, DT, 0.0, 40.0
    sight["others"], x, y, vx, vy, heading, rows = len(others), -3.0, 0.0, 0.0, 0.0, 0.0, []
    for step in range(round(seconds / DT)):
        t, gap = step * DT, np.inf
        for i, (ox, oy, ovx, ovy) in enumerate(others):
            sight["other_x"][i], sight["other_y"][i] = ox + t * ovx, oy + t * ovy
            sight["other_vx"][i], sight["other_vy"][i], sight["field"][i] = ovx, ovy, 1
            gap = min(gap, hypot(ox + t * ovx - x, oy + t * ovy - y))
        rows.append((x, y, vx, vy, heading, gap))
        for name, value in {"x": x, "y": y, "vx": vx, "vy": vy, "heading": heading}.items():
            sight[name] = value
        sight["cosine"], sight["sine"] = cos(heading), sin(heading)
        memory["drove"] = max(memory["drove"] - 1, 0)
        drive_to(command, memory, K, play, scratch, *target, atan2(4.0 - y, -x), 0.0)
        ahead, left = command["forward"] * TOP, command["left"] * TOP
        vx, vy = cos(heading) * ahead - sin(heading) * left, sin(heading) * ahead + cos(heading) * left
        x, y, heading = x + DT * vx, y + DT * vy, heading + DT * command["turn"] * 6.0
    return np.array(rows)


SCENES: dict[str, list[Other]] = {
    "alone": [],
    "one stands": [(0.0, 0.05, 0.0, 0.0)],
    "two stand": [(-0.5, 0.3, 0.0, 0.0), (0.7, -0.3, 0.0, 0.0)],
    "one crosses": [(0.0, -2.0, 0.0, 1.2)],
    "one comes": [(2.0, 0.1, -1.0, 0.0)],
}


@pytest.mark.parametrize("others", SCENES.values(), ids=SCENES)
def test_mh14_it_follows_the_plan_to_its_end_within_the_bases_limits(others: list[Other]) -> None:
    rows = drive(others)
    speeds = np.hypot(rows[:, 2], rows[:, 3])
    changes = np.hypot(*np.diff(rows[:, 2:4], axis=0).T) / DT
    assert speeds.max() <= TOP + 1e-9 and speeds.max() > 2.0
    assert changes.max() <= ACCELERATION + 1e-6
    assert hypot(rows[-1, 0] - 3.0, rows[-1, 1]) < 0.07 and speeds[-1] < 0.01
    assert rows[:, 5].min() > 2.0 * 0.287  # two reaches: they never touch


def test_mh14_every_decision_plans_anew_from_where_the_robot_is() -> None:
    play = settings_of(HeinemannSettings())[OMNI]
    scratch, memory, command = np.zeros(1, SCRATCH)[0], np.zeros(1, MEMORY)[0], np.zeros(1, COMMAND)[0]
    sight, plan, ways = scratch["sight"], scratch["plan"][0], []
    sight["pace"], sight["elapsed"], sight["cosine"], sight["ball_y"] = 1.0, DT, 1.0, 40.0
    for x, others in ((-3.0, 0), (-2.95, 0), (-2.9, 1)):
        sight["x"], sight["others"] = x, others  # at the origin, who comes into sight
        drive_to(command, memory, K, play, scratch, 3.0, 0.0, 0.0, 0.0)
        assert (plan["robot"]["x"], plan["path"]["x"][0]) == (x, x)
        assert plan["path"]["x"][plan["count"] - 1] == 3.0
        ways.append(np.abs(plan["path"]["y"][: plan["count"]]).max())
    assert ways[:2] == [0.0, 0.0] and ways[2] > 0.287  # straight on, and round it in the same decision


def test_mh01_what_it_looks_at_is_free_of_where_it_drives() -> None:
    rows = drive([])
    facing = np.arctan2(4.0 - rows[-1, 1], -rows[-1, 0])
    assert rows[-1, 4] == pytest.approx(facing, abs=0.02)
    turns, speeds = np.diff(rows[:, 4]) / DT, np.hypot(rows[1:, 2], rows[1:, 3])
    assert np.abs(turns * speeds).max() <= 0.4 * ACCELERATION + 1e-6


def test_alone_it_drives_straight_in_the_time_that_acceleration_and_braking_take() -> None:
    rows = drive([])
    assert np.abs(rows[:, 1]).max() < 1e-9
    there = np.flatnonzero(np.abs(rows[:, 0] - 3.0) < 0.1)[0] * DT
    least = 6.0 / TOP + TOP / ACCELERATION - (2.0 * 0.1 / ACCELERATION) ** 0.5  # [s] to 0.1 m before the end
    assert least < there < least + 0.5


def test_mh15_whoever_moves_is_passed_behind_and_a_static_planner_does_not_know() -> None:
    crossing: list[Other] = [(0.0, -2.0, 0.0, 1.2)]
    ways = {name: drive(crossing, planner=name) for name in ("time_variant", "static")}
    ahead = {}
    for name, rows in ways.items():
        step = np.argmin(np.abs(rows[:, 0]))  # where it crosses the other's way
        ahead[name] = rows[step, 1] - (-2.0 + 1.2 * DT * step)
    assert ahead["time_variant"] < -2.0 * 0.287 and ahead["static"] > 0.0  # static: in front of it, where it goes
    unknowing = drive(crossing, velocity=False)
    np.testing.assert_array_equal(unknowing, ways["static"])  # H16: with no velocities it is the baseline


CROWD = [(-2.0 + 0.9 * (i % 6), -2.5 + 1.5 * (i // 6), 0.0, 0.0) for i in range(22)]
HARD: dict[str, tuple[list[Other], tuple[float, float], float]] = {  # others, target, where it may end [m] from that
    "a target inside an obstacle": ([(3.0, 0.0, 0.0, 0.0)], (3.0, 0.0), 0.8),
    "a target under the robot": ([(-2.0, 0.0, 0.0, 0.0)], (-3.0, 0.0), 0.0),
    "a target outside the field": ([], (9.0, 0.0), 2.51),
    "22 obstacles": (CROWD, (4.0, 0.3), 0.07),
    "an obstacle at 5 m/s": ([(0.0, -5.5, 0.0, 5.0)], (3.0, 0.0), 0.07),
    "it comes at 5 m/s": ([(5.5, 0.0, -5.0, 0.0)], (3.0, 0.0), 0.07),
}


@pytest.mark.parametrize("scene", HARD)
def test_whatever_is_in_the_way_it_comes_as_near_as_it_can_and_touches_nobody(scene: str) -> None:
    others, target, near = HARD[scene]
    rows = drive(others, 8.0, target)
    assert np.isfinite(rows[:, :5]).all()
    assert hypot(rows[-1, 0] - target[0], rows[-1, 1] - target[1]) <= near
    assert rows[:, 5].min() > 2.0 * 0.287


def test_a_mirrored_scene_is_driven_in_the_mirror() -> None:
    others: list[Other] = [(-0.5, 0.3, 0.2, 0.1), (0.7, -0.4, 0.0, 0.5)]
    image = [(x, -y, vx, -vy) for x, y, vx, vy in others]
    rows, mirrored = drive(others, 2.0, (3.0, 1.0))[:, :4], drive(image, 2.0, (3.0, -1.0))[:, :4]
    # the facing is not mirrored: only the way is compared
    np.testing.assert_allclose(mirrored * [1, -1, 1, -1], rows, atol=1e-9)


def test_bends_and_turns_are_as_fast_as_their_share_of_the_acceleration() -> None:
    play = settings_of(HeinemannSettings(bending=0.5, turning=0.25))[OMNI]
    assert bend_between(1.0, 0.0, 0.0, 2.0) == pytest.approx(pi / 2)
    assert bend_between(1.0, 0.0, 0.0, 0.0) == 0.0
    assert bend_speed(K, play, 0.5, 1.0) == pytest.approx((0.5 * ACCELERATION * 2.0) ** 0.5)  # r = 1 / 0.5
    assert turn_limit(K, play, 2.0) == pytest.approx(0.5)


def test_mh25_an_obstacle_is_no_faster_than_robots_are() -> None:
    scratch = np.zeros(1, SCRATCH)[0]
    sight = scratch["sight"]
    sight["others"], sight["ball_x"] = 3, 9.0
    sight["other_vx"][:3], sight["other_vy"][:3] = (3.0, 30.0, 0.0), (4.0, 40.0, 0.0)
    sight["field"][:3], sight["other_x"][2] = 1, 8.8
    note_crowd(scratch, K, settings_of(HeinemannSettings())[OMNI], True)
    assert scratch["count"] == 2  # the third has the ball that is fought for
    crowd = scratch["crowd"]
    np.testing.assert_allclose(crowd["vx"][:2], (3.0, 3.0))
    np.testing.assert_allclose(crowd["vy"][:2], (4.0, 4.0))
    note_crowd(scratch, K, settings_of(HeinemannSettings(velocity=False))[OMNI], False)
    assert scratch["count"] == 3 and not crowd["vx"][:3].any()
