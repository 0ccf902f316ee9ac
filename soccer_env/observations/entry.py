"""The entries of an observation: named numbers in [-1, 1], each with its meaning.

The frame and axis of an entry give its sign under the symmetries of the game: a left-right mirror negates numbers
measured to the left or counter-clockwise, a half-turn of the field numbers along the field's axes. The group names the
object that an entry describes.
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
SIDE: Axis = "side"  # for a row of things from one side to the other: a mirror exchanges the entries

OWN_COMMAND = "last command"  # the group of the robot's own command
TEAMMATE, OPPONENT = "teammate", "opponent"  # the groups of the slots for other players


@dataclass(frozen=True)
class Entry:
    """One number of an observation or of a state, in [-1, 1], with its name and meaning."""

    name: str  # unique in its layout
    meaning: str = ""  # in a line, for lists
    scale: str = ""  # the meaning of 1
    frame: Frame | None = None  # None: unknown
    axis: Axis = ""  # of the frame; "" for a number without a direction
    group: str = ""  # the object that it describes
    slot: int | None = None  # index among the slots of its group; None: the group has no slots
    present: bool = False  # True: above 0 while its slot is in use; an empty slot is zeros

    def __post_init__(self) -> None:
        if self.frame is None and self.axis:
            raise ValueError(f"entry {self.name!r} has the axis {self.axis!r} of no frame")

    @property
    def mirror(self) -> int | None:
        """Return the entry's sign, 1 or -1, in a left-right mirror; None if unknown, or if the entry swaps places."""
        if self.frame is None or self.axis == SIDE:
            return None
        return -1 if self.axis in (Y, TURN) else 1

    @property
    def half_turn(self) -> int | None:
        """Return the entry's sign, 1 or -1, under a half-turn of the field; None if unknown."""
        if self.frame is None:
            return None
        return -1 if self.frame == FIELD and self.axis in (X, Y) else 1


class Observation(Protocol):
    """The protocol of a user's own observation: `soccer_v0.parallel_env(observe=MyObservation())`.

    Mirrors need `entries` with frames. Numbers of `names` and `entries` lie in [-1, 1], or in [`low`, `high`] if these
    are given; `space` has any shape, or is a Dict. `needs_beliefs = False` says that the observation reads no beliefs.
    """

    names: Sequence[str]  # one for each number, or instead:
    entries: Sequence[Entry]
    space: Any  # or instead: a gymnasium Box of what one robot observes, or a Dict of such

    def __call__(self, match: Any) -> Any:
        """Return the observations (M, R, ...) of all robots from a match's records; a dict of arrays for a Dict."""
        ...


def copy_to_group(group: str, *entries: Entry) -> tuple[Entry, ...]:
    """Return copies of the given entries, assigned to the group `group`."""
    return tuple(replace(entry, group=group) for entry in entries)


def slot_entries(teammates: int, opponents: int, rows: Sequence[Entry]) -> list[Entry]:
    """Repeat the entries `rows` for each slot of another player, team-mates first."""
    return [
        replace(entry, name=f"{kind}_{slot}_{entry.name}", group=kind, slot=slot)
        for kind, slots in ((TEAMMATE, teammates), (OPPONENT, opponents))
        for slot in range(slots)
        for entry in rows
    ]


def object_entries(name: str, count: int, rows: Sequence[Entry]) -> list[Entry]:
    """Repeat the entries `rows` for each of `count` objects called `name`, numbered if there are several."""
    return [
        replace(entry, name=f"{one}_{entry.name}", meaning=f"{words}: {entry.meaning}", group=name, slot=slot)
        for slot, one in ([(i, f"{name}_{i}") for i in range(count)] if count > 1 else [(None, name)])
        for words in [one.replace("_", " ")]
        for entry in rows
    ]


def slot_counts(league: League) -> tuple[int, int]:
    """Return the numbers of slots for team-mates and for opponents in a league."""
    return league.slots.teammates, league.slots.opponents


def entries_dtype(entries: Iterable[Entry]) -> np.dtype:
    """Return a record dtype with one float32 field for each entry, in order; kernels write fields by name."""
    return np.dtype([(entry.name, "f4") for entry in entries])
