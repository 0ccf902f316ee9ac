"""Reward terms of a user's own: they have weights, can be written down, and potentials telescope and leak nowhere."""

import pickle
import re
from dataclasses import FrozenInstanceError, replace
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, OwnTerm, Rewards

NOTHING = Rewards.only()


def one(match: Match) -> np.ndarray:
    return np.ones(match.robots.shape)


def test_rewards_can_be_compared_copied_and_written_down() -> None:
    rewards = Rewards(goal=2.0, extra={"x": one})
    assert rewards == Rewards(goal=2.0, extra={"x": OwnTerm(one)}) != Rewards(extra={"x": one})
    assert replace(rewards, gamma=0.5) == Rewards(goal=2.0, gamma=0.5, extra={"x": one})
    assert pickle.loads(pickle.dumps(rewards)) == rewards
    with pytest.raises(FrozenInstanceError):
        rewards.goal = 1.0
    described = Match(home=1, away=1, seed=1, rewards=rewards).settings.describe()["rewards"]
    assert described["goal"] == 2.0 and described["extra"]["x"]["kind"] == "event"
    assert described["extra"]["x"]["function"].endswith(".one")


@pytest.mark.parametrize(("bad", "message"), [
    ((3,), "OwnTerm.function must be"),
    ((one, "bonus"), "OwnTerm.kind must be one of potential, event, cost, got 'bonus'"),
    ((one, "cost", np.nan), "OwnTerm.weight must be -1000000000 to 1000000000, got nan"),
    ((one, "event", -1e300), "OwnTerm.weight must be -1000000000 to 1000000000, got -1e+300"),
])  # fmt: skip
def test_bad_terms_of_ones_own_are_refused(bad: tuple[Any, ...], message: str) -> None:
    with pytest.raises(ValueError, match=re.escape(message)):
        OwnTerm(*bad)


def ball_x(match: Match) -> np.ndarray:
    """Return the ball's place (M, R), of either team alike: never 0 in play."""
    return np.repeat(match.balls["x"][:, None] + 5.0, len(match.agents), axis=1)


def test_events_and_costs_of_ones_own_have_weights() -> None:
    extra = {"plain": one, "event": OwnTerm(one, "event", 0.5), "cost": OwnTerm(one, "cost", 0.25)}
    match = Match(home=1, away=1, seed=1, rewards=replace(NOTHING, extra=extra))
    match.step(np.zeros((1, 2, 4)))
    assert match.terms[0, :, -3:].tolist() == [[1.0, 0.5, -0.25]] * 2
    assert match.rewards[0].tolist() == [1.25, 1.25] and match.term_names[-3:] == ["plain", "event", "cost"]


@pytest.mark.parametrize("repeat", [1, 4])
def test_a_potential_of_ones_own_telescopes_over_an_episode_and_is_0_at_its_end(repeat: int) -> None:
    gamma, weight = 0.9, 2.0
    rewards = replace(NOTHING, gamma=gamma, extra={"mine": OwnTerm(ball_x, "potential", weight)})
    match = Match(home=2, away=2, matches=3, seed=2, minutes=0.05, action_repeat=repeat, rewards=rewards)
    start, total, discount = ball_x(match), np.zeros((3, 4)), 1.0
    rng = np.random.default_rng(0)
    while not match.terminated.all():
        before = ball_x(match)
        _, paid, _, _ = match.step(rng.uniform(-1.0, 1.0, (3, 4, 4)))
        after = np.where(match.terminated[:, None], 0.0, ball_x(match))
        np.testing.assert_allclose(paid, weight * (gamma * after - before), atol=1e-12)
        total += discount * paid
        discount *= gamma
    np.testing.assert_allclose(total, -weight * start, atol=1e-9)
    _, paid, _, _ = match.step(np.zeros((3, 4, 4)))
    assert not paid.any(), "a match that is over pays nothing"


@pytest.mark.parametrize("mode", ["same_step", "next_step"])
@pytest.mark.parametrize("ending", [{"max_cycles": 7}, {"minutes": 0.01}])
def test_a_potential_of_ones_own_does_not_leak_over_an_autoreset(mode: str, ending: dict[str, Any]) -> None:
    rewards = replace(NOTHING, extra={"mine": OwnTerm(ball_x, "potential")})
    match = Match(home=1, away=1, matches=2, seed=3, autoreset=mode, rewards=rewards, **ending)
    rng, begun = np.random.default_rng(0), np.zeros(2, np.int64)
    for _ in range(60):
        match.balls["vx"] = rng.uniform(-1.0, 1.0, 2)
        match.rebuild()
        before, episode = ball_x(match), match.matches["episode"].copy()
        _, paid, terminated, _ = match.step(rng.uniform(-1.0, 1.0, (2, 2, 4)))
        same = match.matches["episode"] == episode
        after = np.where(terminated[:, None], 0.0, ball_x(match))
        np.testing.assert_allclose(paid[same], (0.99 * after - before)[same], atol=1e-12)
        if mode == "next_step":
            assert not paid[~same].any()
        elif "minutes" in ending and not same.all():
            np.testing.assert_allclose(paid[~same], -before[~same], atol=1e-12)
        begun += ~same
    assert (begun >= 3).all()


def test_a_potential_is_that_of_the_records_when_the_step_begins() -> None:
    """Whoever writes into the records between two steps, or loads a save, is neither paid nor charged for it."""
    rewards = replace(NOTHING, gamma=1.0, extra={"mine": OwnTerm(ball_x, "potential")})
    match = Match(home=1, away=1, seed=3, rewards=rewards)
    saved = match.save()
    match.step(np.zeros((1, 2, 4)))
    match.balls["x"] = 0.7
    match.rebuild()
    assert abs(match.step(np.zeros((1, 2, 4)))[1]).max() < 0.1
    match.load(saved)
    assert abs(match.step(np.zeros((1, 2, 4)))[1]).max() < 0.1
