"""Compile the physics and the referee in a second process, while the first one compiles senses and teams.

A start with an empty cache takes two thirds of the time so. Machine code gets from one process to the other by the
cache on disk; whatever happens to the second one, the first compiles what it does not find there.
"""

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from soccer_env.compiled import config
from soccer_env.compiling.cache import is_kept
from soccer_env.match.step import step_slice


@contextmanager
def step_compiled_beside() -> Iterator[None]:
    """Start the second process if the step of a match is not in the cache, and end it when the block ends."""
    if config.DISABLE_JIT or not sys.executable or cores() < 2 or is_kept(step_slice):
        yield
        return
    silent = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    with subprocess.Popen([sys.executable, "-m", __name__], **silent) as process:  # type: ignore[call-overload]
        try:
            yield
        finally:
            process.kill()


def cores() -> int:
    """Return how many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def compile_step() -> None:
    """Compile what moves a match on, by one step of a match in which nobody senses anything."""
    from soccer_env.match import Match

    match = Match("legged-2001", home=1, away=1, senses="ideal", seed=0)
    match.step(np.zeros((1, len(match.agents), match.settings.actions.size)))


if __name__ == "__main__":
    compile_step()
