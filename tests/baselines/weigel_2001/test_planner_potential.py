"""The planner's potential field against closed forms: forces, their sum in both readings, gradient, prediction."""

from math import hypot, sqrt
from typing import Any

import numpy as np
import pytest

from soccer_env.baselines.weigel_2001.planner import Planner, Travel
from soccer_env.baselines.weigel_2001.planner.potential import gap_at, gradient, potential
from soccer_env.baselines.weigel_2001.planner.records import OBSTACLE, POINT
from soccer_env.baselines.weigel_2001.planner.settings import PlannerSettings
from tests.scenes.planning import CROSSING_A, CROSSING_B, Scene, cup, random_scene

GOAL = np.array([(3.0, 1.0)], POINT)[0]
NOBODY = np.zeros(0, OBSTACLE)
BOTH = 0.5  # [m] of two radii


def play_of(**changes: Any) -> np.void:
    return PlannerSettings(**changes).record()[0]


def others(*rows: tuple[float, ...]) -> np.ndarray:
    return np.array([(*row, 0.25) for row in rows], OBSTACLE)


def inverse(gap: float) -> float:
    return 0.15 * (1.0 / gap - 1.0)


def test_mh09_the_scalar_field_is_the_distance_and_the_size_of_each_force() -> None:
    play = play_of(form="scalar")
    assert potential(0.0, 0.0, 0.0, GOAL, NOBODY, play) == pytest.approx(sqrt(10.0))
    crowd = others((1.0, 0.0, 0.0, 0.0), (0.0, -0.8, 0.0, 0.0))
    expected = sqrt(10.0) + inverse(0.5) + inverse(0.3)
    assert potential(0.0, 0.0, 0.0, GOAL, crowd, play) == pytest.approx(expected)


def test_mh09_the_vector_field_is_the_size_of_the_sum_of_all_forces() -> None:
    crowd = others((1.0, 0.0, 0.0, 0.0), (0.0, -0.8, 0.0, 0.0))
    expected = hypot(3.0 - inverse(0.5), 1.0 + inverse(0.3))
    assert potential(0.0, 0.0, 0.0, GOAL, crowd, play_of(form="vector")) == pytest.approx(expected)


def test_mh09_the_vector_field_vanishes_before_an_obstacle_where_the_forces_cancel() -> None:
    """Goal at 3 m, obstacle at 1 m: 3 - x = 0.15 (1 / (0.5 - x) - 1) has a root between; the scalar field has none."""
    goal = np.array([(3.0, 0.0)], POINT)[0]
    x = np.linspace(0.0, 0.499, 500)
    found = {
        form: [potential(at, 0.0, 0.0, goal, others((1.0, 0.0, 0.0, 0.0)), play_of(form=form)) for at in x]
        for form in ("vector", "scalar")
    }
    root = x[int(np.argmin(found["vector"]))]
    assert 3.0 - root == pytest.approx(inverse(0.5 - root), rel=0.1)
    assert min(found["vector"]) < 0.05 and min(found["scalar"]) > 2.5


def test_mh09_nobody_repels_from_beyond_the_reach_and_khatibs_force_is_that_over_the_square_of_the_distance() -> None:
    play = play_of()
    near, far = others((1.499, 0.0, 0.0, 0.0)), others((1.501, 0.0, 0.0, 0.0))
    alone = potential(0.0, 0.0, 0.0, GOAL, NOBODY, play)
    assert potential(0.0, 0.0, 0.0, GOAL, far, play) == alone
    assert alone < potential(0.0, 0.0, 0.0, GOAL, near, play) < alone + 1e-3
    play = play_of(repulsion="khatib")
    size = potential(0.0, 0.0, 0.0, GOAL, others((1.0, 0.0, 0.0, 0.0)), play) - sqrt(10.0)
    assert size == pytest.approx(inverse(0.5) / 0.25)


