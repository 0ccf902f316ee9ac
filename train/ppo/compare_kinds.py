"""Compare the two kinds of networks on the same task: a chaser's decisions, fitted and held out.

    OMP_NUM_THREADS=1 python -m soccer_env.train.ppo.compare_kinds

Prints the held-out mean square error and the time of fitting for three seeds, and the time of a decision in the
compiled kernel. What came out stands in agents/policies/README.md.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np
import torch
from gymnasium import spaces

from soccer_env.agents.learned import MEMORY, decide_slice
from soccer_env.agents.perceptron import pack
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.observations import layout
from soccer_env.train.ppo.networks import SoccerPolicy, policy_from
from soccer_env.train.ppo.teaching.imitation import fit, forget_own_commands, record
from soccer_env.types import COMMAND

KINDS = ("slots", "attention")
SEEDS = (1, 2, 3)
EPOCHS = 10
REPEAT = 8
TAUGHT, HELD_OUT = 521, 104  # decisions of 192 robots: 100,032 and 19,968 rows
ROBOTS = (64, 6)
TIMES = 500  # that a kernel is timed; the least counts
LEAGUE = find_league("legged-2001")
ENTRIES = layout(LEAGUE, "belief")


def rows(decisions: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Return observations and actions of chasers in 64 matches, 3 v 3."""
    settings: dict[str, Any] = {"observe": "belief", "senses": "sensors", "matches": ROBOTS[0], "minutes": 4.0}
    seen, asked = record("chaser", "chaser", (3, 3), decisions, REPEAT, seed=seed, **settings)
    forget_own_commands(seen, ENTRIES, seed)
    return seen, asked


def fitted(kind: str, seed: int, taught: tuple[np.ndarray, np.ndarray]) -> tuple[SoccerPolicy, float]:
    """Return a network fitted to the rows, and the processor time of that [s]."""
    torch.manual_seed(seed)
    seen, asked = (spaces.Box(-1.0, 1.0, (size,), np.float32) for size in (len(ENTRIES), 4))
    network = SoccerPolicy(seen, asked, lambda _: 1e-3, entries=ENTRIES, hidden=(64, 64), kind=kind, mirror=True)
    start = time.process_time()
    fit(network, *taught, EPOCHS, seed)
    return network, time.process_time() - start


def held_out_error(network: SoccerPolicy, seen: np.ndarray, asked: np.ndarray) -> float:
    """Return the mean square error on rows that were not fitted."""
    with torch.no_grad():
        return float(((network.mean_actions(torch.as_tensor(seen)) - torch.as_tensor(asked)) ** 2).mean())


def kernel_time(network: SoccerPolicy, seen: np.ndarray) -> float:
    """Return the least time of a decision [us] among 384 in one call."""
    made: dict[str, Any] = {"name": "timed", "league": LEAGUE, "observe": "belief", "action_repeat": REPEAT}
    numbers = pack(policy_from(network, made={}, **made))
    some = np.ascontiguousarray(seen[: ROBOTS[0] * ROBOTS[1]].reshape(*ROBOTS, -1))
    least = np.inf
    for _ in range(TIMES):
        memory = np.zeros(ROBOTS, MEMORY)
        memory["begun"] = 1  # and wait 0: every robot decides
        start = time.perf_counter()
        decide_slice(some, memory, np.zeros(ROBOTS, COMMAND), np.arange(6), constants_of(LEAGUE), numbers, 0, ROBOTS[0])
        least = min(least, time.perf_counter() - start)
    return 1e6 * least / (ROBOTS[0] * ROBOTS[1])


def main() -> None:
    """Compare and print."""
    torch.set_num_threads(1)
    taught, other = rows(TAUGHT, 1), rows(HELD_OUT, 2)
    for kind in KINDS:
        for seed in SEEDS:
            network, seconds = fitted(kind, seed, taught)
            print(f"{kind:9} seed {seed}: held out {held_out_error(network, *other):.4f}, {seconds:.1f} s", flush=True)
        print(f"{kind:9} kernel: {kernel_time(network, other[0]):.1f} us a decision")


if __name__ == "__main__":
    main()
