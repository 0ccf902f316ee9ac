"""What a recording keeps of the robots' thoughts is what they believed, and changes nothing in the play."""

from pathlib import Path

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.thoughts.thoughts import SEES, TABLE, Notes
from soccer_env.train.evaluate.recording import shown_of_memory

TEAMS = {"legged-2001": "sacks-2001", "middle-size-2006": "heinemann-2006"}


def recorded(league: str, steps: int = 60, thinks: bool = True, **settings: object) -> tuple[Match, Replay]:
    match = Match(league, controllers={"home": TEAMS[league], "away": "chaser"}, seed=5, **settings)
    recorder = Recorder(match, Thoughts(match, shown_of_memory()) if thinks else None)
    for _ in range(steps):
        match.step()
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


def test_believed_players_lie_where_the_players_are() -> None:
    match, replay = recorded("middle-size-2006", senses="ideal", home=2, away=1)
    notes = replay.notes()
    assert notes is not None
    tracks = notes.numbers[-1, 0, len(TABLE) : len(TABLE) + 3 * notes.slots].reshape(-1, 3)
    for x, y, age in tracks[tracks[:, 2] != 0]:
        other = match.robots[0, 1 if age > 0 else 2]
        assert np.hypot(x / 1000.0 - other["x"], y / 1000.0 - other["y"]) < 2e-3
    assert sorted(np.sign(tracks[:, 2])) == sorted([1, -1] + [0] * (notes.slots - 2))


def test_a_match_in_which_nobody_believes_anything_has_no_thoughts() -> None:
    match = Match(home=1, away=1, seed=1)
    recorder = Recorder(match, Thoughts(match))
    for _ in range(10):
        match.step(np.zeros((1, 2, 4)))
    assert recorder.stop().notes() is None


def test_damaged_thoughts_are_refused() -> None:
    sound = recorded("legged-2001")[1].thoughts
    for name, value in (
        ("thoughts", sound["thoughts"][:-1]),
        ("thoughts", sound["thoughts"].astype(np.int32)),
        ("thoughts_about", np.frombuffer(b"[1]", np.uint8)),
        ("thoughts_about", np.frombuffer(b"\xff{", np.uint8)),
    ):
        replay = recorded("legged-2001", steps=1)[1]
        replay.thoughts = {**sound, name: value}
        with pytest.raises(ValueError):
            replay.notes()
    assert Notes(sound, len(sound["thoughts"])).numbers.dtype == np.int16
