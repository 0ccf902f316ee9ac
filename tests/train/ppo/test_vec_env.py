"""The VecEnv: what stable-baselines3 may count on, and that its rows are the matches that lie under it."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, Rewards
from soccer_env.agents.learned import first_decision_step
from soccer_env.random_numbers import seeds_for
from soccer_env.rewards import PRESETS
from tests.train.evaluate.staged_rows import MIXED, assert_same_play, draw, play, rows

pytest.importorskip("stable_baselines3")

import stable_baselines3 as sb3

from soccer_env.train.ppo.match_blocks import Result


@pytest.mark.parametrize("state", [False, True])
@pytest.mark.parametrize("actions", ["box", "full"])
@pytest.mark.parametrize("observe", ["truth", "belief", "percepts"])
def test_shapes_types_and_bounds_are_those_of_the_spaces(observe: str, actions: str, state: bool) -> None:
    env = rows(observe=observe, actions=actions, state=state, players=MIXED, senses="sensors", minutes=0.05)
    assert env.num_envs == 3 * 1 + 1 * 3 and env.action_space.shape == ({"box": 4, "full": 7}[actions],)
    seen = env.reset()
    history = [(seen, np.zeros(6, np.float32), np.zeros(6, bool), [{}] * 6), *play(env, 60)]
    for seen, rewards, dones, infos in history:
        assert seen.shape == (6, *env.observation_space.shape) and seen.dtype == env.observation_space.dtype  # type: ignore[misc]
        assert all(row in env.observation_space for row in seen)
        assert rewards.shape == dones.shape == (6,)
        assert rewards.dtype == np.float32 and dones.dtype == bool and np.isfinite(rewards).all()
        assert isinstance(infos, list) and len(infos) == 6
        for info, done in zip(infos, dones, strict=True):
            at_end = {"terminal_observation", "TimeLimit.truncated", "episode", "opponent"}
            assert set(info) == (at_end if done else set())
            assert not done or info["terminal_observation"] in env.observation_space
    assert sum(dones.sum() for _, _, dones, _ in history) == 6, "each row ended once"


def test_what_rows_share_can_be_asked_for_and_what_they_have_not_is_said() -> None:
    env = rows()
    assert env.get_attr("repeat") == [1] * 8 and env.get_attr("repeat", [2, 3]) == [1, 1]
    assert env.env_is_wrapped(sb3.common.vec_env.VecMonitor, [0, 1]) == [False, False]
    assert env.seed(7) == [7] * 8
    with pytest.raises(AttributeError, match="have no attribute 'speed' of their own"):
        env.set_attr("speed", 1)
    with pytest.raises(AttributeError, match="have no method 'render' of their own"):
        env.env_method("render")


@pytest.mark.parametrize("repeat", [1, 8])
def test_what_was_returned_is_not_overwritten_by_the_next_step(repeat: int) -> None:
    env = rows(action_repeat=repeat, minutes=0.05)
    kept = [env.reset()]
    copies = [kept[0].copy()]
    for seen, rewards, dones, infos in play(env, 50):
        last = [info["terminal_observation"] for info in infos if info]
        kept += [seen, rewards, dones, *last]
        copies += [array.copy() for array in (seen, rewards, dones, *last)]
    assert all(np.array_equal(one, copy) for one, copy in zip(kept, copies, strict=True))
    assert len(kept) > 1 + 3 * 50, "some episode ended"


def test_actions_are_clipped_and_nonsense_is_refused() -> None:
    wild, tame = rows(), rows()
    wild.reset(), tame.reset()
    assert assert_same_play([wild.step(np.full((8, 4), 1e30))], [tame.step(np.ones((8, 4), np.int64))])
    with pytest.raises(ValueError, match="not finite"):
        wild.step(np.full((8, 4), np.nan))
    with pytest.raises(ValueError, match="actions must be numbers of shape"):
        wild.step(np.ones((7, 4)))


def by_hand(match: Match, actions: np.ndarray, repeat: int) -> tuple[np.ndarray, np.ndarray, dict[int, np.ndarray]]:
    """Play one step of 2 against 2 with a Match alone; return rewards and ends (M,), and last observations by match."""
    gained, over, last = np.zeros((match.count, 2), np.float32), np.zeros(match.count, bool), dict[int, np.ndarray]()
    numbers = np.zeros((match.count, 4, 4))
    numbers[:, :2] = actions.reshape(match.count, 2, 4)
    for step in range(repeat):
        _, paid, terminated, truncated = match.step(numbers, last=step == repeat - 1)
        gained[~over] += paid[~over, :2]
        for index, m in enumerate(np.flatnonzero(terminated | truncated)):
            last.setdefault(int(m), match.final["observations"][index, :2])
            over[m], numbers[m] = True, 0.0
    return gained, over, last


@pytest.mark.parametrize("repeat", [1, 8])
def test_transitions_are_those_of_a_match(repeat: int) -> None:
    steps = 48 // repeat
    env = rows(action_repeat=repeat, max_cycles=steps, minutes=0.15)
    match = Match(
        home=2, away=2, matches=4, opponents="chaser", senses="ideal", autoreset="same_step", max_cycles=48,
        minutes=0.15, seeds=seeds_for(3, 4), rewards=Rewards(gamma=0.99),
    )  # fmt: skip
    seen, rng, ends = env.reset(), np.random.default_rng(0), 0
    for _ in range(first_decision_step(match.league.delay_steps, repeat)):
        match.step(np.zeros((4, 4, 4)))
    for _ in range(160 // repeat):
        assert (seen == match.observations[:, :2].reshape(8, -1)).all()
        actions = draw(env, rng)
        seen, rewards, dones, infos = env.step(actions)
        paid, over, last = by_hand(match, actions, repeat)
        assert (rewards == paid.ravel()).all() and (dones == np.repeat(over, 2)).all()
        for m, rows_of_it in last.items():
            assert all((infos[2 * m + r]["terminal_observation"] == rows_of_it[r]).all() for r in range(2))
        ends += len(last)
    assert ends >= 8 and match.state_hash() == env.matches[0].state_hash()


@pytest.mark.parametrize("repeat", [1, 8])
def test_a_mix_of_team_sizes_plays_as_each_size_alone(repeat: int) -> None:
    mixed = rows(players=MIXED, action_repeat=repeat, senses="sensors", observe="belief")
    mixed.reset()
    assert mixed.learners == [1, 3] and mixed.edges == [0, 3, 6]
    for size, match, seeds in zip(MIXED, mixed.matches, np.split(seeds_for(3, 4), [3]), strict=True):
        assert (match.settings.home, match.settings.away) == size and match.seeds.tolist() == seeds.tolist()
    alone = rows(players=MIXED[:1], action_repeat=repeat, senses="sensors", observe="belief", matches=3)
    alone.reset()
    rng = np.random.default_rng(0)
    for _ in range(30):
        actions = draw(mixed, rng)
        assert (mixed.step(actions)[0][:3] == alone.step(actions[:3])[0]).all()


def test_a_seed_tells_the_episodes() -> None:
    one, other, third = rows(), rows(), rows(seed=4)
    starts = [env.reset() for env in (one, other, third)]
    assert (starts[0] == starts[1]).all()
    first = play(one, 40)
    assert assert_same_play(first, play(other, 40))
    assert not assert_same_play(first, play(third, 40))
    third.seed(3)
    assert (third.reset() == starts[0]).all() and assert_same_play(first, play(third, 40))


@pytest.mark.parametrize(("players", "matches"), [(((2, 2),), 8), (MIXED, 8), (MIXED, 140)])  # 1, 2 and 3 blocks
def test_threads_change_nothing(players: tuple[tuple[int, int], ...], matches: int) -> None:
    one, two = (rows(players=players, matches=matches, minutes=0.05, threads=threads) for threads in (1, 2))
    one.reset(), two.reset()
    assert assert_same_play(play(one, 60), play(two, 60))
    assert len(one.results) >= matches and one.results == two.results
    two.close()


@pytest.mark.parametrize(
    ("settings", "steps", "limit"), [({"max_cycles": 12}, 12, True), ({"minutes": 0.05}, 48, False)]
)
def test_an_end_by_max_cycles_is_a_time_limit_for_all_rows_and_the_final_whistle_is_none(
    settings: dict[str, Any], steps: int, limit: bool
) -> None:
    env = rows(**settings)
    env.reset()
    history = play(env, steps)
    assert not any(dones.any() for _, _, dones, _ in history[:-1])
    _, _, dones, infos = history[-1]
    assert dones.all() and all(info["TimeLimit.truncated"] is limit for info in infos)


@pytest.mark.parametrize("repeat", [1, 8])
def test_a_goal_that_ends_the_episode_is_no_time_limit_and_ends_its_match_alone(repeat: int) -> None:
    env = rows(episode="goal", action_repeat=repeat, rewards=Rewards.only(goal=1.0))
    env.reset()
    shoot(env.matches[0], 2)
    for _ in range(20):
        _, rewards, dones, infos = env.step(np.zeros((8, 4)))
        if dones.any():
            break
    assert np.flatnonzero(dones).tolist() == [4, 5]
    assert infos[4]["TimeLimit.truncated"] is False and infos[5]["TimeLimit.truncated"] is False
    assert (rewards == np.array([0, 0, 0, 0, 1, 1, 0, 0])).all()
    (result,) = env.results
    assert result == Result((2, 2), "chaser", 1, 0, result.minutes) and 0.0 < result.minutes < 0.02
    assert [Result((1, 1), "x", *score).points for score in ((2, 1), (1, 1), (0, 3))] == [1.0, 0.5, 0.0]


def shoot(match: Match, m: int) -> None:
    half = match.league.pitch.length / 2.0
    match.balls["x"][m], match.balls["y"][m], match.balls["vx"][m] = half - 0.2, 0.0, 2.0
    for r in range(len(match.agents)):
        match.robots["x"][m, r], match.robots["y"][m, r] = -half + 0.3, 0.4 * r - 0.6
    match.rebuild()


def test_returns_of_episodes_sum_their_rewards() -> None:
    env = rows(action_repeat=8, max_cycles=6, minutes=1.0)
    env.reset()
    sums, lengths, seen = np.zeros(8), np.zeros(8, int), 0
    for _, rewards, dones, infos in play(env, 40):
        sums, lengths = sums + rewards, lengths + 1
        for row in np.flatnonzero(dones):
            assert infos[row]["episode"]["r"] == pytest.approx(sums[row], abs=1e-6)
            assert infos[row]["episode"]["l"] == lengths[row]
            sums[row], lengths[row], seen = 0.0, 0, seen + 1
    assert seen >= 4 * 8 and all(isinstance(info["episode"]["r"], float) for info in infos if info)


def test_rewards_are_those_of_their_name_with_the_gamma_of_the_environment() -> None:
    env = rows(rewards="sparse", gamma=0.9)
    assert all(match.settings.rewards == replace(PRESETS["sparse"], gamma=0.9) for match in env.matches)
    with pytest.raises(ValueError, match="unknown rewards 'spars', did you mean 'sparse'"):
        rows(rewards="spars")
