"""Files of lines that survive a crash: a torn last line is dropped."""

import json
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from soccer_env.guards.whole_files import read_regular_file

LARGEST = 1 << 30  # [bytes] of a file of results


def append_lines(path: Path, records: Iterable[dict[str, Any]]) -> None:
    """Append one line of JSON for each record and wait until they are on the disk."""
    with path.open("ab") as file:
        for record in records:
            file.write(json.dumps(record).encode() + b"\n")
            file.flush()
        os.fsync(file.fileno())


def read_bounded(path: Path) -> bytes:
    """Return the contents of a file of results; ValueError if it is no regular file, or larger than LARGEST."""
    try:
        return read_regular_file(path, LARGEST)
    except ValueError as error:
        raise ValueError(f"{path} {error}") from error


def read_lines(path: Path) -> list[dict[str, Any]]:
    """Return the records of a file of JSON lines, and cut off a last line torn by a crash; [] without a file.

    ValueError for any other line that is not JSON: the file was edited or the disk is broken.
    """
    if not path.exists():
        return []
    content = read_bounded(path)
    records, complete = records_in(path, content)
    if complete < len(content):
        os.truncate(path, complete)
    return records


def records_in(path: Path, content: bytes) -> tuple[list[dict[str, Any]], int]:
    """Return the records of JSON lines, and the length of all complete lines [bytes].

    ValueError for a line without a record, except the last line, which a crash may have torn.
    """
    complete, records = 0, []
    lines = content.splitlines(keepends=True)
    for number, line in enumerate(lines, 1):
        record = _parse(line)
        if record is None:
            if number < len(lines):
                raise ValueError(f"{path}, line {number}: not a record: {line[:60]!r}")
            break
        records.append(record)
        complete += len(line)
    return records, complete


def _parse(line: bytes) -> dict[str, Any] | None:
    """Return the record of a line of JSON; None if the line is incomplete."""
    if not line.endswith(b"\n"):
        return None
    try:
        record = json.loads(line)
    except (ValueError, RecursionError):
        return None
    return record if isinstance(record, dict) else None
