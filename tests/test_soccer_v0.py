"""The PettingZoo face: its contract, and that it is the match and nothing else."""

import copy
import os
import subprocess
import sys

import numpy as np
import pytest
from gymnasium.utils.env_checker import data_equivalence
from pettingzoo.utils import BaseParallelWrapper, aec_to_parallel
from pettingzoo.utils.wrappers import AssertOutOfBoundsWrapper, ClipOutOfBoundsWrapper

from soccer_env import Match, Rewards, Scene, soccer_v0
from soccer_env.random_numbers import seeds_for

LEAGUES = ("legged-2001", "middle-size-2006")
GAMES = [("legged-2001", 1, 1), ("legged-2001", 3, 5), ("middle-size-2006", 3, 3), ("middle-size-2006", 11, 11)]


def play(env, steps, seed=0, scale=1.0):
    """Step a parallel env with random actions until it ends; yield actions and what step returned."""
    rng = np.random.default_rng(seed)
    for _ in range(steps):
        if not env.agents:
            return
        actions = {
            agent: (scale * rng.uniform(-1.0, 1.0, env.action_space(agent).shape)).astype(np.float32)
            for agent in env.agents
        }
        yield actions, env.step(actions)


def put_ball(env, x, y=0.0, vx=0.0, vy=0.0):
    """Put the ball somewhere while play is on, field frame."""
    match = env.unwrapped.match
    for name, value in (("x", x), ("y", y), ("vx", vx), ("vy", vy), ("roll_x", vx), ("roll_y", vy)):
        match.balls[name][0] = value
    match.matches["phase"], match.matches["restart_team"] = 0, -1
    match.reseat()


def standing(env):
    """Return the actions of agents that all stand still."""
    return {agent: np.zeros(env.action_space(agent).shape, np.float32) for agent in env.agents}


def about_to_score(after=1, **settings):
    """Return an env, begun, in which home scores in a certain control step, and the rest stands still."""
    env = soccer_v0.parallel_env(home=2, away=2, **settings)
    env.reset(seed=1)
    league = env.unwrapped.match.league
    put_ball(env, league.pitch.length / 2 + league.ball.radius - (after - 0.5) * 2.0 * league.dt, vx=2.0)
    return env


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


# What an env is


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


@pytest.mark.parametrize("league", LEAGUES)
def test_the_layout_is_the_same_at_every_team_size(league):
    envs = [soccer_v0.parallel_env(league=league, home=h, away=a) for h, a in ((1, 1), (3, 5), (11, 11))]
    shapes = {env.observation_space(agent).shape for env in envs for agent in env.possible_agents}
    assert len(shapes) == 1
    names = [env.unwrapped.match.observation_names for env in envs]
    assert names[0] == names[1] == names[2] and shapes == {(len(names[0]),)}


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


def test_team_mates_leave_the_last_robot_that_plays_to_the_learner():
    env = soccer_v0.parallel_env(home=2, away=1, max_players=3, teammates="still", opponents="still")
    assert env.possible_agents == ["home_1"]
    assert env.reset(seed=0)[1]["home_1"]["active"]


def test_padding_robots_are_inactive_agents_off_the_field():
    env = soccer_v0.parallel_env(home=1, away=2, max_players=3)
    _, infos = env.reset(seed=0)
    assert [agent for agent in env.agents if infos[agent]["active"]] == ["home_0", "away_0", "away_1"]
    assert len(env.agents) == 6
    small = soccer_v0.parallel_env(home=1, away=2)
    assert env.state_space.shape[0] > small.state_space.shape[0]
    for _, (observations, *_, infos) in play(env, 5):
        assert not infos["home_2"]["active"]
        assert env.observation_space("home_2").contains(observations["home_2"])


