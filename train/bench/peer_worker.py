"""Time one environment in a process of its own: `soccer bench --peers` runs this file in the interpreter of each peer.

It imports the peer alone, and soccer_env only where soccer_env is timed. Matches are 3 v 3 with random actions, drawn
before the timing and held for half a second. Requests and answers are those of `worker.py`. Times are processor times
on one thread, and wall times on more.

Peers do no work here that ours do not: an episode of VMAS that has ended plays on, since its reset costs another step.
"""

from __future__ import annotations

import os
import runpy
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

import numpy as np

if __name__ == "__main__":
    sys.path.pop(0)  # the folder of this file, whose modules would hide those of other packages

WORKER: dict[str, Any] = runpy.run_path(str(Path(__file__).with_name("worker.py")))
PLAYERS, DRAWS = WORKER["PLAYERS"], WORKER["DRAWS"]
LEAST = 0.25  # [s] of one timing
CHUNK = 5  # steps between two looks at the clock
HOLD = {"vmas": 5, "psim": 30, "rsoccer": 20}  # control steps in half a second

Player = Callable[[int], None]  # plays so many control steps
Maker = Callable[[int, int], Player]  # from how many matches and threads


def play_own(league: str, matches: int, threads: int) -> Player:
    """Return a function that plays the batched core by its truth."""
    player: Player = WORKER["core_player"](league, None, {**WORKER["IDEAL"], "threads": threads}, matches)
    return player


def play_vmas(matches: int, threads: int) -> Player:
    """Return a function that plays the scenario football of VMAS, a batch of PyTorch, without learning."""
    import torch
    from vmas import make_env

    torch.manual_seed(0)
    env: Any = make_env(
        "football", num_envs=matches, device="cpu", continuous_actions=True, seed=0, n_blue_agents=PLAYERS,
        n_red_agents=PLAYERS, ai_blue_agents=False, ai_red_agents=False,
    )  # fmt: skip
    env.reset()
    draws = [[torch.rand(matches, one.action_size) * 2 - 1 for one in env.agents] for _ in range(DRAWS)]

    def step(actions: Any) -> None:
        torch.set_num_threads(threads)
        env.step([one.clone() for one in actions])  # it changes them

    return repeat(step, draws, HOLD["vmas"])


def play_psim(matches: int, threads: int) -> Player:
    """Return a function that plays pSim by PettingZoo, one match at a time."""
    from pSim import VSSSPettingZooEnv

    env: Any = VSSSPettingZooEnv(num_agent_robots=PLAYERS, num_adversary_robots=PLAYERS)
    agents, rng = env.possible_agents, np.random.default_rng(0)
    draws = [dict(zip(agents, rng.uniform(-1.0, 1.0, (len(agents), 2)).astype("f4"))) for _ in range(DRAWS)]
    env.reset(seed=0)

    def step(actions: Any) -> None:
        if not env.agents:
            env.reset()
        env.step(actions)

    return repeat(step, draws, HOLD["psim"])


def play_rsoccer(matches: int, threads: int) -> Player:
    """Return a function that plays VSS of rSoccer by Gym, one match at a time."""
    from rsoccer_gym.vss.env_vss import VSSEnv

    env: Any = VSSEnv()
    rng = np.random.default_rng(0)
    draws = [rng.uniform(-1.0, 1.0, env.action_space.shape).astype("f4") for _ in range(DRAWS)]
    env.reset()

    def step(actions: Any) -> None:
        if env.step(actions)[2]:
            env.reset()

    return repeat(step, draws, HOLD["rsoccer"])


def repeat(step: Callable[[Any], None], draws: list[Any], hold: int) -> Player:
    """Return a function that repeats `step` with random actions, each held for `hold` steps."""
    done = 0

    def play(count: int) -> None:
        nonlocal done
        for _ in range(count):
            step(draws[done // hold % DRAWS])
            done += 1

    play(10 * hold)
    return play


def timer(maker: Maker, matches: int, threads: int) -> Callable[[], float]:
    """Return a function that times the matches of a player [s per match step], for at least LEAST seconds."""
    play, clock = maker(matches, threads), process_time if threads == 1 else perf_counter

    def sample() -> float:
        start, steps = clock(), 0
        while clock() - start < LEAST:
            play(CHUNK)
            steps += CHUNK
        return (clock() - start) / (steps * matches)

    return sample


PEERS: dict[str, Maker] = {"vmas": play_vmas, "psim": play_psim, "rsoccer": play_rsoccer}


def rows_of(name: str, loads: list[tuple[int, int]]) -> dict[str, Callable[[], Callable[[], float]]]:
    """Return the rows of a peer, or of "soccer_env" the rows of both leagues, for numbers of matches and threads."""
    own = {league: partial(play_own, league) for league in WORKER["LEAGUES"]}
    makers = own if name == "soccer_env" else {name: PEERS[name]}
    return {
        f"{name} {matches} {threads}": partial(timer, maker, matches, threads)
        for name, maker in makers.items()
        for matches, threads in loads
    }


if __name__ == "__main__":
    os.environ |= {"SDL_VIDEODRIVER": "dummy", "PYGAME_HIDE_SUPPORT_PROMPT": "1"}
    given = [(int(matches), int(threads)) for matches, _, threads in (load.partition("x") for load in sys.argv[2:])]
    WORKER["serve"](rows_of(sys.argv[1], given))
