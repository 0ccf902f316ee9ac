"""Kernels of compiled teams, made from the function of a single player, with the loop over matches and players.

    @compiled
    def act(belief, tracks, memory, noise, command, k, settings, scratch):
        command.forward = settings.strength

    team = CompiledTeam("runner", per_player(act), NO_MEMORY, np.array([(1.0,)], STRENGTH))

Make a kernel once, at the top of a module: every call makes another kernel, which is compiled again.

`k`: the league's constants.
"""

from collections.abc import Callable

import numpy as np

from soccer_env.compiled import compiled, scratch_records
from soccer_env.compiling.borrowing import borrow_arrays, keep_alive
from soccer_env.guards.ranges import ANY, ranged_record

NO_MEMORY = ranged_record([("unused", "i8", ANY)])  # of players that remember nothing
NO_SCRATCH = NO_MEMORY
STRENGTH = np.dtype([("strength", "f8")])  # the settings of a team that has no others


def per_player(act: Callable[..., None], scratch: np.dtype = NO_SCRATCH) -> Callable[..., None]:
    """Make the kernel of a team in which each player runs `act`, a compiled function.

    act(belief, tracks, memory, noise, command, k, settings, scratch): one player's belief, (slots,) tracks, memory and
    random streams, the command to fill in, the league's constants, the team's settings (its only record, or that of the
    league's kind of base if there is one for each, in the order of `DRIVE_KINDS`), and a record of dtype `scratch` to
    work in, which still holds the values of the player before.
    """

    @compiled
    def kernel(beliefs, tracks, memory, noise, commands, players, constants, settings, first, last):
        owned, k = scratch_records(1, scratch), constants[0]
        own, work = settings[k.drive_kind if len(settings) > 1 else 0], borrow_arrays(owned)
        beliefs, tracks, memory, noise, commands = borrow_arrays((beliefs, tracks, memory, noise, commands))
        for m in range(first, last):
            for p in range(len(players)):
                r = players[p]
                act(beliefs[m, r], tracks[m, r], memory[m, p], noise[m, r], commands[m, r], k, own, work[0])
        keep_alive(owned)

    return kernel


def per_blind_player(act: Callable[..., None]) -> Callable[..., None]:
    """Make the kernel of a team with `blind=True`, whose players use neither sensors nor beliefs.

    act(memory, noise, command, k, settings) is as in `per_player`.
    """

    @compiled
    def kernel(beliefs, tracks, memory, noise, commands, players, constants, settings, first, last):
        k, own = constants[0], settings[0]
        for m in range(first, last):
            for p in range(len(players)):
                act(memory[m, p], noise[m, players[p]], commands[m, players[p]], k, own)

    return kernel
