"""A VecEnv in which both sides learn, by discrete actions, from the critic's state; staggered beginnings, saves."""

import re
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.actions import DISCRETE, ActionKind
from soccer_env.match import truth_state
from soccer_env.random_numbers import seeds_for
from tests.scenes.staging import refused

pytest.importorskip("stable_baselines3")

import stable_baselines3 as sb3
from gymnasium.spaces import Discrete

from soccer_env.teams import Lineup, make_team
from soccer_env.train.ppo.vec_env import SoccerVecEnv
from tests.train.evaluate.staged_rows import MIXED, assert_same_play, play, rows

SETTINGS: dict[str, Any] = {"players": [(2, 1)], "matches": 3, "seed": 4, "minutes": 0.1, "action_repeat": 4}


def under(env: SoccerVecEnv, actions: str) -> Match:
    """Return a match like the one under an environment, at the moment of its first decision."""
    settings: dict[str, Any] = {"seeds": seeds_for(4, 3), "minutes": 0.1, "autoreset": "same_step", "actions": actions}
    match = Match(home=2, away=1, matches=3, **settings)
    for _ in range(env.first_decision):
        match.step(ActionKind(actions).still(3, 3))
    return match


@pytest.mark.parametrize("actions", ["box", "discrete", "multi", "skills"])
def test_the_rows_of_both_sides_are_the_robots_of_each_match(actions: str) -> None:
    env = SoccerVecEnv(**SETTINGS, opponents=None, actions=actions)
    match, rng = under(env, actions), np.random.default_rng(1)
    assert env.num_envs == 9
    seen = env.reset()
    paid_home = paid_away = 0.0
    for _ in range(8):
        assert (seen == match.observations.reshape(9, -1)).all()
        chosen = rng.integers(0, 5, (9, 4)) if actions == "multi" else rng.uniform(-1, 1, (9, 4))
        chosen = rng.integers(0, len(DISCRETE), 9) if actions in ("discrete", "skills") else chosen
        if actions != "box":
            masks = np.stack(env.env_method("action_masks"))
            assert (masks == match.action_masks().reshape(9, -1)).all() and masks.dtype == np.int8
        seen, rewards, dones, _ = env.step(chosen)
        total = np.zeros((3, 3))
        for step in range(4):
            total += match.step(chosen.reshape(3, 3, *chosen.shape[1:]), last=step == 3)[1]
        np.testing.assert_allclose(rewards, total.ravel(), atol=1e-5)
        assert not dones.any()
        paid_home, paid_away = paid_home + rewards[0::3].sum(), paid_away + rewards[2::3].sum()
    assert paid_home and paid_away
    with pytest.raises(AttributeError, match="have no method 'dance'"):
        env.env_method("dance")


def test_an_episode_ends_for_both_sides_and_is_told_from_home() -> None:
    env = SoccerVecEnv(**{**SETTINGS, "players": [(1, 1), (2, 2)], "matches": 4}, opponents=None, actions="discrete")
    env.reset()
    ended = np.zeros(env.num_envs, int)
    for _ in range(40):
        _, _, dones, infos = env.step(np.zeros(env.num_envs, int))
        ended += dones
        for row in np.flatnonzero(dones):
            assert infos[row]["terminal_observation"].shape == env.observation_space.shape
    assert env.num_envs == 3 * 2 + 1 * 4 and (ended == ended[0]).all() and ended[0] >= 1
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
    with pytest.raises(ValueError, match="max_players must be None where both sides learn"):
        SoccerVecEnv(**SETTINGS, opponents=None, max_players=3)
    env = SoccerVecEnv(**SETTINGS, opponents=None)
    sb3.PPO("MlpPolicy", env, n_steps=8, batch_size=24, n_epochs=1, seed=1, device="cpu").learn(9 * 8)
    saved, other = env.save(), SoccerVecEnv(**SETTINGS, opponents=None)
    other.reset()
    assert (other.load(saved) == env._observations()).all()
    actions = np.ones((9, 4))
    for _ in range(5):
        assert all((one == two).all() for one, two in zip(env.step(actions)[:3], other.step(actions)[:3], strict=True))