def test_mh09_below_the_floor_the_force_goes_on_growing_evenly() -> None:
    play = play_of()
    alone = potential(0.0, 0.0, 0.0, GOAL, NOBODY, play)
    near = (others((BOTH + gap, 0.0, 0.0, 0.0)) for gap in (0.05, 0.0, -0.2))
    sizes = [potential(0.0, 0.0, 0.0, GOAL, one, play) - alone for one in near]
    assert sizes == pytest.approx([inverse(0.05), 2.0 * inverse(0.05), 6.0 * inverse(0.05)])


@pytest.mark.parametrize("form", ["scalar", "vector"])
def test_lines_repel_only_if_they_are_asked_to(form: str) -> None:
    goal = np.array([(5.9, 0.0)], POINT)[0]
    size = 0.05 * (1.0 / 0.1 - 1.0 / 0.35)
    assert potential(5.9, 0.0, 0.0, goal, NOBODY, play_of(form=form)) == 0.0
    assert potential(5.9, 0.0, 0.0, goal, NOBODY, play_of(form=form, borders=True)) == pytest.approx(size)
    assert potential(-5.9, 0.0, 0.0, goal, NOBODY, play_of(form=form, borders=True)) == pytest.approx(11.8 + size)
    goal["x"], goal["y"] = 0.0, 3.9
    assert potential(0.0, 3.9, 0.0, goal, NOBODY, play_of(form=form, borders=True)) == pytest.approx(size)
    assert potential(0.0, -3.9, 0.0, goal, NOBODY, play_of(form=form, borders=True)) == pytest.approx(7.8 + size)


@pytest.mark.parametrize("form", ["scalar", "vector"])
def test_mh10_the_gradient_is_the_difference_between_neighbours_over_a_cell(form: str) -> None:
    """As (2) is written: over alpha and not over 2 alpha, hence twice the slope."""
    play, crowd = play_of(form=form), others((1.0, 0.35, 0.0, 0.0))
    at = {(i, j): potential(0.1 * i, 0.1 * j, 0.0, GOAL, crowd, play) for i in (1, 2, 3) for j in (0, 1, 2)}
    found = gradient(2, 1, 0.0, GOAL, crowd, play)
    assert found == pytest.approx(((at[3, 1] - at[1, 1]) / 0.1, (at[2, 2] - at[2, 0]) / 0.1), rel=1e-12)


def test_mh10_the_gradient_of_one_obstacle_is_twice_its_derivative() -> None:
    play = play_of(cell=0.02, pitch_length=1.0, pitch_width=1.0)
    x, y = 0.1, -0.04
    found = gradient(5, -2, 0.0, GOAL, others((0.9, 0.35, 0.0, 0.0)), play)
    towards, away = np.array([x - 3.0, y - 1.0]), np.array([x - 0.9, y - 0.35])
    d, r = np.hypot(*towards), np.hypot(*away)
    slope = towards / d - 0.15 / (r - BOTH) ** 2 * away / r
    assert found == pytest.approx(tuple(2.0 * slope), abs=0.005)


def test_mh15_an_obstacle_is_predicted_along_its_velocity_and_the_gap_is_from_surface_to_surface() -> None:
    play, moves = play_of(), others((1.0, 0.5, -1.0, 0.4))
    for t in (0.3, 1.0, -0.2):
        there = others((1.0 - t, 0.5 + 0.4 * t, 0.0, 0.0))
        expected = potential(0.2, 0.1, 0.0, GOAL, there, play)
        assert potential(0.2, 0.1, t, GOAL, moves, play) == pytest.approx(expected, rel=1e-12)
    play = play_of()
    assert gap_at(0.0, 0.0, 0.0, others((3.0, 4.0, 0.0, 0.0), (0.0, -2.0, 0.0, 1.0)), play) == pytest.approx(1.5)
    assert gap_at(0.0, 0.0, 1.5, others((3.0, 4.0, 0.0, 0.0), (0.0, -2.0, 0.0, 1.0)), play) == pytest.approx(0.0)
    assert gap_at(0.0, 0.0, 0.0, NOBODY, play) >= 1e6


