"""What the sensors of a middle-size robot deliver in a frame: mirror camera, wheels, light barrier."""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.perception.body import sense_body
from soccer_env.perception.ideal import situation
from soccer_env.perception.lines import TABLES, line_tables

__all__ = ["TABLES", "line_tables", "sense_slice"]


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
