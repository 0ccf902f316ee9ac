"""Benchmarks beside the core: the memory of a match, and start-up times; loads in turn."""

import os
import subprocess
import sys
import tempfile
import tracemalloc
from collections.abc import Callable
from statistics import median
from time import perf_counter

import numpy as np

from soccer_env.match import Match
from soccer_env.physics.engine.space import build_space
from soccer_env.train.bench.loads import PLAYERS, senses_for

START_TIMES = {  # name of the row: the Python program to time
    "import soccer_env": "import soccer_env",
    "soccer --help": "from soccer_env.train.command.command_line import main; main(['--help'])",
    "start of an evaluation": "from soccer_env.train.command.command_line import main; "
    "main('evaluate --home chaser --away random@0.5 --matches 2 --minutes 0.02'.split())",
}


def record_bytes(league: str, pose: str | None = None, matches: int = 64) -> float:
    """Return the bytes of a 3 v 3 match outside Chipmunk: every array that a Match and its parts hold.

    Senses are ideal without `pose`; with it all robots have sensors and beliefs, and localise by `pose`.
    """
    match = Match(
        league, home=PLAYERS, away=PLAYERS, matches=matches, seed=0, controllers={"home": "chaser"}, **senses_for(pose)
    )
    return sum(array.nbytes for array in held_arrays(match)) / matches


def held_arrays(root: object) -> list[np.ndarray]:
    """Return every array, except views, that an object of this package or any of its parts holds; each array once."""
    waiting = [root]
    seen = set()
    arrays = []
    while waiting:
        item = waiting.pop()
        if id(item) in seen:
            continue
        seen.add(id(item))
        if isinstance(item, np.ndarray):
            waiting.append(item.base)  # of a view
            if item.base is None:
                arrays.append(item)
        elif isinstance(item, (list, tuple)):
            waiting += item
        elif isinstance(item, dict):
            waiting += item.values()
        elif type(item).__module__.startswith("soccer_env"):
            waiting += getattr(item, "__dict__", {}).values()
    return arrays


def wrapper_bytes(league: str, spaces: int = 16) -> float:
    """Return the bytes of pymunk's Python objects for one Chipmunk space of a 3 v 3 match."""
    match = Match(league, home=PLAYERS, away=PLAYERS, seed=0)
    build_space(match.league, match.balls[0], match.robots[0])
    tracemalloc.start()
    kept = [build_space(match.league, match.balls[0], match.robots[0]) for _ in range(spaces)]
    size, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return size / len(kept)


def process_start_time(program: str, repetitions: int, cold: bool = False) -> float:
    """Return the median seconds of a Python process that runs a program; `cold`: with an empty cache each time."""
    return median(_run(program, cold) for _ in range(repetitions))


def _run(program: str, cold: bool) -> float:
    with tempfile.TemporaryDirectory() as empty:
        variables = {**os.environ, **({"SOCCER_ENV_CACHE": empty} if cold else {})}
        start = perf_counter()
        done = subprocess.run(
            [sys.executable, "-c", program], env=variables, capture_output=True, text=True, check=False
        )
        spent = perf_counter() - start
    if done.returncode != 0:
        raise RuntimeError(f"{program!r} ended with {done.returncode}: {done.stderr.strip()[-400:]}")
    return spent


def interleave_samples(loads: dict[str, Callable[[], float]], repetitions: int) -> dict[str, list[float]]:
    """Return the samples of each load; loads take turns, so that a slow moment of the machine slows all alike."""
    samples: dict[str, list[float]] = {name: [] for name in loads}
    for repetition in range(repetitions):
        for name in loads if repetition % 2 == 0 else reversed(loads):
            samples[name].append(loads[name]())
    return samples
