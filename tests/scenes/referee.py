"""One match of the middle size whose records a test fills, and what the referee says of them."""

from typing import Any

import numpy as np

from soccer_env import Match
from soccer_env.leagues.constants import constants_of
from soccer_env.match.staging import put, put_ball, set_phase
from soccer_env.physics.contacts import find_collisions
from soccer_env.referee.fouls.judging import judge_fouls
from soccer_env.types import HOME, Phase
from tests.scenes.staging import MIDDLE

FAR = ((-3.0, 3.0), (-4.0, 3.0), (-5.0, 3.0), (3.0, 3.0), (4.0, 3.0), (5.0, 3.0))  # out of everybody's way


class Referee:
    """A match 3 v 3 in play, home (rows 0 to 2) to the right, everybody standing far apart; `look` judges fouls."""

    def __init__(self, rules: str = "league", team: int = HOME, **changes: Any) -> None:
        """Let `team` attack to the right; `changes` of the rules by name."""
        text = ",".join(f"{name}={value}" for name, value in changes.items())
        self.match = Match(MIDDLE, home=3, away=3, seed=1, rules=f"{rules}:{text}" if text else rules)
        self.k = constants_of(self.match.league)[0]
        set_phase(self.match, Phase.PLAY)
        self.match.matches["home_direction"] = 1.0 if team == HOME else -1.0
        self.record, self.ball = self.match.matches[0], self.match.balls[0]
        self.robots, self.events = self.match.robots[0], self.match.events[0]
        self.deeds = self.match.robot_events[0]
        self.rows = (0, 1, 2, 3, 4, 5) if team == HOME else (3, 4, 5, 0, 1, 2)  # of `team`, then of the others
        self.own, self.other = team, 1 - team
        for r, (x, y) in zip(self.rows, FAR, strict=True):
            put(self.match, r, x, y)
        put_ball(self.match, 0.0, 0.0)

    def put(self, index: int, x: float, y: float, heading: float = 0.0, forward: float = 0.0) -> np.ndarray:
        """Put a robot (0 to 2 of `team`, 0 its keeper; 3 to 5 of the others) somewhere; return its record."""
        put(self.match, self.rows[index], x, y, heading, forward)
        return self.robots[self.rows[index]]

    def restart(self, phase: Phase, x: float, y: float) -> None:
        """Let `team` have a restart, the ball at its spot."""
        self.record["phase"], self.record["restart_team"] = phase, self.own
        self.record["restart_x"], self.record["restart_y"] = x, y
        put_ball(self.match, x, y)

    def look(self, touches: tuple[int, ...] = (), collides: tuple[int, ...] = (), kicks: tuple[int, ...] = ()) -> int:
        """Judge one control step in which robots touch the ball or others, or kick; return the foul."""
        self.events["foul"] = self.events["restart"] = 0
        for name in self.deeds.dtype.names:
            self.deeds[name] = 0
        for index in touches:
            self.deeds["touch"][self.rows[index]] = 1
        for index in collides:
            self.deeds["collision"][self.rows[index]] = 1
        for index in kicks:
            self.deeds["kick"][self.rows[index]] = 1
        touching = np.zeros(len(self.robots), np.int64)
        find_collisions(self.robots, self.deeds.copy(), touching, self.k)
        judge_fouls(self.record, self.ball, self.robots, self.events, self.deeds, touching, self.k)
        return int(self.events["foul"])

    def wait(self, seconds: float, **seen: tuple[int, ...]) -> list[int]:
        """Judge so many seconds of the same; return the fouls, a step each."""
        return [self.look(**seen) for _ in range(round(seconds / self.match.league.dt))]
