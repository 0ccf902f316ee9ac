"""Branches: matches copied in memory and by saves of some rows, each with the future of its original."""

import re
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.replay import Recorder
from tests.scenes.staging import LEAGUES, refused

TEAMS = {"legged-2001": "sacks-2001", "middle-size-2006": "heinemann-2006"}


def played(league: str = "legged-2001", steps: int = 60, **settings: Any) -> Match:
    """Return matches of two learners and a scripted team, in the midst of play."""
    given = {"home": 2, "away": 2, "matches": 3, "controllers": {"away": TEAMS[league]}, "senses": "sensors"}
    match = Match(league, seed=5, **{**given, **settings})
    go(match, steps, 1)
    return match


def go(match: Match, steps: int, seed: int) -> None:
    """Play random actions, the same in all matches."""
    rng = np.random.default_rng(seed)
    for _ in range(steps):
        drawn = rng.uniform(-1.0, 1.0, (len(match.agents), match.settings.actions.size))
        match.step(np.broadcast_to(drawn, (match.count, *drawn.shape)))


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("pose", ["percept", "particles"])
def test_a_branch_has_the_future_of_its_original(league: str, pose: str) -> None:
    """With sensors, beliefs, memories of teams and statistics of play: into matches that stood elsewhere."""
    match = played(league, observe="belief", pose=pose)
    planner = played(league, 17, matches=8, observe="belief", pose=pose)
    assert match.branch([2, 0], planner, at=[5, 1]) is planner
    for mine, theirs in ((2, 5), (0, 1)):
        assert match.state_hash(mine) == planner.state_hash(theirs)
        assert np.array_equal(match.observations[mine], planner.observations[theirs])
    go(match, 40, 2)
    go(planner, 40, 2)
    for mine, theirs in ((2, 5), (0, 1)):
        assert match.state_hash(mine) == planner.state_hash(theirs)
        assert match.statistics[mine] == planner.statistics[theirs]
        assert np.array_equal(match.rewards[mine], planner.rewards[theirs])


def test_one_match_goes_over_many_and_into_a_new_one() -> None:
    match = played()
    planner = match.branch([1] * 4)
    assert planner.count == 4 and {planner.state_hash(m) for m in range(4)} == {match.state_hash(1)}
    assert match.branch(2, into=planner).count == 4
    assert {planner.state_hash(m) for m in range(4)} == {match.state_hash(2)}


def test_the_other_matches_are_left_alone() -> None:
    match, planner = played(), played(steps=17, matches=6)
    left = [planner.state_hash(m) for m in range(6)]
    bodies, rewards = planner.batch.physics.bodies.copy(), planner.rewards.copy()
    match.branch(0, planner, at=[1, 4])
    others = [0, 2, 3, 5]
    assert [planner.state_hash(m) for m in others] == [left[m] for m in others]
    assert np.array_equal(planner.batch.physics.bodies[others], bodies[others])
    assert np.array_equal(planner.rewards[others], rewards[others]) and not planner.rewards[[1, 4]].any()


def test_branches_that_draw_anew_part_and_do_so_from_the_seed_alone() -> None:
    match, planner = played(), played(steps=0, matches=4)
    futures = []
    for noise in (None, 7, 7, 8):
        match.branch(0, planner, noise=noise)
        assert np.array_equal(planner.robots["x"][3], match.robots["x"][0])
        saved = match.save()
        go(planner, 30, 2)
        futures.append([planner.state_hash(m) for m in range(4)])
        match.load(saved)
    assert len(set(futures[0])) == 1 and len(set(futures[1])) == 4
    assert futures[1] == futures[2] and not set(futures[1]) & set(futures[3])


