"""Situations with a known outcome, for either team and in either half: the acting team always attacks `match.side`."""

from typing import Any

import numpy as np

from soccer_env import Match
from soccer_env.leagues.league import League
from soccer_env.types import AWAY, HOME
from tests.scenes.staging import put, put_ball, stage, stand, steady

CASES = [(team, half) for team in (HOME, AWAY) for half in (0, 1)]


class Scene:
    """Robots a side in play; places are in the frame of the acting team, which attacks +x."""

    def __init__(self, league: str | League, team: int, half: int, players: int = 1, **settings: Any) -> None:
        self.match: Match = stage(steady(league), home=players, away=players, rules=None, **settings)
        self.team, self.players = team, players
        direction = 1.0 if half == 0 else -1.0
        self.match.matches["half"], self.match.matches["home_direction"] = half, direction
        self.side = direction if team == HOME else -direction
        self.actions = stand(self.match)
        self.line = self.match.league.pitch.length / 2

    def row(self, mate: int = 0, opponent: bool = False) -> int:
        """Return the row of a robot of the acting team, or of its opponents."""
        team = self.team if not opponent else 1 - self.team
        return team * self.players + mate

    def put(self, row: int, x: float, y: float, heading: float = 0.0) -> None:
        """Put a robot somewhere [m, rad]."""
        put(self.match, row, self.side * x, self.side * y, heading + (0.0 if self.side > 0 else np.pi))

    def ball(self, x: float, y: float, vx: float = 0.0, vy: float = 0.0) -> None:
        """Put the ball somewhere [m], rolling [m/s]."""
        put_ball(self.match, *(self.side * value for value in (x, y, vx, vy)))

    def feed(self, row: int, x: float, y: float, heading: float = 0.0) -> None:
        """Put a robot somewhere with the ball in the middle of its front."""
        self.put(row, x, y, heading)
        ahead = self.match.league.body.front + self.match.league.ball.radius + 0.005
        self.ball(x + ahead * np.cos(heading), y + ahead * np.sin(heading))

    def begin(self) -> None:
        """Let physics follow from the records, and possession with it."""
        self.match.rebuild()
        self.play(1, idle=True)

    def walk(self, row: int, share: float, seconds: float) -> None:
        """Let a robot walk ahead at a share of its top speed for a time [s]."""
        self.actions[:, row, 0] = share
        self.play(round(seconds * self.match.league.control_rate))

    def play(self, steps: int, idle: bool = False) -> None:
        for _ in range(steps):
            self.match.step(stand(self.match) if idle else self.actions)

    def kick(self, row: int, strength: float = 1.0, seconds: float = 3.0) -> None:
        """Let a robot kick once, and the ball roll."""
        self.actions[:, row, 3] = strength
        for _ in range(round(self.match.league.control_rate)):
            self.play(1)
            if self.match.robot_events["kick"][0, row]:
                break
        else:
            raise AssertionError("no kick")
        self.actions[:, row, 3] = 0.0
        self.play(round(seconds * self.match.league.control_rate))

    def of(self, name: str, opponents: bool = False) -> Any:
        """Return a statistic of the acting team or of its opponents."""
        found = self.match.statistics[name][0]
        return found[1 - self.team if opponents else self.team]
