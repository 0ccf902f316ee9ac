"""What an observation is: named numbers in [-1, 1]."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from soccer_env.leagues.league import League


@dataclass(frozen=True)
class Entry:
    """One number of an observation."""

    name: str
    meaning: str
    scale: str


class Observation(Protocol):
    """An observation of one's own: `soccer_v0.parallel_env(observe=MyObservation())`."""

    names: Sequence[str]  # one for each number; their count is the length of the vector

    def __call__(self, match: Any) -> np.ndarray:
        """Return (M, R, len(names)) numbers in [-1, 1] from a match's records."""
        ...


def slot_entries(league: League, rows: Sequence[tuple[str, str, str]]) -> list[Entry]:
    """Return the entries of a league's slots for other players, team-mates first."""
    kinds = (("teammate", league.slots.teammates), ("opponent", league.slots.opponents))
    return [
        Entry(f"{kind}_{slot}_{name}", meaning, scale)
        for kind, slots in kinds
        for slot in range(slots)
        for name, meaning, scale in rows
    ]
