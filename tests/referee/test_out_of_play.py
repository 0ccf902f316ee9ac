"""Throw-in, goal kick and corner kick: by the last touch, at the right spot, on all sides, in both halves."""

import itertools

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase
from tests.scenes.staging import LEGGED, MIDDLE, asking, place, put, put_ball, stage, stand, steps_in

LEAGUE = find_league(MIDDLE)
HALF_LENGTH, HALF_WIDTH = LEAGUE.pitch.length / 2, LEAGUE.pitch.width / 2
OVER = LEAGUE.ball.radius + 0.01  # [m] beyond a line
CASES = list(itertools.product((1, -1), (1, -1), (HOME, AWAY), (1.0, -1.0)))  # ends, sides, last touch, directions
ENDS, SIDES, TOUCHES, DIRECTIONS = (np.array(column) for column in zip(*CASES, strict=True))


def called(x, y, touches=TOUCHES, directions=DIRECTIONS, **settings) -> Match:
    """Lay the ball down outside in matches with all cases of last touch and direction; the referee has looked."""
    match = Match(MIDDLE, home=3, away=3, matches=len(touches), seed=1, **settings)
    match.matches["phase"], match.matches["restart_team"] = Phase.PLAY, NO_TEAM
    match.matches["last_touch_team"], match.matches["home_direction"] = touches, directions
    place(match, ball=(x, y))
    match.step(stand(match))
    return match


def spots(match):
    return np.stack([match.matches["restart_x"], match.matches["restart_y"]], axis=-1)


def test_over_the_touchline_it_is_a_throw_in_by_the_other_team_where_it_went_out():
    x = np.linspace(-5.0, 5.0, len(CASES))
    match = called(x, SIDES * (HALF_WIDTH + OVER))
    assert (match.events["restart"] == Phase.THROW_IN).all() and (match.events["out"] == 1).all()
    assert (match.events["restart_team"] == 1 - TOUCHES).all()
    np.testing.assert_allclose(spots(match), np.stack([x, SIDES * HALF_WIDTH], axis=-1), atol=1e-9)
    np.testing.assert_allclose(np.stack([match.balls["x"], match.balls["y"]], axis=-1), spots(match))


def test_over_the_goal_line_it_is_a_corner_off_a_defender_and_a_goal_kick_off_an_attacker():
    match = called(ENDS * (HALF_LENGTH + OVER), SIDES * 2.5)
    defenders = np.where(ENDS * DIRECTIONS > 0.0, AWAY, HOME)
    corner = defenders == TOUCHES
    assert (match.events["restart"] == np.where(corner, Phase.CORNER_KICK, Phase.GOAL_KICK)).all()
    assert (match.events["restart_team"] == np.where(corner, 1 - defenders, defenders)).all()
    rules = LEAGUE.rules
    corners = np.stack([ENDS * (HALF_LENGTH - rules.corner_offset), SIDES * (HALF_WIDTH - rules.corner_offset)], -1)
    goal_kicks = np.stack([ENDS * (HALF_LENGTH - rules.goal_kick_x), SIDES * rules.goal_kick_y], -1)
    np.testing.assert_allclose(spots(match), np.where(corner[:, None], corners, goal_kicks))


def test_near_a_corner_a_throw_in_is_taken_no_nearer_to_the_goal_line_than_a_corner_kick():
    most = HALF_LENGTH - LEAGUE.rules.corner_offset
    for x, expected in ((most - 0.01, most - 0.01), (most + 0.01, most), (HALF_LENGTH + 0.1, most)):
        match = called(ENDS * x, SIDES * (HALF_WIDTH + OVER))
        assert (match.events["restart"] == Phase.THROW_IN).all()
        np.testing.assert_allclose(spots(match), np.stack([ENDS * expected, SIDES * HALF_WIDTH], axis=-1), atol=1e-9)


@pytest.mark.parametrize(("beyond", "phase"), [(-0.001, Phase.PLAY), (0.001, Phase.THROW_IN)])
def test_the_whole_ball_must_be_over_the_touchline(beyond, phase):
    match = called(1.0, SIDES * (HALF_WIDTH + LEAGUE.ball.radius + beyond))
    assert (match.matches["phase"] == phase).all()


@pytest.mark.parametrize(("beyond", "out"), [(-0.001, 0), (0.001, 1)])
def test_the_whole_ball_must_be_over_the_goal_line(beyond, out):
    match = called(ENDS * (HALF_LENGTH + LEAGUE.ball.radius + beyond), 2.0)
    assert (match.events["out"] == out).all()


def test_a_ball_that_nobody_touched_goes_to_the_defenders():
    match = called(ENDS * (HALF_LENGTH + OVER), 2.0, touches=np.full(len(CASES), NO_TEAM))
    assert (match.events["restart"] == Phase.GOAL_KICK).all()
    assert (match.events["restart_team"] == np.where(ENDS * DIRECTIONS > 0.0, AWAY, HOME)).all()
    match = called(ENDS * 3.0, HALF_WIDTH + OVER, touches=np.full(len(CASES), NO_TEAM))
    assert (match.events["restart_team"] == np.where(ENDS * DIRECTIONS > 0.0, AWAY, HOME)).all()


def test_the_last_touch_before_it_went_out_decides_and_not_an_earlier_one():
    match = stage(MIDDLE)
    put(match, 0, 0.0, 2.0, np.pi / 2)
    put(match, 1, 0.45, 3.6, np.pi / 2)  # the ball glances off away's robot
    put_ball(match, 0.0, 2.0 + 0.18 + 0.11 + 0.005)
    match.robots["has_ball"][:, 0] = 1
    match.rebuild()
    teams = []
    for _ in range(steps_in(match, 2.0)):
        match.step(asking(match, kick=0.5))
        if match.events["touch_team"][0] != NO_TEAM:
            teams.append(match.events["touch_team"][0])
        if match.events["out"][0]:
            break
    assert match.events["restart"][0] == Phase.THROW_IN and match.events["restart_team"][0] == 1 - teams[-1]


def test_the_middle_size_robot_that_drives_the_ball_out_loses_it():
    match = stage(MIDDLE, ball=(0.0, 2.5 + 0.18 + 0.11 + 0.005), robots={0: (0.0, 2.5, np.pi / 2)})
    for _ in range(steps_in(match, 4.0)):
        match.step(asking(match, forward=0.4))
        if match.events["out"][0]:
            break
    assert match.events["restart"][0] == Phase.THROW_IN and match.events["restart_team"][0] == AWAY
    assert match.matches["last_touch_team"][0] == NO_TEAM, "a restart forgets who touched the ball"


def test_on_a_walled_field_the_ball_never_goes_out():
    match = stage(LEGGED, 60)
    rng = np.random.default_rng(0)
    angle = rng.uniform(-np.pi, np.pi, 60)
    put_ball(match, rng.uniform(-1.2, 1.2, 60), rng.uniform(-0.8, 0.8, 60), 2.0 * np.cos(angle), 2.0 * np.sin(angle))
    match.rebuild()
    for _ in range(64):
        match.step(stand(match))
        assert not match.events["out"].any()
        assert np.isin(match.events["restart"], (0, Phase.KICK_OFF)).all()
