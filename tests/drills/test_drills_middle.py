"""Drills of the middle-size league begin as they say, and are judged by what they ask."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.types import AWAY, HOME
from tests.scenes.staging import MIDDLE, stand, steps_in

SHOTS = 60


def begun(scene: str, home: int, away: int, matches: int = SHOTS) -> Match:
    return Match(MIDDLE, home=home, away=away, matches=matches, seed=4, scene=scene, episode="drill")


@pytest.mark.parametrize(("scene", "far"), [("far-post-shot", True), ("near-post-shot", False)])
def test_shots_are_kicked_at_the_post_that_they_name(scene: str, far: bool) -> None:
    match = begun(scene, 1, 2)
    ball = match.balls
    speed = np.hypot(ball["vx"], ball["vy"])
    crossing = ball["y"] + ball["vy"] / ball["vx"] * (6.0 - ball["x"])
    assert (speed >= 4.0).all() and (speed <= 10.0).all() and speed.min() < 5.0 and speed.max() > 9.0
    assert (ball["roll_x"] == 0.0).all()
    assert (np.abs(crossing) > 0.5).all() and (np.abs(crossing) < 0.85).all()
    assert ((crossing * ball["y"] < 0.0) == far).all()
    goals = np.zeros(SHOTS, bool)
    for _ in range(steps_in(match, 5.0)):
        match.step(stand(match))
        goals |= match.events["drill"] == -1
    assert far == (goals.mean() > 0.8) or not far  # a keeper that stands still saves hardly a far shot
    assert goals.any()


def test_a_ball_that_rolls_passes_the_receiver_within_a_metre() -> None:
    match = begun("receive-pass", 2, 1)
    ball, robot = match.balls, match.robots[:, 1]
    speed = np.hypot(ball["vx"], ball["vy"])
    x, y = robot["x"] - ball["x"], robot["y"] - ball["y"]
    across = np.abs(x * ball["vy"] - y * ball["vx"]) / speed
    assert (across < 1.0).all() and (x * ball["vx"] + y * ball["vy"] > 0.0).all()
    assert (speed >= 1.0).all() and (speed <= 3.0).all()


def test_mh24_in_the_challenge_the_straight_way_meets_the_obstacles() -> None:
    match = begun("challenge-2003", 1, 4)
    robots, ball = match.robots, match.balls
    assert (np.hypot(ball["x"] - robots["x"][:, 0], ball["y"] - robots["y"][:, 0]) < 0.3).all()
    off = robots["y"][:, 1:] - robots["y"][:, :1]
    assert (np.abs(off) < 0.5).all() and (off[:, 0] * off[:, 1] < 0.0).all()
    assert (np.diff(robots["x"], axis=1) > 0.9).all()
    assert set(np.unique(match.robots["team"][:, 1:])) == {AWAY}


@pytest.mark.parametrize(
    ("scene", "home", "away", "attackers"), [("three-v-one", 4, 2, 3), ("counter-attack", 3, 4, 2)]
)
def test_attacks_outnumber_the_defence_before_them(scene: str, home: int, away: int, attackers: int) -> None:
    match = begun(scene, home, away, 8)
    robots = match.robots
    own = (robots["team"] == HOME) & (robots["x"] > -1.0)
    before = (robots["team"] == AWAY) & (robots["x"] > 1.0)
    assert (own.sum(axis=1) == attackers).all() and (before.sum(axis=1) == 2).all()
    assert (robots["keeper"][before].reshape(8, 2).sum(axis=1) == 1).all()
    ball = np.hypot(match.balls["x"] - robots["x"][:, home - 1], match.balls["y"] - robots["y"][:, home - 1])
    assert (ball < 0.3).all()
