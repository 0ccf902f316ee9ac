"""The team that wanders about at random: each player keeps a random command for a while, then draws another.

`k`: the league's constants.
"""

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.guards.ranges import NUMBER, ranged_record
from soccer_env.random_numbers import draw_uniform
from soccer_env.teams import CompiledTeam
from soccer_env.teams.kernels import STRENGTH, per_blind_player
from soccer_env.types import RobotStream

MEMORY = ranged_record(
    [
        ("seconds", "f8", NUMBER),  # [s] until the next draw
        ("forward", "f8", NUMBER),  # [-1, 1]
        ("left", "f8", NUMBER),  # [-1, 1]
        ("turn", "f8", NUMBER),  # [-1, 1]
        ("kick", "f8", NUMBER),  # [-1, 1]
    ]
)
LONGEST = 1.5  # [s] a command is kept at most
TEAM = int(RobotStream.TEAM)


def team(strength: float = 1.0) -> CompiledTeam:
    """Return a team of random walkers; `strength` scales their speed and how often they kick."""
    return CompiledTeam("random", RANDOM, MEMORY, np.array([(strength,)], STRENGTH), blind=True)


@compiled
def choose_random_command(memory, noise, command, k, settings):
    """Write the remembered command, or draw a new random command when the old command's time is over."""
    strength = settings.strength
    memory.seconds -= k.dt
    if memory.seconds <= 0.0:
        memory.seconds = LONGEST * draw_uniform(noise, TEAM)
        memory.forward = strength * (2.0 * draw_uniform(noise, TEAM) - 1.0)
        memory.left = strength * (2.0 * draw_uniform(noise, TEAM) - 1.0)
        memory.turn = strength * (2.0 * draw_uniform(noise, TEAM) - 1.0)
        memory.kick = 2.0 * draw_uniform(noise, TEAM) - 2.0 + strength
    command.forward, command.left = memory.forward, memory.left
    command.turn, command.kick = memory.turn, memory.kick
    command.head = -1.0


RANDOM = per_blind_player(choose_random_command)
