"""Out of local minima: rows and cups of robots, who stands by the end of a way, and hopeless scenes at bounded cost."""

from math import cos, inf, nan, pi, sin
from typing import Any

import numpy as np
import pytest

from soccer_env.baselines.weigel_2001.planner import Plan, Planner, PlannerSettings
from soccer_env.baselines.weigel_2001.planner.planning import plan_way
from soccer_env.baselines.weigel_2001.planner.records import OBSTACLE, PLAN, SCRATCH
from tests.scenes.planning import Scene, at_bearing, cup, random_scene, row

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


def test_the_number_of_evaluations_is_capped() -> None:
    plan = Planner(most_evaluations=150).plan(*cup(0.3))
    assert plan.ended == "capped" and plan.evaluations < 170
    assert np.isfinite(plan.path).all() and plan.path[-1] == pytest.approx(cup(0.3).target)


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


def test_a_target_under_the_robot_is_a_path_of_two_points() -> None:
    plan = Planner().plan((1.0, 1.0), (1.0, 1.0), [(1.3, 1.0, -1.0, 0.0)])
    assert plan.arrived and len(plan) == 2 and plan.time == plan.least_time == 0.0


def test_what_is_no_number_neither_stalls_nor_leaves_the_grid() -> None:
    """`Planner` refuses it; the kernel, which teams call, holds it at the grid's edge or overlooks it."""
    settings, scratch, plan = PlannerSettings().record(), np.zeros(1, SCRATCH), np.zeros(1, PLAN)
    others = np.array([(nan, 0.0, 1.0, 0.0, 0.25), (0.5, 0.1, inf, nan, 0.25), (1.0, 0.2, 0.0, 0.0, 0.25)], OBSTACLE)
    for robot, target in (((nan, 0.0), (2.0, 0.0)), ((0.0, 0.0), (inf, -inf)), ((0.0, 0.0), (2.0, 0.3))):
        plan_way(*robot, *target, 1, others, settings[0], scratch[0], plan[0])
        path = plan["path"][0, : plan["count"][0]]
        assert np.isfinite(path["x"]).all() and np.isfinite(path["y"]).all()
        assert np.abs(path["x"]).max() <= 7.0 and np.abs(path["y"]).max() <= 5.0
        assert not scratch["marks"].any() and plan["evaluations"][0] < 4300
