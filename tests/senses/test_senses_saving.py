"""What is sensed and believed is saved, and has no favoured side: a mirror, or a half-turn with swapped teams."""

from collections.abc import Callable

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.match.saving import dump
from tests.scenes import symmetry
from tests.scenes.staging import play, refused, scatter, set_phase
from tests.scenes.symmetry import Records, assert_same, mirrored, mirrored_actions, swapped_rows, turned
from tests.senses.staged_senses import LEAGUES, look_again, random_actions, sensing_matches


def test_a_team_that_uses_its_sensors_alone_is_saved_alone() -> None:
    teams = {"home": "chaser", "away": "chaser"}
    match = Match("legged-2001", home=3, away=2, seed=1, controllers=teams, senses={"home": "ideal", "away": "sensors"})
    assert match.batch.senses is not None
    assert {array.shape[1] for array in match.batch.senses.parts.values()} == {2}
    play(match, steps=20)
    saved = match.save()
    futures = []
    for _ in range(2):
        play(match, steps=20)
        futures.append((match.state_hash(), match.beliefs.tobytes(), match.tracks.tobytes()))
        match.load(saved)
    assert futures[0] == futures[1]


def test_a_save_with_nonsense_in_the_memory_is_refused() -> None:
    match = sensing_matches("legged-2001", matches=1)
    memory = match.batch.senses.memories
    for name, value in (("count", 100), ("x", np.nan)):
        kept = memory["ball"][name].copy()
        memory["ball"][name] = value
        damaged = dump(match)
        memory["ball"][name] = kept
        with refused(match, "this save is damaged"):
            match.load(damaged)


def scattered_pair(league: str, pose: str, changed: Callable[[Records], Records], seed: int) -> tuple[Match, Match]:
    """Return matches whose robots have just been told where they stand, at random, and their image."""
    match = sensing_matches(league, matches=6, pose=pose)
    scatter(match, np.random.default_rng(seed))
    set_phase(match, 0)
    image = sensing_matches(league, matches=6, pose=pose)
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
    for actions in random_actions(match, 24, seed=3):
        compare_mirrored(match, image, lines)
        match.step(0.5 * actions)
        image.step(0.5 * mirrored_actions(actions))


def calm(match: Match) -> np.ndarray:
    """Return in which matches (M,) no robot touches anything."""
    return ~(match.robot_events["collision"].any(axis=1) | match.robot_events["touch"].any(axis=1))


def compare_mirrored(match: Match, image: Match, lines: int) -> None:
    """Assert that percepts, beliefs and tracks are mirrored, in matches whose robots have not touched anything."""
    rows = calm(match)
    assert_same(symmetry.mirrored_percepts(match.percepts[rows], lines), image.percepts[rows], 1e-5, "percepts")
    states = [one.batch.senses.sensor_states[rows] for one in (match, image)]
    assert_same(symmetry.mirrored_states(states[0]), states[1], 1e-5, "sensor states")
    assert_same(symmetry.mirrored_beliefs(match.beliefs[rows]), image.beliefs[rows], 1e-6, "beliefs")
    assert_same(symmetry.mirrored_tracks(match.tracks[rows]), image.tracks[rows], 1e-6, "tracks")


@pytest.mark.parametrize("pose", ["percept", "particles"])
@pytest.mark.parametrize("league", LEAGUES)
def test_a_half_turn_with_the_teams_swapped_changes_nothing_that_is_sensed(league: str, pose: str) -> None:
    match, image = scattered_pair(league, pose, turned, seed=2)
    for actions in random_actions(match, 24, seed=4):
        rows = calm(match)
        for name, tolerance in (("percepts", 1e-5), ("beliefs", 1e-6), ("tracks", 1e-6)):
            assert_same(swapped_rows(getattr(match, name))[rows], getattr(image, name)[rows], tolerance, name)
        match.step(0.5 * actions)
        image.step(0.5 * swapped_rows(actions))
