"""Drills begin as they say, for teams of every size, and are judged by their success tests."""

from itertools import product

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.scenes import SCENES
from soccer_env.types import AWAY, HOME, MAX_TEAM, NO_TEAM
from tests.scenes.staging import LEAGUES, deepest_overlaps, each_league, place, play, send_off, stand, steps_in

SIZES = ((1, 1), (2, 3), (5, 5), (MAX_TEAM, MAX_TEAM), (1, MAX_TEAM), (MAX_TEAM, 1))


def may_begin(name, scene, home, away):
    """Tell whether a scene is for this league and so many players."""
    try:
        SCENES[scene].check(find_league(name), home, away)
    except ValueError:
        return False
    return True


STARTS = [
    (name, scene, home, away)
    for name, scene, (home, away) in product(LEAGUES, SCENES, SIZES)
    if may_begin(name, scene, home, away)
]


@pytest.mark.parametrize(("name", "scene", "home", "away"), STARTS)
def test_every_scene_begins_with_everybody_on_the_pitch_and_nobody_in_anybody(name, scene, home, away):
    match = Match(name, home=home, away=away, matches=3, seed=3, scene=scene)
    pitch = match.league.pitch
    assert max(deepest_overlaps(match).values()) < 0.001
    for records in (match.robots, match.balls):
        assert (abs(records["x"]) < pitch.length / 2).all() and (abs(records["y"]) < pitch.width / 2).all()


@each_league
def test_a_shot_that_nobody_saves_is_a_goal(name):
    match = Match(name, home=1, away=1, matches=50, seed=4, scene="shot-at-keeper", episode="drill")
    send_off(match, [1])
    match.rebuild()
    drill, goal = np.zeros(50, int), np.full(50, NO_TEAM)
    for _ in range(steps_in(match, 9.0)):
        match.step(stand(match))
        drill += match.events["drill"]
        goal = np.maximum(goal, match.events["goal"])
    assert (goal == HOME).all() and (drill == -1).all() and match.terminated.all()


@each_league
def test_a_shot_that_stops_is_saved(name):
    match = Match(name, home=1, away=1, matches=3, seed=4, scene="shot-at-keeper", episode="drill")
    place(match, ball=(0.5, [0.0, 0.1, -0.2], 0.1, 0.0))
    match.step(stand(match))
    assert (match.events["drill"] == 1).all() and match.terminated.all()


@each_league
def test_only_a_goal_by_home_empties_the_goal(name):
    match = Match(name, home=1, away=1, matches=2, seed=4, scene="empty-goal", episode="drill")
    over = match.league.pitch.length / 2 + match.league.ball.radius + 0.01
    place(match, ball=([over, -over], 0.0))
    match.step(stand(match))
    assert match.events["goal"].tolist() == [HOME, AWAY] and match.events["drill"].tolist() == [1, -1]
    assert match.terminated.all()


@each_league
def test_a_drill_without_a_result_is_cut_off_and_not_lost(name):
    """A trap: time limits learned as failures."""
    rules = "league:global_stuck=False"
    match = Match(name, home=1, away=1, seed=4, scene="empty-goal", episode="drill", rules=rules)
    limit = SCENES["empty-goal"].time_limit
    play(match, steps=steps_in(match, limit) - 1)
    assert not match.terminated[0] and not match.truncated[0]
    match.step(stand(match))
    assert match.truncated[0] and not match.terminated[0] and match.events["drill"][0] == 0


def test_a_stuck_game_ends_a_drill_instead_of_staging_it_elsewhere():
    """It went on from a kick-off: the ball on the centre spot, the robot far from the goal that it was put before."""
    rules = "league:global_stuck_time=3,stuck_time=2"
    match = Match(home=1, away=1, seed=4, scene="empty-goal", episode="drill", rules=rules)
    ball = match.balls[["x", "y"]].copy()
    dropped = 0
    while not (match.terminated | match.truncated).any():
        match.step(stand(match))
        dropped += int(match.events["stuck"][0] == 1 and not match.terminated[0])
        assert match.terminated[0] or (match.balls[["x", "y"]] == ball).all()
    assert match.terminated[0] and match.events["drill"][0] == -1 and dropped >= 1
