"""The team that stands still."""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.teams import CompiledTeam

MEMORY = np.dtype([("unused", "i8")])
SETTINGS = np.dtype([("strength", "f8")])


def team(strength: float = 1.0) -> CompiledTeam:
    """Return a team whose players never move."""
    return CompiledTeam("still", stand_still, MEMORY, np.array([(strength,)], SETTINGS), blind=True)


@compiled
def stand_still(beliefs, tracks, memory, noise, commands, players, constants, settings, first, last):
    """Command every player to stand."""
    for m in range(first, last):
        for r in players:
            command = commands[m, r]
            command.forward = command.left = command.turn = command.kick = 0.0
            command.head = -1.0
