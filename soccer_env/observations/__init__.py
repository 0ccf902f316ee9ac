"""Observations for learners: one flat float32 vector in [-1, 1] a robot, the same layout at every team size.

Own goal behind, opponent's goal ahead, everything else relative to the robot.

    truth        everything, without error                                                       truth.py
    belief       what the robot believes, with confidences and ages                              belief.py
    percepts     what its sensors delivered in this frame, without memory                        percepts.py
"""

from __future__ import annotations

from soccer_env.leagues.league import League
from soccer_env.observations.entry import Entry, Observation

OBSERVE = ("truth", "percepts", "belief")


def layout(league: League, observe: str = "truth") -> list[Entry]:
    """Return the entries of a robot's observation in a league, in order."""
    if observe == "truth":
        from soccer_env.observations.truth import entries
    elif observe == "belief":
        from soccer_env.observations.belief import entries
    else:
        from soccer_env.observations.percepts import entries
    return entries(league)


def names_of(league: League, observe: str | Observation) -> list[str]:
    """Return the name of each number of an observation, ours or a user's own."""
    return [entry.name for entry in layout(league, observe)] if isinstance(observe, str) else list(observe.names)


__all__ = ["OBSERVE", "Entry", "Observation", "layout", "names_of"]
