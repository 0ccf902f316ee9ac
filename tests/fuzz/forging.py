"""Saves whose numbers somebody has changed, with a header and a hash that are right: as an attacker makes them."""

from __future__ import annotations

import functools
import hashlib
import json
import random
from math import inf, nan, nextafter
from typing import Any, NamedTuple

import numpy as np

from soccer_env.guards.ranges import ANY, Columns, NumberPlace, Range, columns, number_places
from soccer_env.match import saving
from soccer_env.match.saving.saves import saved_arrays
from soccer_env.records.save_file import MAGIC

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
    for name, array in saved_arrays(match, memory).items():
        shape = next(shape for other, _, shape, _ in header["parts"] if other == name)
        count = int(np.prod(shape))
        if count * array.dtype.itemsize:
            found.append(Part(name, array.dtype, count, start))
        start += count * array.dtype.itemsize
    return found


@functools.cache
def numbers_of(dtype: np.dtype) -> dict[str, list[NumberPlace]]:
    """Return the numbers of a record by their path, an array itself as one without a name."""
    found: dict[str, list[NumberPlace]] = {}
    for place in list(number_places(dtype)) or [NumberPlace("", dtype, 0, None)]:
        found.setdefault(place.path, []).append(place)
    return found


def hostile(place: NumberPlace, robots: int, draw: random.Random) -> Any:
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
        path = draw.choice(sorted(numbers))
        chosen = numbers[path]
        value = hostile(chosen[0], robots, draw)
        everywhere = draw.random() < 0.3
        for record in range(part.count) if everywhere else [draw.randrange(part.count)]:
            for place in chosen if everywhere else [draw.choice(chosen)]:
                put(content, part.start + record * part.dtype.itemsize + place.start, place.kind, value)
        told.append(f"{part.name}.{path} = {value!r}{' everywhere' if everywhere else ''}")
    return sealed(bytes(content)), ", ".join(told)


def put(content: bytearray, at: int, kind: np.dtype, value: Any) -> None:
    with np.errstate(all="ignore"):
        raw = np.array(value, "u1" if kind.kind == "b" else kind).tobytes()
    content[at : at + len(raw)] = raw


def sealed(body: bytes) -> bytes:
    return body + hashlib.sha256(body).digest()


def with_header(saved: bytes, header: Any) -> bytes:
    """Return a save with another header, a value or its bytes."""
    body, start, _ = saving.open_save(saved)
    raw = header if isinstance(header, bytes) else json.dumps(header).encode()
    return sealed(MAGIC + len(raw).to_bytes(4, "little") + raw + body[start:])


@functools.cache
def fractions_of(dtype: np.dtype) -> list[Columns]:
    """Return the numbers with a fraction that a record holds, by type."""
    numbers = [place._replace(range=ANY) for place in number_places(dtype) if place.kind.kind == "f"]
    kinds = {place.kind for place in numbers}
    return [columns(dtype, kind, [place for place in numbers if place.kind == kind], 0) for kind in kinds]


def not_a_number(match: Any) -> str:
    """Return the first field of a match's records that holds NaN, "" if none does."""
    for name, array in saved_arrays(match, memory=True).items():
        flat = np.ascontiguousarray(array).reshape(-1)
        for kind, word, pieces, *_, paths in fractions_of(array.dtype) if flat.nbytes else ():
            wrong = np.isnan(flat.view(word).reshape(len(flat), -1).take(pieces, axis=1).view(kind)).any(axis=0)
            if wrong.any():
                return f"NaN in {paths[int(wrong.argmax())]} of {name}"
    return "NaN in observations" if np.isnan(match.observations).any() else ""
