"""The true camera, ranger beam and ball of legged robots, for all matches at once."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.match.staging import sensors_of
from soccer_env.optics.head_camera import share_of_tilt
from soccer_env.train.papers.staging import distance_to_point, play, still_actions, watch


def camera_of(match: Match, r: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Return the position of robot r's camera (M, 3) [m] and the unit vector along its axis (M, 3), field frame.

    The geometry of soccer_env.optics.head_camera for all matches at once; a test compares the two.
    """
    s, robot = match.league.sensors, match.robots[:, r]
    pan, tilt = robot["heading"] + robot["pan"], robot["tilt"]
    forward = s.camera_ahead * np.cos(tilt) - s.camera_up * np.sin(tilt)
    height = s.neck_height + s.camera_up * np.cos(tilt) + s.camera_ahead * np.sin(tilt)
    x = robot["x"] + s.neck_ahead * np.cos(robot["heading"]) + forward * np.cos(pan)
    y = robot["y"] + s.neck_ahead * np.sin(robot["heading"]) + forward * np.sin(pan)
    axis = np.stack([np.cos(tilt) * np.cos(pan), np.cos(tilt) * np.sin(pan), np.sin(tilt)], axis=1)
    return np.stack([x, y, height], axis=1), axis


def ball_in_sight(match: Match, r: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Return the ball's distance from the camera (M,) [m], and its angle off the camera's axis (M,) [rad]."""
    camera, axis = camera_of(match, r)
    ball = np.stack([match.balls["x"], match.balls["y"], np.full(match.count, match.league.ball.radius)], axis=1)
    away = ball - camera
    distance = np.linalg.norm(away, axis=1)
    cosine = (away * axis).sum(axis=1) / np.maximum(distance, 1e-9)
    return distance, np.arccos(np.clip(cosine, -1.0, 1.0))


def ball_angle(match: Match, distance: np.ndarray) -> np.ndarray:
    """Return the angle [rad] that the ball's radius spans at a distance (M,)."""
    return np.asarray(np.arcsin(np.minimum(match.league.ball.radius / np.maximum(distance, 1e-9), 1.0)))


def stare_at_ball(match: Match, actions: np.ndarray, r: int = 0) -> None:
    """Turn the head of robot r to the true ball: fill columns 4 to 6 of actions (M, R, 7)."""
    look_at_point(match, actions, r, match.balls["x"], match.balls["y"], match.league.ball.radius)


def look_at_point(match: Match, actions: np.ndarray, r: int, x: np.ndarray, y: np.ndarray, height: float) -> None:
    """Turn the head of robot r to a point (M,) [m, field frame]: fill columns 4 to 6 of actions (M, R, 7)."""
    s = match.league.sensors
    distance, bearing = distance_to_point(match, r, x, y)
    # from the neck, about which the head turns
    ahead, left = distance * np.cos(bearing) - s.neck_ahead, distance * np.sin(bearing)
    away, down = np.hypot(ahead, left), s.neck_height - height
    # the camera stands camera_up above the line through the neck along which it looks
    tilt = -np.arctan2(down, away) - np.arcsin(np.minimum(s.camera_up / np.hypot(away, down), 1.0))
    turn_head(match, actions, r, np.arctan2(left, ahead), tilt)


def turn_head(match: Match, actions: np.ndarray, r: int, pan: Any, tilt: Any) -> None:
    """Ask robot r to turn its head to pan and tilt [rad]: fill columns 4 to 6 of actions (M, R, 7)."""
    head = match.league.head
    actions[:, r, 4] = 1.0
    actions[:, r, 5] = np.clip(pan / head.pan_limit, -1.0, 1.0)
    actions[:, r, 6] = np.clip(share_of_tilt(tilt, head.tilt_low, head.tilt_high), -1.0, 1.0)


def range_from_camera(match: Match, r: int = 0) -> np.ndarray:
    """Return the ball's distance along the ground from robot r's camera (M,) [m]."""
    camera, _ = camera_of(match, r)
    return np.asarray(np.hypot(match.balls["x"] - camera[:, 0], match.balls["y"] - camera[:, 1]))


def stare_for(match: Match, settle: float, seconds: float) -> Iterator[int]:
    """Let robot 0 stand and stare at the true ball; yield each step of `seconds`, after `settle` [s] before them."""
    actions = still_actions(match)
    return watch(match, seconds, actions, settle, lambda step: stare_at_ball(match, actions))


def look_first(match: Match, seconds: float, r: int = 0) -> None:
    """Let robot r stand and stare at the true ball for `seconds`, so that it sees the ball; needs actions="full"."""
    actions = still_actions(match)
    for _ in play(match, seconds, actions):
        stare_at_ball(match, actions, r)


BLIND = {"ball_miss": 1.0, "red_as_orange": 0.0, "false_balls": 0.0}  # of either league, where it has them


def blind_cameras(match: Match) -> None:
    """Hide the ball and false balls from all cameras from now on; coloured patches are left to the caller."""
    for name, value in BLIND.items():
        if hasattr(match.league.sensors, name):
            sensors_of(match)[name] = value


def restore_cameras(match: Match) -> None:
    """Undo `blind_cameras`: restore the sensor settings of the league."""
    for name in BLIND:
        if hasattr(match.league.sensors, name):
            sensors_of(match)[name] = getattr(match.league.sensors, name)


def follow_ball(match: Match, keep: float = 0.0, r: int = 0) -> np.ndarray:
    """Return walk actions (M, 3) in [-1, 1] of robot r to within `keep` [m] of the true ball; 0: into the ball."""
    distance, bearing = distance_to_point(match, r, match.balls["x"], match.balls["y"])
    walk = np.zeros((match.count, 3))
    walk[:, 0] = np.where(np.abs(bearing) < 0.6, np.clip((distance - keep) / 0.2, -1.0, 1.0), 0.0)
    walk[:, 2] = np.clip(bearing / 0.4, -1.0, 1.0)
    return walk
