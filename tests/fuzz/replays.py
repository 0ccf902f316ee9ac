"""Replays that somebody has changed: records, commands, thoughts, settings and the header itself."""

from __future__ import annotations

import io
import json
import random
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest.mock import patch

import numpy as np

from soccer_env import Match, shows
from soccer_env.guards.ranges import UNIT, NumberPlace
from soccer_env.match import saving
from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.train.command.command_line import main
from tests.fuzz.children import Task
from tests.fuzz.forging import BROKEN, changed, hostile, not_a_number, parts_of, with_header

SETTINGS: dict[str, dict[str, Any]] = {
    "legged": {"home": 2, "away": 1, "controllers": {"home": "sacks-2001", "away": "chaser"}},
    "middle": {"league": "middle-size-2006", "home": 1, "away": 2,
               "controllers": {"away": "heinemann-2006", "home": "random"}},
}  # fmt: skip
ODD: list[Any] = [
    None, True, False, -1, 0, 1, 2, 3, 10**6, 2**31, 2**63, 2**64, 10**30, -(2**63), 1e308, -1e308, 5e-324, 1e-9,
    float("inf"), float("-inf"), float("nan"), "", "x", "nan", "inf", "-1", "0", "chaser", "legged-2001", "../../x",
    [], {}, [[]], [0], [1] * 40, [None], {"a": 1}, "\x00", "<script>", "9" * 400, "x" * 1_000_000, [[0, [0]]] * 9,
]  # fmt: skip
DEEP = "[" * 100_000
WAYS = ("start", "log", "commands", "gazes", "header", "header", "header", "text", "thoughts", "about", "save header")
HOW = ("play", "play", "page", "csv", "cdf")


class Agreed(str):
    """A hash that every play agrees with: whoever forges a replay computes the hashes as well."""

    __slots__ = ()

    def __ne__(self, other: object) -> bool:
        return False

    __hash__ = str.__hash__


@dataclass
class Source:
    """The parts of a sound replay, and the match that it begins with."""

    name: str
    parts: dict[str, np.ndarray]
    match: Match
    folder: Path

    def forge(self, number: int, draw: random.Random) -> tuple[str, Task]:
        """Return words for a forged replay, and the task to read it, play it and write it as something else."""
        parts, way = dict(self.parts), draw.choice(WAYS)
        told = FORGERS[way](self, parts, draw)
        path = self.folder / f"{number % 16}.replay"
        how = draw.choice(HOW)
        return f"{self.name} replay as {how}, {way}: {told}", lambda: use(parts, path, how)


def make_source(name: str, folder: Path) -> Source:
    """Return a replay of a lively match, its physics rebuilt once on the way."""
    match = Match(**SETTINGS[name], seed=3)
    for _ in range(40):
        match.step()
    recorder = Recorder(match, Thoughts(match))
    for step in range(24):
        match.step()
        if step == 11:
            match.save()
    with np.load(io.BytesIO(recorder.stop().write(folder / f"{name}.replay").read_bytes())) as file:
        parts = {part: file[part] for part in file.files}
    for how in HOW:  # here, so that children find all code compiled and loaded
        use(parts, folder / "sound.replay", how)
    return Source(name, parts, match, folder)


def records(source: Source, parts: dict[str, np.ndarray], draw: random.Random, name: str) -> str:
    """Forge the records of the start, or of the rebuild."""
    saved = parts[name].tobytes()
    forged, told = changed(saved, parts_of(saved, source.match, memory=False), len(source.match.agents), draw)
    parts[name] = np.frombuffer(forged, np.uint8)
    return told


def commands(source: Source, parts: dict[str, np.ndarray], draw: random.Random, name: str) -> str:
    """Put a hostile number into commands or gazes."""
    numbers = parts[name].copy()
    value = hostile(NumberPlace("", np.dtype("f8"), 0, UNIT), 3, draw)
    at = tuple(draw.randrange(size) for size in numbers.shape)
    numbers[at if draw.random() < 0.7 else ...] = value
    parts[name] = numbers
    return f"{at} = {value!r}"


def header(source: Source, parts: dict[str, np.ndarray], draw: random.Random, name: str = "header") -> str:
    """Change a value of the header, leave it out, or add one."""
    found = json.loads(parts[name].tobytes())
    told = oddly(found, draw)
    parts[name] = np.frombuffer(json.dumps(found).encode(), np.uint8)
    return told


