"""Opponents that have collided and do not come free are pulled apart, in the legged league."""

from dataclasses import replace

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.leagues.rules import NEVER
from tests.scenes.staging import LEGGED, MIDDLE, asking, deepest_overlaps, put, put_ball, stage, stand, steps_in
from tests.scenes.symmetry import Records, assert_same, mirrored, mirrored_actions

PAWS = find_league(LEGGED).body
NOSES = 2.0 * (PAWS.tip_x + PAWS.tip_radius) + 0.002  # [m] between the centres of two robots whose paws touch


def pushing(league=LEGGED, matches=1, x=0.3, y=0.4, contact_time=15.0):
    """Return matches in which two opponents push against each other, away from the ball, and their actions."""
    found = find_league(league)
    found = replace(found, rules=replace(found.rules, contact_time=contact_time, stuck_time=NEVER))
    match = stage(found, matches)
    put_ball(match, -1.2, -0.8)
    put(match, 0, x, y, 0.0)
    put(match, 1, np.asarray(x) + NOSES, y, np.pi)
    match.rebuild()
    return match, asking(match, [0, 1], forward=1.0)


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
    x = match.robots["x"].mean()
    found = separations(match, actions, 17.0)
    assert len(found) == 1 and 14.5 < found[0] / match.league.control_rate < 16.5
    match, actions = pushing()
    separations(match, actions, found[0] / match.league.control_rate)
    match.step(actions)
    assert match.events["separated"][0] == 1 and (match.robots["placed"][0] == 1).all()
    robots, rules = match.robots[0], match.league.rules
    apart = np.hypot(np.ptp(robots["x"]), np.ptp(robots["y"])) - match.league.body.reach
    assert rules.separation - 0.01 < apart < rules.separation + 0.1
    assert abs(robots["x"].mean() - x) < 0.1 and (match.balls["x"][0], match.balls["y"][0]) == (-1.2, -0.8)
    assert (robots["locked"] == 0.0).all() and (robots["vx"] == 0.0).all() and match.matches["phase"][0] == 0


def test_ms55_with_an_infinite_time_they_are_left_alone():
    match, actions = pushing(contact_time=NEVER)
    assert separations(match, actions, 30.0) == []


def test_robots_that_part_in_time_are_left_alone():
    match, actions = pushing()
    assert separations(match, actions, 12.0) == []
    assert separations(match, -actions, 15.0) == []
    assert (match.robots["locked"] == 0.0).all()


def test_team_mates_are_left_alone():
    match, actions = pushing()
    match.robots["team"][:, 1] = 0
    assert separations(match, actions, 20.0) == []


def test_at_a_board_the_other_one_is_moved_farther_and_nobody_stands_in_anybody():
    match, actions = pushing(matches=3, x=np.array([1.05, -1.3, 0.0]), y=np.array([0.5, -0.8, 0.83]))
    put_ball(match, match.robots["x"][:, 0] - 0.25, match.robots["y"][:, 0])
    match.rebuild()
    match.robots["locked"] = 14.9
    assert separations(match, actions, 0.5)
    assert max(deepest_overlaps(match).values()) < 0.002
    apart = np.hypot(np.ptp(match.robots["x"], axis=1), np.ptp(match.robots["y"], axis=1))
    assert (apart > match.league.rules.separation).all()
    assert (abs(match.robots["x"]) < match.league.pitch.length / 2).all()
    assert (abs(match.robots["y"]) < match.league.pitch.width / 2).all()


def test_a_mirrored_pair_is_pulled_apart_the_same_way():
    (match, actions), (other, _) = pushing(), pushing()
    match.robots["locked"] = 15.0
    mirrored(Records.of(match)).put_into(other)
    match.rebuild()
    match.step(actions)
    other.step(mirrored_actions(actions))
    assert match.events["separated"][0] == other.events["separated"][0] == 1
    assert_same(mirrored(Records.of(match)).robots, other.robots, 1e-9)


def test_the_middle_size_league_has_no_such_rule():
    assert find_league(MIDDLE).rules.contact_time == NEVER
    assert find_league(LEGGED).rules.contact_time == 15.0


def test_a_contact_time_must_be_above_zero():
    rules = find_league(LEGGED).rules
    with pytest.raises(ValueError, match=r"Rules\.contact_time must be a number above 0, got 0"):
        Match(rules=replace(rules, contact_time=0.0))
    assert stand(Match(rules=replace(rules, contact_time=3), seed=1)).shape == (1, 6, 4)
