"""A player of sacks-2001 alone with what it is told to believe."""

from typing import Any

import numpy as np

from soccer_env import make_team
from soccer_env.leagues import find_league
from soccer_env.records.beliefs import BELIEF, TRACK
from soccer_env.teams import TeamRandom, View
from soccer_env.types import NOISE_STREAMS

LEAGUE = find_league("legged-2001")
RATE = LEAGUE.control_rate
FORWARD, LEFT, TURN, KICK = range(4)  # columns of its commands


class Mind:
    """One player, its beliefs and its memory; `think` lets it decide for a time, the beliefs unchanged."""

    def __init__(self, **settings: Any) -> None:
        self.league = LEAGUE
        self.team = make_team("sacks-2001", **settings)
        self.beliefs = np.zeros((1, 1), BELIEF)
        self.tracks = np.zeros((1, 1, LEAGUE.slots.teammates + LEAGUE.slots.opponents), TRACK)
        self._memory = np.zeros((1, 1), self.team.memory_dtype)
        self._rng = TeamRandom(np.zeros((1, 1, NOISE_STREAMS), np.uint64), np.arange(1))
        self.belief["own"]["confidence"] = 100.0
        self.belief["situation"]["active"], self.belief["situation"]["number"] = 1, 1
        self.belief["heard"]["distance"] = self.belief["heard"]["age"] = np.inf
        self.see_ball(1.0)

    @property
    def belief(self) -> np.void:
        return self.beliefs[0, 0]  # type: ignore[no-any-return]

    @property
    def memory(self) -> np.void:
        return self._memory[0, 0]  # type: ignore[no-any-return]

    def see_ball(self, distance: float, bearing: float = 0.0, radial: float = 0.0, held: int = 0) -> None:
        """Believe that the ball is there [m, rad], and how fast its distance grows [m/s]."""
        ball = self.belief["ball"]
        ball["distance"] = ball["filtered_distance"] = distance
        ball["bearing"] = ball["filtered_bearing"] = bearing
        ball["x"], ball["y"] = distance * np.cos(bearing), distance * np.sin(bearing)
        ball["radial"], ball["confidence"], ball["age"], ball["held"] = radial, 100.0, 0.0, held

    def stand_at(self, x: float, y: float, heading: float = 0.0) -> None:
        """Believe to stand there [m, m, rad], team frame."""
        own = self.belief["own"]
        own["x"], own["y"], own["heading"] = x, y, heading

    def think(self, seconds: float = 1.0 / RATE) -> np.ndarray:
        """Return the commands (T, 7) of a time: forward, left, turn, kick, head, pan, tilt."""
        steps = max(1, round(seconds * RATE))
        view = View(self.league, self.beliefs, self.tracks)
        return np.array([self.team.act(view, self._memory, self._rng)[0, 0] for _ in range(steps)])

    def does(self, seconds: float = 1.0 / RATE) -> int:
        """Let it think for a time; return what it does then."""
        self.think(seconds)
        return int(self.memory["behaviour"])
