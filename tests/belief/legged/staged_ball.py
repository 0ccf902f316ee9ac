"""A robot that is shown a ball by hand: percepts made with the camera's geometry, without the camera.

    robot = Watcher(averaged=1)         settings of LeggedMemory by name
    robot.see(0.8, 0.1)                 a frame with the ball 0.8 m ahead and 0.1 m to the left, robot frame
    robot.miss(forward=0.01)            a frame without it, after a step ahead
    robot.ball["distance"]

The camera has 64 times the pixels of the real one in each direction, so that rounding to whole pixels hardly shows,
and the tables of sizes are the plain law of the pinhole: size = focal length * diameter / range. `Watcher.coarse` has
the real camera.
"""

from __future__ import annotations

from math import atan2, sqrt
from typing import Any

import numpy as np

from soccer_env.belief.legged.ball import BALL_MEMORY, believe_ball
from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.optics.head_camera import camera_place, focal_x, focal_y
from soccer_env.records.beliefs import BELIEF
from soccer_env.records.percepts import LEGGED_PERCEPT
from tests.scenes.projection import pixel_of_direction

LEAGUE = find_league("legged-2001")
FINE, REAL = 7, 1  # steps of resolution
SIZES = 8192  # [px] room in the tables: more than in the real ones
TABLES = np.dtype([("ball_width", "f8", (SIZES,)), ("ball_height", "f8", (SIZES,))])
TINY = {"area_small": 1e-5, "area_large": 1e-5}  # [px] at 88x72: areas of so fine a picture do not fit their field


@compiled
def believe(percepts, beliefs, memories, constants, sensors, settings, tables):
    """Call the stage as its caller does: with records that lie in arrays."""
    belief = beliefs[0]
    k, s, w, table = constants[0], sensors[0], settings[0], tables[0]
    believe_ball(percepts[0], belief.own, belief.ball, memories[0], k, s, w, table)


class Watcher:
    """One robot with its percept, memory and belief; every call of `see` or `miss` is a frame."""

    def __init__(self, resolution: int = FINE, **settings: Any) -> None:
        self.constants, self.sensors = constants_of(LEAGUE), LEAGUE.sensors.record()
        self.sensors["resolution"] = resolution
        for name in ("focal_x", "focal_y", "picture_width", "picture_height"):
            self.sensors[name] *= 2.0 ** (resolution - REAL)
        settings = {**(TINY if resolution == FINE else {}), **settings}
        self.settings = LEAGUE.memory.changed(settings).record()
        self.beliefs, self.memories = np.zeros(1, BELIEF), np.zeros(1, BALL_MEMORY)
        self.tables = np.zeros(1, TABLES)
        sizes = np.maximum(np.arange(SIZES), 0.5)
        diameter = 2.0 * LEAGUE.ball.radius
        self.focal = focal_x(self.sensors[0]), focal_y(self.sensors[0])
        self.tables["ball_width"] = self.focal[0] * diameter / sizes
        self.tables["ball_height"] = self.focal[1] * diameter / sizes
        self.dt = LEAGUE.dt
        self.frame, self.head = -1, (0.0, -0.3)  # pan, tilt [rad]

    @classmethod
    def coarse(cls, **settings: Any) -> Watcher:
        """Return a robot with the camera of the paper."""
        return cls(REAL, **settings)

    @property
    def ball(self) -> np.void:
        return self.beliefs[0]["ball"]

    @property
    def place(self) -> tuple[float, float]:
        """The latest estimate, x and y in the robot frame [m]."""
        distance, bearing = self.ball["distance"], self.ball["bearing"]
        return distance * np.cos(bearing), distance * np.sin(bearing)

    @property
    def filtered_place(self) -> tuple[float, float]:
        """The filtered estimate, x and y in the robot frame [m]."""
        distance, bearing = self.ball["filtered_distance"], self.ball["filtered_bearing"]
        return distance * np.cos(bearing), distance * np.sin(bearing)

    def look(self, *blobs: tuple[int, ...], forward: float = 0.0, left: float = 0.0, turn: float = 0.0,
             infrared: float = 0.0, skip: int = 1, **body: int) -> np.void:  # fmt: skip
        """Believe a frame with blobs (left, right, high, low, area) [px], after own motion [m, rad]."""
        self.frame += skip
        percepts = np.zeros(1, LEGGED_PERCEPT)
        felt = {"frame": self.frame, "handedness": 1, "forward": forward, "left": left, "turn": turn}
        for name, value in {**felt, "upright": 1, "active": 1, **body}.items():
            percepts["body"][name] = value
        percepts["pan"], percepts["tilt"] = self.head
        percepts["infrared"] = infrared
        for i, blob in enumerate(blobs):
            percepts["ball"][0, i] = blob
        return self.believe(percepts)

    def believe(self, percepts: np.ndarray) -> np.void:
        """Believe a percept (1,) as it is."""
        believe(percepts, self.beliefs, self.memories, self.constants, self.sensors, self.settings, self.tables)
        return self.ball

    def see(self, x: float, y: float, share: tuple[float, float] = (1.0, 1.0), **frame: Any) -> np.void:
        """Believe a frame in which the ball lies at x, y [m], robot frame, after the motion; `share` of it shows."""
        return self.look(self.blob(x, y, share), **frame)

    def miss(self, **frame: Any) -> np.void:
        return self.look(**frame)

    def blob(self, x: float, y: float, share: tuple[float, float] = (1.0, 1.0)) -> tuple[int, ...]:
        """Return the blob of a ball at x, y [m], robot frame, of which a share of width and height shows.

        The head is turned to it first if it would lie outside the picture.
        """
        found = self.project(x, y)
        if found[4] == 0:
            self.face(x, y)
            found = self.project(x, y)
        u, v, wide, high, inside = found
        assert inside, f"a ball at {x}, {y} cannot be shown"
        width, height = max(round(share[0] * wide), 1), max(round(share[1] * high), 1)
        left, top = round(u + 0.5 * width), round(v + 0.5 * height)
        return left, left - width, top, top - height, min(width * height, 32767)

    def face(self, x: float, y: float) -> None:
        """Turn the head towards a place until a ball there lies in the picture."""
        for tilt in (-0.3, -0.6, -0.9, -1.2, -1.4):
            self.head = atan2(y, max(x - 0.075, 1e-9)), tilt  # [m] the neck lies ahead of the body's origin
            if self.project(x, y)[4]:
                return

    def project(self, x: float, y: float) -> tuple[float, float, float, float, int]:
        """Return u, v, width, height [px] of a ball at x, y [m], robot frame, and whether it is in the picture."""
        ahead, left, height = camera_place(*self.head, self.sensors[0])
        dx, dy = x - ahead, y - left
        away = sqrt(dx * dx + dy * dy)
        elevation = atan2(LEAGUE.ball.radius - height, away)
        u, v, inside = pixel_of_direction(atan2(dy, dx), elevation, *self.head, self.sensors[0])
        diameter = 2.0 * LEAGUE.ball.radius
        return u, v, self.focal[0] * diameter / max(away, 0.02), self.focal[1] * diameter / max(away, 0.02), inside
