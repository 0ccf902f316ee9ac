"""From cell to cell: which is next, how long it takes, and until when obstacles are moved; the search's queue."""

from math import atan2, cos, hypot, pi, sin, sqrt
from typing import Any

import numpy as np
import pytest

from soccer_env.baselines.weigel_2001.planner import Plan, Planner, PlannerSettings
from soccer_env.baselines.weigel_2001.planner.planning import length_of, smooth
from soccer_env.baselines.weigel_2001.planner.records import NODE, POINT, SCRATCH
from soccer_env.baselines.weigel_2001.planner.searching import pop, push
from soccer_env.baselines.weigel_2001.planner.stepping import cell_of, next_cell, obstacle_time, step_length, step_time
from tests.scenes.planning import Scene, at_bearing, cup, random_scene, row

PLAY = PlannerSettings().record()[0]


def test_mh15_a_step_takes_38_or_54_milliseconds() -> None:
    """0.1 m and 2.6 m/s."""
    assert 1e3 * step_time(1, 0, PLAY) == pytest.approx(38.46, abs=0.01)
    assert 1e3 * step_time(-1, 1, PLAY) == pytest.approx(54.39, abs=0.01)
    assert step_length(0, 0, PLAY) == 0.0


@pytest.mark.parametrize("degrees", range(0, 360, 5))
def test_mh11_a_quantised_step_goes_to_the_nearest_of_eight_neighbours(degrees: int) -> None:
    play = PlannerSettings(stepping="quantised").record()[0]
    angle = degrees * pi / 180.0
    du, dv, *rests = next_cell(cos(angle), sin(angle), 0.3, -0.2, play)
    off = abs((atan2(dv, du) - angle + pi) % (2.0 * pi) - pi)
    assert off <= pi / 8.0 + 1e-9 and max(abs(du), abs(dv)) == 1
    assert rests == [0.0, 0.0]


@pytest.mark.parametrize("degrees", range(3, 360, 17))
def test_mh11_carried_steps_keep_to_the_line_within_half_a_cell(degrees: int) -> None:
    angle = degrees * pi / 180.0
    x, y = cos(angle), sin(angle)
    u = v = 0
    rest_x = rest_y = 0.0
    for step in range(1, 41):
        du, dv, rest_x, rest_y = next_cell(x, y, rest_x, rest_y, PLAY)
        assert max(abs(du), abs(dv)) == 1
        u, v = u + du, v + dv
        assert abs(x * v - y * u) <= 0.5 + 1e-9, "off the line"
        assert max(abs(u), abs(v)) == step


def test_mh11_no_direction_is_no_step_and_steps_and_cells_of_the_mirror_are_mirrored() -> None:
    assert next_cell(0.0, 0.0, 0.4, 0.4, PLAY)[:2] == (0, 0)
    assert next_cell(0.0, 0.0, 0.4, 0.4, PlannerSettings(stepping="quantised").record()[0])[:2] == (0, 0)
    rng = np.random.default_rng(3)
    for x, y, rest_x, rest_y in rng.uniform(-0.5, 0.5, (200, 4)):
        du, dv, a, b = next_cell(x, y, rest_x, rest_y, PLAY)
        assert next_cell(x, -y, rest_x, -rest_y, PLAY) == (du, -dv, a, -b)
    places = [0.0, 0.04, 0.05, 0.06, 0.25, 1.0, 4.97, 5.2, 80.0, float("inf")]
    assert [cell_of(place, 50, PLAY) for place in places] == [0, 0, 1, 1, 3, 10, 50, 50, 50, 50]
    assert [cell_of(-place, 50, PLAY) for place in places] == [0, 0, -1, -1, -3, -10, -50, -50, -50, -50]
    assert cell_of(float("nan"), 50, PLAY) == -50


def test_mh17_weigels_planner_sees_obstacles_as_they_are_now() -> None:
    still = PlannerSettings(time_variant=False).record()[0]
    assert [obstacle_time(t, still) for t in (-1.0, 0.0, 1.7)] == [0.0, 0.0, 0.0]
    assert [obstacle_time(t, PLAY) for t in (-1.0, 0.0, 1.7)] == [0.0, 0.0, 1.7]
    assert obstacle_time(-0.4, PlannerSettings(literal=True).record()[0]) == -0.4


