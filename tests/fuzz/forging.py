"""Saves whose numbers somebody has changed, with a header and a hash that are right: as an attacker makes them."""

from __future__ import annotations

import hashlib
import json
import random
from collections.abc import Iterator
from math import inf, nan, nextafter
from typing import Any, NamedTuple

import numpy as np

from soccer_env import saving
from soccer_env.ranges import Place, Range, places
from soccer_env.saving.saves import MAGIC, kept

WHOLE = (-1, 0, 1, 2, 3, 4, 5, 7, 127, 1000, 1 << 31, (1 << 31) - 1, 2_000_000, 10**11)
BROKEN = (nan, inf, -inf, 1e308, -1e308, 5e-324, -5e-324, 0.0, -0.0, 1.0, -1.0, 1e-12, 1e-300, 0.5, 3.141592653589794)


class Part(NamedTuple):
    """An array of a save."""

    name: str
    dtype: np.dtype
    count: int  # records
    start: int  # [bytes] where it begins


def parts_of(saved: bytes, match: Any, memory: bool) -> list[Part]:
    """Return the arrays that a save of a match holds, without those of no bytes."""
    _, start, header = saving.open_save(saved)
    found = []
    for name, array in kept(match, memory).items():
        shape = next(shape for other, _, shape, _ in header["parts"] if other == name)
        count = int(np.prod(shape))
        if count * array.dtype.itemsize:
            found.append(Part(name, array.dtype, count, start))
        start += count * array.dtype.itemsize
    return found


def numbers_of(dtype: np.dtype) -> list[Place]:
    """Return the numbers of a record, an array itself as one without a name."""
    return list(places(dtype)) or [Place("", dtype, 0, None)]


def hostile(place: Place, robots: int, draw: random.Random) -> Any:
    """Return a number that may do harm in a field: at the ends of its type or its range, just beyond, or odd."""
    kind, bounds = place.kind, place.range or Range(0, 1)
    low, high = bounds.low, bounds.high + robots * bounds.robots
    if kind.kind == "f":
        least, most = max(low, -1e300), min(high, 1e300)
        near = [low, high, nextafter(low, -inf), nextafter(high, inf), nextafter(low, inf), nextafter(high, -inf)]
        return draw.choice([*near, *near, draw.uniform(least, most), draw.gauss(0.0, 3.0), draw.choice(BROKEN)])
    if kind.kind not in "iu":
        return draw.randrange(256)
    ends = np.iinfo(kind)
    low, high = int(max(low, ends.min)), int(min(high, ends.max))
    near = [low, high, low - 1, high + 1, low + 1, high - 1, draw.randint(low, high)]
    value = draw.choice([*near, *near, *WHOLE, robots - 1, robots, robots + 1, int(ends.min), int(ends.max)])
    return min(max(value, int(ends.min)), int(ends.max))


def changed(saved: bytes, parts: list[Part], robots: int, draw: random.Random) -> tuple[bytes, str]:
    """Return a save with one to four hostile numbers, and words for what they are."""
    content, told = bytearray(saved[:-32]), []
    for _ in range(draw.choice([1, 1, 1, 1, 2, 4])):
        part = draw.choice(parts)
        numbers = numbers_of(part.dtype)
        path = draw.choice(sorted({place.path for place in numbers}))
        chosen = [place for place in numbers if place.path == path]
        value = hostile(chosen[0], robots, draw)
        everywhere = draw.random() < 0.3
        for record in range(part.count) if everywhere else [draw.randrange(part.count)]:
            for place in chosen if everywhere else [draw.choice(chosen)]:
                put(content, part.start + record * part.dtype.itemsize + place.start, place.kind, value)
        told.append(f"{part.name}.{path} = {value!r}{' everywhere' if everywhere else ''}")
    return sealed(bytes(content)), ", ".join(told)


def put(content: bytearray, at: int, kind: np.dtype, value: Any) -> None:
    """Write a number into a save."""
    with np.errstate(all="ignore"):
        raw = np.array(value, "u1" if kind.kind == "b" else kind).tobytes()
    content[at : at + len(raw)] = raw


def sealed(body: bytes) -> bytes:
    """Return a save with the hash of its content."""
    return body + hashlib.sha256(body).digest()


def with_header(saved: bytes, header: Any) -> bytes:
    """Return a save with another header, a value or its bytes."""
    body, start, _ = saving.open_save(saved)
    raw = header if isinstance(header, bytes) else json.dumps(header).encode()
    return sealed(MAGIC + len(raw).to_bytes(4, "little") + raw + body[start:])


def floats(records: np.ndarray) -> Iterator[tuple[str, np.ndarray]]:
    """Yield all numbers with a fraction that records hold, with their names."""
    for name in records.dtype.names or ():
        if records[name].dtype.names:
            yield from ((f"{name}.{inner}", values) for inner, values in floats(records[name]))
        elif records[name].dtype.kind == "f":
            yield name, records[name]


def not_a_number(match: Any) -> str:
    """Return the first field of a match's records that holds NaN, "" if none does."""
    for name, array in kept(match, memory=True).items():
        for path, values in floats(array):
            if np.isnan(values).any():
                return f"NaN in {path} of {name}"
    return "NaN in observations" if np.isnan(match.observations).any() else ""
