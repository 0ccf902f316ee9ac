"""Paws that swing while a robot walks, or spread for a block: how they move in a control step.  MS51, MS53

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.physics.block import paw_out, spread_of
from soccer_env.physics.gait import LEGS, TIPS, paw_offset


@compiled
def note_paws(robot, k, stance, handedness):
    """Note where a robot's paws are before its gait goes on, and how far a block has spread its forelegs."""
    for leg in range(LEGS):
        paw = stance.posts[leg]
        ahead, left = paw_offset(robot, k, leg, handedness)
        paw.x, paw.y = paw.stand_x + ahead, handedness * paw.stand_y + left
    stance.spread = spread_of(robot, k, 0.0)
    if stance.spread > 0.0:
        for leg in range(TIPS):
            paw = stance.posts[leg]
            ahead, left = paw_out(k, leg, stance.spread, handedness)
            paw.x += ahead
            paw.y += left


@compiled
def aim_paws(robot, k, stance, handedness):
    """Give the paws the velocity that takes them, within a control step, to where gait or block now want them."""
    spread = spread_of(robot, k, k.dt)
    stance.spread_rate = (spread - stance.spread) / k.dt
    for leg in range(LEGS):
        paw = stance.posts[leg]
        ahead, left = paw_offset(robot, k, leg, handedness)
        if spread > 0.0:
            out_x, out_y = paw_out(k, leg, spread, handedness)
            ahead += out_x
            left += out_y
        paw.vx = (paw.stand_x + ahead - paw.x) / k.dt
        paw.vy = (handedness * paw.stand_y + left - paw.y) / k.dt
