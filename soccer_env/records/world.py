"""World: the true records of M matches, bundled into one argument of kernels.

Code that takes a World sees the truth. Neither belief/ nor a team ever gets one.

Bundles go into kernels as plain tuples, each of which numba recognises half a microsecond faster, and become named
tuples there: `world = World(*world)` costs nothing.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from soccer_env.types import BALL, EVENTS, MATCH, ROBOT, ROBOT_EVENTS


class World(NamedTuple):
    """The records of M matches of R robots each, and their events in the last control step."""

    matches: np.ndarray  # (M,) MATCH
    balls: np.ndarray  # (M,) BALL
    robots: np.ndarray  # (M, R) ROBOT
    events: np.ndarray  # (M,) EVENTS
    robot_events: np.ndarray  # (M, R) ROBOT_EVENTS

    @classmethod
    def empty(cls, matches: int, robots: int) -> World:
        """Return a World of records for M matches of R robots, filled with zeros."""
        return cls(
            np.zeros(matches, MATCH),
            np.zeros(matches, BALL),
            np.zeros((matches, robots), ROBOT),
            np.zeros(matches, EVENTS),
            np.zeros((matches, robots), ROBOT_EVENTS),
        )