# What step returns


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("actions", ["box", "full", "discrete"])
def test_observations_and_state_stay_in_their_spaces_through_a_whole_match(league, actions):
    env = soccer_v0.parallel_env(league=league, home=3, away=2, minutes=0.25, actions=actions)
    observations, _ = env.reset(seed=5)
    seen = set()
    while env.agents:
        assert all(env.observation_space(agent).contains(array) for agent, array in observations.items())
        assert env.state_space.contains(env.state())
        observations, _, terminated, truncated, infos = env.step(
            {agent: env.action_space(agent).sample() for agent in env.agents}
        )
        seen.update(infos["home_0"]["events"])
    assert {"half_time", "final_whistle"} <= seen
    assert all(terminated.values()) and not any(truncated.values())
    assert infos["away_0"]["phase"] == "over"


@pytest.mark.parametrize("league", LEAGUES)
def test_two_envs_of_one_seed_agree_in_every_bit_for_500_steps(league):
    fresh, used = (soccer_v0.parallel_env(league=league) for _ in range(2))
    used.reset(seed=99)
    for _ in play(used, 150, seed=1):
        pass
    assert data_equivalence(fresh.reset(seed=3), used.reset(seed=3), exact=True)
    for (_, mine), (_, theirs) in zip(play(fresh, 500), play(used, 500), strict=True):
        assert data_equivalence(mine, theirs, exact=True)
        assert fresh.unwrapped.match.state_hash() == used.unwrapped.match.state_hash()
    assert fresh.agents


def test_seeds_differ_and_a_reset_without_one_goes_on_to_the_next_episode():
    one, other = soccer_v0.parallel_env(), soccer_v0.parallel_env()
    first = one.reset(seed=1)[0]["home_0"]
    assert not np.array_equal(first, one.reset(seed=2)[0]["home_0"])
    assert np.array_equal(first, one.reset(seed=1)[0]["home_0"])
    second = one.reset()[0]["home_0"]
    assert not np.array_equal(first, second)
    other.reset(seed=1)
    assert np.array_equal(second, other.reset()[0]["home_0"])
    free = [soccer_v0.parallel_env().reset()[0]["home_0"] for _ in range(2)]
    assert not np.array_equal(*free)


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
            info["events"]["goal"] = info["rewards"]["goal"] = "spoiled"
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


# Infos


@pytest.mark.parametrize("league", LEAGUES)
def test_infos_tell_of_a_goal_in_words(league):
    env = about_to_score(league=league)
    _, rewards, _, _, infos = env.step(standing(env))
    assert infos["home_0"]["events"]["goal"] == infos["away_1"]["events"]["goal"] == "home"
    assert infos["home_0"]["events"]["restart"] == "kick-off"
    assert infos["home_0"]["events"]["restart_team"] == "away"
    assert infos["home_1"]["score"] == (1, 0) and infos["away_1"]["score"] == (0, 1)
    assert infos["home_1"]["rewards"]["goal"] == 1.0 and infos["away_0"]["rewards"]["goal"] == -1.0
    assert infos["home_0"]["phase"] == "kick-off"
    assert rewards["home_0"] == pytest.approx(sum(infos["home_0"]["rewards"].values()), abs=1e-12)
    _, _, _, _, infos = env.step(standing(env))
    assert infos["home_0"]["events"] == {} and infos["home_0"]["rewards"]["goal"] == 0.0
    assert env.reset()[1]["home_0"] == {
        "active": True,
        "events": {},
        "rewards": {"goal": 0.0, "progress": 0.0, "approach": 0.0, "effort": 0.0},
        "score": (0, 0),
        "phase": "kick-off",
    }


def test_infos_can_be_left_out():
    env = soccer_v0.parallel_env(home=1, away=1, infos=False)
    empty = {"home_0": {}, "away_0": {}}
    assert env.reset(seed=1)[1] == empty
    assert [result[4] for _, result in play(env, 3)] == [empty] * 3


def test_infos_tell_who_touched_the_ball():
    env = soccer_v0.parallel_env(league="legged-2001", home=1, away=1)
    env.reset(seed=0)
    robot = env.unwrapped.match.robots[0, 0]
    front = env.unwrapped.match.league.body.front + env.unwrapped.match.league.ball.radius
    put_ball(env, robot["x"] + front * np.cos(robot["heading"]), robot["y"] + front * np.sin(robot["heading"]))
    seen = [infos for _, (*_, infos) in play(env, 10, scale=0.1)]
    mine = {name for infos in seen for name in infos["home_0"]["events"]}
    assert {"touch", "touch_team"} <= mine
    assert all("touch" not in infos["away_0"]["events"] for infos in seen)


