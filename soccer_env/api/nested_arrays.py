"""Nested infos of one robot in each of many matches, in Gymnasium's form for vectors: words, each with a mask.

`report.Report` makes the nested infos of many robots in one match; `infos.py` makes infos as numbers.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from soccer_env.api.report import NO_EVENTS, PHASES, NestedReport, team_of_agent
from soccer_env.match import Match
from soccer_env.statistics.figures import statistics_by_name
from soccer_env.statistics.maps import maps_of_team
from soccer_env.types import QUIET


class NestedInfoArrays:
    """Describe in words what happened to one robot (row) in each match; "score" is (M, 2)."""

    def __init__(self, match: Match, row: int) -> None:
        self._match, self._row, self._team = match, row, team_of_agent(match.agents[row])
        self._one = NestedReport(match, np.array([row]))
        self._before = self._one.opponents

    def infos(self) -> dict[str, Any]:
        """Return `Report.infos` of each match as Gymnasium's arrays and masks."""
        match, row = self._match, self._row
        self._before = self._one.opponents  # of the episodes that a step may have ended
        self._one.turn_to(match)
        score = match.matches["score"]
        shares = zip(match.term_names, match.terms[:, row].T.copy(), strict=True)
        infos = {
            "active": match.robots["active"][:, row] == 1,
            "events": self._events(),
            "rewards": self._masked(dict(shares)),
            "score": np.stack([score[:, self._team], score[:, 1 - self._team]], axis=1),
            "phase": np.array(PHASES, object)[match.matches["phase"]],
            "opponent": self._one.opponents[self._team].copy(),
        }
        return self._masked(infos)

    def _masked(self, values: dict[str, Any]) -> dict[str, Any]:
        """Return values that all matches have, and for each a mask `_key` that is True everywhere."""
        everywhere = np.ones(self._match.count, bool)
        return {
            name: item for key, value in values.items() for name, item in ((key, value), (f"_{key}", everywhere.copy()))
        }

    def _events(self) -> dict[str, Any]:
        """Return the events that happened in any match: a word or True where an event happened, and its mask."""
        match, events = self._match, {}
        for name in QUIET.dtype.names or ():
            codes = match.events[name]
            mask = codes != QUIET[name]
            if name in NO_EVENTS or not mask.any():
                continue
            words = self._one.words.get(name)
            events[name], events[f"_{name}"] = (
                mask.copy() if words is None else codes_to_words(words, codes, mask),
                mask,
            )
        for name in match.robot_events.dtype.names or ():
            mask = match.robot_events[name][:, self._row] != 0
            if mask.any():
                events[name], events[f"_{name}"] = mask.copy(), mask
        return events

    def ended(self, ended: np.ndarray) -> dict[str, Any]:
        """Return statistics (M,) and maps of ended matches, from the learner's side; 0 and None for other matches."""
        numbers = statistics_by_name(self._match.statistics, self._team)
        masked = {name: np.where(ended, values, 0) for name, values in numbers.items()}
        both = {key: item for name, values in masked.items() for key, item in ((name, values), (f"_{name}", ended))}
        return {"statistics": both, "_statistics": ended, "maps": self._maps(ended), "_maps": ended}

    def _maps(self, ended: np.ndarray) -> dict[str, Any]:
        """Return the maps of ended matches by name, each an array (M,) of lists, None elsewhere, with its mask."""
        maps: dict[str, Any] = {}
        for m in np.flatnonzero(ended).tolist():
            for name, value in maps_of_team(self._match.statistics[m], self._team, self._match.settings.rows).items():
                maps.setdefault(name, np.full(len(ended), None, object))[m] = value
                maps[f"_{name}"] = ended
        return maps

    def last(self, index: int) -> dict[str, Any]:
        """Return the robot's last info of an ended episode; `index` is its row in `match.final`."""
        (info,) = self._one.last(index).values()
        opponent = self._before[self._team][self._match.ended[index]]
        return {**info, "score": np.array(info["score"]), "opponent": opponent}

    def forget(self, infos: dict[str, Any], ended: np.ndarray) -> None:
        """Set the rewards of ended episodes to 0 in the infos of the new episodes."""
        for name in self._match.term_names:
            infos["rewards"][name][ended] = 0.0


def codes_to_words(words: Sequence[str], codes: np.ndarray, mask: np.ndarray) -> np.ndarray:
    """Return the words of the codes where the mask is set, None elsewhere (M,)."""
    spelled = np.full(len(codes), None, object)
    spelled[mask] = np.array(words, object)[codes[mask]]
    return spelled
