"""A VecEnv refuses what a Match refuses, then moves nothing, calls Python of its user in one thread, and is copied."""

import copy
import pickle
import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from soccer_env import Rewards, make_team
from soccer_env.match.squads import Lineup
from soccer_env.scenes import SCENES, mixture
from soccer_env.train.ppo.vec_env import SoccerVecEnv
from tests.train.evaluate.staged_rows import MIXED, assert_same_play, draw, play, rows

pytest.importorskip("stable_baselines3")

COUNT = 3 * 1 + 1 * 3  # rows of MIXED: as many robots of each size


def hashes(env: Any) -> list[str]:
    return [match.state_hash() for match in env.matches]


def with_one(value: float, row: int = 0) -> np.ndarray:
    actions = np.zeros((COUNT, 4))
    actions[row, 2] = value
    return actions


@pytest.mark.parametrize(
    ("actions", "complaint"),
    [
        (with_one(np.nan), r"action of row 0, home_0 of match 0 of its block, is not finite: \[0.0, 0.0, nan, 0.0\]"),
        (with_one(np.inf, row=4), "action of row 4, home_1 of match 0 of its block, is not finite"),
        (np.zeros(()), r"actions must be numbers of shape \(6, 4\), got float64 of shape \(\)"),
        (np.zeros((COUNT, 1)), r"got float64 of shape \(6, 1\)"),
        (np.zeros((COUNT, 4), complex), "got complex128"),
        (np.zeros((COUNT, 4), bool), "got bool"),
        (None, "got object"),
    ],
)
def test_wrong_actions_are_refused_before_any_match_moves(actions: Any, complaint: str) -> None:
    env, other = rows(players=MIXED), rows(players=MIXED)
    env.reset(), other.reset()
    before = hashes(env)
    with pytest.raises(ValueError, match=complaint):
        env.step(actions)
    assert hashes(env) == before
    assert assert_same_play(play(env, 3), play(other, 3))


def test_a_step_without_actions_is_refused() -> None:
    env = rows()
    env.reset()
    for _ in range(2):
        before = hashes(env)
        with pytest.raises(RuntimeError, match="step_wait needs the actions of the step: call step_async first"):
            env.step_wait()
        assert hashes(env) == before
        play(env, 1)


def test_an_error_in_code_of_a_user_moves_no_block() -> None:
    calls = {"left": 10**9}

    def pay(match: Any) -> np.ndarray:
        calls["left"] -= 1
        if calls["left"] == 0:
            raise ArithmeticError
        return np.zeros_like(match.rewards)

    settings: dict[str, Any] = {"players": MIXED, "rewards": Rewards(extra={"own": pay}), "action_repeat": 2}
    env, other = rows(**settings), rows(**settings)
    for one in (env, other):
        one.reset()
        play(one, 3)
    before, actions = hashes(env), draw(env, np.random.default_rng(1))
    calls["left"] = 4  # the second step of the second block
    with pytest.raises(ArithmeticError):
        env.step(actions)
    assert hashes(env) == before
    env.step(actions)
    assert hashes(env) != before


def pickled(one: Any) -> Any:
    return pickle.loads(pickle.dumps(one))


def clouded(one: Any) -> Any:
    return pickle.loads(pytest.importorskip("cloudpickle").dumps(one))


LINEUP = Lineup((make_team("chaser"), make_team("still")), np.array([0.7, 0.3]), ("chaser", "still"))


@pytest.mark.parametrize("way", [pickled, clouded, copy.deepcopy])
@pytest.mark.parametrize(
    "settings",
    [
        {"players": [(1, 1), (2, 3)], "matches": 4, "opponents": LINEUP, "max_cycles": 11, "action_repeat": 4},
        {"league": "middle-size-2006", "players": [(2, 2)], "matches": 3, "state": True, "stagger": True},
        {"players": [(2, 2)], "matches": 2, "actions": "full", "observe": "belief", "minutes": 0.1},
    ],
)
def test_an_env_and_its_copy_have_one_future(way: Callable[[Any], Any], settings: dict[str, Any]) -> None:
    env = SoccerVecEnv(**settings, seed=4)
    env.reset()
    actions = np.random.default_rng(1).uniform(-1.0, 1.0, (60, env.num_envs, *env.action_space.shape))
    for t in range(30):
        env.step(actions[t])
    other = way(env)
    assert other.matches[0] is not env.matches[0] and other.playing() == env.playing()
    env.take_results()
    for t in range(30, 60):
        mine, theirs = env.step(actions[t]), other.step(actions[t])
        for one, two in zip(mine[:3], theirs[:3], strict=True):
            assert np.array_equal(one, two)
        assert [sorted(info) for info in mine[3]] == [sorted(info) for info in theirs[3]]
    assert [m.state_hash() for m in env.matches] == [m.state_hash() for m in other.matches]
    assert env.take_results() == other.take_results()
    assert np.array_equal(env.reset(), other.reset())


def test_a_copy_resets_with_the_seed_that_was_given_last() -> None:
    with pytest.raises(ValueError, match="SoccerVecEnv takes no teammates"):
        SoccerVecEnv(teammates="chaser")
    env = SoccerVecEnv(players=[(1, 1)], matches=2, seed=1)
    first = env.reset()
    env.seed(9)
    other = pickled(env)
    assert np.array_equal(env.reset(), other.reset()) and not np.array_equal(first, other.reset())


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


@pytest.mark.parametrize(
    ("kind", "settings_with"),
    [
        (Team, lambda code: {"opponents": code}),
        (Reward, lambda code: {"rewards": Rewards(extra={"own": code})}),
        (Observe, lambda code: {"observe": code}),
        (Place, lambda code: {"scene": replace(SCENES["kick-off"], name="own", place=code)}),
    ],
)
def test_code_of_a_user_is_never_called_by_two_threads_at_once(kind: type[Watch], settings_with: Any) -> None:
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
