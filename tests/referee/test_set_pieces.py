"""Where robots stand at restarts whose taker has to pass."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase
from tests.scenes.staging import MIDDLE, place, stand

LEAGUE = find_league(MIDDLE)
OUT = {  # where the ball goes out, and who touched it last: home attacks +x
    "throw-in": ((1.0, 4.2), AWAY),
    "throw-in before the own goal": ((-5.0, 4.2), AWAY),
    "corner": ((6.2, 2.5), AWAY),
    "goal kick": ((-6.2, -2.5), AWAY),
}
each_case = pytest.mark.parametrize("case", OUT)


def lined_up(case, home=HOME, **settings):
    """Return a match in which a team (home: 0) has just been given a restart; it attacks +x."""
    match = Match(MIDDLE, home=5, away=5, seed=3, placement="instant", **settings)
    (x, y), last = OUT[case]
    match.matches["phase"], match.matches["restart_team"] = Phase.PLAY, NO_TEAM
    match.matches["home_direction"] = 1.0 if home == HOME else -1.0
    match.matches["last_touch_team"] = last if home == HOME else 1 - last
    place(match, ball=(x, y))
    match.step(stand(match))
    assert match.events["restart_team"][0] == home
    return match


def split(match, team):
    """Return the robots of a team and of the others, nearest to the ball first, and their distances [m]."""
    robots, ball = match.robots[0], match.balls[0]
    far = np.hypot(robots["x"] - ball["x"], robots["y"] - ball["y"])
    order = np.argsort(far)
    own = [r for r in order if robots["team"][r] == team and not robots["keeper"][r]]
    others = [r for r in order if robots["team"][r] != team and not robots["keeper"][r]]
    return robots[own], robots[others], far[own], far[others]


@each_case
@pytest.mark.parametrize("team", [HOME, AWAY])
def test_the_taker_stands_behind_the_ball_facing_a_mate_two_metres_away(case, team):
    match = lined_up(case, team)
    own, _, far, _ = split(match, team)
    taker, ball = own[0], match.balls[0]
    assert far[0] == pytest.approx(LEAGUE.body.front + LEAGUE.ball.radius + 0.06, abs=0.03)
    x, y = ball["x"] + 2.0 * np.cos(taker["heading"]), ball["y"] + 2.0 * np.sin(taker["heading"])
    assert np.hypot(own["x"] - x, own["y"] - y).min() < 0.3  # the taker's heading is off by up to 5 degrees
    assert abs(x) < 6.0 and abs(y) < 4.0


@each_case
@pytest.mark.parametrize("team", [HOME, AWAY])
def test_opponents_keep_off_and_stand_in_the_way_to_their_goal_outside_their_penalty_area(case, team):
    match = lined_up(case, team)
    _, others, _, far = split(match, team)
    assert (far >= LEAGUE.rules.restart_distance).all()
    ball = match.balls[0]
    to_goal = np.array([6.0 - ball["x"], -ball["y"]]) / np.hypot(6.0 - ball["x"], ball["y"])
    along = (others["x"] - ball["x"]) * to_goal[0] + (others["y"] - ball["y"]) * to_goal[1]
    across = (others["x"] - ball["x"]) * to_goal[1] - (others["y"] - ball["y"]) * to_goal[0]
    assert ((along > 1.0) & (along < 1.6) & (abs(across) < 0.2)).any()
    inside = (others["x"] > 4.5) & (abs(others["y"]) < 2.5)
    assert inside.sum() <= 1


def test_in_the_simple_rules_the_taker_faces_the_goal():
    match = lined_up("throw-in", rules="simple")
    taker = split(match, HOME)[0][0]
    assert np.cos(taker["heading"] - np.arctan2(-4.0, 5.0)) > 0.99
