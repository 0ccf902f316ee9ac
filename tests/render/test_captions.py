import numpy as np
import pytest

from soccer_env import types
from soccer_env.leagues import find_league
from soccer_env.render.captions import PHASES, clock_words, goal_team, half_words, phase_words, possession_words
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase

RULES = find_league("middle-size-2006").rules


def make_match(**values):
    match = np.zeros((), types.MATCH)
    match["restart_team"] = match["last_touch_team"] = match["last_touch_robot"] = NO_TEAM
    for name, value in values.items():
        match[name] = value
    return match


def make_robots():
    robots = np.zeros(4, types.ROBOT)
    robots["team"], robots["number"], robots["active"] = (0, 0, 1, 1), (0, 1, 0, 1), 1
    robots["keeper"] = robots["number"] == 0
    return robots


def test_every_phase_has_words_of_its_own():
    assert set(PHASES) == set(Phase) and len(set(PHASES.values())) == len(Phase)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"phase": Phase.PLAY, "restart_team": AWAY}, "play"),
        ({"phase": Phase.KICK_OFF, "restart_team": HOME}, "kick-off red"),
        ({"phase": Phase.THROW_IN, "restart_team": AWAY}, "throw-in blue"),
        ({"phase": Phase.CORNER_KICK, "restart_team": HOME}, "corner kick red"),
        ({"phase": Phase.DROP_BALL, "restart_team": NO_TEAM}, "dropped ball"),
        (
            {"phase": Phase.GOAL_KICK, "restart_team": AWAY, "placing": 1, "phase_clock": 3.4},
            "goal kick blue, placing 7 s",
        ),
        (
            {"phase": Phase.KICK_OFF, "restart_team": HOME, "placing": 1, "phase_clock": 99.0},
            "kick-off red, placing 0 s",
        ),
        ({"phase": Phase.OVER, "over": 1}, "final whistle"),
        ({"phase": Phase.PLAY, "over": 1}, "end of episode"),
    ],
)
def test_the_phase_is_spelled_out(values, words):
    assert phase_words(make_match(**values), RULES) == words


@pytest.mark.parametrize(
    ("seconds", "words"), [(0.0, "00:00"), (59.99, "00:59"), (207.3, "03:27"), (6000.0, "100:00"), (-1.0, "00:00")]
)
def test_the_clock_counts_minutes_and_seconds(seconds, words):
    assert clock_words(make_match(clock=seconds)) == words


def test_the_half_is_named():
    assert half_words(make_match(half_length=600.0)) == "1st half, 10 min"
    assert half_words(make_match(half_length=450.0, half=1)) == "2nd half, 7.5 min"
    assert half_words(make_match(half_length=np.inf)) == "no halves"


def test_possession_names_the_robot_that_has_the_ball():
    robots = make_robots()
    robots[3]["has_ball"] = 1
    assert possession_words(make_match(last_touch_team=HOME, last_touch_robot=1), robots) == ("ball: blue 1", AWAY)
    robots[0]["has_ball"] = 1
    assert possession_words(make_match(), robots) == ("ball: red 0 (keeper) + blue 1", NO_TEAM)
    robots["active"] = 0
    assert possession_words(make_match(), robots) == ("loose, not touched yet", NO_TEAM)


def test_a_loose_ball_names_the_last_touch():
    robots = make_robots()
    assert (
        possession_words(make_match(last_touch_team=AWAY, last_touch_robot=3), robots)[0] == "loose, last touch: blue 1"
    )
    assert possession_words(make_match(last_touch_team=HOME), robots)[0] == "loose, last touch: red"


def test_a_goal_is_shown_at_the_kick_off_that_follows_it():
    after = {"phase": Phase.KICK_OFF, "restart_team": AWAY, "clock": 70.0, "phase_clock": 1.0, "score": (1, 0)}
    assert goal_team(make_match(**after)) == HOME
    assert goal_team(make_match(**after | {"phase_clock": 8.0})) == NO_TEAM  # a while ago
    assert goal_team(make_match(**after | {"score": (0, 2)})) == NO_TEAM  # red has no goal
    assert goal_team(make_match(**after | {"phase": Phase.PLAY})) == NO_TEAM
    assert goal_team(make_match(**after | {"clock": 1.0, "half": 1})) == NO_TEAM  # the half has just begun
