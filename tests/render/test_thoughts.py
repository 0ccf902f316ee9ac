"""What a recording and its clips keep of the robots' thoughts is what they believed, and changes no play."""

from pathlib import Path

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.replay.clips import Clips
from soccer_env.thoughts.thoughts import SEES, TABLE, Notes
from soccer_env.train.evaluate.recording import shown_memory_fields
from tests.scenes.staging import play

TEAMS = {"legged-2001": "sacks-2001", "middle-size-2006": "heinemann-2006"}


def recorded(league: str, steps: int = 60, thinks: bool = True, **settings: object) -> tuple[Match, Replay]:
    match = Match(league, controllers={"home": TEAMS[league], "away": "chaser"}, seed=5, **settings)
    recorder = Recorder(match, Thoughts(match, shown_memory_fields()) if thinks else None)
    play(match, steps=steps)
    return match, recorder.stop()


@pytest.mark.parametrize("league", TEAMS)
@pytest.mark.parametrize("pose", ["percept", "particles"])
def test_the_last_note_is_what_the_robots_believe(league: str, pose: str, tmp_path: Path) -> None:
    match, replay = recorded(league, pose=pose)
    notes = Replay.read(replay.write(tmp_path / "a.replay")).notes()
    assert notes is not None and notes.steps[-1] == 60
    column = dict(zip(TABLE, notes.numbers[-1].T[: len(TABLE)], strict=True))
    for r, robot in enumerate(match.robots[0]):
        own, ball = match.beliefs[0, r]["own"], match.beliefs[0, r]["ball"]
        sign = 1.0 if robot["team"] == 0 else -1.0  # away's frame is the field's, turned
        assert abs(column["x"][r] / 1000.0 - sign * own["x"]) < 1e-3
        assert column["ball_confidence"][r] == round(100.0 * ball["confidence"])
        away = np.hypot(column["ball_x"][r] - column["x"][r], column["ball_y"][r] - column["y"][r]) / 1000.0
        assert abs(away - np.hypot(ball["x"], ball["y"])) < 3e-3
        assert bool(column["sees"][r] & SEES["thinks"])
        assert (column["spread"][r] > 0) == (pose == "particles")
    words = {field[0]: field[1] for field in notes.fields[0]}
    assert "guard" in words["behaviour"] if league == "legged-2001" else words["role"][0] == "goalkeeper"


def test_thoughts_change_nothing_in_the_play() -> None:
    assert recorded("legged-2001")[1].hashes == recorded("legged-2001", thinks=False)[1].hashes
    assert recorded("legged-2001", thinks=False)[1].notes() is None
    match = Match(home=1, away=1, seed=1)
    recorder = Recorder(match, Thoughts(match))
    play(match, steps=10)
    assert recorder.stop().notes() is None, "nobody there believes anything"


def test_believed_players_lie_where_the_players_are() -> None:
    match, replay = recorded("middle-size-2006", senses="ideal", home=2, away=1)
    notes = replay.notes()
    tracks = notes.numbers[-1, 0, len(TABLE) : len(TABLE) + 3 * notes.slots].reshape(-1, 3)
    for x, y, age in tracks[tracks[:, 2] != 0]:
        other = match.robots[0, 1 if age > 0 else 2]
        assert np.hypot(x / 1000.0 - other["x"], y / 1000.0 - other["y"]) < 2e-3
    assert sorted(np.sign(tracks[:, 2])) == sorted([1, -1] + [0] * (notes.slots - 2))


def test_damaged_thoughts_are_refused() -> None:
    sound = recorded("legged-2001")[1].thoughts
    shorter, wider = sound["thoughts"][:-1], sound["thoughts"].astype(np.int32)
    about = [np.frombuffer(content, np.uint8) for content in (b"[1]", b"\xff{")]
    for name, value in [("thoughts", shorter), ("thoughts", wider), *(("thoughts_about", one) for one in about)]:
        replay = recorded("legged-2001", steps=1)[1]
        replay.thoughts = {**sound, name: value}
        with pytest.raises(ValueError):
            replay.notes()
    assert Notes(sound, len(sound["thoughts"])).numbers.dtype == np.int16


BEFORE, AFTER = 3.0, 1.0  # [s]


def clipped(league: str, seconds: float, marks: tuple[float, ...]) -> tuple[Match, Replay, list[tuple[int, Replay]]]:
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
    match, whole, found = clipped(league, 25.0, (10.0, 24.5))
    rate = match.league.control_rate
    for mark, (first, clip) in zip((10.0, 24.5), found, strict=True):
        last = min(round((mark + AFTER) * rate), len(whole))
        assert first <= round((mark - BEFORE) * rate) and first + len(clip) == last
        assert clip.hashes == whole.hashes[first:last]  # what happened, step by step
        again = Replay.read(clip.write(tmp_path / "a.replay"))
        assert again.check() == len(clip) and again.teams == whole.teams


def test_a_clip_has_the_thoughts_of_its_part() -> None:
    _, whole, ((first, clip),) = clipped("legged-2001", 12.0, (11.0,))
    mine, all_of_it = clip.notes(), whole.notes()
    assert mine is not None and all_of_it is not None
    inside = (all_of_it.steps > first) & (all_of_it.steps <= first + len(clip))
    assert np.array_equal(mine.steps + first, all_of_it.steps[inside])
    assert np.array_equal(mine.numbers, all_of_it.numbers[inside])
    assert whole.notes().between(len(whole), len(whole)) == {}  # type: ignore[union-attr]
