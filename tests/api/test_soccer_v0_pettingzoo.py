"""The PettingZoo API passes PettingZoo's own tests, works in other people's wrappers, and shows the match."""

import numpy as np
import pytest

from soccer_env import soccer_v0
from tests.scenes.staged_envs import GAMES, play
from tests.scenes.staging import LEAGUES


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
@pytest.mark.parametrize("actions", ["box", "full", "discrete", "multi", "skills"])
def test_pettingzoo_accepts_every_kind_of_action(league, actions):
    from pettingzoo.test import api_test, max_cycles_test, parallel_api_test

    max_cycles_test(soccer_v0)
    parallel_api_test(soccer_v0.parallel_env(league=league, home=2, away=1, actions=actions), num_cycles=100)
    api_test(soccer_v0.env(league=league, home=1, away=2, actions=actions, max_cycles=30), num_cycles=100)


@pytest.mark.parametrize("league", LEAGUES)
def test_frames_show_the_match_and_leave_it_alone(league):
    pytest.importorskip("pygame")
    from pettingzoo.test import render_test

    env, witness = (soccer_v0.parallel_env(league=league, render_mode=mode) for mode in ("rgb_array", None))
    env.reset(seed=1), witness.reset(seed=1)
    frames = []
    for _ in zip(play(env, 10), play(witness, 10), strict=True):
        frames.append(env.render())
    assert frames[0].dtype == np.uint8 and frames[0].ndim == 3 and frames[0].shape[2] == 3
    assert not np.array_equal(frames[0], frames[-1])
    assert env.unwrapped.match.state_hash() == witness.unwrapped.match.state_hash()
    env.close()
    env.close()
    assert np.array_equal(env.render(), frames[-1])
    render_test(lambda render_mode: soccer_v0.env(league=league, home=2, away=2, render_mode=render_mode))


def test_a_window_is_shown_at_every_step_and_closes_twice():
    pytest.importorskip("pygame")
    env = soccer_v0.parallel_env(league="middle-size-2006", home=1, away=1, render_mode="human", opponents="still")
    env.close()
    env.reset(seed=0)
    window = env.screen._window
    assert window.is_open and window.fps == 50
    for _ in play(env, 3):
        assert env.render() is None
    env.close()
    env.close()
    assert not window.is_open


STEPS = 16  # of each robot in a rollout


@pytest.mark.slow
@pytest.mark.parametrize(("league", "processes"), zip(LEAGUES, (2, 1), strict=True))
def test_a_learner_trains_on_vectors_of_copies(league, processes):
    supersuit = pytest.importorskip("supersuit")  # here, as doctest cannot look into it
    sb3 = pytest.importorskip("stable_baselines3")
    env = soccer_v0.parallel_env(league=league, home=2, away=2, opponents="chaser", senses="ideal", max_cycles=10)
    one = supersuit.pettingzoo_env_to_vec_env_v1(env)
    many = supersuit.concat_vec_envs_v1(one, 2, num_cpus=processes, base_class="stable_baselines3")
    assert many.num_envs == 4
    first = many.reset()
    assert len({row.tobytes() for row in first}) == 4  # no two robots see the same: copies draw seeds of their own
    model = sb3.PPO("MlpPolicy", many, n_steps=STEPS, batch_size=STEPS, n_epochs=1, device="cpu")
    before = model.policy.state_dict()["action_net.bias"].clone()
    model.learn(4 * STEPS)
    assert model.num_timesteps == 4 * STEPS
    assert (model.policy.state_dict()["action_net.bias"] != before).any()
    many.close()
