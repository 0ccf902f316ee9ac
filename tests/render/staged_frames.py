"""Records to draw, and where a frame shows a colour: pixels as metres in the field frame."""

from math import pi
from typing import Any

import numpy as np

from soccer_env import types
from soccer_env.render import Picture


def make_records(home: int = 2, away: int = 2) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return a match in play, a ball at rest at the centre, and robots in two columns on their own sides."""
    match, ball, robots = np.zeros((), types.MATCH), np.zeros((), types.BALL), np.zeros(home + away, types.ROBOT)
    match["half_length"], match["home_direction"] = 600.0, 1.0
    match["restart_team"] = match["last_touch_team"] = match["last_touch_robot"] = -1
    for row, robot in enumerate(robots):
        robot["team"] = int(row >= home)
        robot["number"] = row - home * (row >= home)
        robot["active"] = 1
        side = 2 * robot["team"] - 1
        robot["x"], robot["y"] = 0.7 * side, -0.6 + 0.4 * robot["number"]
        robot["heading"] = pi if robot["team"] else 0.0
    return match, ball, robots


def stage_picture(league: str, home: int = 2, away: int = 2, **size: int) -> tuple[Any, np.ndarray, np.ndarray, Any]:
    """Return a picture of a league, and the records of `make_records` to draw."""
    return Picture(league, **size), *make_records(home, away)


def coloured_pixels(frame: np.ndarray, colour: Any, tolerance: int = 24) -> np.ndarray:
    """Return where a frame shows a colour."""
    return (np.abs(frame.astype(int) - colour).max(axis=2) <= tolerance).astype(bool)


def points_around(picture: Any, mask: np.ndarray, x: float, y: float, radius: float) -> np.ndarray:
    """Return the points of a mask (rows, columns) within a radius [m] of a place, as metres in the field frame."""
    rows, columns = np.nonzero(mask)
    xs = (columns + 0.5 - picture.view.centre_x) / picture.view.scale
    ys = -(rows + 0.5 - picture.header_height - picture.view.centre_y) / picture.view.scale
    points = np.column_stack([xs, ys])
    return points[np.hypot(xs - x, ys - y) < radius]


def centre_of(picture: Any, mask: np.ndarray, x: float, y: float, radius: float) -> np.ndarray:
    """Return the middle of those points; fail if there are none."""
    points = points_around(picture, mask, x, y, radius)
    assert len(points), "the colour is not there"
    return points.mean(axis=0)
