"""`Planner`: the Python interface of the planner, which takes plain numbers and checks them."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from soccer_env.baselines.weigel_2001.planner.plan import Plan, make_plan
from soccer_env.baselines.weigel_2001.planner.records import MOST_OBSTACLES, OBSTACLE, SCRATCH
from soccer_env.baselines.weigel_2001.planner.settings import PlannerSettings
from soccer_env.baselines.weigel_2001.planner.travelling import CYCLE, Travel, make_travel
from soccer_env.guards.checking import Range, check_choice, check_whole_number, raise_not_allowed

FARTHEST = 1000.0  # [m] from the middle of the pitch: a place farther away is a mistake
FASTEST = 100.0  # [m/s] of an obstacle; robots of 2006 drive at up to 5  MH25
OBSTACLE_RADIUS = 0.25  # [m] of an obstacle without one: half of the 50 cm that a robot may take, rules of 2006
FORM = "rows of x, y, vx, vy, and a radius if you like"


class Planner:
    """A planner of paths past standing or moving obstacles.

    settings: PlannerSettings, or None for the paper's settings; keywords change settings by name, as in
    Planner(time_variant=False, search=False). A planner holds no state between plans.
    """

    def __init__(self, settings: PlannerSettings | None = None, **changes: Any) -> None:
        if settings is not None and not isinstance(settings, PlannerSettings):
            raise_not_allowed("settings", "a PlannerSettings", settings)
        self.settings = (settings or PlannerSettings()).changed(changes)
        self._scratch = np.zeros(1, SCRATCH)

    def plan(self, robot: Sequence[float], target: Sequence[float], obstacles: Any = (), side: int = 1) -> Plan:
        """Plan a path from robot to target, both (x, y) [m] from the middle of the pitch; return the Plan.

        obstacles: up to 32 rows of x, y [m], vx, vy [m/s] and maybe a radius [m], or records.OBSTACLE. side: +1 or -1,
        the side of y on which to pass if both are equal; a mirrored scene needs the opposite sign. Places beyond the
        pitch's margin are moved to the margin. ValueError for anything else.
        """
        return make_plan(*self._checked(robot, target, obstacles, side), self.settings, self._scratch)

    def travel(
        self, robot: Sequence[float], target: Sequence[float], obstacles: Any = (), seconds: float = 10.0, side: int = 1
    ) -> Travel:
        """Simulate a point that drives to the target at full speed and plans anew every 20 ms; return its Travel.

        Obstacles keep their velocities; arguments as in `plan`. The travel ends after `seconds` at the latest.
        """
        allowed = Range(CYCLE, 1000.0)
        if not (isinstance(seconds, (int, float)) and allowed.holds(seconds)):
            raise_not_allowed("seconds", allowed.text(), seconds)
        return make_travel(*self._checked(robot, target, obstacles, side), self.settings, self._scratch, float(seconds))

    def _checked(
        self, robot: Any, target: Any, obstacles: Any, side: Any
    ) -> tuple[tuple[float, float, float, float], int, np.ndarray]:
        places = (*check_place("robot", robot), *check_place("target", target))
        return (
            places,
            check_choice("side", check_whole_number("side", side, -1, 1), (-1, 1)),
            check_obstacles(obstacles),
        )


def check_place(name: str, value: Any) -> tuple[float, float]:
    """Return a position [m] as two numbers, checked; ValueError names the argument."""
    point = as_float_array(name, "two numbers x, y", value)
    if point.shape != (2,):
        raise_not_allowed(name, "two numbers x, y", value)
    if not (np.abs(point) <= FARTHEST).all():
        raise_not_allowed(name, f"finite and within {FARTHEST:g} m of the middle of the pitch", value)
    return float(point[0]), float(point[1])


def check_obstacles(value: Any) -> np.ndarray:
    """Return obstacles as records, checked; ValueError names the obstacle and its fault."""
    if isinstance(value, np.ndarray) and value.dtype == OBSTACLE and value.ndim == 1:
        rows = np.stack([value[name] for name in OBSTACLE.names or ()], axis=-1)
    else:
        rows = as_float_array("obstacles", FORM, value)
        rows = rows.reshape(0, 5) if rows.size == 0 else rows
    if rows.ndim != 2 or rows.shape[1] not in (4, 5):
        raise_not_allowed("obstacles", f"{FORM}, of shape (n, 4) or (n, 5)", rows.shape)
    if len(rows) > MOST_OBSTACLES:
        raise_not_allowed("obstacles", f"at most {MOST_OBSTACLES}", len(rows))
    return obstacle_records(rows)


def obstacle_records(rows: np.ndarray) -> np.ndarray:
    """Convert rows of x, y, vx, vy and optionally a radius to records; ValueError for numbers out of range."""
    obstacles = np.zeros(len(rows), OBSTACLE)
    obstacles["radius"] = OBSTACLE_RADIUS
    limits = {"x": FARTHEST, "y": FARTHEST, "vx": FASTEST, "vy": FASTEST, "radius": 5.0}
    for column, name in zip(rows.T, OBSTACLE.names or (), strict=False):
        low = 0.0 if name == "radius" else -limits[name]
        for i in np.flatnonzero(~((column >= low) & (column <= limits[name]))):
            raise_not_allowed(f"obstacles[{i}].{name}", Range(low, limits[name]).text(), float(column[i]))
        obstacles[name] = column
    return obstacles


def as_float_array(name: str, allowed: str, value: Any) -> np.ndarray:
    """Convert a value to an array of floats; ValueError if that fails."""
    try:
        array = np.array(value, dtype=float)
    except (TypeError, ValueError):
        raise_not_allowed(name, allowed, value)
    return array
