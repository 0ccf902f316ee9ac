"""A goal: the whole ball over the goal line, between the posts, in both halves; throw-in, goal kick and corner kick."""

import itertools

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase
from tests.scenes.leagues import LEGGED, MIDDLE, each_league, icy
from tests.scenes.staging import place, record_each_step, robot_actions, stage, stand, steps_in


def ball_at(match, x, y):
    """Lay the ball down and let the referee look once."""
    place(match, ball=(x, y))
    match.step(stand(match))


@each_league
def test_the_whole_ball_must_cross_the_line_to_the_millimetre(name):
    league = find_league(name)
    over, mm = league.pitch.length / 2 + league.ball.radius, 0.001  # [m]
    match = stage(league, 6)
    ball_at(match, [over - mm, over + mm, -over + mm, -over - mm, over - 0.02, 0.0], 0.0)
    assert match.events["goal"].tolist() == [NO_TEAM, HOME, NO_TEAM, AWAY, NO_TEAM, NO_TEAM]
    assert match.matches["score"].tolist() == [[0, 0], [1, 0], [0, 0], [0, 1], [0, 0], [0, 0]]


@each_league
def test_a_rolling_ball_counts_in_the_step_in_which_it_is_over_and_from_every_angle(name):
    league = icy(name)
    pitch, r = league.pitch, league.ball.radius
    matches, top = 200, league.ball.top_speed
    rng = np.random.default_rng(1)
    match = stage(league, matches)
    end, aim = rng.choice([-1.0, 1.0], matches), rng.uniform(-0.75, 0.75, matches) * (pitch.goal_width / 2 - r)
    angle, v = rng.uniform(-1.0, 1.0, matches), rng.uniform(0.05, 1.0, matches) * top
    away = rng.uniform(0.5, 2.0, matches) * v * league.dt + 1.2 * r  # [m] before the line
    x, y = end * (pitch.length / 2 - away), aim - away * np.tan(angle)
    place(match, ball=(x, y, end * v * np.cos(angle), v * np.sin(angle)))
    scored = np.full(matches, NO_TEAM)
    for _ in range(400):
        match.step(stand(match))
        over = abs(match.events["ball_x"]) > pitch.length / 2 + r
        between = abs(match.events["ball_y"]) < pitch.goal_width / 2
        goal = match.events["goal"] != NO_TEAM
        assert (goal == (over & between)).all()
        scored = np.where(goal, match.events["goal"], scored)
        if (scored != NO_TEAM).all():
            break
    assert (scored == np.where(end > 0.0, HOME, AWAY)).all()


def test_a_goal_is_between_the_posts_only_and_its_scorer_the_robot_that_touched_the_ball_last():
    league = find_league(MIDDLE)
    over, post = league.pitch.length / 2 + league.ball.radius + 0.01, league.pitch.goal_width / 2
    match = stage(league, 4)
    ball_at(match, over, [0.0, post + 0.3, -post - 0.3, 3.5])
    assert match.events["goal"].tolist() == [HOME, NO_TEAM, NO_TEAM, NO_TEAM]
    assert match.events["out"].tolist() == [0, 1, 1, 1]
    match = stage(LEGGED, home=2, away=1, robots={1: (1.2, 0.0, 0.0)})
    match.robots["has_ball"][:, 1] = 1
    place(match, ball=(1.2 + match.league.body.front + match.league.ball.radius + 0.003, 0.0))
    for _ in range(40):
        match.step(robot_actions(match, 1, kick=1.0))
        if match.events["goal"][0] != NO_TEAM:
            break
    assert match.events["goal"][0] == HOME and match.events["scorer"][0] == 1


@each_league
def test_an_own_goal_counts_for_the_opponents_and_a_shot_is_a_goal_and_a_shot_wide_is_none(name):
    league = find_league(name)
    match = stage(league)
    match.matches["last_touch_team"], match.matches["last_touch_robot"] = HOME, 0
    ball_at(match, -(league.pitch.length / 2 + league.ball.radius + 0.01), 0.0)
    assert match.events["goal"][0] == AWAY and match.events["scorer"][0] == 0
    league = find_league(name)
    aside = np.array([0.1, 0.75]) * league.pitch.goal_width
    match = stage(league, 2, ball=(league.pitch.length / 2 - 0.5, aside, 0.6 * league.ball.top_speed))
    assert (record_each_step(match, lambda: match.events["goal"], 1.5) == HOME).sum(axis=0).tolist() == [1, 0]


@each_league
def test_a_goal_is_counted_once(name):
    match = Match(name, home=1, away=1, seed=1)
    pitch, ball = match.league.pitch, match.league.ball
    match.matches["phase"] = Phase.PLAY
    place(match, ball=(pitch.length / 2 + ball.radius + 0.01, 0.0, 0.5 * ball.top_speed, 0.0))
    goals = record_each_step(match, lambda: match.events["goal"], steps=100)
    assert (goals != NO_TEAM).sum() == 1 and match.matches["score"].tolist() == [[1, 0]]


