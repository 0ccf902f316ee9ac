"""What an observation is: named numbers in [-1, 1], each of which says what it means.

An entry's frame and its axis in it tell what the symmetries of the game do to it: a left-right mirror turns round what
is measured to the left or counter-clockwise, a half-turn of the field what lies along the axes of the field. Its group
tells whom or what it speaks of.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, Protocol

import numpy as np

from soccer_env.leagues.league import League

Frame = Literal["none", "robot", "team", "field", "camera"]
Axis = Literal["", "x", "y", "turn", "side"]
NONE: Frame = "none"  # a flag, a count, a distance: no direction
ROBOT: Frame = "robot"  # x ahead, y to the left, turn counter-clockwise
TEAM: Frame = "team"  # x towards the opponent's goal
FIELD: Frame = "field"  # x towards the goal that away defends in the first half
CAMERA: Frame = "camera"  # y to the left in the picture
X: Axis = "x"
Y: Axis = "y"
TURN: Axis = "turn"
SIDE: Axis = "side"  # of a row of things from one side to the other: a mirror puts another entry in its place

OWN_COMMAND = "last command"  # the group of what the robot itself asked of its body
TEAMMATE, OPPONENT = "teammate", "opponent"  # the groups of the slots for other players


@dataclass(frozen=True)
class Entry:
    """One number of an observation or of a state, in [-1, 1]."""

    name: str  # each different
    meaning: str = ""  # in a line, for lists
    scale: str = ""  # what 1 stands for
    frame: Frame | None = None  # None: nobody has said
    axis: Axis = ""  # of that frame; "" for what has no direction in it
    group: str = ""  # whom or what it tells of
    slot: int | None = None  # which of its group's slots; None: the group has no slots
    present: bool = False  # above 0 where its slot is in use; an empty slot is zeros

    def __post_init__(self) -> None:
        if self.frame is None and self.axis:
            raise ValueError(f"entry {self.name!r} has the axis {self.axis!r} of no frame")

    @property
    def mirror(self) -> int | None:
        """Return what a left-right mirror multiplies it by, 1 or -1; None if that is not known, or no such thing."""
        if self.frame is None or self.axis == SIDE:
            return None
        return -1 if self.axis in (Y, TURN) else 1

    @property
    def half_turn(self) -> int | None:
        """Return what a half-turn of the field multiplies it by, 1 or -1; None if that is not known."""
        if self.frame is None:
            return None
        return -1 if self.frame == FIELD and self.axis in (X, Y) else 1


class Observation(Protocol):
    """A user's own observation: `soccer_v0.parallel_env(observe=MyObservation())`.

    What mirrors observations or attends to players asks for `entries` that say their frame or their slot. Numbers of
    `names` and `entries` lie in [-1, 1] unless `low` and `high` say otherwise; `space` is of any shape, or a Dict.
    With `needs_beliefs = False` no robot senses for its sake.
    """

    names: Sequence[str]  # one for each number, or instead:
    entries: Sequence[Entry]
    space: Any  # or instead: a gymnasium Box of what one robot observes, or a Dict of such

    def __call__(self, match: Any) -> Any:
        """Return (M, R, ...) of all robots from a match's records, or a dict of such, as the space is one."""
        ...


def of_group(group: str, *entries: Entry) -> tuple[Entry, ...]:
    """Return the entries of a group, with its name."""
    return tuple(replace(entry, group=group) for entry in entries)


def slot_entries(teammates: int, opponents: int, rows: Sequence[Entry]) -> list[Entry]:
    """Return the entries of slots for other players, team-mates first."""
    return [
        replace(entry, name=f"{kind}_{slot}_{entry.name}", group=kind, slot=slot)
        for kind, slots in ((TEAMMATE, teammates), (OPPONENT, opponents))
        for slot in range(slots)
        for entry in rows
    ]


def things(name: str, count: int, rows: Sequence[Entry]) -> list[Entry]:
    """Return the entries of `count` things of one name, numbered if there are several."""
    return [
        replace(
            entry,
            name=f"{one}_{entry.name}",
            meaning=f"{one.replace('_', ' ')}: {entry.meaning}",
            group=name,
            slot=slot,
        )
        for slot, one in ([(i, f"{name}_{i}") for i in range(count)] if count > 1 else [(None, name)])
        for entry in rows
    ]


def slots_of(league: League) -> tuple[int, int]:
    """Return the slots that a league has for team-mates and opponents."""
    return league.slots.teammates, league.slots.opponents


def record_of(entries: Iterable[Entry]) -> np.dtype:
    """Return the record whose fields are the entries, in order: what kernels write by name."""
    return np.dtype([(entry.name, "f4") for entry in entries])
