"""Drills begin as they say, for teams of every size, are judged by their success tests, and every team has a floor."""

from itertools import product

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.scenes import SCENES
from soccer_env.train.evaluate.drills import run_drill
from soccer_env.types import AWAY, HOME, MAX_TEAM
from tests.scenes.leagues import LEAGUES, MIDDLE, each_league
from tests.scenes.staging import deepest_overlaps, place, play, record_each_step, send_off, stand, steps_in

SIZES = ((1, 1), (2, 3), (5, 5), (MAX_TEAM, MAX_TEAM), (1, MAX_TEAM), (MAX_TEAM, 1))


def may_begin(name, scene, home, away):
    """Tell whether a scene is for this league and so many players."""
    try:
        SCENES[scene].check(find_league(name), home, away)
    except ValueError:
        return False
    return True


STARTS = [(*one, *size) for *one, size in product(LEAGUES, SCENES, SIZES) if may_begin(*one, *size)]


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
    drill, goal = record_each_step(match, lambda: [match.events["drill"], match.events["goal"]], 9.0).swapaxes(0, 1)
    assert (goal.max(axis=0) == HOME).all() and (drill.sum(axis=0) == -1).all() and match.terminated.all()


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
    goals = (record_each_step(match, lambda: match.events["drill"], 5.0) == -1).any(axis=0)
    assert far == (goals.mean() > 0.8) or not far  # a keeper that stands still saves hardly a far shot
    assert goals.any()


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


RUNS = 60
FLOORS: dict[str, dict[str, float]] = {  # [1] of the runs of a drill of the legged league
    "chaser": {
        "facing-wall": 0.9, "lost-ball-behind": 0.7, "ball-in-corner": 0.45, "empty-goal": 0.8,
    },
    "sacks-2001": {"lost-ball-behind": 0.6, "empty-goal": 0.6},
}  # fmt: skip
CASES = [(team, drill, floor) for team, floors in FLOORS.items() for drill, floor in floors.items()]


@pytest.mark.parametrize(("team", "drill", "floor"), CASES)
def test_a_team_does_not_fall_below_its_floor(team: str, drill: str, floor: float) -> None:
    assert run_drill("legged-2001", SCENES[drill], team, RUNS, starts="all") >= floor * RUNS
