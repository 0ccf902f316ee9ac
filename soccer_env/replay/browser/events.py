"""What happened in a match, in words, with when and where: goals and how they came about, whistles, kicks, halves."""

from __future__ import annotations

from math import hypot
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.render.captions import PHASES, player_words
from soccer_env.render.colours import TEAM_NAMES
from soccer_env.types import NO_TEAM, Foul, Phase

KICK_COUNTS = 3.0  # [s] a goal comes from the scorer's kick if that is no longer ago
KICKS_APART = 0.25  # [s] kicks of a robot nearer to each other are one


class Storyteller:
    """Gathers events as plain values: [step, kind, team, robot, words]; kind: goal, foul, restart, kick or half."""

    def __init__(self, rate: int) -> None:
        self.rate = rate
        self.events: list[list[Any]] = []
        self._kicks: dict[int, tuple[int, float, float]] = {}  # of each robot: step, and where the ball was

    def listen(self, match: Match, step: int, before: np.ndarray) -> None:
        """Note what happened in the first match in a control step; `before` are its robots a step earlier."""
        events, robots = match.events[0], match.robots[0]
        for r in np.flatnonzero(match.robot_events["kick"][0]).tolist():
            last = self._kicks.get(r, (-self.rate,))[0]
            self._kicks[r] = (step, float(events["ball_x"]), float(events["ball_y"]))
            if step - last > KICKS_APART * self.rate:
                self._tell(step, "kick", robots[r], r, f"{player_words(robots[r])} kicks")
        if events["goal"] != NO_TEAM:
            self._tell_goal(match, step, before)
        elif events["foul"] != 0:
            self._tell_foul(match, step)
        elif events["restart"] not in (0, Phase.KICK_OFF):
            team = int(events["restart_team"])
            whose = "" if team == NO_TEAM else f" for {TEAM_NAMES[team]}"
            self._add(step, "restart", team, -1, f"{PHASES[Phase(int(events['restart']))]}{whose}")
        for name, words in (("half_time", "half-time"), ("final_whistle", "final whistle")):
            if events[name]:
                self._add(step, "half", NO_TEAM, -1, words)

    def _tell_goal(self, match: Match, step: int, before: np.ndarray) -> None:
        """Tell who scored and how: a kick of a moment ago, or the ball walked or bumped in."""
        team, r = int(match.events["goal"][0]), int(match.events["scorer"][0])
        score = " : ".join(str(int(goals)) for goals in match.matches["score"][0])
        if not 0 <= r < len(before):
            self._add(step, "goal", team, -1, f"{score}: goal for {TEAM_NAMES[team]}")
            return
        who = player_words(before[r])
        kicked = self._kicks.get(r)
        goal_x = float(np.sign(match.events["ball_x"][0])) * match.league.pitch.length / 2
        if kicked is not None and step - kicked[0] <= KICK_COUNTS * self.rate:
            away = hypot(goal_x - kicked[1], kicked[2])
            how = f"kicked {(step - kicked[0]) / self.rate:.1f} s earlier, {away:.1f} m from the goal"
        else:
            how = "walked or bumped in, without a kick"
        own = "own goal by " if int(before["team"][r]) != team else ""
        self._add(step, "goal", team, r, f"{score}: {own}{who}, {how}")

    def _tell_foul(self, match: Match, step: int) -> None:
        """Tell what was whistled against whom."""
        foul, team = Foul(int(match.events["foul"][0])), int(match.events["foul_team"][0])
        against = np.flatnonzero(match.robot_events["foul"][0] == foul)
        r = int(against[0]) if len(against) else -1
        who = player_words(match.robots[0, r]) if r >= 0 else TEAM_NAMES[team] if team != NO_TEAM else "both"
        self._add(step, "foul", team, r, f"{foul.name.lower().replace('_', ' ')}: {who}")

    def _tell(self, step: int, kind: str, robot: np.void, r: int, words: str) -> None:
        self._add(step, kind, int(robot["team"]), r, words)

    def _add(self, step: int, kind: str, team: int, r: int, words: str) -> None:
        self.events.append([step, kind, team, r, words])
