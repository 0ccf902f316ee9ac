"""Bit-identity: the same settings, seed and actions give the same bits in any process, batch, thread or mode."""

import hashlib
import os
import subprocess
import sys

import numpy as np
import pytest

from soccer_env import Match

LEAGUES = ("legged-2001", "middle-size-2006")
PROGRAM = """
import sys, numpy as np
from soccer_env import Match
for words in sys.argv[2:]:
    steps, size, *team = words.split()
    teams = {"home_0": team[0]} if team else None
    match = Match(sys.argv[1], home=int(size), away=int(size), seeds=[11], controllers=teams, pose="particles")
    rng = np.random.default_rng(5)
    for _ in range(int(steps)):
        match.step(rng.uniform(-1.0, 1.0, (1, 2 * int(size), 4)))
    print(match.state_hash(), match.observations.tobytes().hex()[:64])
"""


def run(*arguments: str, **environment: str) -> str:
    """Return what the program prints in a process of its own: of a league, matches as "steps size team"."""
    command = [sys.executable, "-c", PROGRAM, *arguments]
    done = subprocess.run(command, env={**os.environ, **environment}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def play(match: Match, steps: int, seed: int = 5) -> list[str]:
    rng = np.random.default_rng(seed)
    hashes = []
    for _ in range(steps):
        action = rng.uniform(-1.0, 1.0, (1, len(match.agents), 4))
        match.step(np.repeat(action, match.count, axis=0))
        hashes.append(match.state_hash(0))
    return hashes


@pytest.mark.slow
@pytest.mark.parametrize("league", LEAGUES)
def test_500_steps_agree_across_processes_and_hash_seeds(league: str) -> None:
    first = run(league, "500 3", PYTHONHASHSEED="0")
    assert first == run(league, "500 3", PYTHONHASHSEED="random", PYTHONMALLOC="malloc", MALLOC_PERTURB_="165")


@pytest.mark.slow
@pytest.mark.parametrize("league", LEAGUES)
def test_plain_python_plays_what_the_compiled_code_plays(league: str) -> None:
    played = ("60 1", "40 2 chaser")
    assert run(league, *played) == run(league, *played, NUMBA_DISABLE_JIT="1")


@pytest.mark.parametrize("league", LEAGUES)
def test_a_match_alone_is_the_same_match_among_64(league: str) -> None:
    together = Match(league, home=3, away=3, matches=64, seed=7, threads=2)
    alone = Match(league, home=3, away=3, seeds=[together.seeds[17]])
    rng = np.random.default_rng(0)
    for _ in range(500):
        actions = rng.uniform(-1.0, 1.0, (64, 6, 4))
        together.step(actions)
        alone.step(actions[17:18])
        assert alone.state_hash(0) == together.state_hash(17)
    assert alone.observations[0].tobytes() == together.observations[17].tobytes()


@pytest.mark.slow
@pytest.mark.parametrize("league", LEAGUES)
def test_threads_do_not_matter(league: str) -> None:
    hashes = []
    for threads in (1, 2, 4):
        match = Match(league, matches=16, seed=3, threads=threads, controllers={"home": "chaser", "away": "random"})
        for _ in range(500):
            match.step()
        hashes.append(match.state_hash())
    assert len(set(hashes)) == 1


@pytest.mark.parametrize("league", LEAGUES)
def test_both_ways_of_driving_chipmunk_agree(league: str) -> None:
    settings = {"home": 3, "away": 3, "matches": 2, "seed": 3, "placement": "drive"}
    c, batch = (Match(league, backend=backend, **settings) for backend in ("c", "batch"))
    assert play(c, 400) == play(batch, 400)
    assert c.observations.tobytes() == batch.observations.tobytes()
    assert c.rewards.tobytes() == batch.rewards.tobytes()


@pytest.mark.parametrize("league", LEAGUES)
def test_a_match_forgets_its_past_at_a_reset(league: str) -> None:
    messy = Match(league, home=3, away=3, seed=1)
    play(messy, 200, seed=9)
    messy.save()
    messy.reset(seed=42)
    assert play(messy, 200) == play(Match(league, home=3, away=3, seed=42), 200)


def test_seeds_matter_and_episodes_go_on() -> None:
    first, second = Match(seed=1), Match(seed=2)
    assert first.state_hash() != second.state_hash()
    before = first.state_hash()
    first.reset()
    assert first.state_hash() != before, "the second episode of a seed is another one"
    again = Match(seed=1)
    again.reset()
    assert again.state_hash() == first.state_hash()
    assert Match().state_hash() != Match().state_hash(), "without a seed a match is drawn anew"


def test_the_global_generator_is_neither_read_nor_changed() -> None:
    np.random.seed(0)
    before = hashlib.sha256(str(np.random.get_state()).encode()).hexdigest()
    play(Match(seed=1), 20)
    assert hashlib.sha256(str(np.random.get_state()).encode()).hexdigest() == before


def test_more_noise_draws_do_not_shift_other_streams() -> None:
    quiet, noisy = Match(seed=1, matches=2), Match(seed=1, matches=2)
    noisy.robots["noise"][:, :, 2] += np.uint64(12345)  # the teams' stream
    assert play(quiet, 50)[-1] != play(noisy, 50)[-1], "the stream is part of the state"
    assert quiet.balls.tobytes() == noisy.balls.tobytes(), "and of nothing else"
