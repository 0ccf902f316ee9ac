"""The team that walks straight ahead from where it stands, at strength times its top speed, and stops at nothing.

It moves the players of drills: strengths 0.25, 0.5, 0.75 and 1 are 3, 6, 9 and 12 cm/s in the legged league.

`k`: the league's constants.
"""

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.skills.moves import stand
from soccer_env.teams import CompiledTeam
from soccer_env.teams.kernels import NO_MEMORY, STRENGTH, per_blind_player


def team(strength: float = 1.0) -> CompiledTeam:
    """Return a team whose players walk straight ahead without end; `strength` scales their speed."""
    return CompiledTeam("walker", WALKER, NO_MEMORY, np.array([(strength,)], STRENGTH), blind=True)


@compiled
def walk_on(memory, noise, command, k, settings):
    """Write a command to walk straight ahead."""
    stand(command)
    command.forward = settings.strength


WALKER = per_blind_player(walk_on)
