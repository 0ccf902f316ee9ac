"""Paws that swing while a robot walks: where they are in each substep, for the ball that they meet.  MS51"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.physics.chipmunk_memory import CIRCLE_X, CIRCLE_Y, store
from soccer_env.physics.solver_records import PAWS


@compiled
def swing_paws(solver, time):
    """Put the paws where they are a time [s] after the beginning of the control step."""
    for r in range(solver.robots):
        stance = solver.stances[r]
        for i in range(PAWS):
            paw = stance.paws[i]
            if paw.shape != 0:
                store(paw.shape + CIRCLE_X, paw.x + time * paw.vx)
                store(paw.shape + CIRCLE_Y, paw.y + time * paw.vy)
