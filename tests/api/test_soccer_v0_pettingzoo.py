"""The PettingZoo API passes PettingZoo's own tests and works in other people's wrappers."""

import numpy as np
import pytest
from gymnasium.utils.env_checker import data_equivalence
from pettingzoo.utils import BaseParallelWrapper, aec_to_parallel
from pettingzoo.utils.wrappers import AssertOutOfBoundsWrapper, ClipOutOfBoundsWrapper

from soccer_env import soccer_v0
from tests.scenes.staged_envs import GAMES, play
from tests.scenes.staging import LEAGUES

# PettingZoo's own tests


@pytest.mark.filterwarnings("ignore::DeprecationWarning")  # pettingzoo.test imports an env of its own the old way
@pytest.mark.parametrize(("league", "home", "away"), GAMES)
def test_pettingzoo_accepts_it(league, home, away):
    from pettingzoo.test import api_test, parallel_api_test, parallel_seed_test, seed_test

    def make(maker=soccer_v0.parallel_env, **settings):
        return maker(league=league, home=home, away=away, **settings)

    parallel_api_test(make(), num_cycles=200)
    parallel_api_test(make(max_cycles=50), num_cycles=200)
    parallel_api_test(make(opponents="random"), num_cycles=100)
    api_test(make(soccer_v0.env, max_cycles=40), num_cycles=200)
    parallel_seed_test(make, num_cycles=50)
    seed_test(lambda: make(soccer_v0.env), num_cycles=20)


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("actions", ["box", "full", "discrete"])
def test_pettingzoo_accepts_every_kind_of_action(league, actions):
    from pettingzoo.test import api_test, parallel_api_test

    parallel_api_test(soccer_v0.parallel_env(league=league, home=2, away=1, actions=actions), num_cycles=100)
    api_test(soccer_v0.env(league=league, home=1, away=2, actions=actions, max_cycles=30), num_cycles=100)


def test_max_cycles_are_kept_by_both_faces():
    from pettingzoo.test import max_cycles_test

    max_cycles_test(soccer_v0)


@pytest.mark.parametrize("league", LEAGUES)
def test_pettingzoo_can_render_it(league):
    pytest.importorskip("pygame")
    from pettingzoo.test import render_test

    render_test(lambda render_mode: soccer_v0.env(league=league, home=2, away=2, render_mode=render_mode))


# Other people's wrappers


def test_pettingzoo_wrappers_change_nothing():
    plain = soccer_v0.parallel_env(max_cycles=30)
    wrapped = BaseParallelWrapper(soccer_v0.parallel_env(max_cycles=30))
    there_and_back = aec_to_parallel(soccer_v0.env(max_cycles=30))
    for env in (plain, wrapped, there_and_back):
        env.reset(seed=1)
    assert wrapped.unwrapped.match.agents == plain.unwrapped.match.agents
    for one, two, three in zip(*(play(env, 40) for env in (plain, wrapped, there_and_back)), strict=True):
        assert data_equivalence(one[1], two[1], exact=True)
        assert data_equivalence(one[1], three[1], exact=True)
    assert plain.agents == wrapped.agents == there_and_back.agents == []


def test_wrappers_that_look_at_actions_work():
    clipped = ClipOutOfBoundsWrapper(soccer_v0.env(home=1, away=1))
    clipped.reset(seed=0)
    clipped.step(np.zeros(4, np.float32))
    checked = AssertOutOfBoundsWrapper(soccer_v0.env(home=1, away=1, actions="discrete"))
    checked.reset(seed=0)
    with pytest.raises(AssertionError):
        checked.step(99)
    checked.step(3)


@pytest.mark.parametrize(("home", "away"), [(1, 1), (3, 5), (11, 11)])
def test_torchrl_reads_the_same_layout(home, away):
    pytest.importorskip("torchrl")
    from torchrl.envs import PettingZooWrapper

    env = PettingZooWrapper(soccer_v0.parallel_env(home=home, away=away))
    rollout = env.rollout(3)
    assert rollout["next", "home", "info", "phase"].shape == (3, home)
    assert rollout["home", "observation"].shape == (3, home, len(env.unwrapped.match.observation_names))
    assert rollout["away", "action"].shape == (3, away, 4)
