"""Copies of a SoccerVecEnv: settings, save and seed make them, and copy and original have one future."""

import copy
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

pytest.importorskip("stable_baselines3")

from soccer_env import make_team
from soccer_env.match.squads import Lineup
from soccer_env.train.ppo.vec_env import SoccerVecEnv


def pickled(one: Any) -> Any:
    """Return what pickle makes of something."""
    return pickle.loads(pickle.dumps(one))


def clouded(one: Any) -> Any:
    """Return what cloudpickle makes of something."""
    return pickle.loads(pytest.importorskip("cloudpickle").dumps(one))


LINEUP = Lineup((make_team("chaser"), make_team("still")), np.array([0.7, 0.3]), ("chaser", "still"))


@pytest.mark.parametrize("way", [pickled, clouded, copy.deepcopy])
@pytest.mark.parametrize(
    "settings",
    [
        {"players": [(1, 1), (2, 3)], "matches": 4, "opponents": LINEUP, "max_cycles": 11, "action_repeat": 4},
        {"league": "middle-size-2006", "players": [(2, 2)], "matches": 3, "state": True, "stagger": True},
        {"players": [(2, 2)], "matches": 2, "actions": "full", "observe": "belief", "ideal_share": 0.5, "minutes": 0.1},
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
    env = SoccerVecEnv(players=[(1, 1)], matches=2, seed=1)
    first = env.reset()
    env.seed(9)
    other = pickled(env)
    assert np.array_equal(env.reset(), other.reset()) and not np.array_equal(first, other.reset())


def test_a_wrong_setting_is_still_refused() -> None:
    with pytest.raises(ValueError, match="SoccerVecEnv takes no teammates"):
        SoccerVecEnv(teammates="chaser")
