"""Self-play in which both sides learn, and discrete actions, as rows of the matches that lie under them."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.actions import DISCRETE
from soccer_env.match import truth_state
from soccer_env.random_numbers import seeds_for

pytest.importorskip("stable_baselines3")

import stable_baselines3 as sb3
from gymnasium.spaces import Discrete

from soccer_env.train.ppo.vec_env import SoccerVecEnv

SETTINGS: dict[str, Any] = {"players": [(2, 1)], "matches": 3, "seed": 4, "minutes": 0.1, "action_repeat": 4}


def under(env: SoccerVecEnv, actions: str) -> Match:
    """Return a match like the one under an environment, at the moment of its first decision."""
    seeds = seeds_for(4, 3)
    match = Match(
        home=2,
        away=1,
        matches=3,
        seeds=seeds,
        minutes=0.1,
        autoreset="same_step",
        actions=actions,  # type: ignore[arg-type]
    )
    stand = np.zeros((3, 3), int) if actions == "discrete" else np.zeros((3, 3, 4))
    for _ in range(env.first_decision):
        match.step(stand)
    return match


@pytest.mark.parametrize("actions", ["box", "discrete"])
def test_the_rows_of_both_sides_are_the_robots_of_each_match(actions: str) -> None:
    env = SoccerVecEnv(**SETTINGS, opponents=None, actions=actions)
    match, rng = under(env, actions), np.random.default_rng(1)
    assert env.num_envs == 9
    seen = env.reset()
    paid_home = paid_away = 0.0
    for _ in range(8):
        assert (seen == match.observations.reshape(9, -1)).all()
        chosen = rng.integers(0, len(DISCRETE), 9) if actions == "discrete" else rng.uniform(-1, 1, (9, 4))
        seen, rewards, dones, _ = env.step(chosen)
        total = np.zeros((3, 3))
        for step in range(4):
            total += match.step(chosen.reshape(3, 3, *chosen.shape[1:]), last=step == 3)[1]
        np.testing.assert_allclose(rewards, total.ravel(), atol=1e-5)
        assert not dones.any()
        paid_home, paid_away = paid_home + rewards[0::3].sum(), paid_away + rewards[2::3].sum()
    assert paid_home and paid_away


def test_an_episode_ends_for_both_sides_and_is_told_from_home() -> None:
    env = SoccerVecEnv(**{**SETTINGS, "players": [(1, 1), (2, 2)], "matches": 4}, opponents=None, actions="discrete")
    env.reset()
    ended = np.zeros(env.num_envs, int)
    for _ in range(40):
        _, _, dones, infos = env.step(np.zeros(env.num_envs, int))
        ended += dones
        for row in np.flatnonzero(dones):
            assert infos[row]["terminal_observation"].shape == env.observation_space.shape
    assert env.num_envs == 2 * 2 + 2 * 4 and (ended == ended[0]).all() and ended[0] >= 1
    assert {(result.opponent, result.players) for result in env.results} == {("learner", (1, 1)), ("learner", (2, 2))}


@pytest.mark.parametrize("algorithm", [sb3.PPO, sb3.DQN])
def test_discrete_learners_learn_on_it(algorithm: Any) -> None:
    env = SoccerVecEnv(**SETTINGS, opponents="still", actions="discrete")
    assert env.action_space == Discrete(len(DISCRETE))
    more = {"n_steps": 8, "batch_size": 16} if algorithm is sb3.PPO else {"buffer_size": 100, "learning_starts": 20}
    model = algorithm("MlpPolicy", env, seed=1, device="cpu", **more)
    before = [parameter.detach().clone() for parameter in model.policy.parameters()]
    model.learn(96)
    assert any((one != other).any() for one, other in zip(before, model.policy.parameters(), strict=True))


def test_ppo_learns_against_itself_and_a_save_goes_on() -> None:
    env = SoccerVecEnv(**SETTINGS, opponents=None)
    sb3.PPO("MlpPolicy", env, n_steps=8, batch_size=24, n_epochs=1, seed=1, device="cpu").learn(9 * 8)
    saved, other = env.save(), SoccerVecEnv(**SETTINGS, opponents=None)
    other.reset()
    assert (other.load(saved) == env._observations()).all()
    actions = np.ones((9, 4))
    for _ in range(5):
        assert all((one == two).all() for one, two in zip(env.step(actions)[:3], other.step(actions)[:3], strict=True))


WRONG = [
    (np.zeros(6), "actions must be 6 whole numbers, got float64 of shape (6,)"),
    (np.zeros(5, int), "actions must be 6 whole numbers, got int64 of shape (5,)"),
    (np.zeros((6, 1), int), "actions must be 6 whole numbers, got int64 of shape (6, 1)"),
    (np.array([0, 1, 2, 12, 0, 0]), "action of row 3 must be 0 to 11, got 12"),
    (np.array([0, 1, 2, 3, 0, -1]), "action of row 5 must be 0 to 11, got -1"),
]


@pytest.mark.parametrize(("actions", "message"), WRONG)
def test_wrong_discrete_actions_are_named_and_nothing_moves(actions: np.ndarray, message: str) -> None:
    env = SoccerVecEnv(**SETTINGS, opponents="still", actions="discrete")
    env.reset()
    before = env.matches[0].state_hash()
    with pytest.raises(ValueError) as error:
        env.step(actions)
    assert str(error.value) == message
    assert env.matches[0].state_hash() == before


def test_what_self_play_cannot_do_is_said() -> None:
    with pytest.raises(ValueError, match="max_players must be None where both sides learn"):
        SoccerVecEnv(**SETTINGS, opponents=None, max_players=3)


def test_each_side_has_the_state_from_its_own_side_and_so_at_the_end() -> None:
    env = SoccerVecEnv(**{**SETTINGS, "minutes": None}, opponents=None, state=True, max_cycles=6)
    match, rng = env.matches[0], np.random.default_rng(2)
    seen = env.reset()
    for step in range(6):
        rows = seen.reshape(3, 3, -1)[..., env.observed :]
        assert (rows[:, :2] == match.state("home")[:, None]).all() and (rows[:, 2] == match.state("away")).all()
        assert (rows[:, 0] != rows[:, 2]).any()
        seen, _, dones, infos = env.step(rng.uniform(-1.0, 1.0, (9, 4)))
        assert dones.all() == (step == 5)
    last = np.array([info["terminal_observation"] for info in infos]).reshape(3, 3, -1)[..., env.observed :]
    for side, row in (("home", 0), ("home", 1), ("away", 2)):
        assert (last[:, row] == truth_state.states(match.settings, match.final, side, 2)).all()
    env.load(env.save())
