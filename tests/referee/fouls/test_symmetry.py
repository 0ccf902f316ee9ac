"""Matches under all rules of the legged league play alike mirrored, alone or among others, and on both backends."""

import numpy as np
import pytest

from soccer_env import Match
from tests.scenes.fouls import court
from tests.scenes.staging import LEGGED, put, put_ball, stand
from tests.scenes.symmetry import HALF_TURN, Records, assert_same_records, mirrored, turned


def chasers(**settings):
    """Return matches of two teams of chasers under all rules."""
    controllers = {"home": "chaser", "away": "chaser"}
    return Match(LEGGED, matches=4, seed=4, rules="league", senses="ideal", controllers=controllers, **settings)


def test_both_backends_agree_under_all_rules():
    match, other = chasers(backend="c"), chasers(backend="batch")
    whistles = 0
    for _ in range(120 * match.league.control_rate):
        match.step()
        other.step()
        whistles += int((match.robot_events["foul"] > 0).sum())
        assert np.array_equal(match.robot_events["foul"], other.robot_events["foul"])
    assert whistles > 5 and match.state_hash() == other.state_hash()


@pytest.mark.parametrize("field", ["pushing", "keeper_pushing", "holding", "trespass", "beyond", "penalty"])
def test_what_the_referee_counts_is_saved(field):
    match = chasers()
    match.robots[field][:, 1] = 0.5
    saved = match.save()
    match.robots[field][:, 1] = 0.0
    match.load(saved)
    assert (match.robots[field][:, 1] == 0.5).all()


def whistled():
    """Return a match with a robot that is about to be whistled, one that comes back and a goal that does not count."""
    match = court("illegal_defender=True,keeper_pushing=True,kick_off_shot=True,local_stuck=True")
    put(match, 1, -1.2, 0.3, 0.2)
    put(match, 4, 0.4, -0.6, 2.0)
    put_ball(match, 1.48, 0.2, 0.5)
    match.robots["penalty"][0, 5] = 0.5
    match.matches["whistled"] = 0
    match.rebuild()
    return match


def on_pitch(records):
    """Return records without the poses of those who are out: the bench is in no frame."""
    for name in ("x", "y", "heading", "pan", "tilt", "place_x", "place_y", "place_heading"):
        records.robots[name][records.robots["active"] == 0] = 0.0
    return records


@pytest.mark.parametrize("change", [mirrored, turned])
def test_mirrored_and_turned_matches_are_judged_alike(change):
    match, other = whistled(), whistled()
    change(Records.of(match)).put_into(other)
    fouls = 0
    for _ in range(24):
        match.step(stand(match))
        other.step(stand(other))
        fouls += int((match.robot_events["foul"] > 0).sum())
        assert_same_records(on_pitch(change(Records.of(match))), on_pitch(Records.of(other)), HALF_TURN)
    assert fouls == 1 and match.matches["score"].sum() == 0 and match.robots["active"][0].tolist() == [0, 0, 0, 0, 1, 1]
