"""Mixtures of scenes, the start in the middle of play, and a scene whose success is a function of one's own."""

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, OwnTerm, Rewards, Scene, soccer_v0
from soccer_env.replay import Recorder
from soccer_env.scenes import SCENES, Mixture, mixture
from soccer_env.types import Phase

TEXT = "kick-off:3,scattered:1"


def kicked_off(match: Match) -> np.ndarray:
    """Return which of the matches began with a kick-off."""
    return match.matches["phase"] == Phase.KICK_OFF


def test_episodes_begin_in_each_scene_as_often_as_its_share_says() -> None:
    match = Match(home=2, away=1, matches=200, seed=1, scene=mixture(TEXT))
    counted = []
    for _ in range(3):
        counted.append(kicked_off(match).mean())
        assert (match.balls["x"][kicked_off(match)] == 0.0).all()
        assert (match.balls["x"][~kicked_off(match)] != 0.0).all()
        match.reset()
    assert np.mean(counted) == pytest.approx(0.75, abs=0.06)  # 3.4 standard deviations of 600
    assert len(set(counted)) > 1, "each episode draws anew"


def test_what_an_episode_begins_in_follows_from_seed_and_episode_alone_in_a_match_as_in_a_training() -> None:
    many = Match(home=1, away=1, matches=8, seed=5, scene=mixture(TEXT))
    one = Match(home=1, away=1, seeds=many.seeds[3:4], scene=mixture(TEXT))
    for _ in range(6):
        assert one.balls[0] == many.balls[3] and (one.robots[0] == many.robots[3]).all()
        many.reset(), one.reset()
    match = Match(home=2, away=1, scene=TEXT, seed=1)
    assert match.settings.scene == mixture(TEXT)
    with pytest.raises(ValueError, match="unknown scene 'kickoff', did you mean 'kick-off'"):
        Match(scene="kickoff:0.6,scattered:0.4")
    with pytest.raises(ValueError, match="scenes must be written as NAME:share,NAME:share, got 'kick-off:much'"):
        Match(scene="kick-off:much")


def test_a_part_begins_as_it_does_alone_and_play_goes_on_from_a_drills_start() -> None:
    parts = ("scattered", "facing-wall")
    mixed = Match(home=1, away=1, matches=16, seed=2, scene=mixture(",".join(parts)), minutes=0.02)
    alone = [Match(home=1, away=1, matches=16, seed=2, scene=name) for name in parts]
    chosen = [mixed.settings.scene.of_episode(int(seed), 0).name for seed in mixed.seeds]
    assert set(chosen) == set(parts)
    for m, name in enumerate(chosen):
        assert (alone[parts.index(name)].robots[m] == mixed.robots[m]).all()
    while not mixed.terminated.any():
        mixed.step(np.zeros((16, 2, 4)))
    assert not mixed.events["drill"].any()


def test_a_mixture_is_for_the_sizes_and_leagues_of_all_its_parts_with_a_share_for_each() -> None:
    assert mixture("kick-off:0.2") is SCENES["kick-off"], "one scene is no mixture"
    for message, make in (
        ("a share for each of its scenes, got 0", lambda: Mixture("two", "", parts=(SCENES["kick-off"],))),
        ("away must be 3 to 3 in scene 'dribble-past-three', got 2", lambda: Match(
            home=1, away=2, seed=1, scene=mixture("kick-off,dribble-past-three"))),
        ("scene 'facing-wall'", lambda: Match(
            "middle-size-2006", home=1, away=1, seed=1, scene=mixture("kick-off,facing-wall"))),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=message):
            make()