def test_a_replay_of_a_match_that_was_branched_into_plays_again() -> None:
    match, planner = played(), played(steps=11)
    recorder = Recorder(planner)
    go(planner, 20, 3)
    match.branch(1, planner, at=[0, 2])
    go(planner, 20, 4)
    assert recorder.stop().check() == 40


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"rows": 3}, "rows must be whole numbers from 0 to 2, got 3"),
        ({"rows": -1}, "rows must be whole numbers from 0 to 2, got -1"),
        ({"rows": [0, True]}, "rows must be whole numbers from 0 to 2, got True"),
        ({"rows": [0.5]}, "rows must be whole numbers from 0 to 2, got 0.5"),
        ({"rows": []}, "rows must name at least one match"),
        ({"rows": "all"}, "rows must be a match's number, or several, got 'all'"),
        ({"rows": None}, "rows must be a match's number, or several, got None"),
        ({"rows": np.zeros((1, 2), int)}, "rows must be whole numbers"),
        ({"rows": [0, 1]}, "rows must be one match or as many as are overwritten, 4, got 2"),
        ({"rows": 0, "at": [1, 1]}, "at must be different matches, got [1, 1]"),
        ({"rows": 0, "at": 4}, "at must be whole numbers from 0 to 3, got 4"),
        ({"rows": 0, "noise": -1}, "seed must be a whole number of 0 or more, got -1"),
        ({"rows": 0, "into": "planner"}, "into must be a Match or None, got 'planner'"),
    ],
)
def test_what_cannot_be_branched_is_said_and_changes_nothing(given: dict[str, Any], message: str) -> None:
    match, planner = played(steps=5), played(steps=9, matches=4)
    before = match.state_hash()
    with refused(planner, re.escape(message)):
        match.branch(**{"into": planner, **given})
    assert match.state_hash() == before


@pytest.mark.parametrize("league", LEAGUES)
def test_a_save_of_one_match_goes_into_many_rows_of_another(league: str) -> None:
    match, planner = played(league), played(league, 17, matches=6)
    saved, kept = match.save(1), planner.state_hash(0)
    planner.load(saved, [1, 3, 5])
    assert planner.state_hash(0) == kept
    for _ in range(2):
        assert {planner.state_hash(m) for m in (1, 3, 5)} == {match.state_hash(1)}
        go(match, 30, 2)
        go(planner, 30, 2)


def test_a_save_of_some_rows_goes_into_as_many() -> None:
    match, planner = played(), played(steps=17, matches=6)
    planner.load(match.save([2, 0]), rows=[0, 5])
    assert (planner.state_hash(0), planner.state_hash(5)) == (match.state_hash(2), match.state_hash(0))
    one = played(steps=3, matches=1)
    one.load(match.save(1))
    assert one.state_hash(0) == match.state_hash(1)


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ([0, 1, 2], r"rows must be as many as the matches of the save, 2, got 3"),
        ([0, 0], "rows must be different matches"),
        ([0, 6], "rows must be whole numbers from 0 to 5, got 6"),
        (None, "this save is of 2 matches, not 6; name the rows"),
    ],
)
def test_a_save_of_another_number_of_matches_is_refused(rows: Any, message: str) -> None:
    match, planner = played(steps=5), played(steps=9, matches=6)
    saved = match.save([0, 1])
    with refused(planner, message):
        planner.load(saved, rows)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"observe": "belief", "senses": "ideal"}, "senses ideal there, sensors here; observe 'belief' there"),
        ({"minutes": 3.0}, "minutes 3.0 there, None here$"),
        ({"action_repeat": 4, "max_cycles": 30}, "max_cycles 30 there, None here; action_repeat 4 there, 1 here$"),
        ({"max_players": 4}, "max_players 4 there, None here"),
        ({"rules": "simple"}, "rules simple there, league here$"),
        ({"sensors": {"view_width": 0.9}}, "sensors of other settings$"),
        ({"controllers": {"away": "sacks-2001@0.5"}}, "teams differ: sacks-2001@0.5 "),
        ({"home": 3}, "home 3 there, 2 here$"),
    ],
)
def test_a_save_or_match_that_does_not_fit_names_the_settings_that_differ(settings: Any, message: str) -> None:
    match, other = played(steps=5), played(steps=5, **settings)
    with refused(match, f"this save does not fit the match: .*{message}"):
        match.load(other.save())
    with refused(other, f"into does not fit this match: .*{message}"):
        match.branch(0, other)
