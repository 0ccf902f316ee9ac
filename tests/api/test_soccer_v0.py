"""The PettingZoo API: what an env is and what step returns, which is the match and nothing else."""

import copy

import numpy as np
import pytest
from gymnasium.utils.env_checker import data_equivalence

from soccer_env import Match, soccer_v0
from soccer_env.random_numbers import seeds_for
from soccer_env.types import Phase
from tests.scenes.staged_envs import play
from tests.scenes.staging import LEAGUES


def test_it_says_what_it_is():
    env = soccer_v0.parallel_env(league="middle-size-2006", home=2, away=3)
    assert env.possible_agents == ["home_0", "home_1", "away_0", "away_1", "away_2"]
    assert env.metadata["name"] == str(env) == "soccer_v0"
    assert env.metadata["render_fps"] == 50 and env.metadata["is_parallelizable"]
    assert env.render_mode is None
    assert set(env.observation_spaces) == set(env.action_spaces) == set(env.possible_agents)
    assert all(env.observation_space(agent) is env.observation_spaces[agent] for agent in env.possible_agents)
    assert len({id(space) for space in env.action_spaces.values()}) == 5  # each is seeded on its own
    assert env.state_space.is_bounded()
    assert soccer_v0.env(league="middle-size-2006").unwrapped.match.league.name == "middle-size-2006"


@pytest.mark.parametrize(
    ("teams", "agents"),
    [
        ({"opponents": "random"}, ["home_0", "home_1"]),
        ({"opponents": "still", "teammates": "random"}, ["home_1"]),
        ({"controllers": {"home_0": "random", "away_1": "still"}}, ["home_1", "away_0", "away_2"]),
        ({"controllers": {"home": "random"}}, ["away_0", "away_1", "away_2"]),
    ],
)
def test_agents_are_the_robots_that_no_team_plays(teams, agents):
    env = soccer_v0.parallel_env(home=2, away=3, **teams)
    everybody = soccer_v0.parallel_env(home=2, away=3)
    observations, _ = env.reset(seed=4)
    theirs, _ = everybody.reset(seed=4)
    assert env.agents == list(observations) == agents
    assert all(np.array_equal(observations[agent], theirs[agent]) for agent in agents)
    before = env.unwrapped.match.robots["command"].copy()
    for actions, (seen, rewards, *_, infos) in play(env, 20):
        assert list(seen) == list(rewards) == list(infos) == agents
        for agent in agents:
            row = env.unwrapped.match.agents.index(agent)
            command = env.unwrapped.match.robots["command"][0, row]
            assert command["forward"] == np.float64(actions[agent][0])
            assert rewards[agent] == env.unwrapped.match.rewards[0, row]
    if "random" in str(teams):
        assert (env.unwrapped.match.robots["command"] != before).any()


def test_padding_robots_are_inactive_agents_off_the_field_and_no_learners_beside_team_mates():
    env = soccer_v0.parallel_env(home=1, away=2, max_players=3)
    _, infos = env.reset(seed=0)
    assert [agent for agent in env.agents if infos[agent]["active"]] == ["home_0", "away_0", "away_1"]
    assert len(env.agents) == 6
    assert env.state_space.shape[0] > soccer_v0.parallel_env(home=1, away=2).state_space.shape[0]
    for _, (observations, *_, infos) in play(env, 5):
        assert not infos["home_2"]["active"]
        assert env.observation_space("home_2").contains(observations["home_2"])
    env = soccer_v0.parallel_env(home=2, away=1, max_players=3, teammates="still", opponents="still")
    assert env.possible_agents == ["home_1"] and env.reset(seed=0)[1]["home_1"]["active"]


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("actions", ["box", "full", "discrete", "multi"])
def test_observations_and_state_stay_in_their_spaces_through_a_whole_match(league, actions):
    env = soccer_v0.parallel_env(league=league, home=3, away=2, minutes=0.25, actions=actions)
    observations, _ = env.reset(seed=5)
    seen = set()
    while env.agents:
        assert all(env.observation_space(agent).contains(array) for agent, array in observations.items())
        assert env.state_space.contains(env.state())
        actions = {agent: env.action_space(agent).sample() for agent in env.agents}
        observations, _, terminated, truncated, infos = env.step(actions)
        seen.update(name for name in ("event_half_time", "event_final_whistle") if infos["home_0"][name])
    assert seen == {"event_half_time", "event_final_whistle"}
    assert all(terminated.values()) and not any(truncated.values())
    assert infos["away_0"]["phase"] == Phase.OVER


