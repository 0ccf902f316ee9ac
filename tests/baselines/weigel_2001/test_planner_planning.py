"""Plans: straight ways and their times, T and its iteration, still and moving obstacles, both directions, mirrors."""

from itertools import pairwise
from math import hypot, sqrt
from typing import Any

import numpy as np
import pytest

from soccer_env.baselines.weigel_2001.planner import Plan, Planner
from soccer_env.baselines.weigel_2001.planner.records import PLAN
from tests.scenes.planning import CROSSING_A, CROSSING_B, Scene, random_scene

SPEED, TAU = 2.6, 0.1 / 2.6  # [m/s], [s] of a cell
BESIDE = [(6.9, 4.9, 0.3, 0.0)]  # somebody who moves, far from every way


def plan_of(scene: Scene, side: int = 1, **changes: Any) -> Plan:
    return Planner(**changes).plan(*scene, side=side)


def random_scenes(count: int, **more: Any) -> list[Scene]:
    rng = np.random.default_rng(11)
    return [random_scene(rng, **more) for _ in range(count)]


@pytest.mark.parametrize("stepping", ["carried", "quantised"])
@pytest.mark.parametrize("form", ["scalar", "vector"])
def test_without_obstacles_a_way_along_an_axis_or_a_diagonal_is_straight(form: str, stepping: str) -> None:
    planner = Planner(form=form, stepping=stepping)
    for target in ((2.0, 0.0), (0.0, -2.0), (2.0, 2.0), (-2.0, 2.0)):
        plan = planner.plan((0.0, 0.0), target)
        assert plan.arrived
        assert plan.cells.tolist() == [[i * np.sign(target[0]), i * np.sign(target[1])] for i in range(21)]
        assert plan.time == pytest.approx(plan.least_time) == hypot(*target) / SPEED


def test_without_obstacles_the_driven_path_is_straight_in_every_direction_though_the_cells_way_is_octile() -> None:
    plan = Planner().plan((-2.0, -0.5), (2.0, 0.5))
    steps = np.abs(np.diff(plan.cells, axis=0))
    assert sorted(steps.sum(axis=1).tolist()) == [1] * 30 + [2] * 10
    assert np.ptp(plan.cell_times) == pytest.approx((30.0 + 10.0 * sqrt(2.0)) * TAU)
    for to in [(5.0, 1.0), (4.0, 3.3), (-5.5, 2.2), (1.03, -3.77)]:
        plan = Planner().plan((0.02, -0.03), to)
        assert plan.time / plan.least_time == pytest.approx(1.0, abs=0.003)
        (x, y), (ahead, left) = (plan.path - plan.path[0]).T, plan.path[-1] - plan.path[0]
        assert np.abs(ahead * y - left * x).max() < 0.05 * hypot(*to), "5 cm off the line"
        assert plan.path[0] == pytest.approx((0.02, -0.03)) and plan.path[-1] == pytest.approx(to)


def test_mh13_forwards_no_time_has_to_be_guessed_and_mh16_it_is_never_less_than_that_of_the_straight_line() -> None:
    for scene in random_scenes(60):
        for changes in ({}, {"literal": True}, {"backward": False}):
            plan = plan_of(scene, **changes)
            straight = hypot(scene.target[0] - scene.robot[0], scene.target[1] - scene.robot[1]) / SPEED
            assert plan.least_time == pytest.approx(straight)
            assert (plan.times >= plan.least_time).all() and (plan.guesses >= plan.least_time).all()
            assert plan.time >= plan.length / SPEED - 1e-12 or changes == {"literal": True}
    for scene in random_scenes(20):
        plan = plan_of(scene, backward=False)
        assert plan.iterations == 1 and plan.converged and plan.cell_times[0] == 0.0
        assert (np.diff(plan.cell_times) > 0.0).all()


def test_mh13_backwards_the_way_is_planned_from_the_target_towards_the_robot() -> None:
    """Whoever stands by the robot bends the end of such a way, whoever stands by the target its begin."""
    scene = Scene((-2.5, 0.0), (2.5, 0.0), [(0.0, 0.1, 0.0, 0.0)])
    back, forth = plan_of(scene), plan_of(scene, backward=False)
    assert back.arrived and forth.arrived
    turned = plan_of(Scene(scene.target, scene.robot, scene.obstacles), backward=False)
    assert back.cells.tolist() == turned.cells[::-1].tolist() and back.cells.tolist() != forth.cells.tolist()
    ahead = [int(np.argmax(np.abs(plan.cells[:, 1]) > 1)) for plan in (back, forth)]
    assert ahead[0] < ahead[1], "backwards it leaves the straight line earlier"


def test_mh15_time_is_counted_back_from_t_by_a_step_for_each_cell() -> None:
    plan = plan_of(CROSSING_A)
    steps = np.sqrt((np.diff(plan.cells, axis=0) ** 2).sum(axis=1)) * TAU
    assert plan.cell_times[-1] == plan.guesses[int(plan.record["kept"][0])]
    assert np.diff(plan.cell_times) == pytest.approx(steps)


def test_mh15_the_way_avoids_where_an_obstacle_will_be_and_not_where_it_is() -> None:
    comes = Scene((-2.6, 0.0), (2.6, 0.0), [(0.0, -1.5, 0.0, 1.5)])
    moving, still = plan_of(comes), plan_of(comes, time_variant=False)
    assert still.clearance() < 0.0 and moving.clearance() > 0.3
    goes = Scene((-2.6, 0.0), (2.6, 0.0), [(0.0, 0.1, 0.0, 2.5)])
    moving, still = plan_of(goes), plan_of(goes, time_variant=False)
    assert np.abs(moving.path[:, 1]).max() < 0.1 < 0.5 < np.abs(still.path[:, 1]).max()


