"""The players that a middle-size robot tracks: who is who, how they move, when they are forgotten."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.belief.omni.players import READING, update_team_tracks
from soccer_env.belief.omni.tracking import FILTER
from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.records.beliefs import TRACK
from soccer_env.records.percepts import OMNI_PERCEPT
from tests.belief.omni.staged_omni import state, states_in_frame, thinking_matches
from tests.scenes.staging import MIDDLE, place, play, robot_actions

MATES = find_league(MIDDLE).slots.teammates
BOTH = pytest.mark.parametrize("name", ["kalman", "least-squares"])


def tracks_of(match: Match, teammates: bool) -> np.ndarray:
    """Return the slots (M, n) that robot 0 has for a team."""
    return match.tracks[:, 0, :MATES] if teammates else match.tracks[:, 0, MATES:]


def with_players(places: dict[int, tuple[float, float]], home: int, away: int, **settings: Any) -> Match:
    """Return matches in which robot 0 stands in the middle and others stand somewhere."""
    return thinking_matches(settings.pop("matches", 10), home, away, **settings, ball=(-5.0, -3.5), robots=places)


def test_players_are_kept_by_team_nearest_first() -> None:
    match = with_players({1: (3.0, 1.0), 2: (-1.0, 2.0), 3: (1.5, -2.0), 4: (-2.5, -1.0)}, 3, 2)
    play(match, 0.3)
    mates, others = tracks_of(match, True), tracks_of(match, False)
    assert (mates["present"].sum(axis=1) == 2).all() and (others["present"].sum(axis=1) == 2).all()
    assert (mates["teammate"][:, :2] == 1).all() and (others["teammate"] == 0).all()
    for found, rows in ((mates, (2, 1)), (others, (3, 4))):
        for slot, r in enumerate(rows):
            true = states_in_frame(match, 0, match.robots[:, r])
            assert np.hypot(*(state(found[:, slot])[:, :2] - true[:, :2]).T).max() < 0.1
            assert found["distance"][:, slot] == pytest.approx(np.hypot(true[:, 0], true[:, 1]), abs=0.1)
            assert (found["confidence"][:, slot] == 100.0).all()
    assert (found["number"] == -1).all() and not found["keeper"].any()  # nobody told


@BOTH
def test_mh06_a_player_that_moves_is_tracked_with_its_velocity(name: str) -> None:
    """MH06: most teams of 2005 were unaware of velocities of robots; without a filter there is none."""
    match, bare = (with_players({1: (2.0, -2.0)}, 1, 1, matches=30, memory={"filter": kind}) for kind in (name, "none"))
    for one in (match, bare):
        play(one, 1.0, robot_actions(one, 1, left=0.7))
    true = states_in_frame(match, 0, match.robots[:, 1])
    assert true[:, 3].min() > 1.7
    found = tracks_of(match, False)[:, 0]
    error = state(found) - true
    assert np.median(np.hypot(error[:, 0], error[:, 1])) < 0.06
    assert np.median(np.hypot(error[:, 2], error[:, 3])) < 0.5
    found = tracks_of(bare, False)[:, 0]
    assert found["present"].all() and not found["vx"].any() and not found["vy"].any()


def test_mh06_two_that_pass_each_other_keep_their_tracks() -> None:
    match = with_players({1: (3.0, -2.0), 2: (3.7, 2.0)}, 1, 2, matches=20)
    actions = robot_actions(match, 1, left=0.7) + robot_actions(match, 2, left=-0.7)
    for step in range(95):  # they are in one line of sight after 1.3 s
        match.step(actions)
        others = tracks_of(match, False)
        if step > 20:
            assert (others["present"].sum(axis=1) == 2).mean() > 0.9
    upward = others["vy"][:, :2].max(axis=1)
    downward = others["vy"][:, :2].min(axis=1)
    assert np.median(upward) > 1.2 and np.median(downward) < -1.2


@compiled
def pair_off(percepts, tracks, filters, readings, constants, sensors, settings):  # type: ignore[no-untyped-def]
    k, s, w, mates = constants[0], sensors[0], settings[0], len(tracks)
    update_team_tracks(percepts[0], tracks, filters, readings, len(readings), 1, 0, mates, 0.0, k, s, w)


@pytest.mark.parametrize(("gate", "pairs"), [(1.0, [0, 1]), (0.5, [-1, 1])])
def test_mh06_the_nearest_pair_of_reading_and_track_comes_first(gate: float, pairs: list[int]) -> None:
    """Reading 0 is nearest to track 1 as well, but reading 1 is nearer to it."""
    league = find_league(MIDDLE)
    percepts, tracks, filters = np.zeros(1, OMNI_PERCEPT), np.zeros(3, TRACK), np.zeros(3, FILTER)
    readings = np.zeros(2, READING)
    percepts["players"]["teammate"][0, :2] = tracks["present"][:2] = 1  # the third slot is empty
    tracks["x"][:2], readings["x"] = [0.0, 1.2], [0.6, 1.4]
    tracks["y"][0] = 0.3
    settings = league.memory.changed({"gate": gate, "filter": "none"}).record()
    pair_off(percepts, tracks, filters, readings, constants_of(league), league.sensors.record(), settings)
    found = [int(np.argmin(abs(readings["x"] - x))) if seen else -1 for x, seen in zip(tracks["x"], filters["seen"])]
    assert found[:2] == pairs and tracks["x"][1] == 1.4 and tracks["present"][2] == (gate == 0.5)


def test_players_at_rest_stay_at_rest_for_a_robot_that_drives_and_turns() -> None:
    match = with_players({0: (-3.0, 0.0), 1: (1.0, 2.5), 2: (2.0, -2.0)}, 2, 1)
    play(match, 1.0, robot_actions(match, 0, 0.6, 0.0, 0.15))
    for found, r in ((tracks_of(match, True)[:, 0], 1), (tracks_of(match, False)[:, 0], 2)):
        error = state(found) - states_in_frame(match, 0, match.robots[:, r])
        assert np.median(np.hypot(error[:, 0], error[:, 1])) < 0.06
        assert np.median(np.hypot(found["vx"], found["vy"])) < 0.5


def test_who_is_not_seen_coasts_fades_and_is_forgotten() -> None:
    match = with_players({1: (2.0, 1.0)}, 1, 1)
    play(match, 0.4)
    match.batch.senses.sensors["player_miss"] = 1.0
    play(match, 0.5)
    found = tracks_of(match, False)[:, 0]
    assert found["present"].all()
    assert found["confidence"] == pytest.approx(100.0 - 0.5 * match.league.memory.fading, abs=1.0)
    assert found["age"] == pytest.approx(0.5, abs=0.03)
    play(match, match.league.memory.ghost_time)
    assert not tracks_of(match, False)["present"].any()
    empty = tracks_of(match, False)[0, 0]
    assert empty["number"] == -1 and empty["confidence"] == empty["x"] == empty["distance"] == 0.0


def test_markers_keep_teams_apart_even_side_by_side_and_the_nearest_keep_the_slots() -> None:
    match = with_players({1: (2.0, 0.3), 2: (2.0, -0.3)}, 2, 1)
    play(match, 0.5)
    mates, others = tracks_of(match, True), tracks_of(match, False)
    assert (mates["present"].sum(axis=1) == 1).all() and (others["present"].sum(axis=1) == 1).all()
    assert (mates["y"][:, 0] > 0.15).all() and (others["y"][:, 0] < -0.15).all()
    places = {r: (1.0 + 0.6 * r, 3.0 * np.sin(1.7 * r)) for r in range(1, 9)}
    match = with_players(places, 1, 8)
    play(match, 0.5)
    found = tracks_of(match, False)
    count = match.league.slots.opponents
    assert found["present"].all() and found.shape[1] == count
    nearest = sorted(np.hypot(x, y) for x, y in places.values())[:count]
    assert np.median(found["distance"], axis=0) == pytest.approx(nearest, abs=0.15)


def test_a_player_that_jumps_within_the_gate_is_believed_after_readings_in_a_row() -> None:
    match = with_players({1: (2.0, 0.0)}, 1, 1)
    play(match, 0.4)
    place(match, robots={1: (2.0, 0.8)})
    play(match, 0.04)
    assert (tracks_of(match, False)["y"][:, 0] < 0.2).all()  # one reading, a frame late
    play(match, 0.02)
    found = tracks_of(match, False)
    assert (found["y"][:, 0] > 0.6).all() and (found["present"].sum(axis=1) == 1).all()