@pytest.mark.parametrize("league", LEAGUES)
def test_one_env_is_a_match_of_64(league):
    many = Match(league, home=2, away=2, matches=64, seed=8)
    env = soccer_v0.parallel_env(league=league, home=2, away=2)
    observations, _ = env.reset(options={"match_seed": many.seeds[17]})
    rng = np.random.default_rng(0)
    for _ in range(200):
        assert np.array_equal(np.stack([*observations.values()]), many.observations[17])
        actions = rng.uniform(-1.0, 1.0, (64, 4, 4)).astype(np.float32)
        many.step(actions)
        observations, rewards, *_ = env.step(dict(zip(env.agents, actions[17], strict=True)))
        assert list(rewards.values()) == many.rewards[17].tolist()
        assert env.unwrapped.match.state_hash() == many.state_hash(17)
    assert seeds_for(8, 1)[0] == many.seeds[0]  # so that reset(seed=8) is match 0


@pytest.mark.parametrize("league", LEAGUES)
def test_taking_turns_gives_the_same_transitions(league):
    together = soccer_v0.parallel_env(league=league, home=2, away=1, max_cycles=40)
    turns = soccer_v0.env(league=league, home=2, away=1, max_cycles=40)
    observations, infos = together.reset(seed=6)
    turns.reset(seed=6)
    rewards, ended = dict.fromkeys(together.agents, 0.0), dict.fromkeys(together.agents, False)
    rounds, actions = 0, {}
    for agent in turns.agent_iter():
        observation, reward, terminated, truncated, info = turns.last()
        assert np.array_equal(observation, observations[agent])
        assert (reward, terminated or truncated, info) == (rewards[agent], ended[agent], infos[agent])
        action = None if ended[agent] else turns.action_space(agent).sample()
        turns.step(action)
        if action is not None:
            actions[agent] = action
        if len(actions) == 3:
            observations, rewards, _, ended, infos = together.step(actions)
            rounds, actions = rounds + 1, {}
            assert np.array_equal(turns.state(), together.state())
    assert rounds == 40 and not turns.agents and not together.agents


def test_what_step_returns_is_the_callers_to_change():
    env, witness = soccer_v0.parallel_env(), soccer_v0.parallel_env()
    env.reset(seed=1), witness.reset(seed=1)
    kept = []
    for (actions, mine), (_, theirs) in zip(play(env, 30), play(witness, 30), strict=True):
        assert data_equivalence(mine, theirs, exact=True)
        kept.append((mine, copy.deepcopy(mine)))
        for part in mine:
            assert list(part) == env.agents
        for array in actions.values():
            array[:] = 9.0
        for array in theirs[0].values():
            array[:] = 9.0
        for info in theirs[4].values():
            info["event_goal"] = info["reward_goal"] = "spoiled"
        witness.state()[:] = 9.0
        for part in theirs:
            part.clear()
    assert all(data_equivalence(now, then, exact=True) for now, then in kept)


def test_actions_outside_the_box_are_clipped_and_any_real_dtype_will_do():
    envs = [soccer_v0.parallel_env(home=1, away=1) for _ in range(4)]
    for env in envs:
        env.reset(seed=2)
    wild = np.array([3.0, -7.0, 1e30, 0.5])
    kinds = (wild, wild.astype(np.float32), wild.tolist(), np.clip(wild, -1.0, 1.0).astype(np.float16))
    for env, action in zip(envs, kinds, strict=True):
        for _ in range(20):
            env.step(dict.fromkeys(env.agents, action))
    hashes = {env.unwrapped.match.state_hash() for env in envs}
    assert len(hashes) == 1
