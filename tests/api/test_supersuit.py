"""SuperSuit: the route of PettingZoo's own tutorials from a parallel env to stable-baselines3, with processes."""

import pytest

from soccer_env import soccer_v0
from tests.scenes.staging import LEAGUES

STEPS = 16  # of each robot in a rollout


@pytest.mark.slow
@pytest.mark.parametrize("processes", [1, 2])
@pytest.mark.parametrize("league", LEAGUES)
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
