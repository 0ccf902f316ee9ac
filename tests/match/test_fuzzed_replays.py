"""Replays that were damaged at random: each plays, or is refused in a line with exit code 2, and nothing is written."""

import io
import json
import random
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, shows
from soccer_env.replay import Recorder, Replay
from soccer_env.train.command.command_line import main

FILES = 240  # damaged, a third of them in each way
ODD = [
    None, True, -1, 0, 1, 2**31, 2**63, 2**70, -(2**63), 1e308, float("inf"), float("nan"), "", "x", "../../x", [], {},
    [[]], [1] * 40, {"a": 1}, "\x00", "<script>", "9" * 400,
]  # fmt: skip
DTYPES = ["u1", "i1", "i8", "f4", "f8", "c16", "S3", "U2", "M8[s]", "?", [("a", "f8"), ("b", "i4")]]


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """Return the bytes of a replay of a few steps."""
    match = Match(home=1, away=1, seed=1)
    recorder = Recorder(match)
    for _ in range(2):
        match.step(np.zeros((1, 2, 4)))
    return recorder.stop().write(tmp_path_factory.mktemp("sound") / "a.replay").read_bytes()


def parts_of(content: bytes) -> dict[str, np.ndarray]:
    with np.load(io.BytesIO(content)) as file:
        return {name: file[name] for name in file.files}


def packed(parts: dict[str, Any]) -> bytes:
    file = io.BytesIO()
    np.savez_compressed(file, **parts)
    return file.getvalue()


def damaged_bytes(content: bytes, draw: random.Random) -> bytes:
    """Cut the file short, or change some of its bytes."""
    if draw.random() < 0.3:
        return content[: draw.randrange(len(content))]
    found = bytearray(content)
    for _ in range(draw.choice([1, 1, 4, 30])):
        found[draw.randrange(len(found))] = draw.randrange(256)
    return bytes(found)


def damaged_header(content: bytes, draw: random.Random) -> bytes:
    """Put something odd in place of a value of the header, anywhere in it."""
    parts = parts_of(content)
    header = json.loads(parts["header"].tobytes())
    places = [*places_in(header)]
    inside, key = draw.choice(places)
    inside[key] = draw.choice(ODD)
    parts["header"] = np.frombuffer(json.dumps(header).encode(), np.uint8)
    return packed(parts)


def places_in(value: Any) -> Iterator[tuple[Any, Any]]:
    """Yield every place of a value in a tree of dicts and lists."""
    for key in list(value) if isinstance(value, dict) else range(len(value)):
        yield value, key
        if isinstance(value[key], (dict, list)):
            yield from places_in(value[key])


def damaged_part(content: bytes, draw: random.Random) -> bytes:
    """Give a part another type, another shape or odd numbers, or leave it out."""
    parts = parts_of(content)
    name = draw.choice([*parts])
    part, how = parts[name], draw.randrange(6)
    if how == 0:
        del parts[name]
    elif how == 1:
        parts[name] = np.zeros(part.shape, draw.choice(DTYPES))
    elif how == 2:
        parts[name] = part[..., :-1] if part.ndim else part
    elif how == 3:
        parts[name] = np.concatenate([part, part]) if part.ndim else part
    else:
        changed = part.copy().reshape(-1)
        raw = changed.view(np.uint8)
        for _ in range(draw.choice([1, 8])):
            raw[draw.randrange(len(raw))] = draw.randrange(256)
        parts[name] = changed.reshape(part.shape)
    return packed(parts)


@pytest.mark.parametrize("damage", [damaged_bytes, damaged_header, damaged_part])
def test_a_damaged_replay_plays_or_is_refused_in_a_line(
    damage: Any, sound: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    draw, refused = random.Random(19), 0
    file, out = tmp_path / "a.replay", tmp_path / "out.csv"
    for number in range(FILES // 3):
        file.write_bytes(damage(sound, draw))
        out.unlink(missing_ok=True)
        code = main(["export", str(file), "--out", str(out), "--anew"])
        assert code in (0, 2), number
        said = capsys.readouterr().err.strip().splitlines()
        refused += code == 2
        if code == 2:
            assert len(said) == 1 and said[0].startswith("soccer: "), (number, said)
            assert not out.exists(), number
    assert refused > FILES // 12


@pytest.mark.parametrize("name", ["out.csv", "out.xml", "out.html", "out.png"])
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
    path, parts = tmp_path / "a.replay", parts_of(sound)
    path.write_bytes(packed(parts))
    with zipfile.ZipFile(path, "w") as file:
        for name, part in parts.items():
            head = io.BytesIO()
            shape = (1 << 44,) if name == "commands" else part.shape
            np.lib.format.write_array_header_1_0(
                head, {"descr": np.lib.format.dtype_to_descr(part.dtype), "fortran_order": False, "shape": shape}
            )
            file.writestr(f"{name}.npy", head.getvalue() + part.tobytes())
    with pytest.raises(ValueError, match="is not a replay that can be read"):
        Replay.read(path)


def test_a_pickle_in_it_is_never_opened(sound: bytes, tmp_path: Path) -> None:
    parts: dict[str, Any] = {**parts_of(sound), "commands": np.array([Trap()], object)}
    path = tmp_path / "a.replay"
    path.write_bytes(packed(parts))
    with pytest.raises(ValueError, match="is not a replay that can be read"):
        Replay.read(path)
    assert not Trap.opened


class Trap:
    """A thing that tells when it is taken out of a pickle."""

    opened = False

    def __reduce__(self) -> Any:
        return setattr, (Trap, "opened", True)


def test_a_replay_of_another_version_says_which(sound: bytes, tmp_path: Path) -> None:
    parts = parts_of(sound)
    header = json.loads(parts["header"].tobytes()) | {"format": "soccer_env replay 1", "version": "0.0.9"}
    path = tmp_path / "old.replay"
    path.write_bytes(packed(parts | {"header": np.frombuffer(json.dumps(header).encode(), np.uint8)}))
    with pytest.raises(ValueError, match=r"its format is 'soccer_env replay 1', written by soccer_env 0\.0\.9"):
        Replay.read(path)


def test_a_page_escapes_names_that_came_from_a_file(sound: bytes, tmp_path: Path) -> None:
    hostile = '</script><script>alert("&")</script><b onclick=x>'
    parts = parts_of(sound)
    header = json.loads(parts["header"].tobytes())
    header["settings"]["teams"] = {"home_0": hostile, "away_0": "\u2028" + hostile}
    path = tmp_path / "a.replay"
    path.write_bytes(packed(parts | {"header": np.frombuffer(json.dumps(header).encode(), np.uint8)}))
    plain, page = tmp_path / "plain.html", shows.html(Replay.read(path), tmp_path / "x.html").read_text()
    (tmp_path / "b.replay").write_bytes(sound)
    shows.html(Replay.read(tmp_path / "b.replay"), plain)
    assert hostile not in page
    assert "alert(" in page
    assert "<b onclick" not in page
    assert page.count("<script") == plain.read_text().count("<script")
