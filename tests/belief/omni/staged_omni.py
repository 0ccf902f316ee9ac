"""Scenes for the world model of a middle-size robot, and robots that report by radio what the test tells them."""

from math import cos, sin
from typing import Any

import numpy as np

from soccer_env import Match
from soccer_env.match.staging import begin_scene
from tests.belief.staged_talk import Talkers
from tests.scenes.staging import MIDDLE, stage, steady

CLEAR = {  # what can be seen is seen, but for its pixels
    **dict.fromkeys(("ball_miss", "player_miss", "false_balls", "barrier_miss", "odometry_noise"), 0.0),
    "ball_range": 100.0,
    "player_range": 100.0,
}


def thinking_matches(matches: int = 1, home: int = 1, away: int = 1, sensors: Any = None, memory: Any = None,
             ball: Any = (2.0, 0.0), robots: Any = None) -> Match:  # fmt: skip
    """Return matches in which robot 0 stands on the centre spot, the others are off, the ball lies 2 m ahead."""
    alone, seen = {"shared": False, **(memory or {})}, {**CLEAR, **(sensors or {})}
    robots = {0: (0.0, 0.0), **(robots or {})}
    match = stage(
        steady(MIDDLE), matches, home, away, ball=ball, robots=robots, observe="belief", sensors=seen, memory=alone
    )
    match.robots["placed"] = 0
    begin_scene(match)
    return match


def states_in_frame(match: Match, r: int, things: np.ndarray) -> np.ndarray:
    """Return places and velocities over the ground (M, 4) of things in the frame of robot r."""
    robot = match.robots[:, r]
    cosine, sine = np.cos(robot["heading"]), np.sin(robot["heading"])
    x, y = things["x"] - robot["x"], things["y"] - robot["y"]
    vx, vy = things["vx"], things["vy"]
    return np.stack(
        [cosine * x + sine * y, cosine * y - sine * x, cosine * vx + sine * vy, cosine * vy - sine * vx], axis=-1
    )


def state(believed: np.ndarray) -> np.ndarray:
    """Return the places and velocities (M, 4) in beliefs about a ball or in tracks."""
    return np.stack([believed[name] for name in ("x", "y", "vx", "vy")], axis=-1)


def ball_errors(match: Match, r: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Return how far the believed ball of robot r is off in place [m] and velocity [m/s], (M,) each."""
    error = state(match.beliefs["ball"][:, r]) - states_in_frame(match, r, match.balls)
    return np.hypot(error[:, 0], error[:, 1]), np.hypot(error[:, 2], error[:, 3])


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
        return self.tracks["number"][r][self.tracks["present"][r] == 1].tolist()


def turned(x: Any, y: Any, angle: float) -> np.ndarray:
    return np.array([cos(angle) * x - sin(angle) * y, sin(angle) * x + cos(angle) * y])
