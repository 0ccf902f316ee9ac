"""PPO by its formulas: horizons in seconds, advantages and their scale, episodes that are cut off, divergences."""

from math import log
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("stable_baselines3")

import torch

from soccer_env.leagues import find_league
from soccer_env.match.truth_state import entries
from soccer_env.observations import layout
from soccer_env.train.ppo.networks import SoccerPolicy
from soccer_env.train.ppo.settings import TrainSettings, half_life_factor
from soccer_env.train.ppo.updating.distributions import NEVER, Normal, Skills, policy_of
from soccer_env.train.ppo.updating.rollout import Start, advantages, collect, normalised, scales, values_of
from soccer_env.train.ppo.updating.update import RATES, follow_divergence, make_optimizer
from soccer_env.train.ppo.vec_env import SoccerVecEnv
from tests.train.ppo.staged_training import records, tiny_settings, train_plainly


@pytest.mark.parametrize(("league", "repeat", "seconds"), [("legged-2001", 8, 0.5), ("middle-size-2006", 5, 0.1)])
def test_what_comes_a_half_life_later_counts_half_whatever_the_league(league: str, repeat: int, seconds: float) -> None:
    made = TrainSettings(league=league, action_repeat=repeat, discount_half_life=20.0, advantage_half_life=4.0)
    assert made.decision_time == pytest.approx(seconds)
    assert made.gamma ** (20.0 / seconds) == pytest.approx(0.5) == made.gae_lambda ** (4.0 / seconds)
    assert half_life_factor(0.5, 0.5) == 0.5 and half_life_factor(1.0, 0.5) == 0.25


def test_advantages_are_discounted_sums_of_differences_up_to_the_end_of_an_episode() -> None:
    rng = np.random.default_rng(1)
    rewards, values = rng.normal(size=(2, 6, 3))
    dones, last = rng.random((6, 3)) < 0.3, rng.normal(size=3)
    gamma, lam = 0.9, 0.8
    found = advantages(rewards, values, dones, last, gamma, lam)
    after = np.concatenate([values[1:], last[None]])
    for row in range(3):
        for t in range(6):
            total, weight = 0.0, 1.0
            for later in range(t, 6):
                ended = dones[later, row]
                following = 0.0 if ended else after[later, row]
                total += weight * (rewards[later, row] + gamma * following - values[later, row])
                weight *= gamma * lam
                if ended:
                    break
            assert found[t, row] == pytest.approx(total)


def test_each_team_size_has_advantages_of_mean_0_and_deviation_1() -> None:
    numbers = np.array([[1.0, 10.0, 30.0], [3.0, 30.0, 50.0]])
    found = normalised(numbers, np.array([0, 1, 1]))
    np.testing.assert_allclose(found[:, 0], [-1.0, 1.0])
    np.testing.assert_allclose(found[:, 1:], (numbers[:, 1:] - 30.0) / 200.0**0.5)
    np.testing.assert_allclose(scales(numbers, np.array([0, 1, 1]), 0.1), [1.0, 200.0**0.5, 200.0**0.5])
    assert scales(np.zeros((2, 1)), np.array([0]), 0.1).tolist() == [0.1]


def a_network(env: SoccerVecEnv, value: float) -> SoccerPolicy:
    """Return a network whose critic thinks that every state is worth the same."""
    torch.manual_seed(1)
    made = SoccerPolicy(env.matches[0].observation_entries, env.observation_space.shape[0], hidden=(8,), critic=(8,))
    with torch.no_grad():
        made.critic_net[-1].weight.zero_()
        made.critic_net[-1].bias.fill_(value)
    return made


@pytest.mark.parametrize("whistle", [False, True])
def test_an_episode_that_is_cut_off_keeps_the_value_of_its_last_state(whistle: bool) -> None:
    """Nothing is paid. Cut off, the difference is gamma V - V as at any other time; the final whistle leaves -V."""
    length: dict[str, Any] = {"minutes": 0.02} if whistle else {"max_cycles": 4}
    env = SoccerVecEnv(
        players=[(1, 1)], matches=2, opponents="still", observe="belief", action_repeat=2, rewards="sparse", **length
    )
    network = a_network(env, 2.0)
    found, _ = collect(network, env, Start(env.reset(), network.no_states(2)), 12, 0.5, 0.0, lambda: None)
    ends = [round(0.02 * 60 * 16 / 2) - 1] if whistle else [3, 7, 11]
    expected = np.full((12, 2), 0.5 * 2.0 - 2.0)
    if whistle:
        expected[ends] = -2.0
    np.testing.assert_allclose(found.advantages[: 2 * ends[0] + 1], expected[: 2 * ends[0] + 1], atol=1e-6)
    env.close()


