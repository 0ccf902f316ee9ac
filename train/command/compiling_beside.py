"""Compile physics and referee in a second process while this process compiles senses and teams.

This cuts a start with an empty cache by a third. The processes share machine code through the cache on disk; if the
second one fails, the first compiles everything itself.
"""

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from soccer_env.compiled import config
from soccer_env.compiling.cache import is_cached
from soccer_env.match.step import step_slice


@contextmanager
def compile_step_beside() -> Iterator[None]:
    """Run a second compiling process during a `with` block, if the cache lacks the code for a step of a match."""
    if config.DISABLE_JIT or not sys.executable or count_cores() < 2 or is_cached(step_slice):
        yield
        return
    silent = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    with subprocess.Popen([sys.executable, "-m", __name__], **silent) as process:  # type: ignore[call-overload]
        try:
            yield
        finally:
            process.kill()


def count_cores() -> int:
    """Return the number of processor cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def compile_step() -> None:
    """Compile the code for a step of a match, by playing one step with ideal senses."""
    from soccer_env.match import Match

    match = Match("legged-2001", home=1, away=1, senses="ideal", seed=0)
    match.step(np.zeros((1, len(match.agents), match.settings.actions.size)))


if __name__ == "__main__":
    compile_step()