def test_reward_terms_of_ones_own_are_named_in_infos():
    def haste(match):
        return 0.01 * np.hypot(match.robots["vx"], match.robots["vy"])

    env = soccer_v0.parallel_env(rewards=Rewards(progress=0.0, extra={"haste": haste}), action_repeat=3)
    env.reset(seed=3)
    for _, (_, rewards, *_, infos) in play(env, 20):
        for agent in env.agents:
            assert list(infos[agent]["rewards"]) == ["goal", "progress", "approach", "effort", "haste"]
            assert rewards[agent] == pytest.approx(sum(infos[agent]["rewards"].values()), abs=1e-12)
    assert infos["home_1"]["rewards"]["haste"] > 0.0


# Ends


@pytest.mark.parametrize("after", [1, 2])
@pytest.mark.parametrize("league", LEAGUES)
def test_repeated_actions_add_up_rewards_and_events(league, after):
    rewards = Rewards(gamma=1.0)  # shaping discounts once an action; tests/test_rewards.py has that
    once = about_to_score(after, league=league, rewards=rewards)
    thrice = about_to_score(after, league=league, rewards=rewards, action_repeat=3)
    parts = [once.step(standing(once)) for _ in range(3)]
    observations, rewards, _, _, infos = thrice.step(standing(thrice))
    assert np.array_equal(observations["home_1"], parts[2][0]["home_1"])
    assert rewards["away_0"] == pytest.approx(sum(part[1]["away_0"] for part in parts), abs=1e-12)
    assert infos["away_0"]["events"]["goal"] == "home" and infos["away_0"]["score"] == (0, 1)
    assert ["goal" in part[4]["home_0"]["events"] for part in parts] == [step == after for step in (1, 2, 3)]
    assert once.unwrapped.match.matches["step"] == thrice.unwrapped.match.matches["step"]
    assert thrice.metadata["render_fps"] == once.metadata["render_fps"] / 3


@pytest.mark.parametrize("repeat", [1, 4])
@pytest.mark.parametrize("league", LEAGUES)
def test_the_goal_that_ends_an_episode_terminates_all_agents_together(league, repeat):
    rewards = Rewards(extra={"one": lambda match: np.ones(match.rewards.shape)})
    env = about_to_score(league=league, episode="goal", action_repeat=repeat, rewards=rewards)
    _, rewards, terminated, truncated, infos = env.step(standing(env))
    assert terminated == dict.fromkeys(env.possible_agents, True)
    assert truncated == dict.fromkeys(env.possible_agents, False)
    assert env.agents == [] and infos["home_0"]["events"]["goal"] == "home" and infos["home_0"]["phase"] == "over"
    assert infos["home_0"]["rewards"]["goal"] == 1.0 and rewards["home_0"] > 0.0
    assert infos["home_0"]["rewards"]["one"] == 1.0
    assert env.unwrapped.match.matches["step"][0] == 1  # the repeated steps after it wait
    env.reset()
    assert env.agents == env.possible_agents and env.unwrapped.match.matches["step"][0] == 0


