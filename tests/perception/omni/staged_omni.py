"""Scenes before the mirror camera: a robot in the middle, things put round it, one look."""

from typing import Any

import numpy as np

from soccer_env import Match
from tests.scenes.staging import MIDDLE, stage

NOW = {"camera_delay": 0, "search_every": 1}
SHARP = {"pixel_noise": 0.0, **NOW}  # nothing but whole pixels
SURE = {  # what can be seen is seen
    **dict.fromkeys(("ball_miss", "player_miss", "goal_miss", "line_miss", "false_balls"), 0.0),
    "ball_range": 100.0,
    "player_range": 100.0,
}


def watching_matches(matches: int = 1, home: int = 1, away: int = 1, *, sensors: Any = None, robots: Any = None,
             ball: Any = (-4.0, -3.0), **settings: Any) -> Match:  # fmt: skip
    """Return matches in which robot 0 stands on the centre spot and looks at +x, the others are off, the ball aside."""
    seen, robots = {**NOW, **(sensors or {})}, {0: (0.0, 0.0), **(robots or {})}
    match = stage(MIDDLE, matches, home, away, ball=ball, robots=robots, observe="percepts", sensors=seen, **settings)
    match.robots["placed"] = 0
    return match


def look(match: Match, frames: int = 1) -> np.ndarray:
    """Let robots forget and look for some frames at the field as it is; return robot 0's percepts (M,)."""
    for m in range(match.count):
        match.batch.senses.start(m)
    for frame in range(frames):
        match.matches["step"] = frame
        match.batch.senses.sense(0, match.count)
    return match.percepts[:, 0]


def gather(match: Match, frames: int) -> np.ndarray:
    """Look for some frames; return robot 0's percepts (frames, M)."""
    found = []
    for _ in range(frames):
        match.batch.senses.sense(0, match.count)
        found.append(match.percepts[:, 0].copy())
    return np.stack(found)


def bearings_all_round(count: int) -> np.ndarray:
    """Return bearings [rad] in all directions, none of them special."""
    return (np.arange(count) + 0.37) / count * 2.0 * np.pi - np.pi


def angle_difference(one: Any, other: Any) -> Any:
    """Return the difference of two angles [rad] in [-pi, pi)."""
    return (np.asarray(one, float) - other + np.pi) % (2.0 * np.pi) - np.pi
