"""Clips: parts of a recorded match that play again bit for bit, with what robots thought."""

from pathlib import Path

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.replay.clips import EVERY, Clips, exact

BEFORE, AFTER = 3.0, 1.0  # [s]


def recorded(league: str, seconds: float, marks: tuple[float, ...]) -> tuple[Match, Replay, list[tuple[int, Replay]]]:
    match = Match(league, home=2, away=2, controllers={"home": "chaser", "away": "chaser"}, minutes=2, seed=3)
    rate = match.league.control_rate
    recorder = Recorder(match, Thoughts(match))
    clips = Clips(match, recorder, BEFORE, AFTER)
    for step in range(round(seconds * rate)):
        clips.note()
        match.step()
        if step + 1 in [round(mark * rate) for mark in marks]:
            clips.mark()
    whole = recorder.stop()
    return match, whole, clips.cut(whole)


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
def test_a_clip_shows_what_happened(league: str, tmp_path: Path) -> None:
    match, whole, found = recorded(league, 25.0, (10.0, 24.5))
    rate = match.league.control_rate
    for mark, (first, clip) in zip((10.0, 24.5), found, strict=True):
        last = min(round((mark + AFTER) * rate), len(whole))
        assert first <= round((mark - BEFORE) * rate) and first + len(clip) == last
        assert clip.hashes == whole.hashes[first:last]  # what happened, step by step
        again = Replay.read(clip.write(tmp_path / "a.replay"))
        assert again.check() == len(clip) and again.teams == whole.teams


def test_recording_for_clips_changes_nothing() -> None:
    match, _, _ = recorded("legged-2001", 10.0, (5.0,))
    plain = Match("legged-2001", home=2, away=2, controllers={"home": "chaser", "away": "chaser"}, minutes=2, seed=3)
    for _ in range(10 * match.league.control_rate):
        plain.step()
    assert plain.state_hash(0) == match.state_hash(0)


def test_a_clip_has_the_thoughts_of_its_part() -> None:
    _, whole, ((first, clip),) = recorded("legged-2001", 12.0, (11.0,))
    mine, all_of_it = clip.notes(), whole.notes()
    assert mine is not None and all_of_it is not None
    inside = (all_of_it.steps > first) & (all_of_it.steps <= first + len(clip))
    assert np.array_equal(mine.steps + first, all_of_it.steps[inside])
    assert np.array_equal(mine.numbers, all_of_it.numbers[inside])
    assert whole.notes().between(len(whole), len(whole)) == {}  # type: ignore[union-attr]


def test_where_no_moment_will_do_a_clip_begins_with_the_recording() -> None:
    _, whole, _ = recorded("legged-2001", 4.0, ())
    first, clip = exact(whole, [(16, whole.start)], 32)  # records of another moment
    assert (first, len(clip)) == (0, 32) and clip.check() == 32
    assert EVERY <= BEFORE
