"""What the PettingZoo API says of an episode: events, scores and rewards in infos, and how it ends."""

import numpy as np
import pytest

from soccer_env import Rewards, Scene, soccer_v0
from soccer_env.rewards import NAMES
from tests.scenes.staged_envs import env_about_to_score, play, put_ball, still_actions
from tests.scenes.staging import LEAGUES


@pytest.mark.parametrize("league", LEAGUES)
def test_infos_tell_of_a_goal_in_words(league):
    env = env_about_to_score(league=league, infos="nested")
    _, rewards, _, _, infos = env.step(still_actions(env))
    assert infos["home_0"]["events"]["goal"] == infos["away_1"]["events"]["goal"] == "home"
    assert (infos["home_0"]["events"]["restart"], infos["home_0"]["events"]["restart_team"]) == ("kick-off", "away")
    assert infos["home_1"]["score"] == (1, 0) and infos["away_1"]["score"] == (0, 1)
    assert infos["home_1"]["rewards"]["goal"] == 1.0 and infos["away_0"]["rewards"]["goal"] == -1.0
    assert infos["home_0"]["phase"] == "kick-off"
    assert rewards["home_0"] == pytest.approx(sum(infos["home_0"]["rewards"].values()), abs=1e-12)
    _, _, _, _, infos = env.step(still_actions(env))
    assert infos["home_0"]["events"] == {} and infos["home_0"]["rewards"]["goal"] == 0.0
    assert env.reset()[1]["home_0"] == {
        "active": True, "events": {}, "rewards": dict.fromkeys(NAMES, 0.0), "score": (0, 0), "phase": "kick-off",
        "opponent": "learner",
    }  # fmt: skip


def test_infos_tell_who_touched_the_ball():
    env = soccer_v0.parallel_env(league="legged-2001", home=1, away=1, infos="nested")
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

    env = soccer_v0.parallel_env(rewards=Rewards(progress=0.0, extra={"haste": haste}), action_repeat=3, infos="nested")
    env.reset(seed=3)
    for _, (_, rewards, *_, infos) in play(env, 20):
        for agent in env.agents:
            assert list(infos[agent]["rewards"]) == [*NAMES, "haste"]
            assert rewards[agent] == pytest.approx(sum(infos[agent]["rewards"].values()), abs=1e-12)
    assert infos["home_1"]["rewards"]["haste"] > 0.0


@pytest.mark.parametrize("after", [1, 2])
@pytest.mark.parametrize("league", LEAGUES)
def test_repeated_actions_add_up_rewards_and_events(league, after):
    rewards = Rewards(gamma=1.0)  # shaping discounts once an action; tests/rewards/test_rewards.py has that
    once = env_about_to_score(after, league=league, rewards=rewards, infos="nested")
    thrice = env_about_to_score(after, league=league, rewards=rewards, action_repeat=3, infos="nested")
    parts = [once.step(still_actions(once)) for _ in range(3)]
    observations, rewards, _, _, infos = thrice.step(still_actions(thrice))
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
    env = env_about_to_score(league=league, episode="goal", action_repeat=repeat, rewards=rewards, infos="nested")
    _, rewards, terminated, truncated, infos = env.step(still_actions(env))
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
        _, _, terminated, truncated, _ = env.step(still_actions(env))
        steps += 1
    assert steps == -(-16 // repeat) and all(truncated.values()) and not any(terminated.values())


def test_max_cycles_count_steps_and_not_control_steps():
    env = soccer_v0.parallel_env(home=1, away=1, max_cycles=6, action_repeat=5)
    env.reset(seed=0)
    assert len(list(play(env, 100))) == 6
    assert env.unwrapped.match.matches["step"][0] == 30
