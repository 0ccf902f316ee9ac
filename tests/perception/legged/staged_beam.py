"""Scenes before the infrared ranger: a robot on the centre spot, its beam, and what is put in its way."""

from math import cos, sin
from typing import Any

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.optics.head_camera import camera_place
from soccer_env.perception.legged.infrared import measure_range, trace_beam
from soccer_env.types import BALL, MATCH, ROBOT
from tests.scenes.staging import LEGGED

LEAGUE = find_league(LEGGED)
SHARP = {"infrared_noise": 0.0, "infrared_growth": 0.0, "infrared_pointing": 0.0}
FAR_AWAY = 50.0  # [m]


@compiled
def measure_all(matches, balls, robots, constants, sensors, ranges):  # type: ignore[no-untyped-def]
    for m in range(robots.shape[0]):
        for r in range(robots.shape[1]):
            ranges[m, r] = measure_range(matches[m], balls[m], robots[m], constants[0], sensors[0], r)


@compiled
def trace_all(balls, robots, constants, sensors, lateral, vertical, paths):  # type: ignore[no-untyped-def]
    for m in range(robots.shape[0]):
        paths[m] = trace_beam(balls[m], robots[m], constants[0], sensors[0], 0, lateral, vertical)


class BeamScene:
    """One or more matches: robot 0 at the centre spot with its head level, the ball and robot 1 far away."""

    def __init__(self, matches: int = 1, robots: int = 2, **sensors: float) -> None:
        self.matches, self.balls = np.zeros(matches, MATCH), np.zeros(matches, BALL)
        self.robots = np.zeros((matches, robots), ROBOT)
        self.matches["handedness"] = self.matches["home_direction"] = 1.0
        self.robots["team"] = np.arange(robots) % 2
        self.robots["number"] = np.arange(robots) // 2
        self.robots["active"] = 1
        self.robots["x"][:, 1:] = self.balls["x"] = FAR_AWAY
        noise = self.robots["noise"]
        noise[:] = np.random.default_rng(8).integers(0, 1 << 63, noise.shape, np.uint64)
        self.constants = constants_of(LEAGUE)
        self.sensors = LEAGUE.sensors.changed(SHARP | sensors).record()

    def put(self, r: int, x: Any, y: Any, heading: Any = 0.0, pan: Any = 0.0, tilt: Any = 0.0) -> None:
        """Put a robot of every match somewhere, its head turned."""
        for name, value in zip(("x", "y", "heading", "pan", "tilt"), (x, y, heading, pan, tilt), strict=True):
            self.robots[name][:, r] = value

    def readings(self) -> np.ndarray:
        """Return what the rangers (M, R) read [m]."""
        found = np.zeros(self.robots.shape)
        measure_all(self.matches, self.balls, self.robots, self.constants, self.sensors, found)
        return found

    def path(self, lateral: float = 0.0, vertical: float = 0.0) -> float:
        """Return how far the beam of robot 0 travels in the first match [m]."""
        found = np.zeros(len(self.robots))
        trace_all(self.balls, self.robots, self.constants, self.sensors, lateral, vertical, found)
        return float(found[0])

    def camera(self) -> np.ndarray:
        """Return where the camera of robot 0 is in the first match [m], field frame."""
        robot = self.robots[0, 0]
        ahead, left, height = camera_place(robot["pan"], robot["tilt"], np.rec.array(self.sensors)[0])
        cosine, sine = cos(robot["heading"]), sin(robot["heading"])
        return np.array([robot["x"] + cosine * ahead - sine * left, robot["y"] + sine * ahead + cosine * left, height])


def aim_at(place: BeamScene, x: Any, y: Any, z: float) -> None:
    """Turn the heads of all robots 0 so that the optical axis goes through a point [m], field frame."""
    robot, sensors = place.robots[:, 0], LEAGUE.sensors
    cosine, sine = np.cos(robot["heading"]), np.sin(robot["heading"])
    x, y = x - robot["x"], y - robot["y"]
    ahead, left, up = cosine * x + sine * y - sensors.neck_ahead, cosine * y - sine * x, z - sensors.neck_height
    level = np.hypot(ahead, left)
    robot["pan"] = np.arctan2(left, ahead)
    robot["tilt"] = np.arctan2(up, level) - np.arcsin(sensors.camera_up / np.hypot(level, up))
