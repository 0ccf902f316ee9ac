"""Infos as numbers: flat, with the same keys at every step, as the collectors of libraries expect.

| key | number |
|---|---|
| `active` | False for a robot that is sent off, and for a spare row |
| `score_for`, `score_against` | goals of the agent's team, of its opponents |
| `phase` | phase of play, a `types.Phase` |
| `opponent` | the opponents' team: its place in `env.opponent_names`, 0 for a learner |
| `reward_NAME` | share of each term of the reward: `soccer list rewards` |
| `event_NAME` | events of the match in this step: the fields of `types.EVENTS` without the ball's place |
| `own_NAME` | events of the robot itself: the fields of `types.ROBOT_EVENTS` |
| `action_mask` | of actions="discrete", "multi", "skills": the choices with an effect now, see `actions.action_masks` |
| `variation_NAME` | with `variation=`: the factor of each number in this episode |
| `statistics_NAME` | infos="full": of the episode so far, from the side of the agent's team: `soccer list statistics` |
"""

from operator import itemgetter
from typing import Any

import numpy as np

from soccer_env.actions import mask_for_space
from soccer_env.api.opponents import OpponentNames
from soccer_env.api.report import FINAL_RECORDS, NO_EVENTS, Infos, NestedReport, team_of_agent
from soccer_env.match import Match
from soccer_env.match.arguments import InfoKind
from soccer_env.statistics.figures import flatten_statistics, statistics_by_name
from soccer_env.types import EVENTS, QUIET, ROBOT_EVENTS

STANDING = ("active", "score_for", "score_against", "phase", "opponent")
EVENT_NAMES = tuple(name for name in EVENTS.names or () if name not in NO_EVENTS)
OWN_NAMES = ROBOT_EVENTS.names or ()


def event_and_reward_keys(match: Match) -> tuple[list[str], list[str], list[str]]:
    """Return the keys of a match's rewards, of its events, and of the events of a robot."""
    rewards = [f"reward_{name}" for name in match.term_names]
    return rewards, [f"event_{name}" for name in EVENT_NAMES], [f"own_{name}" for name in OWN_NAMES]


class FlatReport:
    """Describe in numbers what happened in a step of a match, for the infos of some robots (rows)."""

    def __init__(self, match: Match, rows: np.ndarray, full: bool, met: OpponentNames) -> None:
        self._full = full
        self._robots = [(match.agents[row], int(row), team_of_agent(match.agents[row])) for row in rows]
        names = EVENTS.names or ()
        self._chosen = itemgetter(*(names.index(name) for name in EVENT_NAMES))
        self._quiet, self._own_quiet = self._chosen(QUIET.item()), (0,) * len(OWN_NAMES)
        self._rewards, self._events, self._own = event_and_reward_keys(match)
        keys = (*STANDING, *self._rewards, *self._events, *self._own)
        nothing = True, 0, 0, 0, 0, *(0.0,) * len(self._rewards), *self._quiet, *self._own_quiet
        self._nothing = dict(zip(keys, nothing, strict=True))
        self._variation = match.settings.variation
        self._met = met
        self.turn_to(match)

    def turn_to(self, match: Match) -> None:
        """Store the opponents at the start of an episode; `match` may be a new Match with the same robots."""
        self._match = match
        self.opponents = int(self._met.now(0)[0]), int(self._met.now(1)[0])  # of each team, in the first match

    def infos(self) -> Infos:
        """Return the infos of the first match, by agent."""
        match = self._match
        records = match.matches[0], match.robots[0], match.events[0], match.robot_events[0], match.terms[0]
        return self._of(*records, match.statistics[0])

    def last(self, index: int) -> Infos:
        """Return the last infos of an ended episode by agent; `index` is its row in `match.final`."""
        final = self._match.final
        return self._of(*(final[name][index] for name in (*FINAL_RECORDS, "statistics")))

    def _of(
        self, match: Any, robots: np.ndarray, events: Any, robot_events: np.ndarray, terms: np.ndarray, statistics: Any
    ) -> Infos:
        """Return the infos from the records of one match, by agent."""
        score, active = match["score"].tolist(), robots["active"].tolist()
        own, shares, happened = robot_events.tolist(), terms.tolist(), self._chosen(events.item())
        common, infos = self._nothing.copy(), {}
        common["phase"] = int(match["phase"])
        if self._variation is not None:
            common.update((f"variation_{name}", factor) for name, factor in self._variation.factors(match).items())
        if happened != self._quiet:
            common.update(zip(self._events, happened))
        for agent, row, team in self._robots:
            infos[agent] = info = common.copy()  # much faster than a new dict
            info["active"] = active[row] == 1
            info["score_for"], info["score_against"] = score[team], score[1 - team]
            info["opponent"] = self.opponents[team]
            info.update(zip(self._rewards, shares[row]))
            if own[row] != self._own_quiet:
                info.update(zip(self._own, own[row]))
        if self._full:
            of_side = [
                {f"statistics_{name}": value for name, value in flatten_statistics(statistics, t).items()}
                for t in (0, 1)
            ]
            for agent, _, team in self._robots:
                infos[agent].update(of_side[team])
        return infos


