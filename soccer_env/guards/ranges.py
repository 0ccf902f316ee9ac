"""The allowed range of each number in a record, declared beside the field and stored in one table.

Kernels trust the numbers in records: they index and divide by them. Records from outside (a save, a replay, a pickle)
are compared with these ranges first, by `first_out_of_range`. A record without ranges, such as the memory of a user's
team, is not checked.
"""

import functools
from collections.abc import Iterator
from math import gcd, inf, pi
from typing import Any, NamedTuple

import numpy as np


class Range(NamedTuple):
    """The least and the greatest allowed number of a field; NaN is allowed only by the range ANY."""

    low: float
    high: float
    robots: bool = False  # True: `high` is added to the number of robots in the match
    ends: bool = False  # True: only the two ends themselves are allowed


FAR = 1e6  # no quantity of a match is larger; sums over a long match are
LONG = 1 << 30  # [steps] two years of play: more than any match lasts, and sums of two fit into 32 bits

ANY = Range(-inf, inf)  # all bits, NaN too: seeds, states of generators, memory of users' code
NUMBER = Range(-FAR, FAR)  # places, speeds, angles that are not wrapped, clocks that run down below 0
AMOUNT = Range(0.0, FAR)
SUM = Range(-1e12, 1e12)  # sums over a match
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
ROW = Range(0, -1, robots=True)  # row of a robot
ROW_OR_NONE = Range(-1, -1, robots=True)
ROW_FROM_ONE = Range(0, 0, robots=True)  # 1 + row, 0 for none

RANGES: dict[np.dtype, dict[str, Range]] = {}  # by record and field; a nested record has its own entry


def ranged_record(rows: list[tuple[Any, ...]]) -> np.dtype:
    """Return the record dtype of fields (name, type, range) or (name, type, range, shape), and store the ranges.

    A nested record has ranges of its own: (name, RECORD) or (name, RECORD, shape).
    """
    ranges = {row[0]: row[2] for row in rows if len(row) > 2 and isinstance(row[2], Range)}
    for name, kind, *_ in rows:
        if name not in ranges and kind not in RANGES:
            raise TypeError(f"field {name!r} of a record has no range")
    dtype = np.dtype([(row[0], row[1], *row[3:]) if row[0] in ranges else row for row in rows])
    if RANGES.setdefault(dtype, ranges) != ranges:
        raise TypeError(f"another record has the same fields as {dtype}, and other ranges")
    return dtype


class NumberPlace(NamedTuple):
    """The location of a single number in a record: its path, type, position and range."""

    path: str  # "command.pan"
    kind: np.dtype
    start: int  # [bytes] from the start of the record
    range: Range | None  # None: declared without a range


def number_places(dtype: np.dtype, path: str = "", start: int = 0) -> Iterator[NumberPlace]:
    """Yield the location of every number in a record, including nested records and arrays."""
    ranges = RANGES.get(dtype, {})
    for name, (field, offset, *_) in (dtype.fields or {}).items():
        for at in range(start + offset, start + offset + field.itemsize, field.base.itemsize or 1):
            if field.base.names is None or name in ranges:
                yield NumberPlace(path + name, field.base, at, ranges.get(name))
            else:
                yield from number_places(field.base, f"{path}{name}.", at)


class Columns(NamedTuple):
    """All numbers of one type in a record, with their ranges."""

    kind: np.dtype
    word: np.dtype  # unsigned type that cuts a record into pieces of equal size
    pieces: np.ndarray  # indices of the pieces that make up the numbers, in order
    low: np.ndarray
    high: np.ndarray
    ends: np.ndarray  # indices of numbers that must equal `low` or `high`
    paths: list[str]


@functools.lru_cache(maxsize=256)
def columns_of(dtype: np.dtype, robots: int) -> list[Columns]:
    """Return `Columns` for each number type in a record, in a match of `robots` robots."""
    by_type: dict[np.dtype, list[NumberPlace]] = {}
    for place in number_places(dtype):
        if place.range is not None and place.range != ANY:
            by_type.setdefault(place.kind, []).append(place)
    return [columns(dtype, kind, numbers, robots) for kind, numbers in by_type.items()]


def columns(dtype: np.dtype, kind: np.dtype, numbers: list[NumberPlace], robots: int) -> Columns:
    """Return the `Columns` of numbers that all have the type `kind`, with their ranges."""
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


def first_out_of_range(records: np.ndarray, robots: int) -> str:
    """Return the name of the first field of records with a number out of its range; "" if all are in range."""
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
