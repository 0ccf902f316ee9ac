"""Scenes for the planners: canonical crossings, random ones, slow traffic, still obstacles, rows and cups of robots.

Obstacles are rows of x, y [m], vx, vy [m/s]; the middle of the pitch is at 0, 0.
"""

from math import cos, pi, sin
from typing import NamedTuple

import numpy as np

BODY = 0.5  # [m] between the middles of two robots that touch
WAY = 5.0  # [m] from robot to target, as in the paper's figure
CROSSERS = (0.5, 2.5)  # [m/s] of a crossing obstacle, assumed
LATE = 0.3  # [s] by which it comes earlier or later than the robot, at most, assumed
SLOW = 0.3  # [m/s] of slow traffic at most
SLOW_OBSTACLES = 4
STAYS = 4.0  # [s] for which it leaves the target free, twice the time of the straight way
ROOM = 0.9  # [m] free of slow traffic around robot and target, assumed


class Scene(NamedTuple):
    """The input of a planner: the robot's start, its target, and the obstacles."""

    robot: tuple[float, float]
    target: tuple[float, float]
    obstacles: list[tuple[float, float, float, float]]


# Crossings of the straight way as in the paper's figure: chosen with a sketch of the planner, 2 of 260 draws
CANONICAL = {
    "a": Scene((-3.0, 0.0), (3.0, 0.0), [(-0.31, 1.15, 0.0, -2.13)]),
    "b": Scene((-3.0, 0.0), (2.0, 0.0), [(-1.15, 0.63, 0.0, -2.15)]),
}


def turned_scene(rng: np.random.Generator, obstacles: list[tuple[float, float, float, float]]) -> Scene:
    """Rotate a scene, given with its path of WAY metres along x, at random, and move it near the pitch's middle."""
    way = rng.uniform(-pi, pi)
    x, y = rng.uniform(-0.5, 0.5, 2) - 0.5 * WAY * np.array([cos(way), sin(way)])

    def place(ahead: float, left: float) -> tuple[float, float]:
        return float(x + cos(way) * ahead - sin(way) * left), float(y + sin(way) * ahead + cos(way) * left)

    def turn(ahead: float, left: float) -> tuple[float, float]:
        return float(cos(way) * ahead - sin(way) * left), float(sin(way) * ahead + cos(way) * left)

    rows = [(*place(ox, oy), *turn(vx, vy)) for ox, oy, vx, vy in obstacles]
    return Scene(place(0.0, 0.0), place(WAY, 0.0), rows)


def crossing(rng: np.random.Generator, speed: float) -> Scene:
    """Draw a scene in which an obstacle crosses the straight path as a robot of `speed` [m/s] comes to this point."""
    far = rng.uniform(0.3, 0.7) * WAY
    when = far / speed + rng.uniform(-LATE, LATE)
    v, way = rng.uniform(*CROSSERS), rng.choice([-1.0, 1.0]) * rng.uniform(pi / 4, 3 * pi / 4)
    vx, vy = v * cos(way), v * sin(way)
    return turned_scene(rng, [(far - when * vx, -when * vy, vx, vy)])


def slow_traffic(rng: np.random.Generator) -> Scene:
    """Draw a scene with obstacles that move slowly in any direction, the first of them near the straight path."""
    rows: list[tuple[float, float, float, float]] = []
    while len(rows) < SLOW_OBSTACLES:
        wide = 0.3 if not rows else 1.5
        x, y = rng.uniform(0.8, WAY - 0.8), rng.uniform(-wide, wide)
        v, way = rng.uniform(0.0, SLOW), rng.uniform(-pi, pi)
        if min(np.hypot(x + t * v * cos(way) - WAY, y + t * v * sin(way)) for t in np.linspace(0.0, STAYS, 9)) < ROOM:
            continue
        apart = min((np.hypot(x - ox, y - oy) for ox, oy, _, _ in rows), default=9.0)
        if min(np.hypot(x, y), np.hypot(x - WAY, y), apart) > ROOM:
            rows.append((float(x), float(y), float(v * cos(way)), float(v * sin(way))))
    return turned_scene(rng, rows)


def still_obstacle(rng: np.random.Generator) -> Scene:
    """Draw a scene with one standing obstacle on the straight path or a little beside the path."""
    return turned_scene(rng, [(float(rng.uniform(0.35, 0.65) * WAY), float(rng.uniform(-0.2, 0.2)), 0.0, 0.0)])


def robot_row_or_cup(rng: np.random.Generator) -> Scene:
    """Draw a scene with a row of two or three touching robots across the path, or a cup of nine about the target."""
    kind = rng.integers(3)
    middle = float(rng.uniform(0.4, 0.6) * WAY)
    if kind < 2:
        count = 2 + kind
        return turned_scene(rng, [(middle, BODY * (i - 0.5 * (count - 1)), 0.0, 0.0) for i in range(count)])
    bottom = WAY - 0.85
    rows = [(bottom, BODY * i, 0.0, 0.0) for i in range(-2, 3)]
    rows += [(bottom + BODY * i, side * 2.0 * BODY, 0.0, 0.0) for i in (1, 2) for side in (-1.0, 1.0)]
    return turned_scene(rng, rows)
