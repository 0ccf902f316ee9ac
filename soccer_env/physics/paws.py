"""Paws that swing while a robot walks: how they move in a control step, for the ball that they meet.  MS51

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.physics.gait import LEGS, paw_offset


@compiled
def note_paws(robot, k, posts, handedness):
    """Note where a robot's paws are before its gait goes on; posts (4,) of POST."""
    for leg in range(LEGS):
        paw = posts[leg]
        ahead, left = paw_offset(robot, k, leg, handedness)
        paw.x, paw.y = paw.stand_x + ahead, handedness * paw.stand_y + left


@compiled
def aim_paws(robot, k, posts, handedness):
    """Give the paws the velocity that takes them, within a control step, to where the gait now wants them."""
    for leg in range(LEGS):
        paw = posts[leg]
        ahead, left = paw_offset(robot, k, leg, handedness)
        paw.vx = (paw.stand_x + ahead - paw.x) / k.dt
        paw.vy = (handedness * paw.stand_y + left - paw.y) / k.dt
