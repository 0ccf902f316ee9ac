"""Masks of indices in infos, as PettingZoo has them: an action space samples by the mask of its agent."""

import numpy as np
import pytest

from soccer_env import soccer_v0
from tests.scenes.staged_envs import make_vector_env
from tests.scenes.staging import LEAGUES


def by_parts(mask) -> list[np.ndarray]:
    return list(mask) if isinstance(mask, tuple) else [mask]


@pytest.mark.parametrize(("actions", "infos"), [("discrete", "flat"), ("multi", "nested"), ("skills", "full")])
@pytest.mark.parametrize("league", LEAGUES)
def test_an_action_space_samples_by_the_mask_of_its_agent(league, actions, infos):
    env = soccer_v0.parallel_env(league=league, home=2, away=1, actions=actions, infos=infos, max_cycles=40)
    _, told = env.reset(seed=1)
    env.unwrapped.match.robots["kick_clock"][0, 1] = 0.3
    while env.agents:
        match = env.unwrapped.match
        for agent in env.agents:
            assert np.concatenate(by_parts(told[agent]["action_mask"])).dtype == np.int8
        chosen = {agent: env.action_space(agent).sample(told[agent]["action_mask"]) for agent in env.agents}
        for agent, action in chosen.items():
            for index, mask in zip(np.atleast_1d(action), by_parts(told[agent]["action_mask"]), strict=True):
                assert mask[index] == 1
        *_, told = env.step(chosen)
        for row, agent in enumerate(env.possible_agents):
            assert (np.concatenate(by_parts(told[agent]["action_mask"])) == match.action_masks()[0, row]).all()


def test_numbers_and_no_infos_have_no_masks():
    env = soccer_v0.parallel_env(home=1, away=1)
    assert "action_mask" not in env.reset(seed=1)[1]["home_0"]
    env = soccer_v0.parallel_env(home=1, away=1, actions="multi", infos="none")
    assert env.reset(seed=1)[1]["home_0"] == {}


def test_one_agent_at_a_time_has_its_mask_and_a_save_keeps_its_choice():
    env, other = (soccer_v0.env(home=1, away=1, actions="multi") for _ in range(2))
    env.reset(seed=1)
    mask = env.last()[4]["action_mask"]
    assert len(mask) == 4 and all(part.dtype == np.int8 for part in mask)
    env.step(np.array([4, 2, 1, 2]))
    other.load(env.save())
    chosen = env.action_space("away_0").sample(mask)
    for one in (env, other):
        one.step(chosen)
    assert env.unwrapped.match.state_hash() == other.unwrapped.match.state_hash()


@pytest.mark.parametrize(("actions", "size"), [("discrete", 12), ("multi", 20), ("skills", 26)])
def test_the_vector_env_has_the_masks_of_all_matches_and_those_of_the_end(actions, size):
    for mode in ("NextStep", "SameStep"):
        envs = make_vector_env(3, actions=actions, max_cycles=5, autoreset_mode=mode)
        _, infos = envs.reset(seed=1)
        row = envs.match.agents.index(envs.agent)
        for step in range(5):
            assert infos["action_mask"].shape == (3, size) and infos["_action_mask"].all()
            assert (infos["action_mask"] == envs.match.action_masks()[:, row]).all()
            *_, truncated, infos = envs.step(envs.action_space.sample())
            assert truncated.all() == (step == 4)
        if mode == "SameStep":
            assert infos["final_info"]["action_mask"].shape == (3, size)
