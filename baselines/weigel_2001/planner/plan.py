"""`Plan`: a planned path from robot to target, with its measures and the inputs to plan it again."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.baselines.weigel_2001.planner.measuring import fill_forces, least_gap, place_along_path, total_turn
from soccer_env.baselines.weigel_2001.planner.planning import plan_way
from soccer_env.baselines.weigel_2001.planner.records import ENDINGS, PLAN, POINT, SCRATCH
from soccer_env.baselines.weigel_2001.planner.settings import PlannerSettings
from soccer_env.guards.checking import FROM_ZERO, check_finite_number

LOOK = 0.01  # [s] between two looks at the gap along a plan


@dataclass(frozen=True, eq=False)
class Plan:
    """A planned path from the robot to the target over N grid cells, with its inputs, to be planned again."""

    record: np.ndarray  # (1,) of records.PLAN
    obstacles: np.ndarray  # (n,) of records.OBSTACLE
    settings: PlannerSettings
    ends: tuple[float, float, float, float]  # [m] robot and target, as given

    @property
    def path(self) -> np.ndarray:
        """The path to drive, points (N, 2) [m] from the robot to the target."""
        points: np.ndarray = self._points(self.record["path"][0])
        return points

    @property
    def cells(self) -> np.ndarray:
        """The grid cells (N, 2) of the way, from the robot's cell to the target's."""
        cells = self.record["cells"][0][: len(self)]
        return np.stack([cells["u"], cells["v"]], axis=-1)

    @property
    def cell_times(self) -> np.ndarray:
        """The planned time of arrival [s] at each cell (N,), counted from now."""
        times: np.ndarray = self.record["cells"][0]["t"][: len(self)].copy()
        return times

    @property
    def slopes(self) -> np.ndarray:
        """The gradient (N, 2) of the potential at each cell, 0 where it was not needed: (2)."""
        cells = self.record["cells"][0][: len(self)]
        return np.stack([cells["slope_x"], cells["slope_y"]], axis=-1)

    @property
    def ended(self) -> str:
        """The end of planning: "arrived", or the reason why part of the path is only a straight line."""
        return ENDINGS[int(self.record["ended"][0])]

    @property
    def arrived(self) -> bool:
        """Whether the planned way connects robot and target."""
        return self.ended == "arrived"

    @property
    def converged(self) -> bool:
        """Whether the assumed and the resulting travel time (T a priori, T a posteriori) agree."""
        return bool(self.record["converged"][0])

    @property
    def iterations(self) -> int:
        """The number of passes over the grid."""
        return int(self.record["iterations"][0])

    @property
    def guesses(self) -> np.ndarray:
        """The travel time [s] assumed in each pass: T a priori."""
        guesses: np.ndarray = self.record["guesses"][0][: self.iterations].copy()
        return guesses

    @property
    def times(self) -> np.ndarray:
        """The travel time [s] resulting from each pass: T a posteriori."""
        times: np.ndarray = self.record["times"][0][: self.iterations].copy()
        return times

    @property
    def time(self) -> float:
        """The time [s] to drive the path at full speed."""
        return float(self.record["time"][0])

    @property
    def least_time(self) -> float:
        """The time [s] to drive the straight line at full speed: T_min."""
        return float(self.record["least_time"][0])

    @property
    def length(self) -> float:
        """The length [m] of the path."""
        return float(self.record["length"][0])

    @property
    def turn(self) -> float:
        """The total turn of the path [rad], to the left and to the right."""
        return total_turn(self.path)

    @property
    def evaluations(self) -> int:
        """The number of evaluations of the potential in all passes."""
        return int(self.record["evaluations"][0])

    def __len__(self) -> int:
        return int(self.record["count"][0])

    def clearance(self) -> float:
        """Return the smallest gap [m] to an obstacle, surface to surface: below 0 for an overlap, 1e9 without any.

        The robot drives the path from now at full speed, and obstacles keep their velocities.
        """
        play = self.settings.record()[0]
        return float(least_gap(self.record[0], self.obstacles, play, LOOK, np.zeros(1, POINT)))

    def forces(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the attractive and the repulsive force (N, 2) at each cell, at the time of arrival there."""
        forces = np.zeros((len(self), 4))
        fill_forces(self.record[0], self.obstacles, self.settings.record()[0], forces)
        return forces[:, :2], forces[:, 2:]

    def at(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        """Return the positions [m] of the robot (2,), at full speed, and of the obstacles (n, 2) after t [s]."""
        t = check_finite_number("t", t, FROM_ZERO)
        place = np.zeros(1, POINT)
        place_along_path(self.record[0]["path"], len(self), t * self.settings.speed, place[0])
        others = np.stack([self.obstacles[a] + t * self.obstacles[f"v{a}"] for a in "xy"], axis=-1)
        return np.array([place["x"][0], place["y"][0]]), others

    def again(self, **changes: Any) -> Plan:
        """Plan again from the stored inputs: an identical plan, or a plan with changed settings."""
        settings = self.settings.changed(changes)
        return make_plan(self.ends, int(self.record["side"][0]), self.obstacles, settings, np.zeros(1, SCRATCH))

    def _points(self, points: np.ndarray) -> np.ndarray:
        return np.stack([points["x"][: len(self)], points["y"][: len(self)]], axis=-1)


def make_plan(
    ends: tuple[float, float, float, float],
    side: int,
    obstacles: np.ndarray,
    settings: PlannerSettings,
    scratch: np.ndarray,
) -> Plan:
    """Make a plan from checked input."""
    record = np.zeros(1, PLAN)
    plan_way(*ends, side, obstacles, settings.record()[0], scratch[0], record[0])
    return Plan(record, obstacles, settings, ends)
