"""The team that walks straight ahead from where it stands, at strength times its top speed, and stops at nothing.

What moves in drills: strengths 0.25, 0.5, 0.75 and 1 are 3, 6, 9 and 12 cm/s in the legged league.
"""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.teams import CompiledTeam

MEMORY = np.dtype([("unused", "i8")])
SETTINGS = np.dtype([("strength", "f8")])


def team(strength: float = 1.0) -> CompiledTeam:
    """Return a team whose players walk on and on."""
    return CompiledTeam("walker", walk_on, MEMORY, np.array([(strength,)], SETTINGS), blind=True)


@compiled
def walk_on(beliefs, tracks, memory, noise, commands, players, constants, settings, first, last):
    """Command every player to walk straight ahead."""
    for m in range(first, last):
        for r in players:
            command = commands[m, r]
            command.forward = settings[0].strength
            command.left = command.turn = command.kick = 0.0
            command.head = -1.0
