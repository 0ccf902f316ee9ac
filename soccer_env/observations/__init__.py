"""Observations for learners: one flat float32 vector in [-1, 1] a robot, the same layout at every team size.

Own goal behind, opponent's goal ahead, everything else relative to the robot. A layout is a list of entries; each says
its name, its meaning, its scale, its frame and axis (so that mirrors know its sign) and whom or what it tells of.

    truth.py         observe="truth": everything, without error
    belief.py        observe="belief": what the robot believes, with confidences and ages
    percepts.py      observe="percepts": what its sensors delivered in this frame, without memory; of every robot
      legged.py        ... what the legged robots see
      omni.py          ... what the middle-size robots see
    body.py          what a body feels exactly: part of all three
    entry.py         Entry: one number and what it means; layouts as records
    scales.py        what their scales are in numbers, in a league
    own.py           observations of a user's own, and those that differ by team
    row.py           part of an observation as a record, for the compiled writers
    reflection.py    what a left-right mirror does to observations and actions
"""

from collections.abc import Callable, Sequence
from functools import cache

from soccer_env.leagues.league import League
from soccer_env.leagues.robot_kind import kind_of
from soccer_env.observations import belief, truth
from soccer_env.observations.entry import Entry, Observation
from soccer_env.observations.own import BUILT_IN

OBSERVE = BUILT_IN


def layout(league: League, observe: str | Observation = "truth") -> list[Entry]:
    """Return the entries of a robot's observation in a league, in order, of one of ours or a user's own."""
    if isinstance(observe, str):
        return LAYOUTS[observe](league)
    entries = getattr(observe, "entries", None)
    found = [Entry(name) for name in getattr(observe, "names", ())] if entries is None else list(entries)
    wrong = [entry for entry in found if not isinstance(entry, Entry)]
    if wrong:
        raise ValueError(f"entries of observe must be of soccer_env.observations.Entry, got {wrong[0]!r}")
    return found


def names_of(league: League, observe: str | Observation) -> list[str]:
    """Return the name of each number of an observation, ours or a user's own."""
    return [entry.name for entry in layout(league, observe)]


def percept_entries(league: League) -> list[Entry]:
    """Return the entries of what a robot of a league senses, in order."""
    return kind_of(league.sensors).entries(league)


LAYOUTS: dict[str, Callable[[League], list[Entry]]] = {
    "truth": truth.entries,
    "percepts": percept_entries,
    "belief": belief.entries,
}


@cache
def every_entry(observe: str) -> dict[str, Entry]:
    """Return every entry that observations of the truth or of beliefs have in whatever league, by name."""
    found = {"truth": truth.every_entry, "belief": belief.every_entry, "percepts": list[Entry]}[observe]()
    return {entry.name: entry for entry in found}


def entries_named(observe: str, names: Sequence[str]) -> list[Entry]:
    """Return what names of a policy's inputs mean; of an unknown name, and of percepts, the name alone.

    What robots sense depends on their kind, so that names alone do not tell.
    """
    known = every_entry(observe)
    return [known.get(name) or Entry(name) for name in names]


__all__ = ["OBSERVE", "Entry", "Observation", "entries_named", "layout", "names_of"]
