"""Scenes for the world model of a middle-size robot: played for a while, believed and true side by side."""

from typing import Any

import numpy as np

from soccer_env import Match
from tests.scenes.staging import MIDDLE, play, put, put_ball, stage, stand, steady

CLEAR = {  # what can be seen is seen, but for its pixels
    **dict.fromkeys(("ball_miss", "player_miss", "false_balls", "barrier_miss", "odometry_noise"), 0.0),
    "ball_range": 100.0,
    "player_range": 100.0,
}


def thinking(matches: int = 1, home: int = 1, away: int = 1, sensors: Any = None, memory: Any = None) -> Match:
    """Return matches in which robot 0 stands on the centre spot, the others are off, the ball lies 2 m ahead."""
    alone = {"shared": False, **(memory or {})}
    seen = {**CLEAR, **(sensors or {})}
    match = stage(steady(MIDDLE), matches, home, away, observe="belief", sensors=seen, memory=alone)
    put(match, 0, 0.0, 0.0)
    put_ball(match, 2.0, 0.0)
    match.robots["placed"] = 0
    return match


def begin(match: Match) -> None:
    """Build the physics of what was put somewhere, and let robots forget all that they believed."""
    match.rebuild()
    for m in range(match.count):
        match.batch.senses.start(m)


def run(match: Match, seconds: float, actions: np.ndarray | None = None) -> None:
    """Play for a time [s], everybody standing unless told otherwise."""
    play(match, seconds, stand(match) if actions is None else actions)


def in_frame(match: Match, r: int, things: np.ndarray) -> np.ndarray:
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


def off(match: Match, r: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Return how far the believed ball of robot r is off in place [m] and velocity [m/s], (M,) each."""
    error = state(match.beliefs["ball"][:, r]) - in_frame(match, r, match.balls)
    return np.hypot(error[:, 0], error[:, 1]), np.hypot(error[:, 2], error[:, 3])
