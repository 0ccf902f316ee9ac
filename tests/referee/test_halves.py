"""The clock: two halves, change of ends, the second kick-off by the other team, and the final whistle."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.scenes import SCENES
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase
from tests.scenes.staging import LEGGED, each_league, place, play, stand, steps_in

MINUTES = 0.2  # two halves of 6 s


def play_on(match: Match, what: str) -> int:
    """Step until an event; return the control steps."""
    for step in range(1, 2000):
        match.step(stand(match))
        if match.events[what].any():
            return step
    raise AssertionError(f"no {what}")


@each_league
def test_the_first_half_ends_on_time_goals_of_its_last_moment_count_and_end_an_episode_even_then(name):
    """It used to begin a second half of a match that was over."""
    match = Match(name, minutes=MINUTES, seed=1)
    assert play_on(match, "half_time") == steps_in(match, 6.0) and not match.terminated[0]
    assert match.matches["half"][0] == 1 and match.matches["clock"][0] == 0.0
    match = goal_at_half_time(name)
    assert match.events["half_time"][0] == 1 and match.matches["score"].tolist() == [[1, 0]]
    assert match.matches["restart_team"][0] == AWAY, "the second half begins, whoever scored"
    match = goal_at_half_time(name, episode="goal")
    assert match.terminated[0] and match.matches["phase"][0] == Phase.OVER
    assert match.events["half_time"][0] == 0 and match.matches["home_direction"][0] == 1.0


@pytest.mark.parametrize(("name", "minutes"), [("legged-2001", 10.0), ("middle-size-2006", 15.0)])
def test_a_half_of_the_league_is_as_long_as_its_rules_say(name, minutes):
    assert Match(name, seed=1).matches["half_length"][0] == 60.0 * minutes
    assert find_league(name).rules.half_minutes == minutes


@pytest.mark.parametrize("placement", ["instant", "drive"])
@each_league
def test_at_half_time_the_teams_change_ends_and_the_other_team_kicks_off(name, placement):
    match = Match(name, home=3, away=3, minutes=0.6, seed=1, placement=placement)  # 18 s: the drive takes up to 10
    first = match.matches["kick_off_team"][0]
    assert match.matches["restart_team"][0] == first and match.matches["home_direction"][0] == 1.0
    play_on(match, "half_time")
    assert match.matches["home_direction"][0] == -1.0 and match.events["restart"][0] == Phase.KICK_OFF
    assert match.events["restart_team"][0] == match.matches["restart_team"][0] == 1 - first
    for _ in range(steps_in(match, 12.0) if placement == "drive" else 0):
        if match.matches["placing"][0] == 0:
            break
        match.step(stand(match))
    own_half = np.where(match.robots["team"] == HOME, -1.0, 1.0) * match.matches["home_direction"][0]
    assert (own_half * match.robots["x"] > 0.0).all()
    assert match.balls[["x", "y"]].tolist() == [(0.0, 0.0)]


@each_league
def test_the_final_whistle_ends_the_match_and_nothing_happens_after_it(name):
    match = Match(name, minutes=MINUTES, seed=1)
    steps = play_on(match, "final_whistle")
    assert steps == 2 * steps_in(match, 6.0)
    assert match.terminated[0] and not match.truncated[0]
    assert match.matches["phase"][0] == Phase.OVER and match.events["restart"][0] == 0
    before, score = match.robots.copy(), match.matches["score"].copy()
    actions = np.ones((1, len(match.agents), 4))
    for _ in range(20):
        _, rewards, terminated, _ = match.step(actions)
        assert terminated[0] and not rewards.any() and not match.events["final_whistle"].any()
    np.testing.assert_array_equal(match.robots["x"], before["x"])
    np.testing.assert_array_equal(match.matches["score"], score)


@each_league
def test_time_runs_on_while_the_ball_lies_ready_for_a_restart_and_without_a_clock_a_match_goes_on(name):
    match, endless = Match(name, seed=1), Match(name, episode="goal", seed=1)
    assert match.matches["phase"][0] == Phase.KICK_OFF and np.isinf(endless.matches["half_length"][0])
    play(match, 3.0)
    assert match.matches["clock"][0] == pytest.approx(3.0)
    play(endless, steps=200)
    assert endless.matches["half"][0] == 0 and not endless.terminated[0]


def goal_at_half_time(name, **settings):
    """Return a match in which a goal falls in the last step of the first half."""
    match = Match(name, minutes=MINUTES, seed=1, rules="simple", **settings)
    play(match, steps=steps_in(match, 6.0) - 1)
    match.matches["phase"], match.matches["restart_team"] = Phase.PLAY, NO_TEAM
    place(match, ball=(match.league.pitch.length / 2 + match.league.ball.radius + 0.01, 0.0))
    match.step(stand(match))
    assert match.events["goal"][0] == HOME
    return match


@each_league
def test_events_name_teams_and_not_sides(name):
    match = Match(name, home=2, away=2, matches=2, seed=1)
    match.matches["phase"], match.matches["restart_team"] = Phase.PLAY, NO_TEAM
    match.matches["half"], match.matches["home_direction"] = [0, 1], [1.0, -1.0]
    league = match.league
    x = league.pitch.length / 2 - 0.5
    match.robots["x"], match.robots["y"] = [-1.0, -0.5, -1.0, 0.0], [0.5, 0.5, -0.5, -0.5]
    match.robots["x"][:, 1], match.robots["y"][:, 1], match.robots["heading"][:, 1] = [x, -x], 0.0, [0.0, np.pi]
    gap = league.body.front + league.ball.radius + 0.002
    place(match, ball=([x + gap, -x - gap], 0.0))
    match.step(stand(match))
    assert match.events["touch_team"].tolist() == [HOME, HOME]
    place(match, ball=([7.0 * x, -7.0 * x], 0.0))
    match.step(stand(match))
    assert match.events["goal"].tolist() == [HOME, HOME] and match.matches["score"].tolist() == [[1, 0], [1, 0]]
    assert match.events["restart_team"].tolist() == [AWAY, AWAY]


@each_league
def test_the_seed_chooses_who_kicks_off_first_each_side_equally_often(name):
    match = Match(name, home=1, away=1, matches=150, seed=4)
    first = match.matches["kick_off_team"].copy()
    assert (match.matches["restart_team"] == first).all()
    taker = np.where(first == HOME, 0, 1)
    near = np.hypot(match.robots["x"], match.robots["y"]).argmin(axis=1)
    assert (near == taker).all()
    assert abs(first.mean() - 0.5) < 0.125  # three standard deviations
    match.reset()
    assert abs(match.matches["kick_off_team"].mean() - 0.5) < 0.125
    assert (match.matches["kick_off_team"] != first).mean() > 0.3, "an episode draws anew"


def test_with_the_teams_sides_swapped_the_same_side_kicks_off_and_in_a_drill_home():
    """So that each team kicks off in one match of a pair."""
    one, other = (Match(LEGGED, home=home, away=4 - home, matches=20, seed=6) for home in (1, 3))
    assert (one.matches["kick_off_team"] == other.matches["kick_off_team"]).all()
    for scene in [scene for scene in SCENES.values() if scene.place is not None and not scene.in_play]:
        if "legged" not in (scene.families or ("legged",)):
            continue
        match = Match(LEGGED, home=3, away=3, matches=20, seed=4, scene=scene)
        assert (match.matches["kick_off_team"] == HOME).all()