def oddly(found: Any, draw: random.Random) -> str:
    """Change a value somewhere in a tree of values; return words for it."""
    inside, key, path = draw.choice([*places_in(found)])
    if draw.random() < 0.15 and isinstance(inside, dict):
        del inside[key]
        return f"without {path}"
    if draw.random() < 0.05 and isinstance(inside, dict):
        inside[f"{key}_"] = inside[key]
        return f"{path} twice"
    value, was = draw.choice(ODD), inside[key]
    if isinstance(was, (int, float)) and not isinstance(was, bool) and draw.random() < 0.6:
        value = draw.choice([was * 1.5, was * 1e3, was * 1e-3, -was, was + 1, was - 1, was * 1e9, *BROKEN])
        value = int(value) if isinstance(was, int) and abs(value) < 1e18 else value
    inside[key] = value
    return f"{path} = {value!r:.60}"


def places_in(value: Any, path: str = "") -> Iterator[tuple[Any, Any, str]]:
    """Yield every place of a value in a tree of dicts and lists."""
    for key in list(value) if isinstance(value, dict) else range(len(value)):
        yield value, key, f"{path}/{key}"
        if isinstance(value[key], (dict, list)):
            yield from places_in(value[key], f"{path}/{key}")


def text(source: Source, parts: dict[str, np.ndarray], draw: random.Random) -> str:
    """Change the header's text: keys twice, values too deep, cut off."""
    said = parts["header"].tobytes().decode()
    way = draw.choice(["deep", "twice", "cut", "bytes", "long number"])
    at = draw.randrange(1, len(said))
    if way == "twice":
        said = said[:-1] + ', "settings": ' + draw.choice(["{}", "null", "[]", DEEP]) + "}"
    elif way == "deep":
        said = said.replace('"log": ', '"log": ' + draw.choice([DEEP, '{"a":' * 50_000, DEEP + "]" * 100_000 + ","]))
    elif way == "long number":
        said = said.replace('"matches": 1', '"matches": ' + "1" * draw.choice([400, 5000, 100_000]))
    else:
        said = said[:at] + ("" if way == "cut" else draw.choice('",:[]{}0-\\\x00é') + said[at + 1 :])
    parts["header"] = np.frombuffer(said.encode(), np.uint8)
    return f"{way} at {at}"


def thoughts(source: Source, parts: dict[str, np.ndarray], draw: random.Random) -> str:
    """Change numbers, type or shape of the notes."""
    notes = parts["thoughts"].copy()
    way = draw.choice(["numbers", "all", "type", "shape", "gone"])
    if way == "numbers":
        for _ in range(20):
            notes[tuple(draw.randrange(size) for size in notes.shape)] = draw.choice([-32768, 32767, -1, 0, 1, 255])
    elif way == "all":
        notes[...] = draw.choice([-32768, 32767, -1, 1])
    elif way == "type":
        notes = notes.astype(draw.choice(["i8", "f8", "u2", "S2", "?"]))
    elif way == "shape":
        notes = draw.choice([notes[:, :-1], notes[..., :-1], notes[:-1], notes[..., :0], notes.ravel(), notes[:0]])
    parts["thoughts"] = notes
    if way == "gone":
        del parts[draw.choice(["thoughts", "thoughts_about"])]
    return way


def save_header(source: Source, parts: dict[str, np.ndarray], draw: random.Random) -> str:
    """Change the header of the save that a replay begins with."""
    saved = parts["start"].tobytes()
    found = saving.open_save(saved)[2]
    told = oddly(found, draw)
    parts["start"] = np.frombuffer(with_header(saved, DEEP.encode() if draw.random() < 0.05 else found), np.uint8)
    return told


FORGERS: dict[str, Any] = {
    "start": lambda *given: records(*given, "start"),
    "log": lambda source, parts, draw: records(source, parts, draw, next(n for n in parts if n.startswith("records"))),
    "commands": lambda *given: commands(*given, "commands"),
    "gazes": lambda *given: commands(*given, "gazes"),
    "header": header,
    "about": lambda *given: header(*given, "thoughts_about"),
    "text": text,
    "thoughts": thoughts,
    "save header": save_header,
}


def use(parts: dict[str, np.ndarray], path: Path, how: str) -> str:
    """Write a replay's parts as a file, read it, and play it or write it as something else; return what is wrong."""
    with path.open("wb") as file:
        np.savez(file, **parts)  # type: ignore[arg-type]  # numpy's stubs take them for allow_pickle
    with patch.object(saving, "play_hash", lambda match: Agreed()):
        if how in ("csv", "cdf"):
            code = main(["export", str(path), "--out", str(path.with_suffix(f".{how}")), "--anew"])
            return "" if code == 0 else refuse(code)
        replay = Replay.read(path)
        str(replay), repr(replay)
        if how == "page":
            shows.html(replay, path.with_suffix(".html"), anew=True)
            return ""
        replay.notes()
        return "".join(not_a_number(match) for match in replay.play())


def refuse(code: int) -> str:
    """Return what is wrong with an exit code, raise ValueError for that of a plain refusal."""
    if code == 2:
        raise ValueError("refused")
    return f"exit code {code}"
