"""Points that travel through scenes by either planner, and single plans."""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from soccer_env.baselines.weigel_2001.planner import Plan, Planner, PlannerSettings, Travel
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.claims.planning.scenes import WAY, Scene, crossing
from soccer_env.train.papers.verdicts import Samples

SPEED = PlannerSettings().speed  # [m/s] of the robot
SCENES = 200  # single plans of a batch
LONGEST = 15.0  # [s] of a travel: three times the canonical ones
PLANNERS: dict[str, dict[str, Any]] = {"old": {"time_variant": False}, "new": {}}  # Weigel's, the paper's
Draw = Callable[[np.random.Generator], Scene]
CROSSING: Draw = partial(crossing, speed=SPEED)


def scenes_of(batch: Batch, draw: Draw, count: int) -> list[Scene]:
    """Draw `count` scenes of a batch with the function `draw`."""
    rng = batch.rng()
    return [draw(rng) for _ in range(count)]


def travel(scene: Scene, **changes: Any) -> Travel:
    """Return the travel of a point through a scene, led by a planner with the settings `changes`."""
    return Planner(**changes).travel(*scene, seconds=LONGEST)


def plan(scene: Scene, **changes: Any) -> Plan:
    """Return the plan for one scene by a planner with the settings `changes`."""
    return Planner(**changes).plan(*scene)


def plans_of(batch: Batch, draw: Draw = CROSSING, **changes: Any) -> list[Plan]:
    """Return one plan for each scene of a batch, by a planner with the settings `changes`."""
    planner = Planner(**changes)
    return [planner.plan(*scene) for scene in scenes_of(batch, draw, SCENES)]


def crossing_text() -> str:
    """Describe the scenes of `plans_of` in words."""
    return f"{SCENES} crossings a batch, of one obstacle and a way of {WAY:g} m, each planned once"


def side_changes(travels: Travel) -> int:
    """Return how often the plans of a travel change the side on which they pass the first obstacle.

    The side of the obstacle, seen along the path, counts where the planned path is nearest to it; a plan that stays
    more than a metre away has no side.
    """
    sides = [passing_side(travels, cycle) for cycle in range(len(travels.stations) - 1)]
    there = [side for side in sides if side != 0]
    return sum(a != b for a, b in zip(there, there[1:], strict=False))


def passing_side(travels: Travel, cycle: int) -> int:
    """Return +1 if a cycle's plan passes with the first obstacle on its left, -1 on its right, 0 if it is not near."""
    path = travels.planned(cycle)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))])
    one = travels.obstacles[0]
    t = cycle * 0.02 + along / travels.settings.speed
    x, y = one["x"] + t * one["vx"] - path[:, 0], one["y"] + t * one["vy"] - path[:, 1]
    nearest = int(np.argmin(np.hypot(x, y)))
    if np.hypot(x[nearest], y[nearest]) > 1.0 or nearest in (0, len(path) - 1):
        return 0
    way = path[nearest + 1] - path[nearest - 1]
    across = way[0] * y[nearest] - way[1] * x[nearest]
    return int(np.sign(across))


def travel_results(travels: list[Travel], name: str) -> Samples:
    """Return results of travels (M,): arrival, collision, smallest gap [m], time [s], length [m], turn [degrees] ..."""
    figures = {
        "arrived": [one.arrived for one in travels],
        "hit": [one.clearance < 0.0 for one in travels],
        "gap": [one.clearance for one in travels],
        "time": [one.time for one in travels],
        "length": [one.length for one in travels],
        "turn": [np.degrees(one.turn) for one in travels],
        "away": [one.cycles_away for one in travels],
    }
    return {f"{name} {key}": np.array(values, float) for key, values in figures.items()}
