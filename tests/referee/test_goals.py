"""A goal: the whole ball over the goal line, between the posts, for the right team in both halves."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase
from tests.scenes.staging import LEAGUES, LEGGED, MIDDLE, each_league, icy, place, put, put_ball, stage, stand, steps_in

MILLIMETRE = 0.001  # [m]


def ball_at(match, x, y):
    """Lay the ball down and let the referee look once."""
    place(match, ball=(x, y))
    match.step(stand(match))


@each_league
def test_the_whole_ball_must_cross_the_line_to_the_millimetre(name):
    league = find_league(name)
    over = league.pitch.length / 2 + league.ball.radius
    match = stage(league, 6)
    ball_at(
        match, [over - MILLIMETRE, over + MILLIMETRE, -over + MILLIMETRE, -over - MILLIMETRE, over - 0.02, 0.0], 0.0
    )
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
    put_ball(
        match, end * (pitch.length / 2 - away), aim - away * np.tan(angle), end * v * np.cos(angle), v * np.sin(angle)
    )
    match.rebuild()
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


def test_a_goal_is_between_the_posts_only():
    """A trap: a goal judged by x alone."""
    league = find_league(MIDDLE)
    over, post = league.pitch.length / 2 + league.ball.radius + 0.01, league.pitch.goal_width / 2
    match = stage(league, 4)
    ball_at(match, over, [0.0, post + 0.3, -post - 0.3, 3.5])
    assert match.events["goal"].tolist() == [HOME, NO_TEAM, NO_TEAM, NO_TEAM]
    assert match.events["out"].tolist() == [0, 1, 1, 1]


@pytest.mark.parametrize("name", LEAGUES)
def test_in_the_second_half_the_teams_have_changed_ends_and_goals_count_for_them(name):
    league = find_league(name)
    over = league.pitch.length / 2 + league.ball.radius + 0.01
    match = stage(league, 4)
    match.matches["half"] = [0, 0, 1, 1]
    match.matches["home_direction"] = [1.0, 1.0, -1.0, -1.0]
    ball_at(match, [over, -over, over, -over], 0.0)
    assert match.events["goal"].tolist() == [HOME, AWAY, AWAY, HOME]


@each_league
def test_an_own_goal_counts_for_the_opponents(name):
    league = find_league(name)
    match = stage(league)
    match.matches["last_touch_team"], match.matches["last_touch_robot"] = HOME, 0
    ball_at(match, -(league.pitch.length / 2 + league.ball.radius + 0.01), 0.0)
    assert match.events["goal"][0] == AWAY and match.events["scorer"][0] == 0


@each_league
def test_a_goal_is_counted_once(name):
    """A trap: one reward too many."""
    match = Match(name, home=1, away=1, seed=1)
    league = match.league
    match.matches["phase"] = Phase.PLAY
    place(match, ball=(league.pitch.length / 2 + league.ball.radius + 0.01, 0.0, 0.5 * league.ball.top_speed, 0.0))
    goals = 0
    for _ in range(100):
        match.step(stand(match))
        goals += (match.events["goal"] != NO_TEAM).sum()
    assert goals == 1 and match.matches["score"].tolist() == [[1, 0]]


@pytest.mark.parametrize("placement", ["instant", "drive"])
@each_league
def test_after_a_goal_the_team_that_conceded_it_kicks_off_from_the_centre(name, placement):
    match = Match(name, home=2, away=2, matches=4, seed=1, placement=placement)
    league = match.league
    over = league.pitch.length / 2 + league.ball.radius + 0.01
    match.matches["phase"] = Phase.PLAY
    match.matches["home_direction"] = [1.0, 1.0, -1.0, -1.0]
    ball_at(match, [over, -over, over, -over], 0.0)
    scored = match.events["goal"]
    assert scored.tolist() == [HOME, AWAY, AWAY, HOME]
    assert (match.events["restart"] == Phase.KICK_OFF).all()
    assert (match.events["restart_team"] == 1 - scored).all()
    assert (match.matches["restart_team"] == 1 - scored).all()
    assert match.balls[["x", "y", "vx", "vy"]].tolist() == [(0.0, 0.0, 0.0, 0.0)] * 4


@each_league
def test_a_shot_is_a_goal_and_a_shot_wide_is_none(name):
    league = find_league(name)
    match = stage(league, 2)
    x = league.pitch.length / 2 - 0.5
    put_ball(
        match, x, [0.1 * league.pitch.goal_width, 0.75 * league.pitch.goal_width], 0.6 * league.ball.top_speed, 0.0
    )
    match.rebuild()
    goals = np.zeros(2, int)
    for _ in range(steps_in(match, 1.5)):
        match.step(stand(match))
        goals += match.events["goal"] == HOME
    assert goals.tolist() == [1, 0]


def test_the_scorer_is_the_robot_that_touched_the_ball_last():
    match = stage(LEGGED, home=2, away=1)
    put(match, 1, 1.2, 0.0, 0.0)
    put_ball(match, 1.2 + match.league.body.front + match.league.ball.radius + 0.003, 0.0)
    match.robots["has_ball"][:, 1] = 1
    match.rebuild()
    actions = stand(match)
    actions[:, 1, 3] = 1.0
    for _ in range(40):
        match.step(actions)
        if match.events["goal"][0] != NO_TEAM:
            break
    assert match.events["goal"][0] == HOME and match.events["scorer"][0] == 1
