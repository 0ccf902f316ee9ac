"""The loop in which robots bring their beliefs up to their percepts, then talk: the same for every kind of robot.

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from soccer_env.compiled import compiled


class Minds(NamedTuple):
    """What the robots of M matches of R robots believe and remember; memories and messages are the kind's own."""

    beliefs: np.ndarray  # (M, R) BELIEF
    tracks: np.ndarray  # (M, R, slots) TRACK
    memories: np.ndarray  # (M, R)
    particles: np.ndarray  # (M, R, N) PARTICLE
    messages: np.ndarray  # (M, R)
    noise: np.ndarray  # (M, R, streams) the robots' own noise
    gazes: np.ndarray  # (M, R) GAZE: where the head looks unless the command says otherwise


class MemoryNumbers(NamedTuple):
    """What league and settings say to beliefs."""

    constants: np.ndarray  # (1,) CONSTANTS
    sensors: np.ndarray  # (1,) record of the league's sensors
    memory: np.ndarray  # (1,) record of its memory
    tables: np.ndarray  # (1,) what was calibrated before the match
    home: int  # rows below it are team-mates of each other, as are those from it on


def believe_kernel(
    make_scratch: Callable[..., Any], believe_robot: Callable[..., None], talk: Callable[..., None]
) -> Callable[..., None]:
    """Return the compiled loop over matches and robots of a kind.

    make_scratch() makes the scratch that believe_robot(percept, belief, tracks, memory, particles, noise, gaze,
    scratch, k, s, w, table) works in. It gets its robot's rows one by one: the arrays of a bundle would have their
    references counted once more at every call.
    talk(percepts, beliefs, tracks, messages, noise, k, s, w, home, rows) is among the robots of one match.
    """

    @compiled
    def believe_slice(percepts, minds, numbers, asleep, rows, first, last):
        """Bring the beliefs of some robots of a slice of matches up to their percepts (M, R).

        Nothing happens in matches that are `asleep` (M,), over before this step.
        """
        numbers = MemoryNumbers(*numbers)
        k = numbers.constants[0]
        s = numbers.sensors[0]
        w = numbers.memory[0]
        table = numbers.tables[0]
        beliefs, tracks, memories, particles, messages, noise, gazes = Minds(*minds)
        scratch = make_scratch()
        for m in range(first, last):
            if asleep[m]:
                continue
            for r in rows:
                believe_robot(
                    percepts[m, r], beliefs[m, r], tracks[m, r], memories[m, r], particles[m, r], noise[m, r],
                    gazes[m, r], scratch, k, s, w, table,
                )  # fmt: skip
            talk(percepts[m], beliefs[m], tracks[m], messages[m], noise[m], k, s, w, numbers.home, rows)

    return believe_slice
