"""The single-agent Gymnasium API: its contract, and that it is the parallel env seen by one agent."""

import gymnasium
import numpy as np
import pettingzoo
import pytest
from gymnasium.utils.env_checker import check_env, data_equivalence

from soccer_env import soccer_v0
from soccer_env.api.ids import register
from tests.scenes.staged_envs import GAMES, TEAMS, make
from tests.scenes.staging import LEAGUES

# The contract


@pytest.mark.parametrize(("league", "home", "away"), GAMES)
def test_gymnasium_accepts_it(league, home, away):
    pytest.importorskip("pygame")
    name = {"legged-2001": "Legged2001", "middle-size-2006": "MiddleSize2006"}[league]
    env = gymnasium.make(f"soccer_env/{name}-1v1-v0", home=home, away=away, render_mode="rgb_array", **TEAMS)
    check_env(env.unwrapped)


@pytest.mark.parametrize(("league", "home", "away"), GAMES)
@pytest.mark.parametrize("actions", ["box", "full", "discrete"])
def test_stable_baselines_accepts_it(league, home, away, actions):
    checker = pytest.importorskip("stable_baselines3.common.env_checker")
    checker.check_env(make(league, home, away, actions=actions))


def test_every_id_can_be_made():
    ids = [name for name in gymnasium.registry if name.startswith("soccer_env/")]
    assert "soccer_env/Legged2001-1v1-v0" in ids and "soccer_env/MiddleSize2006-6v6-v0" in ids and len(ids) == 24
    for name in ids:
        env = gymnasium.make(name, **TEAMS)
        settings = env.unwrapped.match.settings
        league = {"legged-2001": "Legged2001", "middle-size-2006": "MiddleSize2006"}[settings.league.name]
        word = "Match-" if settings.max_cycles is None else ""
        assert name == f"soccer_env/{league}-{word}{settings.home}v{settings.away}-v0"
        assert env.unwrapped.agent == f"home_{settings.home - 1}"
    register()  # again, and nobody is warned


@pytest.mark.skipif(not hasattr(pettingzoo, "make"), reason="this PettingZoo has no registry")
def test_pettingzoo_knows_it_by_name():
    parallel = pettingzoo.make("parallel", "soccer_env/soccer-v0", home=1, away=2)
    assert parallel.possible_agents == ["home_0", "away_0", "away_1"]
    assert pettingzoo.make("aec", "soccer_env/soccer-v0", max_cycles=3).unwrapped.match.settings.max_cycles == 3


def test_the_default_opponent_is_a_team_of_the_league():
    pytest.importorskip("soccer_env.baselines.chaser")
    for name in ("soccer_env/Legged2001-2v2-v0", "soccer_env/MiddleSize2006-2v2-v0"):
        env = gymnasium.make(name)
        env.reset(seed=1)
        for _ in range(20):
            env.step(env.action_space.sample())
        assert [squad.team.name for squad in env.unwrapped.match.squads] == ["chaser", "chaser"]


# Agreement


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("agent", ["home_1", "home_0", "away_1"])
def test_the_single_env_is_the_parallel_env_of_its_agent(league, agent):
    solo = make(league, agent=agent, max_cycles=60)
    others = {name: "random" for name in ("home_0", "home_1", "away_0", "away_1") if name != agent}
    parallel = soccer_v0.parallel_env(league=league, home=2, away=2, controllers=others, max_cycles=60)
    assert solo.observation_space == parallel.observation_space(agent)
    assert solo.action_space == parallel.action_space(agent)
    for episode in range(2):
        seed = 5 if episode == 0 else None
        mine, theirs = solo.reset(seed=seed), parallel.reset(seed=seed)
        assert data_equivalence(mine, tuple(part[agent] for part in theirs), exact=True)
        ended = False
        while not ended:
            action = solo.action_space.sample()
            mine, theirs = solo.step(action), parallel.step({agent: action})
            assert data_equivalence(mine, tuple(part[agent] for part in theirs), exact=True)
            assert solo.match.state_hash() == parallel.unwrapped.match.state_hash()
            ended = mine[2] or mine[3]
    assert parallel.agents == []


# Who plays


def test_the_learner_and_the_teams_can_be_chosen():
    assert make(home=3, away=3).agent == "home_2"
    assert make(home=1, away=1, max_players=3).agent == "home_0"  # not a robot of the padding
    env = make(home=2, away=3, agent="away_1", controllers={"away_0": "still"})
    names = {name: squad.team.name for squad in env.match.squads for name in np.array(env.match.agents)[squad.players]}
    assert names == {"home_0": "random", "home_1": "random", "away_0": "still", "away_2": "random"}
    assert make(home=1, away=1, teammates=None).agent == "home_0"


# Training libraries


@pytest.mark.parametrize("league", LEAGUES)
def test_one_policy_fits_every_team_size(league):
    sb3 = pytest.importorskip("stable_baselines3")
    model = sb3.PPO("MlpPolicy", make(league, 1, 1), n_steps=8, batch_size=8, n_epochs=1, device="cpu")
    model.learn(8)
    for home, away in ((3, 5), (11, 11)):
        env = make(league, home, away)
        model.set_env(env)
        model.learn(8)
        action, _ = model.predict(env.reset(seed=0)[0])
        assert action.shape == (4,)
