"""The compiled loop over matches and robots that computes percepts, shared by all kinds of robots.

`k`: the league's constants; `s`: settings of the sensors.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.compiling.borrowing import borrow_arrays, keep_alive
from soccer_env.perception.body import sense_body
from soccer_env.records.world import World


class SensorArrays(NamedTuple):
    """The arrays that perception fills for M matches of R robots; each kind of robot has its own records."""

    percepts: np.ndarray  # (M, R) what the sensors deliver, with a BODY_PERCEPT "body"
    states: np.ndarray  # (M, R) what they remember but do not deliver, with a POSE_ERROR "pose_error"
    pending: np.ndarray  # (M, R, frames) pictures on their way, as percepts


class SensorNumbers(NamedTuple):
    """The constants and settings that the sensors read."""

    constants: np.ndarray  # (1,) CONSTANTS; under variation (1 + M,), first the league's own
    sensors: np.ndarray  # (1,) or (1 + M,) record of the league's sensors
    pose_sensed: int  # 1: robots get the noisy pose as a percept


def make_sensor_kernel(make_scratch: Callable[..., Any], sense_robot: Callable[..., None]) -> Callable[..., None]:
    """Compile the sensing loop over matches and robots for one kind of robot; return the compiled function.

    sense_robot(match, ball, robots, r, percept, state, pending, scratch, k, s) fills in robot r's percept, except what
    its body feels; make_scratch(k, s) returns the `scratch` arrays for it.
    """

    @compiled
    def sense_slice(world, sensing, numbers, asleep, rows, first, last):
        """Compute the percepts of some robots of a slice of matches; matches that are `asleep` (M,) stay unchanged."""
        world = World(*borrow_arrays(world))
        numbers = SensorNumbers(*borrow_arrays(numbers))
        varied, pose_sensed = len(numbers.constants) > 1, numbers.pose_sensed
        percepts, states, pending = SensorArrays(*borrow_arrays(sensing))
        owned = make_scratch(numbers.constants[0], numbers.sensors[0])
        scratch = borrow_arrays(owned)
        for m in range(first, last):
            if asleep[m]:
                continue
            match, ball, robots = world.matches[m], world.balls[m], world.robots[m]
            robot_events, own = world.robot_events[m], m + 1 if varied else 0
            k, s = numbers.constants[own], numbers.sensors[own]
            for r in rows:
                percept = percepts[m, r]
                state = states[m, r]
                sense_body(match, robots[r], robot_events[r], percept.body, state.pose_error, k, s, pose_sensed)
                sense_robot(match, ball, robots, r, percept, state, pending[m, r], scratch, k, s)
        keep_alive(owned)

    return sense_slice
