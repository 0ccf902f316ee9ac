"""Measures of a plan: its smallest gap to moving obstacles, its total turn, and the forces along it."""

import numpy as np

from soccer_env.baselines.weigel_2001.planner.potential import FARTHEST, attractive_force, gap_at, repulsive_force
from soccer_env.baselines.weigel_2001.planner.stepping import obstacle_time
from soccer_env.compiled import compiled
from soccer_env.geometry import length


@compiled
def place_along_path(path, count, far, place):
    """Write the point at distance `far` [m] along a path into `place`; return the index of the next path point."""
    left = far
    for i in range(1, count):
        dx, dy = path[i].x - path[i - 1].x, path[i].y - path[i - 1].y
        piece = length(dx, dy)
        if left < piece:
            share = max(left, 0.0) / piece
            place.x, place.y = path[i - 1].x + share * dx, path[i - 1].y + share * dy
            return i
        left -= piece
    place.x, place.y = path[count - 1].x, path[count - 1].y
    return count


@compiled
def least_gap(plan, obstacles, settings, step, place):
    """Return the smallest gap [m] to any obstacle while driving a plan at full speed, sampled every `step` [s].

    Obstacles keep their velocities. place: scratch record (1,).
    """
    least = FARTHEST
    count = int(plan.time / step) + 2
    for i in range(count):
        t = min(i * step, plan.time)
        place_along_path(plan.path, plan.count, t * settings.speed, place[0])
        least = min(least, gap_at(place[0].x, place[0].y, t, obstacles, settings))
    return least


@compiled
def fill_forces(plan, obstacles, settings, forces):
    """Compute the forces (count, 4) at a plan's cells: x, y of the attractive, x, y of the repulsive force."""
    goal = plan.robot if settings.backward == 1 else plan.target
    for i in range(plan.count):
        cell = plan.cells[i]
        x, y = cell.u * settings.cell, cell.v * settings.cell
        forces[i, 0], forces[i, 1] = attractive_force(x, y, goal, settings)
        now = obstacle_time(cell.t, settings)
        forces[i, 2], forces[i, 3] = repulsive_force(x, y, now, obstacles, settings)


def total_turn(path: np.ndarray) -> float:
    """Return the total turn of a path (N, 2) [rad]: the sum of the absolute angles of its bends."""
    steps = np.diff(path, axis=0)
    steps = steps[np.hypot(steps[:, 0], steps[:, 1]) > 1e-9]
    if len(steps) < 2:
        return 0.0
    a, b = steps[:-1], steps[1:]
    across, along = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], (a * b).sum(axis=1)
    return float(np.abs(np.arctan2(across, along)).sum())
