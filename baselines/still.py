"""The team that stands still.

`k`: the league's constants.
"""

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.skills.moves import stand
from soccer_env.teams import CompiledTeam
from soccer_env.teams.kernels import NO_MEMORY, STRENGTH, per_blind_player


def team(strength: float = 1.0) -> CompiledTeam:
    """Return a team whose players never move."""
    return CompiledTeam("still", STILL, NO_MEMORY, np.array([(strength,)], STRENGTH), blind=True)


@compiled
def stand_still(memory, noise, command, k, settings):
    """Write a command with which the player stands still."""
    stand(command)


STILL = per_blind_player(stand_still)
