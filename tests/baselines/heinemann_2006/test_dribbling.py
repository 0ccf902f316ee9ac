"""Dribbling stays inside what the guide bears, and so keeps the ball where a quicker turn loses it."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.baselines.heinemann_2006.dribbling import LEAST, dribble, grip_speed, grip_turn
from soccer_env.baselines.heinemann_2006.memory import MEMORY, SCRATCH
from soccer_env.baselines.heinemann_2006.settings import HeinemannSettings, settings_of
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.scenes import SCENES
from soccer_env.train.casting import controllers_of
from soccer_env.types import COMMAND, Phase
from tests.scenes.staging import MIDDLE

OMNI = 1
MATCHES, HOLDING, REACH = 20, 0.29, 0.287  # [m] from the robot's middle to a ball in its guide, and to its edge


@pytest.mark.parametrize("turn", [0.1, 0.3, 1.0])
def test_speed_times_turn_is_the_grip(turn: float) -> None:
    play = settings_of(HeinemannSettings(dribble_grip=0.35, dribble_turn=4.0))[OMNI]
    speed = grip_speed(play, turn)
    assert speed * turn == pytest.approx(0.35) and grip_speed(play, -turn) == speed
    assert grip_turn(play, speed) == pytest.approx(turn)
    assert grip_speed(play, 100.0) == LEAST and grip_turn(play, 0.0) == 4.0


def asked(speed: float, aside: float) -> tuple[float, float]:
    """Return speed and turn [m/s, rad/s] asked for with a ball in the guide that is to go `aside` [rad] to the left."""
    scratch, memory, command = (np.zeros(1, dtype)[0] for dtype in (SCRATCH, MEMORY, COMMAND))
    sight, k = scratch["sight"], constants_of(find_league(MIDDLE))[0]
    sight["pace"], sight["cosine"], sight["now_cosine"], sight["vx"] = 1.0, 1.0, 1.0, speed
    sight["touch"] = HOLDING
    play = settings_of(HeinemannSettings(dribble_grip=0.35))[OMNI]
    dribble(command, sight, memory, k, play, np.cos(aside), np.sin(aside))
    return float(command["forward"]) * 2.6, float(command["turn"]) * 6.0


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_mh24_at_speed_it_turns_no_faster_than_the_guide_bears_and_slows_down_to_turn(side: float) -> None:
    for speed in (0.5, 1.0, 1.5):
        slower, turn = asked(speed, side * 2.0)
        assert side * turn == pytest.approx(0.35 / speed) and slower < speed
    assert side * asked(0.0, side * 2.0)[1] == pytest.approx(4.0)
    assert asked(1.5, 0.0)[1] == 0.0


def kept(team: str) -> tuple[float, float]:
    """Return the share of two seconds for which a ball is kept that has to be turned with, and goals a match."""
    match = Match(MIDDLE, home=1, away=1, matches=MATCHES, seed=3, rules="none", senses="ideal",
                  controllers={"home": team, "away": "still"})  # fmt: skip
    match.matches["phase"] = int(Phase.PLAY)
    heading = np.linspace(-2.5, 2.5, MATCHES)
    robots, balls = match.robots, match.balls
    robots["x"][:], robots["y"][:] = (-3.0, 5.6), (0.0, 3.4)
    robots["heading"][:, 0] = heading
    balls["x"], balls["y"] = -3.0 + HOLDING * np.cos(heading), HOLDING * np.sin(heading)
    match.rebuild()
    held = np.zeros(MATCHES)
    for step in range(400):
        match.step()
        if step < 100:
            x, y = balls["x"] - robots["x"][:, 0], balls["y"] - robots["y"][:, 0]
            c, s = np.cos(robots["heading"][:, 0]), np.sin(robots["heading"][:, 0])
            held += (c * x + s * y < HOLDING + 0.06) & (np.abs(c * y - s * x) < 0.1)
    return float(held.mean()) / 100.0, float(match.matches["score"][:, 0].mean())


def test_mh24_it_turns_with_the_ball_and_keeps_it_and_scores() -> None:
    careful, goals = kept("heinemann-2006")
    hasty, _ = kept("heinemann-2006:dribble_grip=20.0")
    assert careful > 0.85 and careful > hasty + 0.03
    assert goals >= 0.95


def through_the_challenge(team: str, **more: Any) -> tuple[float, float]:
    """Return the shares of runs in which a robot gets past the obstacles of 2003 with the ball, and touches none."""
    scene, runs = SCENES["challenge-2003"], 40
    match = Match(MIDDLE, home=1, away=4, matches=runs, seed=1, scene=scene, episode="drill",
                  controllers=controllers_of(scene, team), **more)  # fmt: skip
    past, gap, robots = np.zeros(runs, bool), np.full(runs, np.inf), match.robots
    over = past.copy()
    while not over.all():
        match.step()
        past |= match.events["drill"] == 1
        over |= past | match.terminated | match.truncated
        apart = np.hypot(robots["x"][:, 1:] - robots["x"][:, :1], robots["y"][:, 1:] - robots["y"][:, :1])
        gap = np.where(over, gap, np.minimum(gap, apart.min(axis=1)))
    match.close()
    return float(past.mean()), float((gap > 2.0 * REACH).mean())


def test_mh24_it_dribbles_the_ball_round_still_obstacles_and_touches_hardly_any() -> None:
    past, clear = through_the_challenge("heinemann-2006:dribbles_round=True", senses="ideal")
    _, by_the_widest_way = through_the_challenge("heinemann-2006", senses="ideal")
    assert past > 0.7 and clear > 0.9 and clear > by_the_widest_way + 0.3


def test_mh24_so_it_does_with_a_ball_that_has_no_colour() -> None:
    sensors = {"ball_coloured": False}
    past, _ = through_the_challenge("heinemann-2006:dribbles_round=True", senses="sensors", sensors=sensors)
    assert past > 0.35