class FlatInfoArrays:
    """Infos as numbers for one robot in each of many matches: an array (M,) for each key."""

    def __init__(self, match: Match, row: int, full: bool, met: OpponentNames) -> None:
        self._match, self._row, self._team = match, row, team_of_agent(match.agents[row])
        self._full = full
        self._keys = (*STANDING, *(key for keys in event_and_reward_keys(match) for key in keys))
        self._one = FlatReport(match, np.array([row]), full, met)
        self._met = met
        self._before = self._now = met.now(self._team)

    def infos(self) -> dict[str, Any]:
        """Return the infos as new arrays (M,), each with a mask `_key` that is True for all matches."""
        match, row = self._match, self._row
        self._before, self._now = self._now, self._met.now(self._team)  # a step may have ended episodes
        score, own = match.matches["score"], match.robot_events[:, row]
        values = [match.robots["active"][:, row] == 1, score[:, self._team], score[:, 1 - self._team]]
        values += [match.matches["phase"], self._now, *match.terms[:, row].T]
        values += [*(match.events[name] for name in EVENT_NAMES), *(own[name] for name in OWN_NAMES)]
        arrays = dict(zip(self._keys, values, strict=True))
        arrays |= {f"variation_{name}": factors for name, factors in match.variation.items()}
        if self._full:
            numbers = statistics_by_name(match.statistics, self._team)
            arrays |= {f"statistics_{name}": values for name, values in numbers.items()}
        found = {}
        for key, numbers in arrays.items():
            # the types of Python's numbers
            found[key] = numbers.astype({"i": np.int64, "f": np.float64}.get(numbers.dtype.kind, numbers.dtype))
            found[f"_{key}"] = np.ones(match.count, bool)
        return found

    def ended(self, ended: np.ndarray) -> dict[str, Any]:
        """Return {}: flat infos have no further entries where episodes ended (M,)."""
        return {}

    def last(self, index: int) -> dict[str, Any]:
        """Return the robot's last info of an ended episode; `index` is its row in `match.final`."""
        (info,) = self._one.last(index).values()
        info["opponent"] = int(self._before[self._match.ended[index]])
        return info

    def forget(self, infos: dict[str, Any], ended: np.ndarray) -> None:
        """Set the rewards of ended episodes to 0 in the infos of the new episodes."""
        for name in self._match.term_names:
            infos[f"reward_{name}"][ended] = 0.0


def add_action_masks(infos: Infos, match: Match) -> Infos:
    """Add each agent's mask to the infos of the first match, in the form in which its action space samples by it."""
    kind = match.settings.actions
    if kind.parts:
        masks = match.action_masks()[0]
        for agent, info in infos.items():
            info["action_mask"] = mask_for_space(kind, masks[match.agents.index(agent)])
    return infos


def make_report(
    infos: InfoKind, match: Match, rows: np.ndarray, met: OpponentNames
) -> NestedReport | FlatReport | None:
    """Return the report that makes the infos of some robots (rows)."""
    if infos == "none":
        return None
    return NestedReport(match, rows) if infos == "nested" else FlatReport(match, rows, infos == "full", met)
