"""Paws that swing while a robot walks: how they move in a control step, for the ball that they meet.  MS51

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.physics.gait import paw_offset, stance
from soccer_env.physics.solver_records import PAWS


@compiled
def note_paws(robot, k, paws, handedness):
    """Note where a robot's paws are before its gait goes on; paws (4,) of PAW."""
    for leg in range(PAWS):
        x, y = stance(k, leg)
        ahead, left = paw_offset(robot, k, leg, handedness)
        paws[leg].x, paws[leg].y = x + ahead, y + left


@compiled
def aim_paws(robot, k, paws, handedness):
    """Give the paws the velocity that takes them, within a control step, to where the gait now wants them."""
    for leg in range(PAWS):
        x, y = stance(k, leg)
        ahead, left = paw_offset(robot, k, leg, handedness)
        paws[leg].vx = (x + ahead - paws[leg].x) / k.dt
        paws[leg].vy = (y + left - paws[leg].y) / k.dt
