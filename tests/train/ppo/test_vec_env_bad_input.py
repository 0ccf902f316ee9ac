"""A VecEnv refuses the actions that a Match refuses, and moves nothing when it refuses or when a user's code raises."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Rewards
from tests.train.evaluate.staged_rows import MIXED, draw, play, rows, same

pytest.importorskip("stable_baselines3")

COUNT = 2 * 1 + 2 * 3  # rows of MIXED


def hashes(env: Any) -> list[str]:
    return [match.state_hash() for match in env.matches]


def with_one(value: float, row: int = 0) -> np.ndarray:
    """Return actions of which one number is something else."""
    actions = np.zeros((COUNT, 4))
    actions[row, 2] = value
    return actions


@pytest.mark.parametrize(
    ("actions", "complaint"),
    [
        (with_one(np.nan), r"action of row 0, home_0 of match 0 of its block, is not finite: \[0.0, 0.0, nan, 0.0\]"),
        (with_one(np.inf, row=6), "action of row 6, home_1 of match 1 of its block, is not finite"),
        (np.zeros(()), r"actions must be numbers of shape \(8, 4\), got float64 of shape \(\)"),
        (np.zeros(4), r"got float64 of shape \(4,\)"),
        (np.zeros((1, 4)), r"got float64 of shape \(1, 4\)"),
        (np.zeros((COUNT, 1)), r"got float64 of shape \(8, 1\)"),
        (np.zeros((COUNT, 4), complex), "got complex128"),
        (np.zeros((COUNT, 4), bool), "got bool"),
        (np.zeros((COUNT, 4), object), "got object"),
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
    assert same(play(env, 3), play(other, 3))


def test_numbers_beyond_the_box_are_clipped_as_by_a_match() -> None:
    env, other = rows(), rows()
    env.reset(), other.reset()
    assert same([env.step(np.full((8, 4), 5.0))], [other.step(np.ones((8, 4), np.int64))])


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