@pytest.mark.parametrize("repeat", [1, 7])
def test_the_time_limit_of_a_drill_truncates(repeat):
    scene = Scene("wait", "nothing happens", success="home scores", time_limit=1.0, in_play=True)
    env = soccer_v0.parallel_env(scene=scene, episode="drill", home=1, away=1, action_repeat=repeat)
    env.reset(seed=0)
    steps = 0
    while env.agents:
        _, _, terminated, truncated, _ = env.step(standing(env))
        steps += 1
    assert steps == -(-16 // repeat) and all(truncated.values()) and not any(terminated.values())


def test_max_cycles_count_steps_and_not_control_steps():
    env = soccer_v0.parallel_env(home=1, away=1, max_cycles=6, action_repeat=5)
    env.reset(seed=0)
    assert len(list(play(env, 100))) == 6
    assert env.unwrapped.match.matches["step"][0] == 30


# Bad input: an error that names agent and value, and nothing has changed

NAN, GOOD = float("nan"), np.zeros(4, np.float32)
BAD_ACTIONS = {
    "not a number": (lambda good: {**good, "away_1": np.array([0, NAN, 0, 0], np.float32)}, r"away_1.*finite.*nan"),
    "not a number, as a list": (lambda good: {**good, "home_1": [0, NAN, 0, 0]}, r"home_1.*finite.*nan"),
    "infinity": (lambda good: {**good, "home_0": np.array([0, 0, -np.inf, 0])}, r"home_0.*finite.*-inf"),
    "too short": (lambda good: {**good, "home_1": np.zeros(3, np.float32)}, r"home_1.*4 numbers.*\(3,\)"),
    "too long": (lambda good: {**good, "home_1": np.zeros(7, np.float32)}, r"home_1.*4 numbers.*\(7,\)"),
    "a batch": (lambda good: {**good, "home_1": np.zeros((1, 4), np.float32)}, r"home_1.*4 numbers.*\(1, 4\)"),
    "a scalar": (lambda good: {**good, "home_1": np.float32(0.5)}, r"home_1.*4 numbers"),
    "a word": (lambda good: {**good, "home_1": "forward"}, r"home_1.*4 numbers"),
    "words": (lambda good: {**good, "home_1": ["1", "0", "0", "0"]}, r"home_1.*4 numbers"),
    "nothing": (lambda good: {**good, "home_1": None}, r"home_1.*4 numbers"),
    "ragged": (lambda good: {**good, "home_1": [[1.0], 2.0, 3.0, 4.0]}, r"home_1.*4 numbers"),
    "complex": (lambda good: {**good, "home_1": np.zeros(4, complex)}, r"home_1.*4 numbers.*complex"),
    "truth values": (lambda good: {**good, "home_1": np.zeros(4, bool)}, r"home_1.*4 numbers.*bool"),
    "an object": (lambda good: {**good, "home_1": np.array([object()] * 4)}, r"home_1.*4 numbers.*object"),
    "an agent is missing": (lambda good: {a: x for a, x in good.items() if a != "away_0"}, r"away_0 is missing"),
    "no agents": (lambda good: {}, r"home_0 is missing"),
    "unknown agent": (lambda good: {**good, "home_7": GOOD}, r"unknown agent 'home_7'.*home_0, home_1, away_0, away_1"),
    "unknown agent for a known one": (
        lambda good: {**{a: x for a, x in good.items() if a != "home_0"}, 3: GOOD},
        r"home_0 is missing",
    ),
    "no dict": (lambda good: list(good.values()), r"dict.*list"),
    "an array": (lambda good: np.zeros((4, 4), np.float32), r"dict.*ndarray"),
    "None": (lambda good: None, r"dict.*NoneType"),
}


@pytest.mark.parametrize(("spoil", "complaint"), BAD_ACTIONS.values(), ids=BAD_ACTIONS.keys())
def test_bad_actions_are_refused_and_change_nothing(spoil, complaint):
    env, witness = (soccer_v0.parallel_env(home=2, away=2) for _ in range(2))
    env.reset(seed=1), witness.reset(seed=1)
    for _ in zip(play(env, 5), play(witness, 5), strict=True):
        pass
    before = env.unwrapped.match.state_hash()
    with pytest.raises(ValueError, match=complaint):
        env.step(spoil(standing(env)))
    assert env.unwrapped.match.state_hash() == before
    for (_, mine), (_, theirs) in zip(play(env, 5), play(witness, 5), strict=True):
        assert data_equivalence(mine, theirs, exact=True)


@pytest.mark.parametrize(
    ("action", "complaint"),
    [
        (12, "home_0 must be 0 to 11, got 12"),
        (-1, "home_0 must be 0 to 11, got -1"),
        (1.0, "home_0 must be one integer"),
        (True, "home_0 must be one integer"),
        (None, "home_0 must be one integer"),
        ([1, 2], "home_0 must be one integer"),
        ("kick", "home_0 must be one integer"),
    ],
)
def test_bad_discrete_actions_are_refused(action, complaint):
    env = soccer_v0.parallel_env(home=1, away=1, actions="discrete")
    env.reset(seed=1)
    before = env.unwrapped.match.state_hash()
    with pytest.raises(ValueError, match=complaint):
        env.step({"home_0": action, "away_0": 0})
    assert env.unwrapped.match.state_hash() == before
    env.step({"home_0": np.array([3]), "away_0": np.int64(10)})


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        ({"seed": -1}, "seed.*-1"),
        ({"seed": 1.5}, "seed.*1.5"),
        ({"seed": "seven"}, "seed.*seven"),
        ({"seed": True}, "seed.*True"),
        ({"options": {"speed": 3}}, "unknown option 'speed'; known: match_seed"),
        ({"options": 3}, "options must be a dict, got 3"),
        ({"options": {"match_seed": -3}}, "seeds.*-3"),
        ({"options": {"match_seed": 0.5}}, "seeds.*0.5"),
        ({"options": {"match_seed": 1 << 70}}, "seeds"),
        ({"seed": 1, "options": {"match_seed": 3}}, "both"),
    ],
)
def test_bad_resets_are_refused_and_the_episode_goes_on(arguments, complaint):
    env = soccer_v0.parallel_env(home=1, away=1)
    env.reset(seed=1)
    env.step(standing(env))
    before = env.unwrapped.match.state_hash()
    with pytest.raises(ValueError, match=complaint):
        env.reset(**arguments)
    assert env.unwrapped.match.state_hash() == before
    env.step(standing(env))