@pytest.mark.parametrize(("text", "said"), [
    ("kick-off:0.5,scatered:0.5", "'scatered', did you mean 'scattered'"),
    ("kick-off:much,scattered", "NAME:share,NAME:share, got"), ("kick-off,kick-off:2", "scenes must be different"),
    ("kick-off:0,scattered:1", "shares of a Mixture must be above 0"),
    ("kick-off:inf,scattered:1", "shares of a Mixture must be above 0"),
])  # fmt: skip
def test_wrong_mixtures_are_refused(text: str, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        mixture(text)


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
def test_in_the_middle_of_play_ball_and_robots_are_anywhere(league: str) -> None:
    match = Match(league, home=3, away=3, matches=100, seed=3, scene="scattered")
    pitch, robots = match.league.pitch, match.robots
    assert (match.matches["phase"] == Phase.PLAY).all()
    field = robots["keeper"] == 0
    for axis, side in (("x", pitch.length), ("y", pitch.width)):
        for values in (match.balls[axis], robots[axis][field]):
            quarters = np.histogram(values, 4, (-side / 2, side / 2))[0] / len(values)
            assert (quarters > 0.12).all()
    assert (np.histogram(robots["heading"], 4, (-np.pi, np.pi))[0] > 0.2 * robots.size).all()
    goals = np.where(robots["team"] == 0, -1.0, 1.0) * pitch.length / 2
    assert (np.abs(robots["x"] - goals)[~field] < 0.5 + 2.0 * match.league.body.reach).all()


def test_in_half_of_the_episodes_robots_remember_the_ball_where_it_is_not_until_they_see_it() -> None:
    match = Match(home=1, away=1, matches=300, seed=4, scene="scattered", observe="belief")
    robots, balls, beliefs = match.robots[:, 0], match.balls, match.beliefs[:, 0]["ball"]
    sure = beliefs["confidence"] > 0.0
    x = robots["x"] + np.cos(robots["heading"]) * beliefs["x"] - np.sin(robots["heading"]) * beliefs["y"]
    y = robots["y"] + np.sin(robots["heading"]) * beliefs["x"] + np.cos(robots["heading"]) * beliefs["y"]
    off = np.hypot(x - balls["x"], y - balls["y"])[sure]
    assert 0.1 < sure.mean() < 0.6, "most look elsewhere"
    assert 0.3 < (off > 0.4).mean() < 0.7
    misled = Match(home=1, away=1, matches=20, seed=4, scene="scattered")
    told = Match(home=1, away=1, matches=20, seed=4, scene=replace(SCENES["scattered"], shows=None))
    assert (misled.balls == told.balls).all() and (misled.robots["x"] == told.robots["x"]).all()


def walked(match: Any) -> np.ndarray:
    """Succeed 5 cm ahead of where home stood at first, fail as far behind."""
    ahead = match.robots["x"][:, 0] - START
    return np.where(ahead > 0.05, 1, np.where(ahead < -0.05, -1, 0))


def at_start(league: Any, ball: Any, robots: Any, draw: Any) -> None:
    """Put home's robot behind the centre, far from the ball."""
    robots[0]["x"], robots[0]["y"], robots[0]["heading"] = START, 0.5, 0.0
    ball["x"], ball["y"] = 0.5, -0.5


START = -0.5
WALK = Scene("walk", "walk ahead", place=at_start, success=walked, time_limit=3.0, in_play=True)
SETTINGS: dict[str, Any] = {"scene": WALK, "episode": "drill", "home": 1, "away": 1, "opponents": "still", "seed": 1}


def test_shaping_ends_with_potential_0() -> None:
    own = OwnTerm(lambda match: match.robots["x"], kind="potential")
    sums = []
    for speed in (1.0, 0.7):
        match = Match(**SETTINGS, rewards=Rewards.only(progress=1.0, approach=1.0, extra={"own": own}))
        actions, total, discount = np.zeros((1, 2, 4)), np.zeros(len(match.term_names)), 1.0
        actions[:, 0, 0] = speed
        while not match.terminated[0]:
            match.step(actions)
            total += discount * match.terms[0, 0]
            discount *= 0.99
        assert match.rewards[0, 0] == pytest.approx(match.terms[0, 0].sum())
        sums.append(total)
    np.testing.assert_allclose(sums[0], sums[1], atol=1e-9)  # whatever the way, minus the potential of the start
    assert sums[0][-1] == pytest.approx(-START) and sums[0][match.term_names.index("approach")] != 0.0


def test_envs_tell_of_it_recordings_do_not_and_other_words_are_refused() -> None:
    env = soccer_v0.parallel_env(**{name: value for name, value in SETTINGS.items() if name != "seed"}, infos="nested")
    env.reset(seed=1)
    while env.agents:
        _, _, terminations, _, infos = env.step({"home_0": np.array([1.0, 0, 0, 0])})
    assert terminations["home_0"] and infos["home_0"]["events"]["drill"] == "success"
    with pytest.raises(ValueError, match="replays hold no code"):
        Recorder(Match(**SETTINGS))
    assert Recorder(Match(**{**SETTINGS, "episode": "match"})).stop().check() == 0
    with pytest.raises(ValueError, match="Scene.success must be one of none, home scores, .*, or a function of the"):
        Scene("a", "b", success="often")


@pytest.mark.parametrize(("returned", "message"), [
    (0.5, "success of scene 'mine' must return 1, -1 or 0 for each match, got 0.5 for 0"),
    (np.nan, "success of scene 'mine' must return numbers in [-1, 1], got nan at (0,)"),
    (2, "success of scene 'mine' must return numbers in [-1, 1], got 2.0 at (0,)"),
    (np.zeros(3), "success of scene 'mine' must return numbers of shape (2,), got shape (3,)"),
    (None, "success of scene 'mine' must return"),
])  # fmt: skip
def test_what_it_returns_wrongly_is_named(returned: Any, message: str) -> None:
    mine = Scene("mine", "wrong", success=lambda match: returned)
    match = Match(**{**SETTINGS, "scene": mine}, matches=2)
    with pytest.raises(ValueError, match=re.escape(message)):
        match.step(np.zeros((2, 2, 4)))
