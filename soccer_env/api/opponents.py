"""The opponents of the learners of an API: their names for infos, and what a reset changes."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.match.arguments import MatchArguments, select_fields
from soccer_env.match.squads import Squad, playing_team_names

CHANGES = ("opponents", "home", "away", "scene")  # options of a reset that need another Match
LEARNER = "learner"  # name in infos of a robot that no team plays


class OpponentNames:
    """The opponents of some robots (rows): names of all opponents so far, and the number of the present one."""

    def __init__(self, match: Match, rows: np.ndarray) -> None:
        self._names = [LEARNER]
        self._sides = sorted({int(match.agents[row].startswith("away")) for row in rows.tolist()})
        self.turn_to(match)

    def turn_to(self, match: Match) -> None:
        """Store the opponents that can play; `match` may be a new Match with the same robots."""
        self._match, self._count, self._known = match, match.count, len(match.squads)
        self._squads: list[list[tuple[int, Squad]]] = [[], []]  # number and squad of the opponents of each side
        for team in self._sides:
            last = last_opponent(match, team)
            for squad in match.squads:
                if last in squad.players:
                    if squad.name not in self._names:
                        self._names.append(squad.name)
                    self._squads[team].append((self._names.index(squad.name), squad))

    @property
    def names(self) -> list[str]:
        """Return the names of all opponents so far."""
        self._take_added()
        return self._names

    def now(self, team: int) -> np.ndarray:
        """Return the number (M,) of the team that plays the last robot of the other side now; 0: a learner."""
        self._take_added()
        numbers = np.zeros(self._count, np.int64)
        for number, squad in self._squads[team]:
            numbers[slice(None) if squad.plays is None else squad.plays] = number
        return numbers

    def _take_added(self) -> None:
        """Store the teams that were added to a lineup."""
        if len(self._match.squads) != self._known:
            self.turn_to(self._match)


def last_opponent(match: Match, team: int) -> int:
    """Return the row of the last robot of the opponents of `team`."""
    return match.settings.rows[0] - 1 if team == 1 else len(match.agents) - 1


def opponents_of(match: Match, team: int) -> np.ndarray:
    """Return the name of the team that plays the last robot of the other side now, (M,) objects."""
    names = playing_team_names(match.squads, last_opponent(match, team), match.count)
    names[names == ""] = LEARNER
    return names


def changed_by(match: Match, options: Mapping[str, Any]) -> Match:
    """Return the match that these of a reset's options, CHANGES, ask for, before its next episode.

    It is `match` itself without these options, else a new one. ValueError, and `match` can go on, if the learners play
    on both sides or would be others, or if these teams cannot play.
    """
    wanted = {name: options[name] for name in CHANGES if name in options}
    if not wanted:
        return match
    if match.recorder is not None:
        raise ValueError(f"{' and '.join(wanted)} cannot change while a Recorder writes the match down: stop it first")
    arguments = select_fields(match.arguments, MatchArguments)
    if "opponents" in wanted:
        arguments |= against(match, arguments["controllers"] or {}, wanted.pop("opponents"))
    new_match = Match(**{**arguments, **wanted, "seed": 0, "seeds": None})
    if not np.array_equal(new_match.learns, match.learns):
        new_match.close()
        raise ValueError(f"{' and '.join(wanted)} can change within max_players, and with the same learners; give both")
    new_match.seeds[:], new_match.matches["episode"] = match.seeds, match.matches["episode"]
    return new_match


def against(match: Match, controllers: Mapping[str, Any], opponents: Any) -> dict[str, Any]:
    """Return the arguments by which other opponents play against the learners of a match."""
    sides = sorted({match.agents[row].split("_")[0] for row in np.flatnonzero(match.learns)})
    if len(sides) != 1 or opponents is None:
        raise ValueError(
            f"the option opponents must be a team where one side has all the learners, got {opponents!r} for learners "
            f"of {' and '.join(sides)}"
        )
    other = "away" if sides == ["home"] else "home"
    others = {name: team for name, team in controllers.items() if not name.startswith(other)}
    dropped = "opponents" if other == "away" else "teammates"
    return {dropped: None, "controllers": {**others, other: opponents}}
