"""Overlays show at their places, under or over the robots, and bad ones leave no trace; captions say the state."""

import numpy as np
import pytest

pytest.importorskip("pygame")

import pytest

from soccer_env import types
from soccer_env.leagues import find_league
from soccer_env.render import Arrows, Picture, Points, Polyline, colours
from soccer_env.render.captions import clock_words, goal_team, half_words, phase_words
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase
from tests.render.staged_frames import make_records


def test_bad_overlays_name_the_value_and_leave_no_trace():
    picture = Picture("legged-2001", 480)
    records = make_records()
    clean = picture.draw(*records)
    bad = {
        r"Points.xy must have shape \(N, 2\), got \(3,\)": Points([1.0, 2.0, 3.0], colours.WHITE),
        r"Points.xy must be finite, got \[0.5, nan\]": Points([(0.5, np.nan)], colours.WHITE),
        "a vector for each tail, got 2 for 1 tails": Arrows([(0, 0)], [(1, 1), (2, 2)], colours.WHITE),
    }
    for message, overlay in bad.items():
        with pytest.raises(ValueError, match=message):
            picture.draw(*records, overlays=[Polyline([(0, 0), (1, 1)], colours.WHITE), overlay])
        assert np.array_equal(picture.draw(*records), clean)


PLACING = {"restart_team": HOME, "placing": 1, "phase_clock": 3.4}
RULES = find_league("middle-size-2006").rules


def make_match(**values):
    match = np.zeros((), types.MATCH)
    match["restart_team"] = match["last_touch_team"] = match["last_touch_robot"] = NO_TEAM
    for name, value in values.items():
        match[name] = value
    return match


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"phase": Phase.PLAY, "restart_team": AWAY}, "play"),
        ({"phase": Phase.KICK_OFF, "restart_team": HOME}, "kick-off red"),
        ({"phase": Phase.THROW_IN, "restart_team": AWAY}, "throw-in blue"),
        ({"phase": Phase.CORNER_KICK, "restart_team": HOME}, "corner kick red"),
        ({"phase": Phase.DROP_BALL, "restart_team": NO_TEAM}, "dropped ball"),
        (PLACING | {"phase": Phase.GOAL_KICK, "restart_team": AWAY}, "goal kick blue, placing 7 s"),
        (PLACING | {"phase": Phase.KICK_OFF, "phase_clock": 99.0}, "kick-off red, placing 0 s"),
        ({"phase": Phase.OVER, "over": 1}, "final whistle"),
        ({"phase": Phase.PLAY, "over": 1}, "end of episode"),
    ],
)
def test_the_phase_is_spelled_out(values, words):
    assert phase_words(make_match(**values), RULES) == words


def test_the_clock_counts_minutes_and_seconds_and_the_half_is_named():
    words = [clock_words(make_match(clock=seconds)) for seconds in (0.0, 59.99, 207.3, 6000.0, -1.0)]
    assert words == ["00:00", "00:59", "03:27", "100:00", "00:00"]
    assert half_words(make_match(half_length=600.0)) == "1st half, 10 min"
    assert half_words(make_match(half_length=450.0, half=1)) == "2nd half, 7.5 min"
    assert half_words(make_match(half_length=np.inf)) == "no halves"


def test_a_goal_is_shown_at_the_kick_off_that_follows_it():
    after = {"phase": Phase.KICK_OFF, "restart_team": AWAY, "clock": 70.0, "phase_clock": 1.0, "score": (1, 0)}
    assert goal_team(make_match(**after)) == HOME
    ago, none_of_red, begun = {"phase_clock": 8.0}, {"score": (0, 2)}, {"clock": 1.0, "half": 1}
    for change in (ago, none_of_red, begun, {"phase": Phase.PLAY}):
        assert goal_team(make_match(**after | change)) == NO_TEAM