def test_the_search_takes_the_least_first_and_of_equal_ones_the_older() -> None:
    rng = np.random.default_rng(1)
    nodes, heap = np.zeros(200, NODE), np.zeros(200, "i4")
    nodes["potential"] = rng.integers(0, 40, 200)
    size = 0
    for node in range(200):
        size = push(heap, size, node, nodes)
    taken = [pop(heap, size - i, nodes) for i in range(200)]
    assert taken == sorted(range(200), key=lambda node: (nodes["potential"][node], node))


def test_a_step_is_the_root_of_its_squares_a_corner_the_mean_of_nine_cells_and_an_unsmoothed_path_the_cells() -> None:
    assert step_length(3, -4, PLAY) == pytest.approx(0.5)
    assert step_length(1, 1, PLAY) == pytest.approx(0.1 * sqrt(2.0))
    path = smoothed(CORNER, (-1.0, 0.0), (0.0, 1.0), 4)
    assert path[10] == pytest.approx((-1.0 / 9.0, 1.0 / 9.0))  # 0.1 m times (4 + 3 + 2 + 1) / 9
    assert path[:6, 1] == pytest.approx(0.0) and path[15:, 0] == pytest.approx(0.0)
    assert smoothed(CORNER, (-1.0, 0.0), (0.0, 1.0), 0) == pytest.approx(0.1 * np.array(CORNER))


def smoothed(
    cells: list[tuple[int, int]], begin: tuple[float, float], end: tuple[float, float], many: int
) -> np.ndarray:
    """Return the path (N, 2) [m] of a way of cells, smoothed over so many on each side."""
    scratch = np.zeros(1, SCRATCH)
    scratch["count"] = len(cells)
    scratch["way"]["u"][0, : len(cells)], scratch["way"]["v"][0, : len(cells)] = np.transpose(cells)
    first, last = np.array([begin, end], POINT)
    smooth(first, last, PlannerSettings(smoothing=many).record()[0], scratch[0])
    path = scratch["path"][0, : len(cells)]
    assert length_of(path, len(path)) == pytest.approx(np.hypot(np.diff(path["x"]), np.diff(path["y"])).sum())
    return np.stack([path["x"], path["y"]], axis=-1)


CORNER = [(i, 0) for i in range(-10, 1)] + [(0, i) for i in range(1, 11)]


@pytest.mark.parametrize("count", [2, 3, 5, 9, 30])
def test_a_straight_way_stays_one_and_is_shifted_evenly_onto_both_ends(count: int) -> None:
    begin, end = (0.04, -0.03), (0.1 * (count - 1) - 0.02, 0.05)
    path = smoothed([(i, 0) for i in range(count)], begin, end, 4)
    assert path == pytest.approx(np.linspace(begin, end, count))
    assert np.hypot(*np.diff(path, axis=0).T).sum() == pytest.approx(hypot(end[0] - begin[0], end[1] - begin[1]))


ANGLES = [0.3 + 0.5 * i for i in range(13)]


def plans(scenes: list[Scene], **changes: Any) -> list[Plan]:
    planner = Planner(**changes)
    return [planner.plan(*scene) for scene in scenes]


def mean_of_arrivals(found: list[Plan]) -> float:
    return float(np.mean([plan.arrived for plan in found]))


@pytest.mark.parametrize("backward", [True, False])
def test_mh12_a_search_leads_out_of_a_cup_of_robots_and_without_it_nobody_gets_out(backward: bool) -> None:
    scenes = [cup(angle) for angle in ANGLES]
    found = plans(scenes, backward=backward)
    assert mean_of_arrivals(found) == 1.0 and min(plan.clearance() for plan in found) > 0.1
    without = plans(scenes, backward=backward, search=False)
    assert {plan.ended for plan in without} == {"looped"}


@pytest.mark.parametrize("count", [2, 3, 4])
def test_mh12_a_search_leads_round_a_row_of_robots_and_without_it_many_ways_end_there(count: int) -> None:
    scenes = [row(count, angle) for angle in [0.5 * pi * i for i in range(4)] + ANGLES]
    found = plans(scenes)
    assert mean_of_arrivals(found) == 1.0 and min(plan.clearance() for plan in found) > 0.3
    assert mean_of_arrivals(plans(scenes, search=False)) < 0.8


def test_mh12_a_way_never_comes_to_a_cell_twice() -> None:
    rng = np.random.default_rng(5)
    for scene in [*map(cup, ANGLES), *(random_scene(rng, most=14) for _ in range(60))]:
        cells = Planner().plan(*scene).cells.tolist()
        assert len({tuple(cell) for cell in cells}) == len(cells)
        assert np.abs(np.diff(cells, axis=0)).max() == 1


