"""Who the learners of an API play against: their name for infos, and others at a reset."""

from __future__ import annotations

from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.match_settings import MatchArguments, part_of
from soccer_env.squads import who_plays

LEARNER = "learner"  # what infos call a robot that no team plays


def opponents_of(match: Match, team: int) -> np.ndarray:
    """Return the name of what plays the last robot of the other team now, (M,) objects; a lineup's own names."""
    last = match.settings.rows[0] - 1 if team == 1 else len(match.agents) - 1
    names = who_plays(match.squads, last, match.count)
    names[names == ""] = LEARNER
    return names


def against(match: Match, opponents: Any) -> Match:
    """Return a match like another, with other opponents for its learners, before its next episode.

    ValueError, and the other goes on, if the learners are not all of one side, or if these opponents cannot play.
    """
    sides = sorted({match.agents[row].split("_")[0] for row in np.flatnonzero(match.learns)})
    if len(sides) != 1 or opponents is None:
        raise ValueError(
            f"the option opponents must be a team where one side has all the learners, got {opponents!r} for learners "
            f"of {' and '.join(sides)}"
        )
    if match.recorder is not None:
        raise ValueError("opponents cannot change while a Recorder writes the match down: stop it first")
    asked = part_of(match.asked, MatchArguments)
    other = "away" if sides == ["home"] else "home"
    controllers = {name: team for name, team in (asked["controllers"] or {}).items() if not name.startswith(other)}
    dropped = "opponents" if other == "away" else "teammates"
    made = Match(**{**asked, dropped: None, "controllers": {**controllers, other: opponents}, "seed": 0, "seeds": None})
    made.seeds[:], made.matches["episode"] = match.seeds, match.matches["episode"]
    return made
