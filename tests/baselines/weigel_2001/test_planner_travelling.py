"""A point that plans anew every cycle: the paper's crossing, slow and fast obstacles, nobody at all."""

from math import hypot
from typing import Any

import numpy as np
import pytest

from soccer_env.baselines.weigel_2001.planner import Planner, Travel
from tests.scenes.planning import CROSSING_A, CROSSING_B, Scene, cup, random_scene

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
def test_mh18_weigels_planner_nearly_meets_the_obstacle_and_drives_away_and_the_time_variant_one_does_not(
    scene: Scene,
) -> None:
    old, new = travel_of(scene, time_variant=False), travel_of(scene)
    assert old.arrived and new.arrived
    assert old.clearance < 0.25 and old.cycles_away > 10
    assert new.clearance > 0.5 and new.cycles_away == 0
    assert old.time - new.time > 1.0 and old.turn > 3.0 * new.turn
    assert (new.stations["iterations"][:-1] == 1).all() and new.stations["converged"][:-1].all()


def test_mh25_an_obstacle_at_5_metres_a_second_is_planned_for_where_it_will_be() -> None:
    """It is in the way now and gone by then; or far off now and in the way by then."""
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


def test_still_and_slow_obstacles_are_passed_without_touching_by_both_planners() -> None:
    rng = np.random.default_rng(4)
    for _ in range(6):
        scene = random_scene(rng, most=5, speed=0.3)
        for changes in ({}, {"time_variant": False}):
            travel = travel_of(scene, **changes)
            assert travel.clearance > -0.02
    assert travel_of(cup(0.7)).arrived


def test_a_point_that_cannot_arrive_stops_after_the_time_that_it_has() -> None:
    travel = Planner().travel((0.0, 0.0), (900.0, 0.0), seconds=0.5)
    assert not travel.arrived and len(travel.stations) == 26 and travel.time == pytest.approx(0.5)
    there = Planner().travel((1.0, 1.0), (1.0, 1.0))
    assert there.arrived and there.time == 0.0 and there.cycles_away == 0