@pytest.mark.parametrize("backward", [True, False])
def test_whoever_stands_by_the_end_of_a_way_does_not_keep_it_from_arriving(backward: bool) -> None:
    """The potential has its minimum beside the end then: the last piece goes straight."""
    planner = Planner(backward=backward)
    for angle in ANGLES:
        beside = [(2.0 + 0.5 * cos(angle), 0.5 * sin(angle), 0.0, 0.0), (-2.0, -0.5, 0.0, 0.0)]
        plan = planner.plan((2.0, 0.0), (-2.0, 0.0), beside)
        assert plan.arrived and plan.evaluations < 600 and plan.clearance() > -0.15


def test_a_target_inside_an_obstacle_is_left_on_its_nearest_side() -> None:
    """Its middle lies off to one side: the way into it goes round on the target's side."""
    for side in (1.0, -1.0):
        plan = Planner().plan((-2.5, 0.0), (0.1, 0.2 * side), [(0.0, 0.0, 0.0, 0.0)])
        assert plan.arrived and (side * plan.path[-8:, 1] > 0.15).all()
        assert np.hypot(*plan.path.T).min() > 0.2


def ring() -> list[tuple[float, ...]]:
    """Return eight robots round the middle of the pitch, without a gap between them."""
    return at_bearing(0.2, [(0.8 * cos(i * pi / 4.0), 0.8 * sin(i * pi / 4.0)) for i in range(8)])


def test_an_enclosed_robot_or_target_ends_the_plan_at_bounded_cost_with_a_path_nevertheless() -> None:
    for robot, target in (((0.0, 0.0), (4.0, 1.0)), ((4.0, 1.0), (0.0, 0.0))):
        for moves in (0.0, 0.5):
            crowd = [(x, y, moves, 0.0) for x, y, *_ in ring()]
            plan = Planner(search=True).plan(robot, target, crowd)
            assert plan.ended in ("enclosed", "capped", "arrived") and plan.evaluations < 4000 + 100
            assert plan.path[0] == pytest.approx(robot) and plan.path[-1] == pytest.approx(target)
    assert Planner().plan((4.0, 1.0), (0.0, 0.0), ring()).ended == "enclosed"


def test_evaluations_are_capped_and_a_target_under_the_robot_is_a_path_of_two_points() -> None:
    plan = Planner(most_evaluations=150).plan(*cup(0.3))
    assert plan.ended == "capped" and plan.evaluations < 170
    assert np.isfinite(plan.path).all() and plan.path[-1] == pytest.approx(cup(0.3).target)
    plan = Planner().plan((1.0, 1.0), (1.0, 1.0), [(1.3, 1.0, -1.0, 0.0)])
    assert plan.arrived and len(plan) == 2 and plan.time == plan.least_time == 0.0


@pytest.mark.parametrize("form", ["scalar", "vector"])
@pytest.mark.parametrize("changes", [{}, {"literal": True}, {"backward": False}, {"borders": True}])
def test_nothing_stalls_or_throws(form: str, changes: dict[str, Any]) -> None:
    """22 others at up to 5 m/s, some in robot or target, places beyond the pitch, a target under the robot."""
    rng = np.random.default_rng(8)
    planner = Planner(form=form, **changes)
    arrived = 0
    for case in range(60):
        _, _, crowd = random_scene(rng, most=22 if case % 3 else 4, speed=5.0)
        robot, target = rng.uniform((-9.0, -7.0), (9.0, 7.0), (2, 2))
        target = target if case % 4 else robot + rng.normal(0.0, 0.03, 2)
        if case % 5 == 0:
            crowd[0], crowd[1] = (*robot, 1.0, 0.0), (*target, 0.0, -5.0)
        plan = planner.plan(robot, target, crowd)
        assert np.isfinite(plan.path).all() and len(plan) >= 2 and plan.evaluations < 4300
        assert np.abs(plan.cells).max(axis=0)[0] <= 70 and np.abs(plan.cells).max(axis=0)[1] <= 50
        assert plan.path[0] == pytest.approx(np.clip(robot, (-7.0, -5.0), (7.0, 5.0)))
        assert plan.path[-1] == pytest.approx(np.clip(target, (-7.0, -5.0), (7.0, 5.0)))
        arrived += plan.arrived
    assert arrived > 45
