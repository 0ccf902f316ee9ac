"""What a folder of results says: conditions, what it was made with, and its lines. Nothing is changed or made."""

from __future__ import annotations

import json
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from soccer_env.checking import brief
from soccer_env.train.evaluate.results import EVALUATION, MATCHES, MatchLine
from soccer_env.train.files import records_in
from soccer_env.train.provenance import settings_hash
from soccer_env.train.results_folder import GROWN, PARTS, SETTINGS, check_kinds, settings_before
from soccer_env.whole_files import read_plain

RESULT = "result.json"
LARGEST = 1 << 30  # [bytes] of matches.jsonl and of result.json
MOST = 10_000_000  # matches


@dataclass(frozen=True)
class Found:
    """An evaluation as its folder tells of it."""

    path: Path
    conditions: dict[str, Any]
    made_with: dict[str, str]
    sizes: tuple[int, ...]  # matches that it asks for, and those that it asked for before it grew
    lines: dict[int, dict[str, Any]]  # of finished matches, by number
    result: dict[str, Any] | None  # what result.json says, if there is one

    @property
    def pairs(self) -> list[int]:
        """Return the finished pairs: those whose two matches both have a line."""
        return sorted(number // 2 for number in self.lines if number % 2 == 0 and number + 1 in self.lines)


def read_folder(path: Path) -> Found:
    """Return what a folder says; ValueError if it is none of an evaluation, or damaged."""
    if not path.is_dir():
        raise ValueError(f"{path} is no folder" if path.exists() else f"there is no folder {path}")
    result = read_result(path / RESULT)  # before the lines, from which it follows: an evaluation may go on just now
    before = settings_before(path, EVALUATION)
    if before is None:
        raise ValueError(f"{path} holds no evaluation: there is no {SETTINGS}")
    conditions, made_with, about = (before[part] for part in PARTS)
    matches = conditions.get("matches")
    if not isinstance(matches, int) or isinstance(matches, bool) or not 2 <= matches <= MOST or matches % 2:
        raise ValueError(f"{path / SETTINGS}: matches must be an even number of 2 to {MOST}, got {brief(matches)}")
    if not all(isinstance(value, str) for value in made_with.values()):
        raise ValueError(f"{path / SETTINGS}: what it was made with must be texts, got {brief(made_with)}")
    earlier = [size for size in about.get(GROWN) or () if isinstance(size, int) and not isinstance(size, bool)]
    sizes = (matches, *earlier)
    mine = {settings_hash({**conditions, "matches": size}, made_with) for size in sizes}
    lines = read_matches(path / MATCHES, matches, mine, conditions, made_with)
    return Found(path, conditions, made_with, sizes, lines, result)


def read_matches(
    path: Path, matches: int, mine: set[str], conditions: dict[str, Any], made_with: dict[str, str]
) -> dict[int, dict[str, Any]]:
    """Return the lines of finished matches, by number; those of this evaluation when it was smaller count as its own.

    ValueError for lines of another one, for a match that it has not, and for one that has two different lines.
    """
    current = settings_hash(conditions, made_with)
    names = sorted(field.name for field in fields(MatchLine))
    lines: dict[int, dict[str, Any]] = {}
    for record in records_in(path, read_plain(path, LARGEST))[0] if path.exists() else ():
        if sorted(record) != names:
            raise ValueError(f"{path}: a line has the fields {', '.join(names)}, got {brief(sorted(record))}")
        check_kinds(path, record, MatchLine)
        number = record["match"]
        if not 0 <= number < matches:
            raise ValueError(f"{path}: match must be 0 to {matches - 1}, got {number}")
        if record["settings"] not in mine:
            raise ValueError(f"{path}: match {number} belongs to other settings than those of {SETTINGS} beside it")
        record["settings"] = current
        if lines.setdefault(number, record) != record:
            raise ValueError(f"{path}: match {number} has two lines that differ")
    return lines


def read_result(path: Path) -> dict[str, Any] | None:
    """Return what a result.json says, None if there is none; ValueError if it cannot be read."""
    if not path.exists():
        return None
    try:
        found = json.loads(read_plain(path, LARGEST))
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{path} cannot be read as JSON ({error})") from error
    return found if isinstance(found, dict) else {}
