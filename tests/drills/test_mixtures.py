"""Mixtures of scenes, and the start in the middle of play: ball and robots anywhere, memories perhaps wrong."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
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


def test_what_an_episode_begins_in_follows_from_seed_and_episode_alone() -> None:
    many = Match(home=1, away=1, matches=8, seed=5, scene=mixture(TEXT))
    one = Match(home=1, away=1, seeds=many.seeds[3:4], scene=mixture(TEXT))
    for _ in range(6):
        assert one.balls[0] == many.balls[3] and (one.robots[0] == many.robots[3]).all()
        many.reset(), one.reset()


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


def test_a_match_takes_scenes_with_shares_as_a_training_does() -> None:
    match = Match(home=2, away=1, scene=TEXT, seed=1)
    assert match.settings.scene == mixture(TEXT)
    with pytest.raises(ValueError, match="unknown scene 'kickoff', did you mean 'kick-off'"):
        Match(scene="kickoff:0.6,scattered:0.4")
    with pytest.raises(ValueError, match="scenes must be written as NAME:share,NAME:share, got 'kick-off:much'"):
        Match(scene="kick-off:much")


def test_one_scene_is_no_mixture() -> None:
    assert mixture("kick-off:0.2") is SCENES["kick-off"]


@pytest.mark.parametrize(("text", "said"), [
    ("kick-off:0.5,scatered:0.5", "'scatered', did you mean 'scattered'"),
    ("kick-off:much,scattered", "NAME:share,NAME:share, got"), ("kick-off,kick-off:2", "scenes must be different"),
    ("kick-off:0,scattered:1", "shares of a Mixture must be above 0"),
    ("kick-off:inf,scattered:1", "shares of a Mixture must be above 0"),
])  # fmt: skip
def test_wrong_mixtures_are_refused(text: str, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        mixture(text)


def test_a_mixture_needs_a_share_for_each_scene() -> None:
    with pytest.raises(ValueError, match="a share for each of its scenes, got 0"):
        Mixture("two", "", parts=(SCENES["kick-off"],))


def test_a_mixture_is_for_the_sizes_and_leagues_of_all_its_parts() -> None:
    with pytest.raises(ValueError, match="away must be 3 to 3 in scene 'dribble-past-three', got 2"):
        Match(home=1, away=2, seed=1, scene=mixture("kick-off,dribble-past-three"))
    with pytest.raises(ValueError, match="scene 'facing-wall'"):
        Match("middle-size-2006", home=1, away=1, seed=1, scene=mixture("kick-off,facing-wall"))


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


def test_in_half_of_the_episodes_robots_remember_the_ball_where_it_is_not() -> None:
    match = Match(home=1, away=1, matches=300, seed=4, scene="scattered", observe="belief")
    robots, balls, beliefs = match.robots[:, 0], match.balls, match.beliefs[:, 0]["ball"]
    sure = beliefs["confidence"] > 0.0
    x = robots["x"] + np.cos(robots["heading"]) * beliefs["x"] - np.sin(robots["heading"]) * beliefs["y"]
    y = robots["y"] + np.sin(robots["heading"]) * beliefs["x"] + np.cos(robots["heading"]) * beliefs["y"]
    off = np.hypot(x - balls["x"], y - balls["y"])[sure]
    assert 0.1 < sure.mean() < 0.6, "most look elsewhere"
    assert 0.3 < (off > 0.4).mean() < 0.7


def test_only_what_is_seen_first_is_wrong() -> None:
    misled = Match(home=1, away=1, matches=20, seed=4, scene="scattered")
    told = Match(home=1, away=1, matches=20, seed=4, scene=replace(SCENES["scattered"], shows=None))
    assert (misled.balls == told.balls).all() and (misled.robots["x"] == told.robots["x"]).all()
