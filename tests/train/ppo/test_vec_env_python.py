"""A VecEnv of several blocks and threads calls Python code of its user from one thread at a time."""

import time
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from soccer_env import Rewards
from soccer_env.scenes import SCENES, mixture
from tests.train.evaluate.staged_rows import MIXED, play, rows

pytest.importorskip("stable_baselines3")


class Watch:
    """Note how many threads are inside at once."""

    def __init__(self) -> None:
        self.inside, self.most, self.calls = 0, 0, 0

    def look(self) -> None:
        self.inside, self.calls = self.inside + 1, self.calls + 1
        self.most = max(self.most, self.inside)
        time.sleep(1e-3)
        self.inside -= 1


class Team(Watch):
    name = "own"
    memory_dtype = np.dtype([])

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        self.look()
        return view.stand()


class Reward(Watch):
    def __call__(self, match: Any) -> np.ndarray:
        self.look()
        return np.zeros_like(match.rewards)


class Observe(Watch):
    names = ("nothing",)

    def __call__(self, match: Any) -> np.ndarray:
        self.look()
        return np.zeros((*match.rewards.shape, 1))


class Place(Watch):
    def __call__(self, *records: Any) -> None:
        self.look()


def settings_with(code: Watch) -> dict[str, Any]:
    """Return the settings that bring some code of a user into play."""
    if isinstance(code, Team):
        return {"opponents": code}
    if isinstance(code, Reward):
        return {"rewards": Rewards(extra={"own": code})}
    if isinstance(code, Observe):
        return {"observe": code}
    return {"scene": replace(SCENES["kick-off"], name="own", place=code)}


@pytest.mark.parametrize("kind", [Team, Reward, Observe, Place])
def test_code_of_a_user_is_never_called_by_two_threads_at_once(kind: type[Watch]) -> None:
    code = kind()
    env = rows(players=(*MIXED, (2, 2)), matches=6, threads=3, minutes=0.05, **settings_with(code))
    env.reset()
    play(env, 60)
    env.close()
    assert code.calls >= 6 and code.most == 1


def test_compiled_code_is_played_by_all_threads() -> None:
    assert rows(players=MIXED, matches=8, threads=2)._workers.threads == 2
    scene = mixture("kick-off,scattered")
    assert rows(players=MIXED, matches=8, threads=2, scene=scene)._workers.threads == 2
