"""What an entry says of itself: sign in a mirror and a half-turn, slot, place in a record; what a layout names."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.observations import Entry, entries_named, layout
from soccer_env.observations.entry import CAMERA, FIELD, NONE, ROBOT, SIDE, TEAM, TURN, X, Y
from soccer_env.observations.reflection import observation_signs
from soccer_env.observations.scales import scale_in_numbers
from soccer_env.observations.truth import PLAYER, PLAYER_SIZE
from tests.scenes import symmetry
from tests.scenes.staging import LEAGUES
from tests.scenes.symmetry import MIRROR, Records, assert_close, mirrored, mirrored_observations, mirrored_tracks


@pytest.mark.parametrize(("frame", "axis", "mirror", "half_turn"), [
    (NONE, "", 1, 1), (ROBOT, X, 1, 1), (ROBOT, Y, -1, 1), (ROBOT, TURN, -1, 1), (TEAM, X, 1, 1), (TEAM, Y, -1, 1),
    (FIELD, X, 1, -1), (FIELD, Y, -1, -1), (FIELD, TURN, -1, 1), (CAMERA, "", 1, 1), (CAMERA, SIDE, None, 1),
    (None, "", None, None),
])  # fmt: skip
def test_signs_follow_from_frame_and_axis(frame: Any, axis: Any, mirror: int | None, half_turn: int | None) -> None:
    entry = Entry("a", frame=frame, axis=axis)
    assert (entry.mirror, entry.half_turn) == (mirror, half_turn)


def test_an_axis_without_a_frame_and_what_is_no_entry_are_refused() -> None:
    with pytest.raises(ValueError, match="entry 'a' has the axis 'y' of no frame"):
        Entry("a", axis=Y)
    with pytest.raises(ValueError, match=r"entries of observe must be of soccer_env.observations.Entry, got 'clock'"):
        Match(home=1, away=1, seed=1, observe=Own(entries=["clock"]))


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("observe", ["truth", "belief", "percepts"])
def test_every_entry_of_ours_says_what_it_means_on_a_scale_that_has_a_number(league: str, observe: str) -> None:
    found = find_league(league)
    for entry in layout(found, observe):
        assert entry.meaning and entry.scale and entry.frame and entry.group
        scale = scale_in_numbers(entry, found)
        assert any(letter.isdigit() for letter in scale) and "soft" not in scale


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("observe", ["truth", "belief"])
def test_names_of_a_policys_inputs_give_back_the_entries(league: str, observe: str) -> None:
    entries = layout(find_league(league), observe)
    assert entries_named(observe, [entry.name for entry in entries]) == entries
    assert entries_named(observe, ["something"]) == [Entry("something")]


def played(league: str, observe: str) -> Match:
    """Return matches some time after the kick-off, everybody moving."""
    match = Match(league, home=3, away=3, matches=8, seed=4, observe=observe, minutes=2.0)
    rng = np.random.default_rng(2)
    for _ in range(40):
        match.step(rng.uniform(-1.0, 1.0, (8, 6, 4)))
    return match


@pytest.mark.parametrize("league", LEAGUES)
def test_mirrored_beliefs_are_observed_with_the_signs_that_the_entries_say(league: str) -> None:
    match = played(league, "belief")
    before, entries = match.observations.copy(), match.observation_entries
    match.robots[:] = mirrored(Records.of(match)).robots
    match.beliefs[:], match.tracks[:] = symmetry.mirrored_beliefs(match.beliefs), mirrored_tracks(match.tracks)
    match.batch.observe_anew(0, 8)
    assert_close(match.observations, mirrored_observations(before, entries), MIRROR + np.finfo("f4").eps, "mirror")
    unsigned = before * (observation_signs(entries) < 0.0)
    assert np.count_nonzero(unsigned.any(axis=(0, 1))) >= 15, "much of it has a sign to turn round"


@pytest.mark.parametrize("league", LEAGUES)
def test_mirrored_percepts_are_observed_with_signs_or_in_other_places(league: str) -> None:
    match = played(league, "percepts")
    before, entries = match.observations.copy(), match.observation_entries
    match.robots[:] = mirrored(Records.of(match)).robots
    match.percepts[:] = symmetry.mirrored_percepts(match.percepts, getattr(match.league.sensors, "lines", 0))
    match.batch.observe_anew(0, 8)
    signed = [index for index, entry in enumerate(entries) if entry.mirror is not None]
    turned = mirrored_observations(before[..., signed], [entries[index] for index in signed])
    assert_close(match.observations[..., signed], turned, MIRROR + np.finfo("f4").eps, "mirror")
    moved = [index for index in range(len(entries)) if index not in signed]
    assert moved and (match.observations[..., moved] != before[..., moved]).any(), "left has become right"


# Observations of one's own


class Own:
    """An observation of one's own, that says what it means or gives names alone."""

    def __init__(self, **said: Any) -> None:
        vars(self).update(said)

    def __call__(self, match: Match) -> np.ndarray:
        return np.zeros((match.count, len(match.agents), len(match.observation_names)))


