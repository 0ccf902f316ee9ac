"""Where robots stand at restarts whose taker has to pass; and penalty kicks after a drawn match."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.match.staging import put_ball
from soccer_env.referee.shoot_out import is_decided
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase
from tests.scenes.staging import MIDDLE, place, play, record_each_step, stand

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


def drawn(rules="league:shoot_out=True", **settings) -> Match:
    """Return a match at its final whistle, 0 to 0."""
    match = Match(MIDDLE, home=3, away=3, seed=1, minutes=1.0, rules=rules, placement="instant", **settings)
    match.matches["half"], match.matches["clock"] = 1, 30.0
    match.step(stand(match))
    return match


def kick(match: Match, scored: bool) -> None:
    """Let the kick that goes on end: in the goal, or beside it."""
    end = np.sign(match.matches["restart_x"][0])
    put_ball(match, end * 6.12, 0.0 if scored else 2.0)
    match.rebuild()
    match.step(stand(match))


def test_a_drawn_match_goes_on_with_a_penalty_kick_by_who_kicked_off_first_and_the_others_keep_off():
    match = drawn()
    first = int(match.matches["kick_off_team"][0])
    assert match.matches["phase"][0] == Phase.PENALTY_KICK and not match.terminated[0]
    assert match.matches["restart_team"][0] == first and match.matches["shoot_out"][0] == 1
    end = np.sign(match.matches["restart_x"][0])
    assert (end * match.balls["x"][0], match.balls["y"][0]) == (4.0, 0.0)  # 2 m from the goal line
    assert end == (1.0 if first == HOME else -1.0) * match.matches["home_direction"][0]
    match = drawn()
    end = np.sign(match.matches["restart_x"][0])
    near = match.robots[0][end * match.robots["x"][0] > 0.0]
    first = match.matches["kick_off_team"][0]
    assert sorted(near["team"].tolist()) == [HOME, AWAY]
    keeper = near[near["team"] != first][0]
    assert keeper["keeper"] == 1 and end * keeper["x"] > 5.5
    match = drawn()
    places, end = match.robots["x"][0].copy(), np.sign(match.matches["restart_x"][0])
    actions = stand(match)
    actions[:, :, 1] = 1.0  # aside: the taker leaves the ball
    play(match, actions=actions, steps=100)
    looks_on, gone = end * places < 0.0, abs(match.robots["y"][0]) > 3.0
    moved = abs(match.robots["x"][0] - places)
    assert looks_on.sum() == 4 and moved[looks_on].max() < 0.2 and gone[~looks_on].any()


def test_goals_of_it_count_apart_and_teams_take_turns():
    match = drawn()
    teams = []
    for scored in (True, False, True, True):
        teams.append(int(match.matches["restart_team"][0]))
        kick(match, scored)
        assert match.events["penalty"][0] == (1 if scored else 2)
    first = teams[0]
    assert teams == [first, 1 - first, first, 1 - first]
    assert match.matches["score"][0].tolist() == [0, 0]
    assert match.matches["shoot_out_score"][0][first] == 2 and match.matches["shoot_out_score"][0][1 - first] == 1


def test_it_ends_when_one_team_cannot_be_caught_and_who_waits_ten_seconds_or_hits_the_own_goal_misses():
    match = drawn()
    for scored in (True, False, True, False, True, False):
        assert not match.terminated[0]
        kick(match, scored)
    assert match.terminated[0] and match.events["final_whistle"][0] == 1
    assert match.matches["phase"][0] == Phase.OVER and match.matches["restart_team"][0] == -1
    match = drawn()
    assert record_each_step(match, lambda: match.events["penalty"][0], steps=501).tolist().index(2) == 499
    match = drawn()
    put_ball(match, -6.12 * np.sign(match.matches["restart_x"][0]), 0.0)
    match.rebuild()
    match.step(stand(match))
    assert match.events["penalty"][0] == 2 and match.matches["shoot_out_score"][0].tolist() == [0, 0]


@pytest.mark.parametrize(("taken", "first", "second", "over"), [
    (6, 3, 0, True),  # 3 to 0 with two left
    (6, 2, 0, False), (7, 3, 0, True), (8, 3, 3, False), (9, 4, 2, True), (9, 4, 3, False), (9, 3, 4, True),
    (10, 3, 3, False), (10, 4, 3, True),
    (11, 4, 3, False),  # in single pairs both kick
    (12, 4, 3, True),
    (20, 5, 5, True),  # a draw in the end
])  # fmt: skip
def test_when_it_is_decided(taken, first, second, over):
    match = drawn()
    record, k = match.matches[0], constants_of(match.league)[0]
    record["shoot_out"] = taken
    record["shoot_out_score"][record["kick_off_team"]] = first
    record["shoot_out_score"][1 - record["kick_off_team"]] = second
    assert bool(is_decided(record, k)) == over


@pytest.mark.parametrize(("speed", "result"), [(0.0, 2), (0.057, 2), (0.059, 0)])  # [m/s], of which a step takes 8 mm/s
def test_a_ball_that_comes_to_rest_is_missed(speed, result):
    match = drawn()
    end = np.sign(match.matches["restart_x"][0])
    put_ball(match, end * 4.5, 0.0, 0.0, speed)
    match.rebuild()
    match.step(stand(match))
    assert match.matches["phase"][0] == (Phase.PENALTY_KICK if result else Phase.PLAY)
    assert match.events["penalty"][0] == result


@pytest.mark.parametrize(("steps", "result"), [(2, 1), (1, 2)])
def test_a_goal_counts_until_its_time_is_up(steps, result):
    match = drawn()
    match.matches["phase"] = Phase.PLAY
    match.matches["phase_clock"] = match.league.rules.shoot_out_time - steps * match.league.dt
    kick(match, True)
    assert match.events["penalty"][0] == result


@pytest.mark.parametrize("score", [(1, 0), (0, 2)])
def test_a_match_that_is_won_ends_and_so_does_a_draw_without_the_rule(score):
    match = Match(MIDDLE, home=3, away=3, seed=1, minutes=1.0, rules="league:shoot_out=True")
    match.matches["half"], match.matches["clock"], match.matches["score"] = 1, 30.0, score
    match.step(stand(match))
    assert match.terminated[0] and match.matches["shoot_out"][0] == 0
    assert drawn("league").terminated[0]
