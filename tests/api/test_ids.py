"""The registered ids: episodes of a length that a learner sees returns for, whole matches, and processes of workers."""

import subprocess
import sys

import gymnasium
import numpy as np
import pettingzoo
import pytest
from gymnasium.wrappers import RecordEpisodeStatistics, TimeAwareObservation

from soccer_env.api.ids import LEAGUES, STEPS
from tests.scenes.staged_envs import TEAMS


@pytest.mark.parametrize("name", LEAGUES)
def test_episodes_of_an_id_end_while_a_learner_still_watches(name):
    env = RecordEpisodeStatistics(gymnasium.make(f"soccer_env/{name}-1v1-v0", opponents="still"))
    env.reset(seed=1)
    for step in range(1, STEPS + 1):
        *_, terminated, truncated, info = env.step(np.zeros(4, np.float32))
        assert (terminated, truncated) == (False, step == STEPS)
    assert info["episode"]["l"] == STEPS


def test_the_length_can_be_changed_and_match_ids_have_none():
    def steps_of(name, **settings):
        return gymnasium.make(f"soccer_env/{name}", **TEAMS, **settings).unwrapped.match.settings.max_cycles

    assert steps_of("Legged2001-2v2-v0", max_cycles=7) == 7
    assert steps_of("Legged2001-2v2-v0", max_cycles=None) is None
    assert steps_of("Legged2001-Match-2v2-v0") is steps_of("MiddleSize2006-Match-6v6-v0") is None


def test_gymnasiums_own_word_for_the_length_is_understood():
    single = gymnasium.make("soccer_env/Legged2001-1v1-v0", max_episode_steps=3, **TEAMS)
    many = gymnasium.make_vec("soccer_env/Legged2001-1v1-v0", num_envs=2, max_episode_steps=3, **TEAMS)
    single.reset(seed=1), many.reset(seed=1)
    for step in (1, 2, 3):
        one = single.step(single.action_space.sample())
        two = many.step(many.action_space.sample())
        assert one[3] == two[3].all() == two[3].any() == (step == 3)
    with pytest.raises(ValueError, match="max_episode_steps must be .*got 0"):
        gymnasium.make_vec("soccer_env/Legged2001-1v1-v0", num_envs=2, max_episode_steps=0, **TEAMS)


def test_wrappers_that_want_to_know_the_length_do():
    env = gymnasium.make("soccer_env/Legged2001-1v1-v0", **TEAMS)
    assert env.spec.max_episode_steps == STEPS and TimeAwareObservation(env).max_timesteps == STEPS
    again = gymnasium.make(env.spec)
    assert again.spec.max_episode_steps == STEPS == again.unwrapped.match.settings.max_cycles
    assert gymnasium.make("soccer_env/Legged2001-Match-1v1-v0", **TEAMS).spec.max_episode_steps is None


@pytest.mark.skipif(not hasattr(pettingzoo, "make"), reason="this PettingZoo has no registry")
def test_pettingzoos_ids_have_the_same_lengths():
    for kind in ("parallel", "aec"):
        lengths = [
            pettingzoo.make(kind, f"soccer_env/soccer-{word}v0").unwrapped.match.settings.max_cycles
            for word in ("", "Match-")
        ]
        assert lengths == [STEPS, None]


def test_a_process_that_has_imported_nothing_finds_an_id_by_its_module():
    words = "import gymnasium; print(gymnasium.make('soccer_env:soccer_env/Legged2001-1v1-v0').unwrapped.agent)"
    done = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, check=False)
    assert done.stdout.strip() == "home_0", done.stderr


@pytest.mark.slow
def test_a_learner_of_stable_baselines_logs_returns():
    sb3 = pytest.importorskip("stable_baselines3")
    env = gymnasium.make("soccer_env/Legged2001-1v1-v0")
    model = sb3.PPO("MlpPolicy", env, n_steps=STEPS + 24, batch_size=512, n_epochs=1, device="cpu")
    model.learn(STEPS + 24)
    assert len(model.ep_info_buffer) == 1 and model.ep_info_buffer[0]["l"] == STEPS
