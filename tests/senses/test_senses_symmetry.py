"""What is sensed and believed has no favoured side: a mirror, or a half-turn with swapped teams, changes nothing."""

from collections.abc import Callable

import numpy as np
import pytest

from soccer_env import Match
from tests.scenes.staging import scatter, set_phase
from tests.scenes.symmetry import (
    Records,
    assert_same,
    mirrored,
    mirrored_actions,
    mirrored_beliefs,
    mirrored_percepts,
    mirrored_states,
    mirrored_tracks,
    swapped_rows,
    turned,
)
from tests.senses.staged_senses import LEAGUES, draws, look_again, sensing


def scattered_pair(league: str, pose: str, changed: Callable[[Records], Records], seed: int) -> tuple[Match, Match]:
    """Return matches whose robots have just been told where they stand, at random, and their image."""
    match = sensing(league, matches=6, pose=pose)
    scatter(match, np.random.default_rng(seed))
    set_phase(match, 0)
    image = sensing(league, matches=6, pose=pose)
    changed(Records.of(match)).put_into(image)
    match.rebuild()
    for one in (match, image):
        one.robots["placed"] = 1
        look_again(one)
    return match, image


@pytest.mark.parametrize("pose", ["percept", "particles"])
@pytest.mark.parametrize("league", LEAGUES)
def test_mirrored_play_is_sensed_and_believed_mirrored(league: str, pose: str) -> None:
    match, image = scattered_pair(league, pose, mirrored, seed=1)
    lines = getattr(match.league.sensors, "lines", 0)
    for actions in draws(match, 24, seed=3):
        compare_mirrored(match, image, lines)
        match.step(0.5 * actions)
        image.step(0.5 * mirrored_actions(actions))


def compare_mirrored(match: Match, image: Match, lines: int) -> None:
    """Assert that percepts, beliefs and tracks are mirrored, in matches whose robots have not touched anything."""
    calm = match.robot_events["collision"].any(axis=1) | match.robot_events["touch"].any(axis=1)
    rows = ~calm
    assert_same(mirrored_percepts(match.percepts[rows], lines), image.percepts[rows], 1e-5, "percepts")
    states = [one.batch.senses.sensor_states[rows] for one in (match, image)]
    assert_same(mirrored_states(states[0]), states[1], 1e-5, "sensor states")
    assert_same(mirrored_beliefs(match.beliefs[rows]), image.beliefs[rows], 1e-6, "beliefs")
    assert_same(mirrored_tracks(match.tracks[rows]), image.tracks[rows], 1e-6, "tracks")


@pytest.mark.parametrize("pose", ["percept", "particles"])
@pytest.mark.parametrize("league", LEAGUES)
def test_a_half_turn_with_the_teams_swapped_changes_nothing_that_is_sensed(league: str, pose: str) -> None:
    match, image = scattered_pair(league, pose, turned, seed=2)
    for actions in draws(match, 24, seed=4):
        calm = ~(match.robot_events["collision"].any(axis=1) | match.robot_events["touch"].any(axis=1))
        assert_same(swapped_rows(match.percepts)[calm], image.percepts[calm], 1e-5, "percepts")
        assert_same(swapped_rows(match.beliefs)[calm], image.beliefs[calm], 1e-6, "beliefs")
        assert_same(swapped_rows(match.tracks)[calm], image.tracks[calm], 1e-6, "tracks")
        match.step(0.5 * actions)
        image.step(0.5 * swapped_rows(actions))
