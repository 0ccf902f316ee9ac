"""The events of the first match of a replay, as `soccer_env.statistics` counts them.

Passes, interceptions, shots and saves follow from changes in the record of statistics: nothing is judged here.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.statistics.maps import OUTCOMES
from soccer_env.statistics.records import FRESH, GoalKind, Outcome
from soccer_env.types import NO_TEAM, Foul, Phase

NOBODY = -1
CALLS = {  # field of EVENTS -> kind of the event
    "out": "ball_out", "in_play": "in_play", "separated": "separation", "annulled": "goal_annulled",
    "half_time": "half_time", "final_whistle": "final_whistle",
}  # fmt: skip
TRAIL = ("player", "touched", "played_x", "played_y", "flight", "shot")


@dataclass(frozen=True)
class Event:
    """An event; places [m] are those of the ball, in the field frame."""

    frame: int
    kind: str  # kick, pass, interception, shot, save, goal, foul, restart, or one of CALLS
    team: int = NO_TEAM  # HOME, AWAY or NO_TEAM
    row: int = NOBODY  # of the robot that did it
    x: float = 0.0
    y: float = 0.0
    outcome: str = ""  # result of a pass, shot or goal; kind of a foul or restart
    end_frame: int = NOBODY  # of passes and shots
    end_x: float = float("nan")
    end_y: float = float("nan")
    receiver: int = NOBODY  # row of the robot that got a pass


class Listener:
    """Collects the events of a match that is played step by step."""

    def __init__(self, match: Match) -> None:
        self._events: list[Event] = []
        self._step = self._frame = 0
        self._teams = match.robots["team"][0].tolist()
        self._keepers = {self._teams[row]: row for row in np.flatnonzero(match.robots["keeper"][0]).tolist()}
        self._begin(match)

    def sorted_events(self) -> list[Event]:
        """Return all events in the order of frames, with a save at the end of each saved shot."""
        saves = [
            Event(
                shot.end_frame, "save", 1 - shot.team, self._keepers.get(1 - shot.team, NOBODY), shot.end_x, shot.end_y
            )
            for shot in self._events
            if shot.outcome == OUTCOMES[Outcome.SAVED]
        ]
        return sorted([*self._events, *saves], key=lambda event: event.frame)

    def listen(self, match: Match, step: int) -> None:
        """Note the events of a control step in the first match."""
        if match.matches["step"][0] <= self._step:
            match.statistics[0] = FRESH  # another episode has begun, or an earlier moment was loaded
            self._begin(match)
            return
        self._frame, self._step = step, int(match.matches["step"][0])
        events, now = match.events[0], match.statistics[0]
        self._x, self._y = float(events["ball_x"]), float(events["ball_y"])
        for row in np.flatnonzero(match.robot_events["kick"][0]).tolist():
            self._add("kick", self._teams[row], row)
        self._listen_to_passes(now)
        self._listen_to_shots(now)
        if events["goal"] != NO_TEAM:
            team = int(events["goal"])
            kinds = np.flatnonzero(now["goals"][team] > self._counts["goals"][team])
            kind = GoalKind(int(kinds[0])).name.lower() if len(kinds) else ""
            self._add("goal", team, int(events["scorer"]), outcome=kind)
        self._listen_to_calls(match, events)
        self._store_statistics(now)

    def _begin(self, match: Match) -> None:
        """Start to compare statistics anew, from the present statistics and with no shot on its way."""
        self._step = int(match.matches["step"][0])
        self._shot = NOBODY  # place in the list of the shot that is on its way
        self._store_statistics(match.statistics[0])

    def _store_statistics(self, now: Any) -> None:
        """Store copies of the statistics, to compare them in the next step."""
        self._passes = now["maps"]["passes"].copy()
        self._tried = int(now["passes_tried"].sum())
        self._counts = {name: now[name].copy() for name in ("goals", "shots")}
        self._trail = {name: now["trail"][name].item() for name in TRAIL}

    def _add(self, kind: str, team: int = NO_TEAM, row: int = NOBODY, **fields: Any) -> None:
        """Note an event of this step."""
        place = {"frame": self._frame, "x": self._x, "y": self._y}
        self._events.append(Event(kind=kind, team=team, row=row, **(place | fields)))

    def _listen_to_passes(self, now: Any) -> None:
        """Note a pass when a team-mate gets it or an opponent intercepts it."""
        if int(now["passes_tried"].sum()) == self._tried:
            return
        for row, receiver in np.argwhere(now["maps"]["passes"] > self._passes).tolist():
            team, arrived = self._teams[row], self._teams[receiver]
            self._add(
                "pass", team, row, frame=self._frame - (self._step - self._trail["touched"]),
                x=self._trail["played_x"], y=self._trail["played_y"], receiver=receiver,
                outcome="successful" if team == arrived else "intercepted",
                end_frame=self._frame, end_x=self._x, end_y=self._y,
            )  # fmt: skip
            if team != arrived:
                self._add("interception", arrived, receiver)

    def _listen_to_shots(self, now: Any) -> None:
        """Note a shot when it is counted, and follow it until its flight is over."""
        for team in np.flatnonzero(now["shots"] > self._counts["shots"]).tolist():
            row, trail = int(now["trail"]["flight"]), now["trail"]
            self._shot = len(self._events)
            self._add(
                "shot", team, row, x=float(trail["played_x"]), y=float(trail["played_y"]),
                outcome=OUTCOMES[Outcome.OFF_TARGET],
            )  # fmt: skip
        if self._shot >= 0:
            shot, kept = self._events[self._shot], int(now["trail"]["shot"])
            outcome = OUTCOMES[int(now["maps"]["shots"][kept]["outcome"])] if kept >= 0 else shot.outcome
            if shot.outcome == OUTCOMES[Outcome.OFF_TARGET] or outcome == OUTCOMES[Outcome.GOAL]:
                self._events[self._shot] = replace(
                    shot, outcome=outcome, end_frame=self._frame, end_x=self._x, end_y=self._y
                )
            if now["trail"]["flight"] < 0:
                self._shot = NOBODY

    def _listen_to_calls(self, match: Match, events: Any) -> None:
        """Note the calls of the referee."""
        fouls = match.robot_events["foul"][0]
        for row in np.flatnonzero(fouls).tolist():
            self._add("foul", self._teams[row], row, outcome=Foul(int(fouls[row])).name.lower())
        if events["foul"] != 0 and not fouls.any():
            self._add("foul", int(events["foul_team"]), outcome=Foul(int(events["foul"])).name.lower())
        for name, kind in CALLS.items():
            if events[name] != 0:
                self._add(kind)
        if events["restart"] != 0:
            record = match.matches[0]
            place: dict[str, Any] = {"x": float(record["restart_x"]), "y": float(record["restart_y"])}
            self._add(
                "restart", int(events["restart_team"]), outcome=Phase(int(events["restart"])).name.lower(), **place
            )
