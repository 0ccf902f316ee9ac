"""Scenes for the planner: obstacles as rows of x, y, vx, vy, in metres of a pitch with the origin in its middle."""

from __future__ import annotations

from math import cos, sin
from typing import Any, NamedTuple

import numpy as np

BODY = 0.5  # [m] from middle to middle of two robots that touch


class Scene(NamedTuple):
    """What a planner is asked."""

    robot: tuple[float, float]
    target: tuple[float, float]
    obstacles: list[tuple[float, ...]]

    def mirrored(self) -> Scene:
        """Return the scene with left and right swapped."""
        (x, y), (to_x, to_y) = self.robot, self.target
        others = [(ox, -oy, vx, -vy, *more) for ox, oy, vx, vy, *more in self.obstacles]
        return Scene((x, -y), (to_x, -to_y), others)


def from_corner(robot: Any, target: Any, obstacle: Any) -> Scene:
    """Return a scene of an 8 x 12 m pitch with its origin in a corner, turned onto one of 12 x 8 m."""
    (x, y), (to_x, to_y), (ox, oy, vx, vy) = robot, target, obstacle
    return Scene((y - 6.0, 4.0 - x), (to_y - 6.0, 4.0 - to_x), [(oy - 6.0, 4.0 - ox, vy, -vx)])


# Where an obstacle crosses the straight way as in the paper's figure, found by a sketch of the planner.
CROSSING_A = from_corner((4.0, 3.0), (4.0, 9.0), (2.85, 5.69, 2.13, 0.0))
CROSSING_B = from_corner((4.0, 3.0), (4.0, 8.0), (3.37, 4.85, 2.15, 0.0))


def at_bearing(angle: float, points: list[tuple[float, float]]) -> list[tuple[float, ...]]:
    """Return still obstacles at points turned by an angle about the middle of the pitch."""
    return [(cos(angle) * x - sin(angle) * y, sin(angle) * x + cos(angle) * y, 0.0, 0.0) for x, y in points]


def row(count: int, angle: float) -> Scene:
    """Return a row of robots that touch, square to the way from one side of it to the other."""
    places = [(0.0, BODY * (i - 0.5 * (count - 1))) for i in range(count)]
    return Scene(
        (-2.0 * cos(angle), -2.0 * sin(angle)), (1.5 * cos(angle), 1.5 * sin(angle)), at_bearing(angle, places)
    )


def cup(angle: float) -> Scene:
    """Return a U of nine robots that touch, the target between its sides, the robot behind its bottom."""
    places = [(0.0, BODY * i) for i in range(-2, 3)]
    places += [(BODY * i, side) for i in (1, 2) for side in (-2 * BODY, 2 * BODY)]
    return Scene(
        (-2.0 * cos(angle), -2.0 * sin(angle)), (0.85 * cos(angle), 0.85 * sin(angle)), at_bearing(angle, places)
    )


def random_scene(rng: np.random.Generator, most: int = 9, speed: float = 2.0) -> Scene:
    """Return a scene anywhere on the pitch, with obstacles that do not touch robot or target now."""
    robot, target = rng.uniform((-6.0, -4.0), (6.0, 4.0), (2, 2))
    obstacles: list[tuple[float, ...]] = []
    while len(obstacles) < most:
        place, way, v = rng.uniform((-6.0, -4.0), (6.0, 4.0)), rng.uniform(-3.0, 3.0), rng.uniform(0.0, speed)
        if min(np.hypot(*(place - robot)), np.hypot(*(place - target))) > 0.6:
            obstacles.append((*map(float, place), float(v * np.cos(way)), float(v * np.sin(way))))
    return Scene((float(robot[0]), float(robot[1])), (float(target[0]), float(target[1])), obstacles)
