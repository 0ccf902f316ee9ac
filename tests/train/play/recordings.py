"""Recordings made by hand: a ball that lies in the middle, and robots that stand one beside the other far from it."""

from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.train.play.recording import BALL_MOMENT, DEEDS, MOMENT, ROBOT_MOMENT, WHISTLES, Recording
from soccer_env.types import NO_TEAM, Phase

AWAY_Y = -3.0  # [m] where robots wait that a test does not mention


def blank(steps: int, *, matches: int = 1, robots: int = 2, league: str | League = "middle-size-2006") -> Recording:
    """Return a recording in play in which nothing happens."""
    found = Recording(
        league=find_league(league),
        live=np.ones((steps, matches), bool),
        matches=np.zeros((steps, matches), MOMENT),
        balls=np.zeros((steps, matches), BALL_MOMENT),
        robots=np.zeros((steps, matches, robots), ROBOT_MOMENT),
        events=np.zeros((steps, matches), WHISTLES),
        deeds=np.zeros((steps, matches, robots), DEEDS),
    )
    found.matches["phase"], found.matches["last_touch_robot"] = Phase.PLAY, -1
    found.events["goal"] = NO_TEAM
    found.robots["active"], found.robots["y"] = 1, AWAY_Y
    found.robots["x"] = np.arange(robots) - robots / 2
    return found


def put(recording: Recording, r: int, x: Any, y: Any, heading: Any = 0.0) -> None:
    """Put a robot of every match somewhere, for all steps [m, m, rad]."""
    for name, value in (("x", x), ("y", y), ("heading", heading)):
        recording.robots[name][:, :, r] = np.reshape(value, (-1, 1)) if np.ndim(value) else value


def roll(recording: Recording, x: Any, y: Any) -> None:
    """Put the ball of every match on a path (T,) [m], with the velocities that belong to it."""
    rate = recording.league.control_rate
    for name, path in (("x", x), ("y", y)):
        path = np.broadcast_to(path, len(recording.live)).astype(float)
        recording.balls[name][:] = path[:, None]
        recording.balls[f"v{name}"][:] = (np.diff(path, prepend=path[0]) * rate)[:, None]
