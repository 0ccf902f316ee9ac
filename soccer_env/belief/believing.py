"""The compiled loop over matches and robots that updates beliefs and exchanges messages, shared by all kinds of robots.

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.compiling.borrowing import borrow_arrays, keep_alive


class BeliefArrays(NamedTuple):
    """Beliefs and memories in M matches of R robots; each kind of robot has its own records of memory and message."""

    beliefs: np.ndarray  # (M, R) BELIEF
    tracks: np.ndarray  # (M, R, slots) TRACK
    memories: np.ndarray  # (M, R)
    particles: np.ndarray  # (M, R, N) PARTICLE
    messages: np.ndarray  # (M, R)
    noise: np.ndarray  # (M, R, streams) the robots' own noise
    gazes: np.ndarray  # (M, R) GAZE: where the head looks unless the command says otherwise


class MemoryNumbers(NamedTuple):
    """The constants and settings that the update of beliefs reads."""

    constants: np.ndarray  # (1,) CONSTANTS
    sensors: np.ndarray  # (1,) record of the league's sensors
    memory: np.ndarray  # (1,) record of its memory
    tables: np.ndarray  # (1,) what was calibrated before the match
    home: int  # robots in rows below it are one team, the others the other team


def make_belief_kernel(
    make_scratch: Callable[..., Any], believe_robot: Callable[..., None], talk: Callable[..., None]
) -> Callable[..., None]:
    """Compile the belief loop over matches and robots for one kind of robot; return the compiled function.

    believe_robot(percept, belief, tracks, memory, particles, noise, gaze, scratch, k, s, w, table) updates one robot;
    make_scratch() returns the `scratch` arrays for it. The robot's rows are separate arguments, since each array in a
    bundle would cost another reference count at every call.
    talk(percepts, beliefs, tracks, messages, noise, k, s, w, home, rows) runs once for the robots of a match.
    """

    @compiled
    def believe_slice(percepts, minds, numbers, asleep, rows, first, last):
        """Update the beliefs of some robots of a slice of matches from their percepts (M, R).

        Matches that are `asleep` (M,), because they ended before this step, stay unchanged.
        """
        numbers = MemoryNumbers(*borrow_arrays(numbers))
        k, s, w, table = numbers.constants[0], numbers.sensors[0], numbers.memory[0], numbers.tables[0]
        beliefs, tracks, memories, particles, messages, noise, gazes = BeliefArrays(*borrow_arrays(minds))
        percepts, owned = borrow_arrays(percepts), make_scratch()
        scratch = borrow_arrays(owned)
        for m in range(first, last):
            if asleep[m]:
                continue
            for r in rows:
                believe_robot(
                    percepts[m, r], beliefs[m, r], tracks[m, r], memories[m, r], particles[m, r], noise[m, r],
                    gazes[m, r], scratch, k, s, w, table,
                )  # fmt: skip
            talk(percepts[m], beliefs[m], tracks[m], messages[m], noise[m], k, s, w, numbers.home, rows)
        keep_alive(owned)

    return believe_slice
