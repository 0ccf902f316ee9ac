"""Observations for learners: a flat float32 vector in [-1, 1] for each robot, with one layout for every team size.

Own goal behind, opponent's goal ahead, all else relative to the robot. A layout is a list of entries; an entry has a
name, a meaning, a scale, a frame and an axis (from which mirrors take its sign), and a group.

    truth.py         observe="truth": the whole state, without error
    belief.py        observe="belief": the robot's belief, with confidences and ages
    percepts.py      observe="percepts": the readings of the sensors in this frame; the part of all robots
      legged.py        ... pictures of legged robots
      omni.py          ... pictures of middle-size robots
    body.py          exact readings of the own body, part of all three
    entry.py         Entry: one number and its meaning; layouts as records
    scales.py        scales in numbers, for a league
    own.py           a user's own observations, and observations that differ by team
    row.py           part of an observation as a record, for the compiled writers
    reflection.py    the signs of observations and actions in a left-right mirror
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
    """Return the entries of an observation in a league, in order, for a built-in or a user's own observation."""
    if isinstance(observe, str):
        return LAYOUTS[observe](league)
    entries = getattr(observe, "entries", None)
    listed = [Entry(name) for name in getattr(observe, "names", ())] if entries is None else list(entries)
    wrong = [entry for entry in listed if not isinstance(entry, Entry)]
    if wrong:
        raise ValueError(f"entries of observe must be of soccer_env.observations.Entry, got {wrong[0]!r}")
    return listed


def entry_names(league: League, observe: str | Observation) -> list[str]:
    """Return the names of an observation's entries, for a built-in or a user's own observation."""
    return [entry.name for entry in layout(league, observe)]


LAYOUTS: dict[str, Callable[[League], list[Entry]]] = {
    "truth": truth.entries,
    "percepts": lambda league: kind_of(league.sensors).entries(league),
    "belief": belief.entries,
}


@cache
def every_entry(observe: str) -> dict[str, Entry]:
    """Return all entries, by name, that a built-in observation has in any league; empty for "percepts"."""
    listed = {"truth": truth.every_entry, "belief": belief.every_entry, "percepts": list[Entry]}[observe]()
    return {entry.name: entry for entry in listed}


def entries_named(observe: str, names: Sequence[str]) -> list[Entry]:
    """Return the entry of each named input of a policy; unknown names get an entry that has only a name.

    The meaning of a percept depends on the kind of robot, not only on its name.
    """
    known = every_entry(observe)
    return [known.get(name) or Entry(name) for name in names]


__all__ = ["OBSERVE", "Entry", "Observation", "entries_named", "layout", "entry_names"]
