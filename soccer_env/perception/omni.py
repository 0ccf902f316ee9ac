"""What the sensors of a middle-size robot deliver in a frame: mirror camera, wheels, light barrier."""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.leagues.league import League
from soccer_env.perception.body import sense_body
from soccer_env.perception.ideal import situation

TABLES = np.dtype([("unused", "f8")])


def line_tables(league: League) -> np.ndarray:
    """Return the (1,) record of what a robot knows beforehand of its field."""
    return np.zeros(1, TABLES)


@compiled
def sense_slice(
    matches, balls, robots, robot_events, percepts, pending, beliefs, constants, sensors, pose_sensed, rows, first, last
):
    """Fill the percepts (M, R) of some robots of a slice of matches, and what they are told of the game."""
    k, s = constants[0], sensors[0]
    for m in range(first, last):
        match, team = matches[m], robots[m]
        for r in rows:
            percept, robot = percepts[m, r], team[r]
            sense_body(match, robot, robot_events[m, r], percept.body, k, s, pose_sensed)
            situation(match, team, beliefs[m, r].situation, r)
