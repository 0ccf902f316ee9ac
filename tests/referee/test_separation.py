"""Robots that have collided and do not come free are pulled apart, in the legged league, and neither side gains."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.leagues.rules import NEVER, simple_rules
from soccer_env.types import MAX_TEAM
from tests.referee.test_dropped_ball import crowd
from tests.scenes.leagues import LEGGED, MIDDLE
from tests.scenes.staging import (
    deepest_overlaps,
    distance,
    play,
    put,
    put_ball,
    robot_actions,
    stage,
    stand,
    steps_in,
)
from tests.scenes.symmetry import Records, assert_same, mirrored, mirrored_actions

PAWS = find_league(LEGGED).body
NOSES = 2.0 * (PAWS.tip_x + PAWS.tip_radius) + 0.002  # [m] between the centres of two robots whose paws touch


def pushing(league=LEGGED, matches=1, x=0.3, y=0.4, contact_time=15.0):
    """Return matches in which two opponents push against each other, away from the ball, and their actions."""
    found = find_league(league)
    found = replace(found, rules=replace(simple_rules(found.rules), contact_time=contact_time, dropped_ball=False))
    match = stage(found, matches, ball=(-1.2, -0.8), robots={0: (x, y, 0.0), 1: (np.asarray(x) + NOSES, y, np.pi)})
    return match, robot_actions(match, [0, 1], forward=1.0)


def separations(match, actions, seconds):
    """Return the steps at which somebody was pulled apart."""
    found = []
    for step in range(steps_in(match, seconds)):
        match.step(actions)
        if match.events["separated"].any():
            found.append(step)
    return found


def test_ms55_robots_that_push_against_each_other_are_pulled_apart_after_the_set_time():
    match, actions = pushing()
    found = separations(match, actions, 17.0)
    assert len(found) == 1 and 14.5 < found[0] / match.league.control_rate < 16.5
    match, actions = pushing()
    separations(match, actions, found[0] / match.league.control_rate)
    before = match.robots[0].copy()
    match.step(actions)
    assert match.events["separated"][0] == 1 and match.robots["placed"][0].tolist() == [0, 1]
    robots, rules = match.robots[0], match.league.rules
    apart = np.hypot(np.ptp(robots["x"]), np.ptp(robots["y"])) - match.league.body.reach
    assert rules.separation - 0.01 < apart < rules.separation + 0.03
    assert abs(robots["x"][0] - before["x"][0]) < 0.01, "the defender was moved"
    assert (match.balls["x"][0], match.balls["y"][0]) == (-1.2, -0.8) and match.matches["phase"][0] == 0
    assert (robots["locked"] == 0.0).all() and robots["vx"][1] == 0.0


def overdue(x, y, heading, ball, home=2, away=2, matches=1, **records):
    """Return matches whose robots stand in contact and have done so for too long, and a step of them."""
    match = stage(LEGGED, matches, home=home, away=away)
    for r, pose in enumerate(zip(x, y, heading, strict=True)):
        if pose[0] is not None:
            put(match, r, *pose)
    put_ball(match, *ball)
    match.robots["locked"] = 16.0
    for name, value in records.items():
        match.matches[name] = value
    match.rebuild()
    before = match.robots.copy()
    match.step(stand(match))
    return match, distance(match.robots, before["x"], before["y"])


NOSE = NOSES / 2


@pytest.mark.parametrize("direction", [1.0, -1.0])
@pytest.mark.parametrize("half", [1.0, -1.0])
def test_the_one_that_attacks_the_goal_of_the_balls_half_is_moved_back(half, direction):
    x = 0.2 * half
    match, way = overdue(
        (None, x - NOSE, None, x + NOSE),
        (0, 0.3, 0, 0.3),
        (0, 0.0, 0, np.pi),
        (0.5 * half, -0.4),
        home_direction=direction,
    )
    attacker, defender = (1, 3) if half * direction > 0.0 else (3, 1)
    assert match.events["separated"][0] == 1
    assert way[0, defender] < 0.01 and 0.3 < way[0, attacker] <= match.league.rules.separation + 0.3


def test_the_attacker_comes_no_nearer_to_ball_or_goal_whoever_has_the_ball_and_bystanders_are_not_touched():
    held = PAWS.front + find_league(LEGGED).ball.radius + 0.001  # [m] of a ball between the paws of both
    match, way = overdue((None, 0.9, None, 0.9 + 2.0 * held), (0, 0.2, 0, 0.2), (0, 0.0, 0, np.pi), (0.9 + held, 0.2))
    robot = match.robots[0, 1]
    assert way[0, 3] < 0.01 and robot["x"] < 0.7
    assert np.hypot(robot["x"] - 0.9 - held, robot["y"] - 0.2) > 0.3
    match, way = overdue((None, 0.8, None, 0.8 - NOSES), (0, 0.2, 0, 0.2), (0, np.pi, 0, 0.0), (1.2, 0.2))
    robot = match.robots[0, 1]
    goal = match.league.pitch.length / 2
    assert way[0, 3] < 0.01 and 0.3 < way[0, 1] <= match.league.rules.separation + 0.3
    assert np.hypot(goal - robot["x"], robot["y"]) >= np.hypot(goal - 0.8, 0.2) - 1e-6
    match, way = overdue(
        (0.5 + NOSE, 0.2 - NOSE, None, 0.2 + NOSE), (0.5, 0.3, 0, 0.3), (0, 0.0, 0, np.pi), (0.5, -0.4)
    )
    assert match.events["separated"][0] == 1 and way[0, 0] < 0.01


@pytest.mark.parametrize(("keeper_x", "moved"), [(-1.2, 3), (-0.9, 1)])
def test_a_goalkeeper_in_its_own_area_is_never_moved(keeper_x, moved):
    """Not even where it is the attacker of the two: the ball lies before the other goal. Out of its area it may be."""
    match, way = overdue((keeper_x, None, None, keeper_x + NOSES), (0.2, 0, 0, 0.2), (0, 0, 0, np.pi), (1.0, 0.0))
    assert match.robots["keeper"][0, 0] == 1 and match.events["separated"][0] == 1
    rows = {3: (3, 0), 1: (0, 3)}[moved]
    assert way[0, rows[0]] > 0.3 and way[0, rows[1]] < 0.01


@pytest.mark.slow
@pytest.mark.parametrize("size", [3, MAX_TEAM])
@pytest.mark.parametrize("place", ["board", "corner", "goal"])
def test_in_a_crowd_nobody_is_put_into_anybody_or_off_the_pitch_and_no_keeper_is_moved(size, place):
    match = stage(LEGGED, 24 if size <= 5 else 12, home=size, away=size)
    crowd(match, place, np.random.default_rng(20 + size), spread=1.5, pairs=True)
    match.robots["locked"] = 16.0
    match.rebuild()
    before, balls = match.robots.copy(), match.balls.copy()
    match.step(stand(match))
    assert match.events["separated"].mean() > 0.3
    way, pitch = distance(match.robots, before["x"], before["y"]), match.league.pitch
    attack = np.where(before["team"] == 0, 1.0, -1.0)
    deep = attack * before["x"] < -pitch.length / 2 + pitch.penalty_depth
    at_home = deep & (abs(before["y"]) < pitch.penalty_width / 2) & (before["keeper"] == 1)
    assert way[at_home].max(initial=0.0) < 0.02
    assert way.max() <= match.league.rules.separation + (0.3 if size <= 3 else 0.4), "the ramps leave crowds less room"
    moved = way > 0.02
    ball = np.hypot(match.robots["x"] - balls["x"][:, None], match.robots["y"] - balls["y"][:, None])
    assert (ball[moved] > match.league.body.reach + match.league.ball.radius).all()
    assert deepest_overlaps(match)["robot robot"] < 0.003 and deepest_overlaps(match)["robot wall"] < 0.003


def test_ms55_with_an_infinite_time_they_are_left_alone():
    match, actions = pushing(contact_time=NEVER)
    assert separations(match, actions, 30.0) == []
    assert find_league(MIDDLE).rules.contact_time == NEVER and find_league(LEGGED).rules.contact_time == 15.0
    with pytest.raises(ValueError, match=r"Rules\.contact_time must be a number above 0, got 0"):
        Match(rules=replace(find_league(LEGGED).rules, contact_time=0.0))


def test_robots_that_part_in_time_and_team_mates_are_left_alone():
    match, actions = pushing()
    assert separations(match, actions, 12.0) == separations(match, -actions, 15.0) == []
    assert (match.robots["locked"] == 0.0).all()
    match, actions = pushing()
    match.robots["team"][:, 1] = 0
    assert separations(match, actions, 20.0) == []


def test_team_mates_that_hold_each_other_by_the_legs_are_set_free_and_the_farther_from_the_ball_goes():
    match = stage(LEGGED, 1, home=2, away=1, ball=(0.5, 0.0), robots={0: (0.0, 0.0), 1: (0.0, 0.17)})
    match.robots["locked"][:, :2] = 16.0
    match.robots["caught_by"][0, 1] = 1
    match.robots["gait_phase"] = 1  # legs are looked at anew as a gait step begins
    match.rebuild()
    before = match.robots.copy()
    match.step(stand(match))
    way = distance(match.robots, before["x"], before["y"])[0]
    assert match.events["separated"][0] == 1
    assert way[0] < 0.01 and 0.05 < way[1] < 0.25
    assert (match.robots["locked"][0, :2] == 0.0).all()


def test_time_in_contact_counts_for_a_robot_that_stands_too_and_a_mirrored_pair_is_parted_alike():
    """A trap of searchers: the one stands for ever, the other cannot leave."""
    match, actions = pushing()
    actions[:, 0] = 0.0
    play(match, actions=actions, steps=3)
    assert (match.robots["locked"] > 0.0).all()
    (match, actions), (other, _) = pushing(), pushing()
    match.robots["locked"] = 15.0
    mirrored(Records.of(match)).put_into(other)
    match.rebuild()
    match.step(actions)
    other.step(mirrored_actions(actions))
    assert match.events["separated"][0] == other.events["separated"][0] == 1
    assert_same(mirrored(Records.of(match)).robots, other.robots, 1e-9)