@pytest.mark.parametrize("placement", ["instant", "drive"])
@each_league
def test_goals_count_in_both_halves_and_the_team_that_conceded_kicks_off_from_the_centre(name, placement):
    match = Match(name, home=2, away=2, matches=4, seed=1, placement=placement)
    over = match.league.pitch.length / 2 + match.league.ball.radius + 0.01
    match.matches["phase"], match.matches["half"] = Phase.PLAY, [0, 0, 1, 1]
    match.matches["home_direction"] = [1.0, 1.0, -1.0, -1.0]
    ball_at(match, [over, -over, over, -over], 0.0)
    scored = match.events["goal"]
    assert scored.tolist() == [HOME, AWAY, AWAY, HOME] and (match.events["restart"] == Phase.KICK_OFF).all()
    assert (match.events["restart_team"] == 1 - scored).all() and (match.matches["restart_team"] == 1 - scored).all()
    assert match.balls[["x", "y", "vx", "vy"]].tolist() == [(0.0, 0.0, 0.0, 0.0)] * 4


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


def test_over_the_touchline_it_is_a_throw_in_by_the_other_team_where_it_went_out_no_nearer_than_a_corner():
    most = HALF_LENGTH - LEAGUE.rules.corner_offset
    for x, expected in ((most - 0.01, most - 0.01), (most + 0.01, most), (HALF_LENGTH + 0.1, most)):
        match = called(ENDS * x, SIDES * (HALF_WIDTH + OVER))
        assert (match.events["restart"] == Phase.THROW_IN).all()
        np.testing.assert_allclose(spots(match), np.stack([ENDS * expected, SIDES * HALF_WIDTH], axis=-1), atol=1e-9)
    x = np.linspace(-5.0, 5.0, len(CASES))
    match = called(x, SIDES * (HALF_WIDTH + OVER))
    assert (match.events["restart"] == Phase.THROW_IN).all() and (match.events["out"] == 1).all()
    assert (match.events["restart_team"] == 1 - TOUCHES).all()
    np.testing.assert_allclose(spots(match), np.stack([x, SIDES * HALF_WIDTH], axis=-1), atol=1e-9)
    np.testing.assert_allclose(np.stack([match.balls["x"], match.balls["y"]], axis=-1), spots(match))


@pytest.mark.parametrize(("beyond", "out"), [(-0.001, False), (0.001, True)])
def test_the_whole_ball_must_be_over_the_touchline_or_the_goal_line(beyond, out):
    match = called(1.0, SIDES * (HALF_WIDTH + LEAGUE.ball.radius + beyond))
    assert (match.matches["phase"] == (Phase.THROW_IN if out else Phase.PLAY)).all()
    assert (called(ENDS * (HALF_LENGTH + LEAGUE.ball.radius + beyond), 2.0).events["out"] == out).all()


@pytest.mark.parametrize(("x", "y"), [(HALF_LENGTH + OVER, 2.0), (3.0, HALF_WIDTH + OVER)])
def test_a_ball_that_nobody_touched_goes_to_the_defenders(x, y):
    match = called(ENDS * x, y, touches=np.full(len(CASES), NO_TEAM))
    assert (match.events["restart_team"] == np.where(ENDS * DIRECTIONS > 0.0, AWAY, HOME)).all()
    assert (match.events["restart"] == (Phase.GOAL_KICK if x > HALF_LENGTH else Phase.THROW_IN)).all()


def test_the_last_touch_before_it_went_out_decides_and_a_robot_that_drives_the_ball_out_loses_it():
    match = stage(MIDDLE, robots={0: (0.0, 2.0, np.pi / 2), 1: (0.45, 3.6, np.pi / 2)})
    match.robots["has_ball"][:, 0] = 1
    place(match, ball=(0.0, 2.0 + 0.18 + 0.11 + 0.005))  # it glances off away's robot
    teams = []
    for _ in range(steps_in(match, 2.0)):
        match.step(robot_actions(match, kick=0.5))
        if match.events["touch_team"][0] != NO_TEAM:
            teams.append(match.events["touch_team"][0])
        if match.events["out"][0]:
            break
    assert match.events["restart"][0] == Phase.THROW_IN and match.events["restart_team"][0] == 1 - teams[-1]
    match = stage(MIDDLE, ball=(0.0, 2.5 + 0.18 + 0.11 + 0.005), robots={0: (0.0, 2.5, np.pi / 2)})
    for _ in range(steps_in(match, 4.0)):
        match.step(robot_actions(match, forward=0.4))
        if match.events["out"][0]:
            break
    assert match.events["restart"][0] == Phase.THROW_IN and match.events["restart_team"][0] == AWAY
    assert match.matches["last_touch_team"][0] == NO_TEAM, "a restart forgets who touched the ball"
