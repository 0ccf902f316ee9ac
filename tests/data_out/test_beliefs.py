"""Beliefs beside the truth: without error for ideal senses, as large as the belief is wrong, missing where unknown."""

import csv
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, errors_of
from soccer_env.data_out.collect import collect_match
from soccer_env.data_out.table_files import write_tables
from soccer_env.data_out.tables import BELIEFS, match_tables
from soccer_env.replay import Recorder, Thoughts


def ideal(league: str = "legged-2001", steps: int = 40) -> Match:
    match = Match(
        league, home=2, away=2, matches=2, seed=3, senses="ideal", controllers={"home": "chaser", "away": "still"}
    )
    for _ in range(steps):
        match.step()
    return match


def test_an_error_is_as_large_as_the_belief_is_wrong(monkeypatch: pytest.MonkeyPatch) -> None:
    match = ideal()
    beliefs, tracks = match.beliefs.copy(), match.tracks.copy()
    beliefs["own"]["x"] += 0.3
    beliefs["own"]["heading"] += 2.0 * pi + 0.2
    beliefs["ball"]["y"] -= 0.4
    beliefs["ball"]["confidence"][1] = 0.0
    tracks["x"] += 0.05
    monkeypatch.setattr(type(match), "beliefs", beliefs)
    monkeypatch.setattr(type(match), "tracks", tracks)
    errors = errors_of(match)
    assert errors.error[..., 0] == pytest.approx(np.full((2, 4), 0.3))
    assert errors.heading == pytest.approx(np.full((2, 4), 0.2))
    assert errors.error[0, :, 1] == pytest.approx(np.full(4, 0.4))
    assert np.isnan(errors.error[1, :, 1]).all() and np.isfinite(errors.range[1, :, 1]).all()
    assert np.nanmax(errors.error[..., 2:]) == pytest.approx(0.05)


def test_a_robot_off_the_field_is_neither_right_nor_wrong() -> None:
    match = ideal()
    match.robots["active"][0, 1] = 0
    match.robots["x"][0, 1] = 70.0
    errors = errors_of(match)
    assert np.isnan(errors.error[0, 1]).all() and np.isnan(errors.true[0, 1]).all() and np.isnan(errors.heading[0, 1])
    assert np.nanmax(errors.error) < 1e-9 and np.isnan(errors.heading).sum() == 1


def test_a_match_without_senses_says_so() -> None:
    with pytest.raises(ValueError, match="senses"):
        errors_of(Match(home=1, away=1))


def test_the_table_has_a_row_for_every_robot_and_noted_time_and_the_errors_of_the_match(tmp_path: Path) -> None:
    match = Match(home=2, away=1, seed=3, senses="ideal", controllers={"home": "chaser", "away": "still"}, minutes=0.05)
    recorder = Recorder(match, Thoughts(match))
    seen = []
    while not match.terminated.all():
        match.step()
        seen.append(errors_of(match))
    replay = recorder.stop()
    found = collect_match(replay, beliefs=True)
    assert found.beliefs is not None and found.noted.tolist() == replay.notes().steps.tolist()
    for at, frame in enumerate(found.noted.tolist()[1:], 1):
        for name in ("believed", "true", "age"):
            now, then = getattr(found.beliefs, name)[at], getattr(seen[frame - 1], name)[0]
            assert now == pytest.approx(then, abs=0.06 if name == "age" else 0.01, nan_ok=True), name
    paths = write_tables([match_tables(found)], tmp_path / "x.csv", beliefs=True)
    with paths["beliefs"].open(encoding="utf-8", newline="") as file:
        rows = [*csv.DictReader(file)]
    assert [*rows[0]] == [column.name for column in BELIEFS]
    assert len(rows) == len(found.noted) * 3 * 4, "of each of three robots: itself, the ball, two others"
    told: list[Any] = [(row["robot"], row["object"]) for row in rows[:4]]
    assert told == [("home_0", "own"), ("home_0", "ball"), ("home_0", "teammate"), ("home_0", "opponent")]
    assert all(float(row["error"]) < 0.01 for row in rows)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["x.csv", "x_beliefs.csv", "x_events.csv"]


def test_a_replay_without_notes_says_how_to_keep_them() -> None:
    match = Match(home=1, away=1, seed=3, senses="ideal", controllers={"home": "chaser", "away": "still"}, minutes=0.01)
    recorder = Recorder(match)
    match.step()
    with pytest.raises(ValueError, match="thoughts=Thoughts"):
        collect_match(recorder.stop(), beliefs=True)


@pytest.mark.parametrize("name", ["x.csv", "x.png", "x.svg"])
def test_the_command_writes_beliefs_of_a_folder(name: str, soccer: Any, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    words = ["--senses", "ideal", "--players", "1", "--minutes", "0.03", "--out", tmp_path / "a.replay"]
    soccer("record", "--home", "chaser", "--away", "still", *words)
    assert name in soccer("export", tmp_path, "--beliefs", "--out", tmp_path / name)
    assert "exists already" in soccer("export", tmp_path, "--beliefs", "--out", tmp_path / name, code=2)
    assert "with --beliefs must end with" in soccer(
        "export", tmp_path, "--beliefs", "--out", tmp_path / "x.mp4", code=2
    )
    assert "maps or beliefs" in soccer("export", tmp_path, "--beliefs", "--maps", code=2)
