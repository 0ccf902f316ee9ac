"""The single-agent Gymnasium API: its contract, its ids, and that it is the parallel env seen by one agent."""

import subprocess
import sys

import gymnasium
import numpy as np
import pettingzoo
import pytest
from gymnasium.utils.env_checker import check_env, data_equivalence
from gymnasium.wrappers import RecordEpisodeStatistics, TimeAwareObservation

from soccer_env import soccer_v0
from soccer_env.api import ids
from soccer_env.api.ids import STEPS, register
from tests.scenes.staged_envs import GAMES, TEAMS, make_single_env
from tests.scenes.staging import LEAGUES


@pytest.mark.parametrize(("league", "home", "away"), GAMES)
def test_gymnasium_accepts_it(league, home, away):
    pytest.importorskip("pygame")
    name = {"legged-2001": "Legged2001", "middle-size-2006": "MiddleSize2006"}[league]
    env = gymnasium.make(f"soccer_env/{name}-1v1-v0", home=home, away=away, render_mode="rgb_array", **TEAMS)
    check_env(env.unwrapped)


@pytest.mark.parametrize(("league", "home", "away"), GAMES[1:3])
@pytest.mark.parametrize("actions", ["box", "full", "discrete", "multi", "skills"])
def test_stable_baselines_accepts_it(league, home, away, actions):
    checker = pytest.importorskip("stable_baselines3.common.env_checker")
    checker.check_env(make_single_env(league, home, away, actions=actions))


def test_every_id_can_be_made():
    known = [name for name in gymnasium.registry if name.startswith("soccer_env/")]
    assert "soccer_env/Legged2001-1v1-v0" in known and "soccer_env/MiddleSize2006-6v6-v0" in known and len(known) == 24
    for name in known:
        env = gymnasium.make(name, **TEAMS)
        settings = env.unwrapped.match.settings
        league = {"legged-2001": "Legged2001", "middle-size-2006": "MiddleSize2006"}[settings.league.name]
        word = "Match-" if settings.max_cycles is None else ""
        assert name == f"soccer_env/{league}-{word}{settings.home}v{settings.away}-v0"
        assert env.unwrapped.agent == f"home_{settings.home - 1}"
    register()  # again, and nobody is warned


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("agent", ["home_1", "home_0", "away_1"])
def test_the_single_env_is_the_parallel_env_of_its_agent(league, agent):
    solo = make_single_env(league, agent=agent, max_cycles=60)
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


def test_the_learner_and_the_teams_can_be_chosen():
    assert make_single_env(home=3, away=3).agent == "home_2"
    assert make_single_env(home=1, away=1, max_players=3).agent == "home_0"  # not a robot of the padding
    env = make_single_env(home=2, away=3, agent="away_1", controllers={"away_0": "still"})
    names = {name: squad.team.name for squad in env.match.squads for name in np.array(env.match.agents)[squad.players]}
    assert names == {"home_0": "random", "home_1": "random", "away_0": "still", "away_2": "random"}
    assert make_single_env(home=1, away=1, teammates=None).agent == "home_0"


@pytest.mark.parametrize("name", ids.LEAGUES)
def test_episodes_of_an_id_end_while_a_learner_still_watches(name):
    env = RecordEpisodeStatistics(gymnasium.make(f"soccer_env/{name}-1v1-v0", opponents="still"))
    env.reset(seed=1)
    for step in range(1, STEPS + 1):
        *_, terminated, truncated, info = env.step(np.zeros(4, np.float32))
        assert (terminated, truncated) == (False, step == STEPS)
    assert info["episode"]["l"] == STEPS


def test_wrappers_that_want_to_know_the_length_do():
    env = gymnasium.make("soccer_env/Legged2001-1v1-v0", **TEAMS)
    assert env.spec.max_episode_steps == STEPS and TimeAwareObservation(env).max_timesteps == STEPS
    again = gymnasium.make(env.spec)
    assert again.spec.max_episode_steps == STEPS == again.unwrapped.match.settings.max_cycles
    assert gymnasium.make("soccer_env/Legged2001-Match-1v1-v0", **TEAMS).spec.max_episode_steps is None


@pytest.mark.skipif(not hasattr(pettingzoo, "make"), reason="this PettingZoo has no registry")
def test_pettingzoo_knows_it_by_name_with_the_same_lengths():
    for kind in ("parallel", "aec"):
        envs = [pettingzoo.make(kind, f"soccer_env/soccer-{word}v0") for word in ("", "Match-")]
        assert [env.unwrapped.match.settings.max_cycles for env in envs] == [STEPS, None]
    assert pettingzoo.make("parallel", "soccer_env/soccer-v0", home=1, away=1).possible_agents == ["home_0", "away_0"]
    assert pettingzoo.make("aec", "soccer_env/soccer-v0", max_cycles=3).unwrapped.match.settings.max_cycles == 3


def test_a_process_that_has_imported_nothing_finds_an_id_by_its_module():
    words = "import gymnasium; print(gymnasium.make('soccer_env:soccer_env/Legged2001-1v1-v0').unwrapped.agent)"
    done = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, check=False)
    assert done.stdout.strip() == "home_0", done.stderr