@pytest.mark.parametrize(
    ("settings", "complaint"),
    [
        ({"league": "legged-2002"}, "unknown league 'legged-2002'; known: legged-2001"),
        ({"league": ["legged-2001"]}, "unknown league"),
        ({"scene": {}}, "unknown scene"),
        ({"rewards": {"goal": 1.0}}, "unknown rewards.*or a Rewards object"),
        ({"home": 0}, "home must be 1 to 11, got 0"),
        ({"home": 14}, "home must be 1 to 11, got 14"),
        ({"away": 2.0}, "away must be 1 to 11, got 2.0"),
        ({"max_players": 2}, "max_players must be 3 to 11, got 2"),
        ({"keeper": -1}, "keeper must be 0 to 2, got -1"),
        ({"observe": "smell"}, "observe must be one of truth, percepts, belief, got 'smell'"),
        ({"senses": "eyes"}, "senses must be one of ideal, sensors, got 'eyes'"),
        ({"pose": "compass"}, "pose must be one of percept, particles, got 'compass'"),
        ({"sensors": {"radar": 1.0}}, "unknown name 'radar' in LeggedSensors"),
        ({"memory": {"memory": True}}, "unknown name 'memory' in LeggedMemory"),
        ({"senses": {"north": "ideal"}}, "home and away"),
        ({"actions": "buttons"}, "unknown actions 'buttons'; known: box, full, discrete"),
        ({"scene": "kickoff"}, "unknown scene 'kickoff'; known: kick-off"),
        ({"episode": "forever"}, "episode must be one of match, goal, drill"),
        ({"episode": "drill"}, "needs a scene with a success test"),
        ({"rules": "fifa"}, "unknown rules 'fifa'"),
        ({"rewards": "rich"}, "unknown rewards 'rich'; known: default, sparse"),
        ({"variation": "wild"}, "variation must be None"),
        ({"placement": "teleport"}, "placement must be one of instant, drive"),
        ({"minutes": 0}, "minutes must be above zero, got 0"),
        ({"minutes": NAN}, "minutes must be above zero, got nan"),
        ({"action_repeat": 0}, "action_repeat must be 1 to 1000, got 0"),
        ({"max_cycles": 0}, "max_cycles must be 1"),
        ({"render_mode": "ansi"}, "render_mode must be one of rgb_array, human, got 'ansi'"),
        ({"opponents": "giants"}, "unknown team 'giants'; known:"),
        ({"opponents": "random@1.5"}, "0 to 1"),
        ({"controllers": {"home_9": "still"}}, "unknown agent 'home_9' in controllers"),
        ({"controllers": ["still"]}, "controllers must map"),
        ({"controllers": {"home": "still", "away": "still"}}, "no agent is left"),
    ],
)
@pytest.mark.parametrize("maker", [soccer_v0.parallel_env, soccer_v0.env], ids=["parallel", "turns"])
def test_bad_settings_are_refused(maker, settings, complaint):
    with pytest.raises(ValueError, match=complaint):
        maker(**settings)


