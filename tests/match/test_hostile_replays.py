"""A stranger's replay, or one damaged at random, plays as a match of its size would, or is refused in a line."""

import io
import json
import os
import random
import resource
import zipfile
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
from soccer_env.train.command.command_line import main
from tests.scenes.staging import play


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    match = Match(home=1, away=1, seed=1)
    recorder = Recorder(match)
    play(match, steps=3)
    return recorder.stop().write(tmp_path_factory.mktemp("sound") / "a.replay").read_bytes()


@pytest.fixture
def recorded(tmp_path: Path, sound: bytes) -> Path:
    (tmp_path / "a.replay").write_bytes(sound)
    return tmp_path / "a.replay"


def parts_of(content: bytes) -> dict[str, Any]:
    with np.load(io.BytesIO(content)) as file:
        return {name: file[name] for name in file.files}


def packed(parts: dict[str, Any], header: Any = None) -> bytes:
    told = {} if header is None else {"header": np.frombuffer(json.dumps(header).encode(), np.uint8)}
    file = io.BytesIO()
    np.savez_compressed(file, **parts | told)
    return file.getvalue()


def forged(path: Path, change: Callable[[dict[str, Any]], None], **arrays: np.ndarray) -> Path:
    """Return a sound file whose header says something else."""
    parts = parts_of(path.read_bytes())
    header = json.loads(parts["header"].tobytes())
    change(header)
    other = path.with_name("forged.replay")
    other.write_bytes(packed(parts | arrays, header))
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
def test_a_replay_that_asks_for_more_than_it_holds_is_refused(recorded: Path, change: Any, complaint: str) -> None:
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
    said = r"BallModel.top_speed must be at most 48 with 12 substeps in 1/16 s, got 1000"
    with pytest.raises(ValueError, match=said):
        replace(legged, ball=replace(legged.ball, top_speed=1000.0))


FILES = 80


def damaged_bytes(content: bytes, draw: random.Random) -> bytes:
    """Cut the file short, or change some of its bytes."""
    if draw.random() < 0.3:
        return content[: draw.randrange(len(content))]
    found = bytearray(content)
    for _ in range(draw.choice([1, 1, 4, 30])):
        found[draw.randrange(len(found))] = draw.randrange(256)
    return bytes(found)


def test_a_damaged_replay_plays_or_is_refused_in_a_line(sound: bytes, tmp_path: Path, capsys: Any) -> None:
    draw, refused = random.Random(19), 0
    file, out = tmp_path / "a.replay", tmp_path / "out.csv"
    for number in range(FILES):
        file.write_bytes(damaged_bytes(sound, draw))
        out.unlink(missing_ok=True)
        code = main(["export", str(file), "--out", str(out), "--anew"])
        assert code in (0, 2), number
        said = capsys.readouterr().err.strip().splitlines()
        refused += code == 2
        if code == 2:
            assert len(said) == 1 and said[0].startswith("soccer: "), (number, said)
            assert not out.exists(), number
    assert refused > FILES // 4


@pytest.mark.parametrize("name", ["out.csv", "out.html", "out.png"])
def test_what_is_there_outlives_a_replay_that_cannot_be_read(sound: bytes, tmp_path: Path, name: str) -> None:
    file, out = tmp_path / "a.replay", tmp_path / name
    file.write_bytes(sound[:-40])
    out.write_text("mine")
    assert main(["export", str(file), "--out", str(out), "--anew"]) == 2
    assert out.read_text() == "mine"


def test_an_archive_that_unpacks_to_gigabytes_is_refused_unread(sound: bytes, tmp_path: Path) -> None:
    """A megabyte of zeros is a kilobyte in it."""
    path = tmp_path / "bomb.replay"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file, file.open("header.npy", "w") as part:
        for _ in range(600):
            part.write(bytes(1 << 20))
    assert path.stat().st_size < 1 << 20
    with pytest.raises(ValueError, match="it would unpack to 629145600 bytes"):
        Replay.read(path)


def test_an_array_that_says_it_is_huge_is_refused(sound: bytes, tmp_path: Path) -> None:
    path = tmp_path / "a.replay"
    with zipfile.ZipFile(path, "w") as file:
        for name, part in parts_of(sound).items():
            head, shape = io.BytesIO(), (1 << 44,) if name == "commands" else part.shape
            told = {"descr": np.lib.format.dtype_to_descr(part.dtype), "fortran_order": False, "shape": shape}
            np.lib.format.write_array_header_1_0(head, told)
            file.writestr(f"{name}.npy", head.getvalue() + part.tobytes())
    with pytest.raises(ValueError, match="is not a replay that can be read"):
        Replay.read(path)


def test_a_pickle_in_it_is_never_opened_and_files_cut_short_are_refused(sound: bytes, tmp_path: Path) -> None:
    path = tmp_path / "a.replay"
    with_trap = packed({**parts_of(sound), "commands": np.array([Trap()], object)})
    for content in (with_trap, b"", sound[:10], sound[:2000]):
        path.write_bytes(content)
        with pytest.raises(ValueError, match="is not a replay that can be read"):
            Replay.read(path)
    assert not Trap.opened


class Trap:
    """A thing that tells when it is taken out of a pickle."""

    opened = False

    def __reduce__(self) -> Any:
        return setattr, (Trap, "opened", True)


def test_a_replay_is_shown_in_one_plain_line_whoever_named_its_teams() -> None:
    teams = {"home_0": "\x1b[2J\x1b[31mred\nline", "away_0": "x" * 1000}
    replay = Replay({"teams": teams}, b"", np.zeros(0), np.zeros(0), [], [])
    shown = repr(replay)
    assert shown.isprintable() and len(shown) < 250
    assert shown.startswith(r"<Replay of \x1b[2J\x1b[31mred\nline against xxx")