WRONG = [
    (np.zeros(6), "actions must be whole numbers of shape (6,), got float64 of shape (6,)"),
    (np.zeros(5, int), "actions must be whole numbers of shape (6,), got int64 of shape (5,)"),
    (np.zeros((6, 1), int), "actions must be whole numbers of shape (6,), got int64 of shape (6, 1)"),
    (np.array([0, 1, 2, 12, 0, 0]), "action of row 3 must be 0 to 11, got 12"),
    (np.array([0, 1, 2, 3, 0, -1]), "action of row 5 must be 0 to 11, got -1"),
]


@pytest.mark.parametrize(("actions", "message"), WRONG)
def test_wrong_discrete_actions_are_named_and_nothing_moves(actions: np.ndarray, message: str) -> None:
    env = SoccerVecEnv(**SETTINGS, opponents="still", actions="discrete")
    env.reset()
    with refused(env.matches[0], f"^{re.escape(message)}$"):
        env.step(actions)


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


def named_state(env: Any, row: np.ndarray) -> dict[str, float]:
    """Return the state behind an observation by name."""
    names = env.matches[0].state_names
    assert len(names) == len(row) - env.observed
    return dict(zip(names, row[env.observed :].tolist(), strict=True))


def test_the_state_lies_behind_the_observation_seen_from_home() -> None:
    env, plain = rows(state=True, minutes=0.1), rows(minutes=0.1)
    env.reset(), plain.reset()
    halves = set()
    for step in range(90):
        (seen, *_), (less, *_) = play(env, 1, step)[0], play(plain, 1, step)[0]
        assert (seen[:, : env.observed] == less).all()
        assert (seen[::2, env.observed :] == seen[1::2, env.observed :]).all()
        match, told = env.matches[0], named_state(env, seen[0])
        direction = match.matches["home_direction"][0]
        halves.add(float(direction))
        half = match.league.pitch.length / 2 + match.league.pitch.goal_depth
        assert told["ball_x"] == pytest.approx(direction * match.balls["x"][0] / half, abs=1e-6)
        assert told["home_direction"] == 1.0
        assert told["home_0_x"] == pytest.approx(less[0, env.matches[0].observation_names.index("own_x")], abs=1e-6)
        assert told["home_1_cos"] == pytest.approx(less[1, env.matches[0].observation_names.index("own_cos")], abs=1e-6)
    assert halves == {1.0, -1.0}, "both halves were played"


@pytest.mark.parametrize("repeat", [1, 8])
def test_stagger_spreads_the_clocks_over_the_first_half(repeat: int) -> None:
    env = rows(matches=8, stagger=True, minutes=1.0, action_repeat=repeat, senses="sensors", observe="belief")
    seen, match = env.reset(), env.matches[0]
    clock, gap = match.matches["clock"], match.settings.half_length / 8
    assert (np.abs(np.diff(clock) - gap) <= repeat * match.league.dt).all() and clock[-1] < match.settings.half_length
    left = seen[::2, match.observation_names.index("time_left")]
    np.testing.assert_allclose(left, 1.0 - clock / 60.0, atol=1e-3, err_msg="robots know")
    ends = [np.flatnonzero(dones[::2]).tolist() for _, _, dones, _ in play(env, 970 // repeat)]
    assert [m for end in ends for m in end] == [7, 6, 5, 4, 3, 2, 1, 0]


@pytest.mark.parametrize("players", [((2, 2),), MIXED], ids=["one size", "mixed"])
def test_a_save_goes_on_bit_for_bit(players: Any) -> None:
    def fresh(seed: int) -> Any:
        return rows(
            players=players, observe="belief", senses="sensors", action_repeat=8, max_cycles=9, seed=seed, state=True,
            opponents=Lineup((make_team("still"), make_team("chaser")), np.ones(2), ("a", "b")),  # type: ignore[arg-type]
        )  # fmt: skip

    one, other = fresh(3), fresh(4)
    one.reset(), other.reset()
    play(one, 5)
    saved = one.save()
    seen = other.load(saved)
    assert (seen == one._observations()).all() and other.opponents == one.opponents
    histories = play(one, 30, seed=1), play(other, 30, seed=1)
    assert assert_same_play(*histories)
    assert one.results and [result.opponent for result in one.results] == [result.opponent for result in other.results]
    for (*_, infos), (*_, others) in zip(*histories, strict=True):
        assert [info.get("episode") for info in infos] == [info.get("episode") for info in others]


def test_a_save_of_other_settings_is_refused() -> None:
    with pytest.raises(ValueError, match="does not fit"):
        rows(minutes=1.0).load(rows().save())
