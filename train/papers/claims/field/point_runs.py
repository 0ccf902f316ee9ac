"""The results of runs of points: paths, changes of side, clearances, arrivals.  [Sacks 2001, 4.3]"""

from dataclasses import dataclass

import numpy as np

SIDE = 0.35  # [rad] off the goal beyond which a way counts as left or right of it: 20 degrees, assumed
ROUNDING = 1e-9  # [m]


@dataclass(frozen=True)
class PointRuns:
    """M runs of points over T decisions; values are NaN once a point has arrived."""

    path: np.ndarray  # (T + 1, M, 2) [m] team frame
    off: np.ndarray  # (T, M) [rad] of each step off the goal's direction, left positive
    others: np.ndarray  # (T + 1, M, P, 2) [m] the other players
    goal: float  # [m] x of the destination
    replan: float  # [s] between two decisions

    @property
    def arrived(self) -> np.ndarray:
        """Tell which points arrived (M,)."""
        return np.asarray(np.isnan(self.path[-1, :, 0]))

    @property
    def clearance(self) -> np.ndarray:
        """Return the least distance to another player (M,) [m], at decisions and between decisions."""
        gap = self.others - self.path[:, :, None]
        before, change = gap[:-1], np.diff(gap, axis=0)
        square = np.maximum((change**2).sum(axis=-1), ROUNDING**2)
        share = np.clip(-(before * change).sum(axis=-1) / square, 0.0, 1.0)
        nearest = np.linalg.norm(before + share[..., None] * change, axis=-1)
        return np.asarray(np.nanmin(nearest, axis=(0, 2)))

    @property
    def flips(self) -> np.ndarray:
        """Count how often each path changes between left and right of the goal's direction (M,)."""
        side = np.where(np.abs(self.off) > SIDE, np.sign(self.off), 0.0)
        count, last = np.zeros(side.shape[1], int), np.zeros(side.shape[1])
        for now in side:
            count += now * last < 0.0
            last = np.where(now != 0.0, now, last)
        return count

    @property
    def steps(self) -> np.ndarray:
        """Count the decisions of each run (M,)."""
        return np.asarray(np.isfinite(self.off).sum(axis=0))

    @property
    def retreats(self) -> np.ndarray:
        """Count the steps that lead away from the goal (M,)."""
        distance = np.hypot(self.goal - self.path[..., 0], self.path[..., 1])
        return np.asarray((np.diff(distance, axis=0) > ROUNDING).sum(axis=0))

    @property
    def length(self) -> np.ndarray:
        """Return the lengths of the paths (M,) [m]."""
        return np.asarray(np.nansum(np.linalg.norm(np.diff(self.path, axis=0), axis=-1), axis=0))

    @property
    def deviation(self) -> np.ndarray:
        """Return the greatest distance of each path from the straight line between start and goal (M,) [m]."""
        start = self.path[0]
        line = np.stack([self.goal - start[:, 0], -start[:, 1]], axis=-1)
        way = self.path - start
        across = (line[:, 0] * way[..., 1] - line[:, 1] * way[..., 0]) / np.linalg.norm(line, axis=-1)
        return np.asarray(np.nanmax(np.abs(across), axis=0))

    @property
    def turns(self) -> np.ndarray:
        """Return the change of direction from each step to the next (T - 1, M) [rad]."""
        way = np.diff(self.path, axis=0)
        turn = np.diff(np.arctan2(way[..., 1], way[..., 0]), axis=0)
        return (turn + np.pi) % (2.0 * np.pi) - np.pi
