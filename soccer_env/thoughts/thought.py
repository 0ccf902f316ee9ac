"""One robot's note as numbers in metres and radians of the field frame, for drawing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from soccer_env.leagues.robot_kind import Group
from soccer_env.thoughts.groups import count_columns
from soccer_env.thoughts.thoughts import CENTI, MILLI, SEES, TABLE, TRACK, Notes, Thoughts

NEVER = 300.0  # [s] a ball unseen for longer has no believed place
JUMP = 600  # [mm] between two notes: a longer move is a jump, and is not interpolated
PLACES = ("x", "y", "ball_x", "ball_y")


class Player(NamedTuple):
    """Another player in a robot's belief."""

    x: float  # [m] field frame
    y: float  # [m]
    mate: bool
    age: float  # [s] since it was seen


@dataclass(frozen=True)
class Thought:
    """Percepts, beliefs and decisions of one robot at one time."""

    knows: bool  # False: it believes nothing, or its beliefs were not noted
    pose: tuple[float, float, float]  # [m, m, rad] believed pose of the robot
    confidence: float  # [0, 100] in that pose
    cloud: tuple[float, float, float]  # [m, m, rad] of its particles: two standard deviations, angle of the first
    ball: tuple[float, float] | None  # [m] None: never seen
    ball_confidence: float  # [0, 100]
    ball_age: float  # [s] since it was seen
    infrared: float  # [m] reading of the ranger, 0: none
    players: tuple[Player, ...]
    words: tuple[str, ...]  # its team's words for what the robot does
    numbers: dict[str, float]  # other fields of its team's memory
    groups: dict[str, np.ndarray]  # (count, parts) int, see groups.py


@dataclass(frozen=True)
class NoteReader:
    """A reader that converts the columns of notes to metres, radians and words."""

    slots: int
    fields: list[list[list[Any]]]
    groups: list[Group]

    @staticmethod
    def of(notes: Notes | Thoughts) -> NoteReader:
        """Return a reader for notes of a running match, or for the notes of a file."""
        return NoteReader(notes.slots, notes.fields, notes.groups)

    def thinks(self, row: np.ndarray) -> np.ndarray:
        """Return flags (R,): 1 for each robot that has beliefs in a note (R, C)."""
        return np.asarray((row[:, TABLE.index("sees")] & SEES["thinks"]) != 0)

    def memory(self, row: np.ndarray, r: int) -> tuple[tuple[str, ...], dict[str, float]]:
        """Return words for robot r's activity and the other numbers of its memory, from a note (R, C)."""
        first = len(TABLE) + len(TRACK) * self.slots + count_columns(self.groups)
        memory = zip(self.fields[r], row[r, first:].tolist(), strict=False)
        return words_and_numbers([(path, known, value / step) for (path, known, step), value in memory])

    def thought(self, row: np.ndarray, r: int) -> Thought:
        """Return the Thought of robot r, from a note (R, C)."""
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


def words_and_numbers(memory: list[tuple[str, list[str], float]]) -> tuple[tuple[str, ...], dict[str, float]]:
    """Split a robot's noted memory into words for its activity, and other numbers by name."""
    words, numbers = [], {}
    for path, known, value in memory:
        if known:
            words += known[int(value) : int(value) + 1] if value >= 0 else []
        else:
            numbers[path.rpartition(".")[2]] = value
    return tuple(dict.fromkeys(words)), numbers


def note_at(notes: Notes, step: int) -> np.ndarray | None:
    """Return the note (R, C) at a control step, with positions interpolated; None before the first note."""
    at = int(np.searchsorted(notes.steps, step, side="right")) - 1
    if at < 0:
        return None
    if at + 1 == len(notes.steps) or notes.steps[at] == step:
        return np.asarray(notes.numbers[at])
    share = float(step - notes.steps[at]) / float(notes.steps[at + 1] - notes.steps[at])
    return interpolate_notes(notes.numbers[at], notes.numbers[at + 1], share, notes.slots)


def interpolate_notes(early: np.ndarray, late: np.ndarray, share: float, slots: int) -> np.ndarray:
    """Return the early note (R, C) with its positions interpolated towards the late note, except where they jump.

    Without interpolation, believed places would lag behind moving robots and balls.
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
