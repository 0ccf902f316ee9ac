"""A stranger's replay takes no more memory and time than a match of its size, and is refused in a line."""

import json
import os
import resource
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.replay import Recorder, Replay
from soccer_env.replay.checks import MOST_ROBOTS


@pytest.fixture
def recorded(tmp_path: Path) -> Path:
    match = Match(home=1, away=1, seed=1)
    recorder = Recorder(match)
    for _ in range(3):
        match.step(np.zeros((1, 2, 4)))
    return recorder.stop().write(tmp_path / "a.replay")


def forged(path: Path, change: Callable[[dict[str, Any]], None], **arrays: np.ndarray) -> Path:
    """Return a sound file whose header says something else."""
    with np.load(path) as file:
        parts = {name: file[name] for name in file.files}
    header = json.loads(parts["header"].tobytes())
    change(header)
    parts |= {"header": np.frombuffer(json.dumps(header).encode(), np.uint8), **arrays}
    other = path.with_name("forged.replay")
    with other.open("wb") as out:
        np.savez_compressed(out, **parts)
    return other


def setting(**values: Any) -> Callable[[dict[str, Any]], None]:
    return lambda header: header["settings"].update(values)


def substeps(**values: Any) -> Callable[[dict[str, Any]], None]:
    return lambda header: header["settings"]["league"]["substeps"].update(values)


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        (setting(matches=5000), "a replay holds at most 8192 robots, 5000 matches have 10000"),
        (setting(matches=1 << 20), "a replay holds at most 8192 robots"),
        (setting(matches=4000), r"begins with robots of shape \[1, 2\], its settings say \[4000, 2\]"),
        (setting(matches=-5), "begins with robots of shape"),
        (setting(matches="many"), "the settings of this replay are damaged"),
        (setting(home=11), r"its settings say \[1, 12\]"),
        (setting(max_players=11), r"its settings say \[1, 22\]"),
        (setting(league=None), "the settings of this replay are damaged"),
        (substeps(least=10**9, close=10**9, most=10**9), "Substeps.least must be 1 to 1000, got 1000000000"),
        (substeps(iterations=2**31 - 1, jam_iterations=2**31 - 1), "Substeps.iterations must be 1 to 1000"),
        (substeps(most=1000, jam_iterations=1000), "most times jam_iterations must be at most 100000, got 1000000"),
    ],
)
def test_a_replay_that_asks_for_more_than_it_holds_is_refused(
    recorded: Path, change: Callable[[dict[str, Any]], None], complaint: str
) -> None:
    replay = Replay.read(forged(recorded, change))
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(ValueError, match=complaint):
        replay.check()
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert grown < 100_000, f"{grown} kB more memory"


def test_a_start_of_zeros_is_looked_at_before_anything_is_made(recorded: Path) -> None:
    path = forged(recorded, setting(matches=4000), start=np.zeros(100_000, np.uint8))
    with pytest.raises(ValueError, match="this is not a save of soccer_env, or it is damaged"):
        Replay.read(path).check()


def test_a_rebuild_of_one_match_over_and_over_is_refused(recorded: Path) -> None:
    match = Match(home=1, away=1, seed=1)
    recorder = Recorder(match)
    match.save()
    replay = recorder.stop()
    replay.log = [(step, rows * 1000, records) for step, rows, records in replay.log]
    with pytest.raises(ValueError, match="this replay is damaged: it rebuilds matches"):
        replay.check()


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="Windows has no such files")
def test_pipes_devices_and_folders_are_not_read(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for path, complaint in ((tmp_path / "pipe", "is not a regular file"), (Path("/dev/zero"), "is not a regular file"),
                            (tmp_path, "is a folder")):  # fmt: skip
        with pytest.raises(ValueError, match=f"is not a replay that can be read: {complaint}"):
            Replay.read(path)


def test_nobody_records_what_nobody_could_read() -> None:
    match = Match(home=1, away=1, seed=1)
    match.count = MOST_ROBOTS
    with pytest.raises(ValueError, match="a replay holds at most 8192 robots"):
        Recorder(match)
    assert match.recorder is None


def test_a_ball_that_would_pass_through_the_boards_is_refused() -> None:
    legged = find_league("legged-2001")
    replace(legged, ball=replace(legged.ball, top_speed=48.0))
    with pytest.raises(
        ValueError, match=r"BallModel.top_speed must be at most 48 with 12 substeps in 1/16 s, got 1000"
    ):
        replace(legged, ball=replace(legged.ball, top_speed=1000.0))