def test_the_critic_sees_the_same_of_a_match_in_a_run_of_small_teams_and_of_large_ones() -> None:
    shared: dict[str, Any] = {"matches": 4, "opponents": "still", "observe": "belief", "state": 5, "seed": 3}
    small, mixed = SoccerVecEnv(players=[(1, 1)], **shared), SoccerVecEnv(players=[(1, 1), (3, 3)], **shared)
    rows, others = small.reset(), mixed.reset()
    assert rows.shape[1] == others.shape[1] == small.observed + len(entries(5))
    np.testing.assert_array_equal(rows[:3], others[:3])
    assert others.shape == (6, rows.shape[1]) and mixed.size_of_row.tolist() == [0, 0, 0, 1, 1, 1]
    network = a_network(small, 1.0)
    np.testing.assert_array_equal(values_of(network, rows[:3]), values_of(network, others)[:3])


def test_densities_divergence_and_entropy_are_those_of_normal_distributions() -> None:
    torch.manual_seed(2)
    means, others, actions = torch.randn(3, 5, 4)
    std, narrow = torch.tensor([0.5, 0.3, 1.0, 2.0]), torch.tensor([0.4, 0.3, 1.5, 1.0])
    one, other = torch.distributions.Normal(means, std), torch.distributions.Normal(others, narrow)
    old, new = Normal(means, std), Normal(others, narrow)
    ratio = new.log_prob(actions) - old.log_prob(actions)
    assert torch.allclose(ratio, (other.log_prob(actions) - one.log_prob(actions)).sum(1), atol=1e-5)
    assert torch.allclose(new.divergence(old), torch.distributions.kl_divergence(one, other).sum(1).mean(), atol=1e-5)
    assert torch.allclose(old.entropy(), one.entropy().sum(1)[0], atol=1e-5)


def test_chances_divergence_and_entropy_of_skills_are_those_of_the_skills_that_apply() -> None:
    torch.manual_seed(2)
    outputs, others = torch.randn(2, 400, 5)
    masks = torch.rand(400, 5) < 0.6
    masks[:, 0] = True
    old, new = (policy_of(values, torch.zeros(5), masks) for values in (outputs, others))
    assert isinstance(old, Skills) and isinstance(new, Skills) and ((old.outputs > 0.5 * NEVER) == masks).all()
    chosen = old.draw()
    assert masks.gather(1, chosen.long()).all() and len(chosen.unique()) == 5
    one, other = (torch.distributions.Categorical(logits=policy.outputs) for policy in (old, new))
    assert torch.allclose(old.log_prob(chosen), one.log_prob(chosen[:, 0]), atol=1e-5)
    assert torch.allclose(new.divergence(old), torch.distributions.kl_divergence(one, other).mean(), atol=1e-5)
    assert torch.allclose(old.entropy(), one.entropy().mean(), atol=1e-5)


def test_the_actors_rate_follows_the_divergence_within_its_bounds_and_the_critics_stays() -> None:
    network = SoccerPolicy(layout(find_league("legged-2001"), "belief"), 200, hidden=(4,), critic=(4,))
    optimizer = make_optimizer(network, 1e-3)

    def rate_after(*divergences: float) -> float:
        for kl in divergences:
            follow_divergence(optimizer, kl, 0.01)
        assert [group["lr"] for group in optimizer.param_groups[1:]] == [1e-3, 1e-3]
        return float(optimizer.param_groups[0]["lr"])

    assert rate_after(0.01, 0.006, 0.019, 0.0) == 1e-3
    assert rate_after(0.021) == pytest.approx(1e-3 / 1.5) and rate_after(0.004) == pytest.approx(1e-3)
    assert rate_after(*[0.5] * 100) == RATES[0] and rate_after(*[0.001] * 100) == RATES[1]


def test_the_log_says_how_each_team_size_plays(tmp_path: Path) -> None:
    train_plainly(tiny_settings(tmp_path, steps=96, past=0, critic_first=0, action_repeat=4))
    line = records(tmp_path / "log.jsonl")[-1]
    assert line["entropy"] == pytest.approx(2.0 * (1.0 + log(2.0 * np.pi)) + 4.0 * log(line["noise"]), abs=0.05)
    assert line["kl"] >= 0.0 and line["learning_rate"] > 0.0 and line["explained"] <= 1.0
    assert set(line["minute"]) == {"1v1", "2v2"}
    assert set(line["minute"]["2v2"]) >= {"approach", "kicks", "whistles", "whistles_against"}
    assert all(goals["for"] >= 0.0 and goals["minutes"] > 0.0 for goals in line["goals"].values())
