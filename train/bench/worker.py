"""Time rows of one checkout when asked to: `soccer bench --against` runs this file once in each checkout's interpreter.

It uses only the public API (Match, soccer_v0), and no setting that was ever renamed, because the other checkout may be
older than this file. A request is one line of JSON on stdin, {"row": name}; the answer is one line on stdout,
{"seconds": of one step} or {"error": why this checkout has no such row}.
"""

import json
import os
import subprocess
import sys
from collections.abc import Callable, Mapping
from functools import partial
from itertools import cycle
from time import perf_counter, process_time
from typing import Any

import numpy as np

if __name__ == "__main__":
    sys.path.pop(0)  # the folder of this file, whose modules are not those of the checkout

LEAGUES = {"legged-2001": 16, "middle-size-2006": 50}  # control steps a second
PLAYERS = 3  # a side
HOLD = 0.5  # [s] that a random action lasts: shorter ones cancel out and robots stand still
WARM_UP = 5.0  # [s] of play before the first timing
DRAWS = 32  # sets of random actions, used in turn
IDEAL, SENSING = {"senses": "ideal"}, {"senses": "sensors", "observe": "belief"}
LOCATING = {**SENSING, "pose": "particles"}

Sampler = Callable[[], float]  # returns the seconds of one step
Makers = Mapping[str, Callable[..., Sampler]]  # here from how many matches and steps
Player = Callable[[int], None]  # plays so many control steps


def core_timer(
    league: str, team: str | None, settings: Mapping[str, Any], matches: int, steps: int, players: int = PLAYERS
) -> Sampler:
    """Return a function that times the batched core [s per match step]: random actions, or a team against itself."""
    play = core_player(league, team, settings, matches, players)

    def sample() -> float:
        start = process_time()
        play(steps)
        return (process_time() - start) / (steps * matches)

    return sample


def core_player(
    league: str, team: str | None, settings: Mapping[str, Any], matches: int, players: int = PLAYERS
) -> Player:
    """Return a function that plays steps of matches in mid-play: random actions, or a team against itself."""
    from soccer_env import Match

    rng, hold = np.random.default_rng(0), round(HOLD * LEAGUES[league])
    both = None if team is None else {"home": team, "away": team}
    match = Match(
        league, home=players, away=players, matches=matches, seed=0, autoreset="same_step", controllers=both, **settings
    )
    draws = rng.uniform(-1.0, 1.0, (DRAWS, matches, 2 * players, 4))
    done = 0

    def play(count: int) -> None:
        nonlocal done
        for _ in range(count):
            match.step(None if team else draws[done // hold % DRAWS])
            done += 1

    play(round(WARM_UP * LEAGUES[league]))
    return play


def save_timer(league: str, matches: int, steps: int) -> Sampler:
    """Return a function that times a save and a load of a running match with sensors [s for both, per match]."""
    from soccer_env import Match

    match = Match(league, home=PLAYERS, away=PLAYERS, matches=matches, seed=0, senses="sensors", observe="belief")
    match.step(np.zeros((matches, 2 * PLAYERS, 4)))

    def sample() -> float:
        start = process_time()
        match.load(match.save())
        return (process_time() - start) / matches

    return sample


def branch_timer(league: str, matches: int, steps: int, together: bool = False) -> Sampler:
    """Return a function that times a branch of a match with sensors, into one of 64 in play or into all [s a match]."""
    from soccer_env import Match

    both = {"home": "chaser", "away": "chaser"}
    settings: Any = {"home": PLAYERS, "away": PLAYERS, "controllers": both, "senses": "sensors"}
    match, planner = Match(league, seed=0, **settings), Match(league, matches=64, seed=1, **settings)
    for _ in range(round(WARM_UP * LEAGUES[league])):
        match.step()

    def sample() -> float:
        spent = 0.0
        for _ in range(steps):
            planner.step()
            match.step()
            start = process_time()
            match.branch(0, into=planner, at=None if together else 0)
            spent += process_time() - start
        return spent / (steps * (64 if together else 1))

    return sample


def api_timer(league: str, resets: bool, matches: int, steps: int, observe: Any = "truth") -> Sampler:
    """Return a function that times `parallel_env.step`, or a reset after a step of play [s each]."""
    from soccer_env import soccer_v0

    rng = np.random.default_rng(0)
    env: Any = soccer_v0.parallel_env(league=league, home=PLAYERS, away=PLAYERS, observe=observe)
    agents = env.possible_agents
    actions = [dict(zip(agents, rng.uniform(-1.0, 1.0, (len(agents), 4)).astype("f4"))) for _ in range(DRAWS)]
    upcoming = cycle(action for action in actions for _ in range(8))  # each is held for eight steps
    env.reset(seed=0)

    def step() -> None:
        if not env.agents:
            env.reset()
        env.step(next(upcoming))

    def sample_steps() -> float:
        start = process_time()
        for _ in range(8 * steps):
            step()
        return (process_time() - start) / (8 * steps)

    def sample_resets() -> float:
        spent = 0.0
        for seed in range(steps):
            step()
            start = process_time()
            env.reset(seed=seed)
            spent += process_time() - start
        return spent / steps

    for _ in range(round(WARM_UP * LEAGUES[league])):
        step()
    return sample_resets if resets else sample_steps


def import_timer(matches: int, steps: int) -> Sampler:
    """Return a function that times `import soccer_env` in a new process [s]."""

    def sample() -> float:
        start, before = perf_counter(), children_time()
        subprocess.run([sys.executable, "-c", "import soccer_env"], check=True)
        spent = children_time() - before
        return spent if spent > 0.0 else perf_counter() - start

    return sample


def children_time() -> float:
    """Return the processor time of ended child processes [s]; 0 where the system does not report it."""
    try:
        import resource
    except ImportError:  # Windows
        return 0.0
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


ROWS: Makers = {
    "import soccer_env": import_timer,
    **{
        f"{league}: {name}": maker
        for league in LEAGUES
        for name, maker in {
            "random, ideal": partial(core_timer, league, None, IDEAL),
            "random, observe belief": partial(core_timer, league, None, SENSING),
            "random, particles": partial(core_timer, league, None, LOCATING),
            "5 v 5, random, particles": partial(core_timer, league, None, LOCATING, players=5),
            "chaser v chaser, ideal": partial(core_timer, league, "chaser", IDEAL),
            "chaser v chaser, sensors": partial(core_timer, league, "chaser", {"senses": "sensors"}),
            "save and load": partial(save_timer, league),
            "branch": partial(branch_timer, league),
            "parallel_env.step": partial(api_timer, league, False),
            "parallel_env.reset": partial(api_timer, league, True),
        }.items()
    },
}


def serve(rows: Makers, *arguments: int) -> None:
    """Answer requests until stdin ends, with rows made from `arguments`; other output goes to stderr."""
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    samplers: dict[str, Sampler] = {}
    print(json.dumps({"rows": [*rows]}), file=answers, flush=True)
    for line in sys.stdin:
        name = json.loads(line)["row"]
        try:
            if name not in samplers:
                samplers[name] = rows[name](*arguments)
            answer: dict[str, Any] = {"seconds": samplers[name]()}
        except Exception as error:  # an older checkout may lack anything
            answer = {"error": f"{type(error).__name__}: {error}"}
        print(json.dumps(answer), file=answers, flush=True)


if __name__ == "__main__":
    serve(ROWS, *map(int, sys.argv[1:]))
