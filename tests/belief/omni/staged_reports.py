"""Middle-size robots that report by radio, for tests: each believes what the test says, and hears the others."""

from math import cos, sin
from typing import Any

import numpy as np

from tests.belief.staged_talk import Talkers
from tests.scenes.staging import MIDDLE

POSES = ((-2.0, 0.5, 0.3), (1.0, 1.0, -2.0), (0.5, -2.0, 1.2))  # [m, m, rad] team frame


class Radio(Talkers):
    """Middle-size robots on the field that report to each other."""

    def __init__(self, home: int = 3, away: int = 0, **sensors: float) -> None:
        super().__init__(MIDDLE, home, away, **sensors)
        self.tracks["number"] = -1
        situation = self.beliefs["situation"]
        situation["number"] = [*range(home), *range(away)]
        situation["keeper"] = situation["number"] == 0
        for r in range(home + away):
            self.stand(r, *POSES[r % 3])

    def stand(self, r: int, x: float, y: float, heading: float, forward: float = 0.0, left: float = 0.0) -> None:
        """Let a robot believe that it is somewhere, and moves [m/s, robot frame]."""
        own = self.beliefs["own"][r : r + 1]
        own["x"], own["y"], own["heading"], own["forward"], own["left"] = x, y, heading, forward, left

    def track_ball(self, r: int, x: float, y: float, vx: float = 0.0, vy: float = 0.0, age: float = 0.0) -> None:
        """Let a robot believe the ball at a place of the field, team frame [m, m/s], seen some time ago [s]."""
        own, ball = self.beliefs["own"][r], self.beliefs["ball"][r : r + 1]
        ball["x"], ball["y"] = turned(x - own["x"], y - own["y"], -own["heading"])
        ball["vx"], ball["vy"] = turned(vx, vy, -own["heading"])
        ball["distance"] = ball["filtered_distance"] = np.hypot(ball["x"], ball["y"])
        ball["age"], ball["confidence"] = age, max(100.0 - 25.0 * age, 0.0)

    def film(self, r: int, slot: int, x: float, y: float, age: float = 0.0) -> None:
        """Let robot r have seen a team-mate with its own camera some time ago: at a place in its frame [m]."""
        track = self.tracks[r, slot : slot + 1]
        track["present"] = track["teammate"] = 1
        track["x"], track["y"], track["number"] = x, y, -1
        track["age"], track["confidence"] = age, 100.0 - 25.0 * age

    def place_of(self, r: int, number: int) -> np.ndarray:
        """Return where on the field [m] robot r believes the team-mate with a number; it must be in one slot."""
        slots = np.flatnonzero((self.tracks["number"][r] == number) & (self.tracks["present"][r] == 1))
        assert len(slots) == 1
        own, track = self.beliefs["own"][r], self.tracks[r, slots[0]]
        return np.array([own["x"], own["y"]]) + turned(track["x"], track["y"], own["heading"])

    def ball_of(self, r: int) -> np.ndarray:
        """Return where on the field [m] robot r believes the ball."""
        own, ball = self.beliefs["own"][r], self.beliefs["ball"][r]
        return np.array([own["x"], own["y"]]) + turned(ball["x"], ball["y"], own["heading"])

    def present(self, r: int) -> list[int]:
        """Return the numbers in the slots of robot r that are in use."""
        numbers: list[int] = self.tracks["number"][r][self.tracks["present"][r] == 1].tolist()
        return numbers


def turned(x: Any, y: Any, angle: float) -> np.ndarray:
    """Return a vector turned by an angle."""
    return np.array([cos(angle) * x - sin(angle) * y, sin(angle) * x + cos(angle) * y])
