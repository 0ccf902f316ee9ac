"""A line as it stands in a folder, and as it was played again: what differs, bit for bit."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from soccer_env.checking import brief

DEEP = 2  # names of a field that stand by themselves: statistics.shots_for, maps.heat_for; the rest is counted
NOTHING = "nothing"


@dataclass(frozen=True)
class Difference:
    """A field of a match's line that is not what the match comes to."""

    pair: int
    match: int
    field: str  # statistics.shots_for
    there: str  # in the folder
    again: str  # played again
    more: int  # numbers of this field that differ beside the one that is shown

    def __str__(self) -> str:
        more = f", and {self.more} more of its numbers" if self.more else ""
        return f"match {self.match}: {self.field} is {self.there} there, {self.again} played again{more}"


def differences(there: dict[str, Any], again: dict[str, Any]) -> list[Difference]:
    """Return the fields in which two records of a match differ, each once; a number and its text are different."""
    both = [dict(leaves(record)) for record in (there, json.loads(json.dumps(again)))]
    fields: dict[tuple[Any, ...], list[tuple[tuple[Any, ...], str, str]]] = {}
    for place in dict.fromkeys([*both[0], *both[1]]):
        before, now = (text_of(record[place]) if place in record else NOTHING for record in both)
        if before != now:
            fields.setdefault(place[:DEEP], []).append((place, before, now))
    found = []
    for places in fields.values():
        place, before, now = places[0]
        name = ".".join(map(name_of, place))
        found.append(Difference(again["pair"], again["match"], name, before, now, len(places) - 1))
    return found


def leaves(value: Any, place: tuple[Any, ...] = ()) -> Iterator[tuple[tuple[Any, ...], Any]]:
    """Yield every value that is neither a table nor a list, with the names and numbers that lead to it.

    A table and a list are values themselves if nothing is in them.
    """
    if isinstance(value, (dict, list)) and value:
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from leaves(inner, (*place, key))
    else:
        yield place, value


def text_of(value: Any) -> str:
    """Return a value so that two texts are the same only if the values are, bit for bit."""
    return brief(value) if isinstance(value, str) and len(value) < 60 else json.dumps(value)[:200]


def name_of(key: Any) -> str:
    """Return a name on the way to a value as it can be printed."""
    return key if isinstance(key, str) and key.isidentifier() else brief(key)