def test_entries_of_ones_own_are_mirrored() -> None:
    slots = [
        Entry(f"{name}_of_{kind}", frame=ROBOT, axis=axis, group=kind, slot=0, present=name == "there")
        for kind in ("teammate", "opponent")
        for name, axis in (("there", ""), ("left", Y))
    ]
    match = Match(home=1, away=1, seed=1, observe=Own(entries=[Entry("ball", "", "", ROBOT, X), *slots]))  # type: ignore[arg-type]
    entries = match.observation_entries
    slotted = [f"{name}_of_{kind}" for kind in ("teammate", "opponent") for name in ("there", "left")]
    assert match.observation_names == ["ball", *slotted]
    assert observation_signs(entries).tolist() == [1.0, 1.0, -1.0, 1.0, -1.0]
    assert [(entry.group, entry.slot) for entry in entries[1::2]] == [("teammate", 0), ("opponent", 0)]


def test_scales_are_in_numbers_as_observations_are_made() -> None:
    match = Match("legged-2001", home=1, away=1, seed=1, observe="truth")
    match.robots[0, 0]["x"], match.robots[0, 0]["y"], match.robots[0, 0]["heading"] = 0.9, 0.25, 0.0
    match.balls[0]["x"], match.balls[0]["y"], match.balls[0]["vx"] = 1.26055, 0.25, 0.2
    match.batch.observe_anew(0, 1)
    seen = dict(zip(match.observation_names, match.observations[0, 0].tolist(), strict=True))
    told = {entry.name: scale_in_numbers(entry, match.league) for entry in layout(match.league, "truth")}
    assert (told["own_x"], told["own_y"], told["ball_x"]) == ("1.8 m", "1 m", "3.606 m")
    assert told["ball_near_x"] == "x / (|x| + 0.3606 m)" and told["ball_vx"] == "v / (|v| + 0.2 m/s)"
    found = [seen[name] for name in ("own_x", "own_y", "ball_x", "ball_near_x", "ball_vx")]
    np.testing.assert_allclose(found, [0.5, 0.25, 0.1, 0.5, 0.5], atol=1e-4)


@pytest.mark.parametrize(("league", "truth", "belief"), [("legged-2001", 73, 100), ("middle-size-2006", 101, 133)])
def test_the_layout_names_every_number_once(league: str, truth: int, belief: int) -> None:
    for observe, size in (("truth", truth), ("belief", belief)):
        names = [item.name for item in layout(find_league(league), observe)]
        assert len(names) == len(set(names)) == size == len(Match(league, seed=0, observe=observe).observation_names)
    assert ("obstacle_near" in names) is (league == "legged-2001")  # the only league with a ranger
    assert len(PLAYER) == PLAYER_SIZE


@pytest.mark.parametrize("league", LEAGUES)
def test_wild_states_stay_in_the_box(league: str) -> None:
    match = Match(league, home=3, away=3, matches=64, seed=0)
    rng = np.random.default_rng(0)
    for field in ("x", "y", "vx", "vy", "omega", "heading"):
        match.robots[field] = rng.normal(0.0, 100.0, match.robots.shape)
    for field in ("x", "y", "vx", "vy"):
        match.balls[field] = rng.normal(0.0, 100.0, 64)
    match.matches["score"] = rng.integers(0, 1000, (64, 2))
    match.batch.observe_anew(0, 64)
    assert np.abs(match.observations).max() <= 1.0


def test_the_last_command_is_seen_clipped() -> None:
    match = Match(home=1, away=1, seed=0)
    match.step(np.array([[[3.0, -0.25, 0.5, -7.0], [0, 0, 0, 0]]]))
    seen = dict(zip(match.observation_names, match.observations[0, 0].tolist(), strict=True))
    assert [seen[f"last_{name}"] for name in ("forward", "left", "turn", "kick")] == [1.0, -0.25, 0.5, -1.0]