def test_mh17_weigels_planner_knows_no_velocities() -> None:
    for scene in random_scenes(20):
        still = [(x, y, 0.0, 0.0) for x, y, *_ in scene.obstacles]
        first = plan_of(scene, time_variant=False)
        second = plan_of(scene._replace(obstacles=still), time_variant=False)
        assert first.record.tobytes() == second.record.tobytes() and first.iterations == 1


@pytest.mark.parametrize("form", ["scalar", "vector"])
def test_mh17_with_all_velocities_zero_the_time_variant_plan_is_the_baselines(form: str) -> None:
    for scene in random_scenes(40, speed=0.0):
        moving, still = plan_of(scene, form=form), plan_of(scene, form=form, time_variant=False)
        assert moving.record.tobytes() == still.record.tobytes()


def test_mh17_so_it_is_for_every_time_that_it_is_planned_for() -> None:
    """Somebody far away who moves makes T be iterated, and changes no cell."""
    changed = 0
    for scene in random_scenes(40, speed=0.0, most=8):
        moving = plan_of(scene._replace(obstacles=scene.obstacles + BESIDE))
        still = plan_of(scene._replace(obstacles=scene.obstacles + BESIDE), time_variant=False)
        assert moving.cells.tolist() == still.cells.tolist() and moving.path.tobytes() == still.path.tobytes()
        changed += moving.iterations > 1
    assert changed > 0


def test_mh16_t_begins_at_its_least_and_goes_half_way_to_the_time_of_the_last_way() -> None:
    iterated = 0
    for scene in random_scenes(80):
        plan = plan_of(scene)
        assert plan.guesses[0] == plan.least_time
        for (guess, took), after in pairwise(zip(plan.guesses, plan.times, strict=True)):
            assert abs(took - guess) >= 0.1
            assert after[0] == pytest.approx(0.5 * (guess + took))
            iterated += 1
        assert plan.converged == bool(abs(plan.times[-1] - plan.guesses[-1]) < 0.1)
        assert plan.converged or plan.iterations == 8
    assert iterated > 10


def test_mh16_by_the_papers_words_t_is_the_time_of_the_last_way_of_cells() -> None:
    iterated = 0
    for scene in random_scenes(60):
        plan = plan_of(scene, literal=True)
        assert plan.guesses[1:].tolist() == plan.times[:-1].tolist()
        assert int(plan.record["kept"][0]) == plan.iterations - 1
        octile = np.sqrt((np.diff(plan.cells, axis=0) ** 2).sum(axis=1)).sum() * TAU
        assert plan.time == pytest.approx(max(octile, plan.least_time)) or not plan.arrived
        iterated += plan.iterations > 1
    assert iterated > 10


def swinging() -> Scene:
    """Return a scene whose T swings: the first of random ones for which it never agrees."""
    return next(scene for scene in random_scenes(300) if not plan_of(scene).converged)


def test_mh16_if_no_time_agrees_the_best_the_first_or_the_last_plan_is_kept() -> None:
    scene = swinging()
    best, first, last = (plan_of(scene, fallback=name) for name in ("best", "first", "last"))
    off = np.abs(best.times - best.guesses)
    assert best.iterations == first.iterations == last.iterations == 8
    assert off[int(best.record["kept"][0])] == off.min()
    assert [int(plan.record["kept"][0]) for plan in (first, last)] == [0, 7]
    assert first.time == first.times[0] and last.time == last.times[7]
    assert plan_of(scene, most_iterations=3).iterations == 3


@pytest.mark.parametrize("scene", [CROSSING_A, CROSSING_B])
def test_mh16_in_the_papers_scene_one_iteration_tells_the_time_to_a_tenth_of_a_second(scene: Scene) -> None:
    plan = plan_of(scene)
    assert plan.iterations == 1 and plan.converged and plan.arrived
    assert abs(plan.time - plan.least_time) < 0.1
    assert plan.clearance() > 0.5 > 0.2 > plan_of(scene, time_variant=False).clearance()


@pytest.mark.parametrize("changes", [{}, {"time_variant": False}, {"backward": False}, {"stepping": "quantised"}])
def test_the_mirrored_scene_has_the_mirrored_plan_exactly(changes: dict[str, Any]) -> None:
    for scene in [*random_scenes(40), Scene((-2.0, 0.0), (2.0, 0.0), [(0.0, 0.0, 0.0, 0.0)])]:
        plan, image = plan_of(scene, **changes), plan_of(scene.mirrored(), side=-1, **changes)
        assert (image.cells * (1, -1)).tolist() == plan.cells.tolist()
        assert (image.path * (1, -1)).tolist() == plan.path.tolist()
        assert image.guesses.tolist() == plan.guesses.tolist() and image.evaluations == plan.evaluations


def test_plans_are_records_that_depend_on_no_plan_before_and_on_side_only_where_both_are_equal() -> None:
    ahead = Scene((-2.0, 0.0), (2.0, 0.0), [(0.0, 0.0, 0.0, 0.0)])
    left, right = plan_of(ahead, side=1), plan_of(ahead, side=-1)
    assert (left.path * (1, -1)).tolist() == right.path.tolist() and left.path.tolist() != right.path.tolist()
    for scene in random_scenes(10):
        one, other = plan_of(scene, side=1), plan_of(scene, side=-1)
        assert one.record["searches"][0] > 0 or one.cells.tolist() == other.cells.tolist()
    used = Planner()
    for scene in random_scenes(30):
        assert used.plan(*scene).record.tobytes() == Planner().plan(*scene).record.tobytes()
    assert PLAN.hasobject is False and plan_of(CROSSING_A).record.dtype == PLAN
