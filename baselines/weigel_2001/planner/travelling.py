"""A point that plans anew every cycle and drives on: the paper's demonstration, without a robot.  MH14, MH18, MH25

The point drives at full speed along the newest path and turns at once; obstacles keep their velocities. A travel shows
the plans by themselves; a match shows them with inertia, noise and delay.
"""

from dataclasses import dataclass

import numpy as np

from soccer_env.baselines.weigel_2001.planner.measuring import place_along_path, total_turn
from soccer_env.baselines.weigel_2001.planner.planning import plan_way
from soccer_env.baselines.weigel_2001.planner.potential import gap_at
from soccer_env.baselines.weigel_2001.planner.records import PLAN, POINT
from soccer_env.baselines.weigel_2001.planner.settings import PlannerSettings
from soccer_env.compiled import compiled
from soccer_env.geometry import length

CYCLE = 0.02  # [s] Heinemann 2006, 2: "a global 20ms cycle"  MH14

STATION = np.dtype(
    [
        ("x", "f8"),  # [m] the point at the beginning of a cycle
        ("y", "f8"),  # [m]
        ("gap", "f8"),  # [m] to the nearest obstacle, from surface to surface
        ("left", "f8"),  # [m] from the target
        ("time", "f8"),  # [s] of the plan made there; 0 at the last station
        ("iterations", "i8"),
        ("converged", "i8"),
        ("ended", "i8"),  # ENDINGS
    ]
)


@dataclass(frozen=True, eq=False)
class Travel:
    """The drive of a point to its target: S stations, one for each cycle."""

    stations: np.ndarray  # (S,) of STATION
    plans: np.ndarray  # (S,) of records.PLAN, the last one empty
    obstacles: np.ndarray  # (n,) of records.OBSTACLE, as they were at first
    settings: PlannerSettings
    arrived: bool

    @property
    def path(self) -> np.ndarray:
        """The position (S, 2) [m] of the point in each cycle."""
        return np.stack([self.stations["x"], self.stations["y"]], axis=-1)

    @property
    def time(self) -> float:
        """The duration of the travel [s]."""
        return (len(self.stations) - 1) * CYCLE

    @property
    def length(self) -> float:
        """The distance driven [m]."""
        return float(np.hypot(*np.diff(self.path, axis=0).T).sum())

    @property
    def turn(self) -> float:
        """The total turn [rad] of the drive, to the left and to the right."""
        return total_turn(self.path)

    @property
    def clearance(self) -> float:
        """The smallest gap [m] between the point and an obstacle during the travel, below 0 for an overlap."""
        return float(self.stations["gap"].min())

    @property
    def cycles_away(self) -> int:
        """The number of cycles in which the point moved away from the target."""
        return int((np.diff(self.stations["left"]) > 0.0).sum())

    def planned(self, cycle: int) -> np.ndarray:
        """Return the path (N, 2) [m] that was planned at the start of a cycle."""
        plan = self.plans[cycle]
        points = plan["path"][: plan["count"]]
        return np.stack([points["x"], points["y"]], axis=-1)

    def others(self, cycle: int) -> np.ndarray:
        """Return the positions (n, 2) [m] of the obstacles at the start of a cycle."""
        t = cycle * CYCLE
        return np.stack([self.obstacles[a] + t * self.obstacles[f"v{a}"] for a in "xy"], axis=-1)


def make_travel(
    ends: tuple[float, float, float, float],
    side: int,
    obstacles: np.ndarray,
    settings: PlannerSettings,
    scratch: np.ndarray,
    seconds: float,
) -> Travel:
    """Simulate a travel from checked input."""
    most = round(seconds / CYCLE)
    stations, plans = np.zeros(most + 1, STATION), np.zeros(most + 1, PLAN)
    now = obstacles.copy()
    count = travel(*ends, side, obstacles, now, settings.record()[0], scratch[0], plans, stations, np.zeros(1, POINT))
    near = settings.speed * CYCLE
    return Travel(stations[:count], plans[:count], obstacles, settings, bool(stations["left"][count - 1] <= near))


@compiled
def travel(x, y, target_x, target_y, side, obstacles, now, settings, scratch, plans, stations, place):
    """Simulate a travel cycle by cycle until the target is one cycle away; return the number of stations.  MH14

    now: a copy of the obstacles, which this function moves; place: scratch record (1,).
    """
    for i in range(len(stations)):
        for j in range(len(now)):
            now[j].x = obstacles[j].x + i * CYCLE * obstacles[j].vx
            now[j].y = obstacles[j].y + i * CYCLE * obstacles[j].vy
        one = stations[i]
        one.x, one.y, one.gap = x, y, gap_at(x, y, 0.0, now, settings)
        one.left = length(target_x - x, target_y - y)
        if one.left <= settings.speed * CYCLE or i == len(stations) - 1:
            return i + 1
        plan = plans[i]
        plan_way(x, y, target_x, target_y, side, now, settings, scratch, plan)
        one.time, one.iterations = plan.time, plan.iterations
        one.converged, one.ended = plan.converged, plan.ended
        place_along_path(plan.path, plan.count, settings.speed * CYCLE, place[0])
        x, y = place[0].x, place[0].y
    return len(stations)