def test_positions_and_unknown_settings_are_refused():
    with pytest.raises(TypeError):
        soccer_v0.parallel_env("legged-2001")
    for maker in (soccer_v0.parallel_env, soccer_v0.env, soccer_v0.raw_env):
        with pytest.raises(TypeError, match="legue"):
            maker(legue="legged-2001")


def test_calls_in_the_wrong_order_say_that_reset_is_due():
    env = soccer_v0.parallel_env(home=1, away=1, max_cycles=1, render_mode="rgb_array")
    before = env.unwrapped.match.state_hash()
    with pytest.raises(RuntimeError, match="step before reset"):
        env.step({"home_0": GOOD, "away_0": GOOD})
    with pytest.raises(RuntimeError, match="render before reset"):
        env.render()
    assert env.unwrapped.match.state_hash() == before
    env.reset(seed=0)
    env.step(standing(env))
    before = env.unwrapped.match.state_hash()
    for actions in ({}, {"home_0": GOOD, "away_0": GOOD}):
        with pytest.raises(RuntimeError, match="step after the end of the episode"):
            env.step(actions)
    assert env.unwrapped.match.state_hash() == before


def test_a_bad_action_of_one_who_takes_turns_is_refused_at_once():
    env = soccer_v0.env(home=2, away=1, max_cycles=2)
    env.reset(seed=0)
    before = env.unwrapped.match.state_hash()
    for action in (None, np.array([0, 0, NAN, 0]), np.zeros(3)):
        with pytest.raises(ValueError, match="home_0"):
            env.step(action)
    assert env.agent_selection == "home_0" and env.unwrapped.match.state_hash() == before
    for _ in range(6):
        env.step(GOOD)
    assert all(env.truncations.values())
    with pytest.raises(ValueError, match=f"{env.agent_selection} has ended.*None"):
        env.step(GOOD)
    for _ in range(3):
        env.step(None)
    assert env.agents == []


def test_bad_input_is_refused_without_assertions_too():
    program = """
import numpy as np
from soccer_env import soccer_v0
env = soccer_v0.parallel_env(home=1, away=1)
still, nan = np.zeros(4), np.full(4, np.nan)
for act in (
    lambda: env.step({}),
    lambda: env.reset(seed=1) and env.step({"home_0": nan, "away_0": still}),
    lambda: env.step({"home_0": still}),
    lambda: env.reset(seed=-1),
    lambda: soccer_v0.env(home=99),
):
    try:
        act()
        print("accepted")
    except (ValueError, RuntimeError) as error:
        print(type(error).__name__)
env.step({"home_0": np.zeros(4), "away_0": np.zeros(4)})
print(env.unwrapped.match.matches["step"][0])
"""
    done = subprocess.run([sys.executable, "-O", "-c", program], capture_output=True, text=True, env={**os.environ})
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == ["RuntimeError", "ValueError", "ValueError", "ValueError", "ValueError", "1"]


# Pictures


@pytest.mark.parametrize("league", LEAGUES)
def test_frames_show_the_match_and_leave_it_alone(league):
    pytest.importorskip("pygame")
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


def test_rendering_without_a_mode_warns():
    env = soccer_v0.parallel_env(home=1, away=1)
    env.reset(seed=0)
    with pytest.warns(UserWarning, match="render_mode"):
        assert env.render() is None


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

    env = PettingZooWrapper(soccer_v0.parallel_env(home=home, away=away, infos=False))
    rollout = env.rollout(3)
    assert rollout["home", "observation"].shape == (3, home, len(env.unwrapped.match.observation_names))
    assert rollout["away", "action"].shape == (3, away, 4)
