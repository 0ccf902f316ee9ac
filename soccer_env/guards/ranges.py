"""What the fields of records may hold: a range stands beside each field, and one table answers for all records.

Kernels trust what lies in records: they index by it and divide by it. Whatever brings records in from outside (a save,
a replay, a pickle) compares them with these ranges first, by `outside`. A record that declares none, such as the memory
of a team of one's own, is left alone: what its author's code bears, its author knows.
"""

import functools
from collections.abc import Iterator
from math import gcd, inf, pi
from typing import Any, NamedTuple

import numpy as np


class Range(NamedTuple):
    """The least and the greatest number that a field may hold; NaN lies in no range but ANY."""

    low: float
    high: float
    robots: bool = False  # True: `high` is counted on from the number of robots of the match
    ends: bool = False  # True: only the two ends themselves


FAR = 1e6  # no quantity of a match is larger; sums over a long match are
LONG = 1 << 30  # [steps] two years of play: more than any match lasts, and sums of two fit into 32 bits

ANY = Range(-inf, inf)  # all bits, NaN too: seeds, states of generators, what a user's own code keeps
NUMBER = Range(-FAR, FAR)  # places, speeds, angles that are not wrapped, clocks that run down below 0
AMOUNT = Range(0.0, FAR)
SUM = Range(-1e12, 1e12)  # what adds up over a match
ENDLESS = Range(0.0, inf)
SHARE = Range(0.0, 1.0)
UNIT = Range(-1.0, 1.0)
CONFIDENCE = Range(0.0, 100.0)
ANGLE = Range(-pi, pi)  # [rad]
SIGN = Range(-1, 1, ends=True)
FLAG = Range(0, 1)
COUNT = Range(0, LONG)
STEP = Range(0, LONG)
LATELY = Range(-LONG, LONG)  # a step, or LONG_AGO
ROW = Range(0, -1, robots=True)  # of a robot
ROW_OR_NONE = Range(-1, -1, robots=True)
ROW_FROM_ONE = Range(0, 0, robots=True)  # 1 + row, 0 for none

RANGES: dict[np.dtype, dict[str, Range]] = {}  # of the fields of each record; one that is a record has its own entry


def record(rows: list[tuple[Any, ...]]) -> np.dtype:
    """Return the dtype of fields (name, type, range) or (name, type, range, shape), and note their ranges.

    A field that is a record gets none, as its own fields have theirs: (name, RECORD) or (name, RECORD, shape).
    """
    ranges = {row[0]: row[2] for row in rows if len(row) > 2 and isinstance(row[2], Range)}
    for name, kind, *_ in rows:
        if name not in ranges and kind not in RANGES:
            raise TypeError(f"field {name!r} of a record has no range")
    dtype = np.dtype([(row[0], row[1], *row[3:]) if row[0] in ranges else row for row in rows])
    if RANGES.setdefault(dtype, ranges) != ranges:
        raise TypeError(f"another record has the same fields as {dtype}, and other ranges")
    return dtype


class Place(NamedTuple):
    """One number of a record."""

    path: str  # "command.pan"
    kind: np.dtype
    start: int  # [bytes] from the record's first
    range: Range | None  # None: it was declared without


def places(dtype: np.dtype, path: str = "", start: int = 0) -> Iterator[Place]:
    """Yield all numbers of a record, those of its records and arrays too."""
    ranges = RANGES.get(dtype, {})
    for name, (field, offset, *_) in (dtype.fields or {}).items():
        for at in range(start + offset, start + offset + field.itemsize, field.base.itemsize or 1):
            if field.base.names is None or name in ranges:
                yield Place(path + name, field.base, at, ranges.get(name))
            else:
                yield from places(field.base, f"{path}{name}.", at)


class Columns(NamedTuple):
    """All numbers of one type that a record holds, and the ranges of each."""

    kind: np.dtype
    word: np.dtype  # as which a record is cut into pieces of equal size
    pieces: np.ndarray  # those that the numbers consist of, in a row
    low: np.ndarray
    high: np.ndarray
    ends: np.ndarray  # which numbers are only one of the two
    paths: list[str]


@functools.lru_cache(maxsize=256)
def columns_of(dtype: np.dtype, robots: int) -> list[Columns]:
    """Return the numbers of a record that have ranges, by type, for a match of so many robots."""
    by_type: dict[np.dtype, list[Place]] = {}
    for place in places(dtype):
        if place.range is not None and place.range != ANY:
            by_type.setdefault(place.kind, []).append(place)
    return [columns(dtype, kind, numbers, robots) for kind, numbers in by_type.items()]


def columns(dtype: np.dtype, kind: np.dtype, numbers: list[Place], robots: int) -> Columns:
    """Return numbers of one type with their ranges, as arrays to compare with."""
    size = gcd(kind.itemsize, dtype.itemsize, *(place.start for place in numbers))
    starts = np.array([place.start for place in numbers]) // size
    pieces = (starts[:, None] + np.arange(kind.itemsize // size)).ravel()
    ranges = [place.range for place in numbers if place.range is not None]
    low = np.array([one.low for one in ranges])
    high = np.array([one.high + robots * one.robots for one in ranges])
    if kind.kind in "iu":
        most = np.iinfo(kind)
        low, high = (np.clip(ends, most.min, most.max).astype(kind) for ends in (low, high))
    ends = np.flatnonzero([one.ends for one in ranges])
    return Columns(kind, np.dtype(f"u{size}"), pieces, low, high, ends, [place.path for place in numbers])


def outside(records: np.ndarray, robots: int) -> str:
    """Return the first field of records, of a match of so many robots, that is out of its range; "" if none is."""
    if records.dtype == bool:
        return "" if (records.view(np.uint8) <= 1).all() else "a flag"
    if not records.size:
        return ""
    flat = np.ascontiguousarray(records).reshape(-1)
    for kind, word, pieces, low, high, ends, paths in columns_of(records.dtype, robots):
        numbers = flat.view(word).reshape(len(flat), -1).take(pieces, axis=1).view(kind)
        well = (numbers >= low) & (numbers <= high)
        if len(ends):
            well[:, ends] &= (numbers[:, ends] == low[ends]) | (numbers[:, ends] == high[ends])
        if not well.all():
            return paths[int(np.flatnonzero(~well.all(axis=0))[0])]
    return ""
