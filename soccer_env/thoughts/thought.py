"""One robot's note as numbers in metres and radians of the field frame, for drawing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from soccer_env.leagues.robot_kind import Group
from soccer_env.thoughts.groups import width_of
from soccer_env.thoughts.thoughts import CENTI, MILLI, SEES, TABLE, TRACK, Notes, Thoughts

NEVER = 300.0  # [s] a ball that was not seen for longer is not believed to be anywhere
JUMP = 600  # [mm] from note to note beyond which nothing lies between
PLACES = ("x", "y", "ball_x", "ball_y")


class Player(NamedTuple):
    """Another player as a robot believes it."""

    x: float  # [m] field frame
    y: float  # [m]
    mate: bool
    age: float  # [s] since it was seen


@dataclass(frozen=True)
class Thought:
    """What one robot saw, believed and decided."""

    knows: bool  # False: it believes nothing, or nobody asked
    pose: tuple[float, float, float]  # [m, m, rad] where it believes it is
    confidence: float  # [0, 100] in that
    cloud: tuple[
        float, float, float
    ]  # [m, m, rad] of the poses that it thinks possible: deviations, angle of the first
    ball: tuple[float, float] | None  # [m] None: never seen
    ball_confidence: float  # [0, 100]
    ball_age: float  # [s] since it was seen
    infrared: float  # [m] reading of the ranger, 0: none
    players: tuple[Player, ...]
    words: tuple[str, ...]  # what its team calls what it does
    numbers: dict[str, float]  # other fields of its team's memory
    groups: dict[str, np.ndarray]  # (count, parts) int, see groups.py


@dataclass(frozen=True)
class Reader:
    """Tells what the columns of notes mean."""

    slots: int
    fields: list[list[list[Any]]]
    groups: list[Group]

    @staticmethod
    def of(notes: Notes | Thoughts) -> Reader:
        """Return the reader of notes that are taken, or that were read from a file."""
        return Reader(notes.slots, notes.fields, notes.groups)

    def thinks(self, row: np.ndarray) -> np.ndarray:
        """Return which robots believe anything (R,), out of a note (R, C)."""
        found: np.ndarray = (row[:, TABLE.index("sees")] & SEES["thinks"]) != 0
        return found

    def memory(self, row: np.ndarray, r: int) -> tuple[tuple[str, ...], dict[str, float]]:
        """Return the words for what robot r does, and other numbers of its memory, out of a note (R, C)."""
        first = len(TABLE) + len(TRACK) * self.slots + width_of(self.groups)
        memory = zip(self.fields[r], row[r, first:].tolist(), strict=False)
        return said([(path, known, value / step) for (path, known, step), value in memory])

    def thought(self, row: np.ndarray, r: int) -> Thought:
        """Return what robot r thought, out of a note (R, C)."""
        numbers = row[r].tolist()
        of = dict(zip(TABLE, numbers, strict=False))
        at = len(TABLE)
        players = [numbers[at + 3 * slot : at + 3 * slot + 3] for slot in range(self.slots)]
        at += len(TRACK) * self.slots
        groups = {}
        for name, count, parts in self.groups:
            size = count * len(parts)
            groups[name] = np.array(numbers[at : at + size]).reshape(count, len(parts))
            at += size
        words, rest = self.memory(row, r)
        age = of["ball_age"] / CENTI
        return Thought(
            knows=bool(of["sees"] & SEES["thinks"]),
            pose=(of["x"] / MILLI, of["y"] / MILLI, of["heading"] / MILLI),
            confidence=of["confidence"] / CENTI,
            cloud=(of["spread"] / MILLI, of["narrow"] / MILLI, of["axis"] / MILLI),
            ball=None if age >= NEVER else (of["ball_x"] / MILLI, of["ball_y"] / MILLI),
            ball_confidence=of["ball_confidence"] / CENTI,
            ball_age=age,
            infrared=of["infrared"] / MILLI,
            players=tuple(
                Player(x / MILLI, y / MILLI, age > 0, (abs(age) - 1) / 10.0) for x, y, age in players if age != 0
            ),
            words=words,
            numbers=rest,
            groups=groups,
        )


def said(memory: list[tuple[str, list[str], float]]) -> tuple[tuple[str, ...], dict[str, float]]:
    """Return the words of what a robot does, and its other numbers by name."""
    words, numbers = [], {}
    for path, known, value in memory:
        if known:
            words += known[int(value) : int(value) + 1] if value >= 0 else []
        else:
            numbers[path.rpartition(".")[2]] = value
    return tuple(dict.fromkeys(words)), numbers


def note_at(notes: Notes, step: int) -> np.ndarray | None:
    """Return the note (R, C) at a control step, its places between two notes; None before the first of them."""
    at = int(np.searchsorted(notes.steps, step, side="right")) - 1
    if at < 0:
        return None
    if at + 1 == len(notes.steps) or notes.steps[at] == step:
        row: np.ndarray = notes.numbers[at]
        return row
    share = float(step - notes.steps[at]) / float(notes.steps[at + 1] - notes.steps[at])
    return between(notes.numbers[at], notes.numbers[at + 1], share, notes.slots)


def between(early: np.ndarray, late: np.ndarray, share: float, slots: int) -> np.ndarray:
    """Return a note between two (R, C): places move evenly where both are near each other, all else is the early one's.

    What a robot believes lies on a thing that moves: the early note alone would lag behind it.
    """
    note = early.copy()
    pairs = [(TABLE.index(x), TABLE.index(y)) for x, y in (PLACES[:2], PLACES[2:])]
    first = len(TABLE)
    pairs += [(first + len(TRACK) * slot, first + len(TRACK) * slot + 1) for slot in range(slots)]
    for x, y in pairs:
        away = late[:, [x, y]].astype(np.int64) - early[:, [x, y]]
        near = np.hypot(*away.T) < JUMP
        if x >= first:
            near &= np.sign(early[:, x + 2]) == np.sign(late[:, x + 2])
        note[:, [x, y]] += np.where(near[:, None], np.rint(share * away), 0).astype(np.int16)
    heading = TABLE.index("heading")
    turn = (late[:, heading].astype(np.int64) - early[:, heading]) / MILLI
    turned = early[:, heading] / MILLI + share * np.arctan2(np.sin(turn), np.cos(turn))
    note[:, heading] = np.rint(MILLI * np.arctan2(np.sin(turned), np.cos(turned)))
    return note