CYCLE = 0.02


def travel_of(scene: Scene, **changes: Any) -> Travel:
    return Planner(**changes).travel(*scene)


def test_mh14_a_cycle_is_20_ms_of_driving_at_full_speed_along_a_new_plan() -> None:
    travel = travel_of(Scene((-2.0, 0.0), (2.0, 1.0), []))
    steps = np.hypot(*np.diff(travel.path, axis=0).T)
    assert steps == pytest.approx(2.6 * CYCLE, rel=2e-3)
    assert travel.arrived and travel.cycles_away == 0
    assert travel.time == pytest.approx(hypot(4.0, 1.0) / 2.6, abs=1.5 * CYCLE)
    assert (travel.plans["count"][:-1] > 0).all() and len(travel.plans) == len(travel.stations)


def test_mh14_each_plan_begins_where_the_point_and_the_others_are_by_then() -> None:
    travel = travel_of(CROSSING_B)
    for cycle in (0, 10, 40):
        again = Planner().plan(travel.path[cycle], CROSSING_B.target, with_velocities(travel, cycle))
        assert again.path.tolist() == travel.planned(cycle).tolist()


def with_velocities(travel: Travel, cycle: int) -> np.ndarray:
    now = travel.obstacles.copy()
    now["x"], now["y"] = travel.others(cycle).T
    return now


@pytest.mark.parametrize("scene", [CROSSING_A, CROSSING_B])
def test_mh18_weigels_planner_nearly_meets_the_obstacle_and_drives_away_and_the_time_variant_one_does_not(scene):
    old, new = travel_of(scene, time_variant=False), travel_of(scene)
    assert old.arrived and new.arrived
    assert old.clearance < 0.25 and old.cycles_away > 10
    assert new.clearance > 0.5 and new.cycles_away == 0
    assert old.time - new.time > 1.0 and old.turn > 3.0 * new.turn
    assert (new.stations["iterations"][:-1] == 1).all() and new.stations["converged"][:-1].all()


def test_mh25_an_obstacle_at_5_metres_a_second_is_planned_for_where_it_will_be() -> None:
    goes = Scene((-2.6, 0.0), (2.6, 0.0), [(0.0, 0.1, 0.0, 5.0)])
    assert np.abs(Planner().plan(*goes).path[:, 1]).max() < 0.05
    assert np.abs(Planner(time_variant=False).plan(*goes).path[:, 1]).max() > 0.5
    comes = Scene((-2.6, 0.0), (2.6, 0.0), [(0.0, -4.9, 0.0, 5.0)])
    assert np.abs(Planner().plan(*comes).path[:, 1]).max() > 0.2
    assert np.abs(Planner(time_variant=False).plan(*comes).path[:, 1]).max() < 0.05


def test_mh25_whatever_comes_at_5_metres_a_second_the_target_is_reached() -> None:
    for angle in np.linspace(0.0, 6.0, 9):
        vx, vy = 5.0 * np.cos(angle), 5.0 * np.sin(angle)
        travel = travel_of(Scene((-2.6, 0.0), (2.6, 0.0), [(-vx, -vy, vx, vy)]))
        assert travel.arrived and travel.time < 1.25 * travel.plans[0]["least_time"]


def test_both_planners_pass_still_and_slow_obstacles_and_stop_in_time_where_they_cannot_arrive() -> None:
    rng = np.random.default_rng(4)
    for _ in range(6):
        scene = random_scene(rng, most=5, speed=0.3)
        for changes in ({}, {"time_variant": False}):
            travel = travel_of(scene, **changes)
            assert travel.clearance > -0.02
    assert travel_of(cup(0.7)).arrived
    travel = Planner().travel((0.0, 0.0), (900.0, 0.0), seconds=0.5)
    assert not travel.arrived and len(travel.stations) == 26 and travel.time == pytest.approx(0.5)
    there = Planner().travel((1.0, 1.0), (1.0, 1.0))
    assert there.arrived and there.time == 0.0 and there.cycles_away == 0
