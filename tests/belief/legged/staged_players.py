"""A robot that is shown players by hand: percepts made of boxes, without a camera.

    robot = Onlooker(player_odometry=False)                 settings of LeggedMemory by name
    robot.look(opponents=[player(u=10.0, height=6)])        a frame with a blob
    robot.look(opponents=[robot.show(1.0, 0.2)])            ... with the blob of a player 1 m ahead, 0.2 m to the left
    robot.look(forward=0.01)                                a frame without, after a step ahead
    robot.opponents["x"]

The tables are the plain law of the pinhole, range = focal length * height of a sticker / height of its blob, and
differ by known factors: `FACTORS`.
"""

from dataclasses import replace
from math import atan2, sqrt
from typing import Any

import numpy as np
import pytest

from soccer_env.belief.legged.players import PLAYERS_MEMORY, believe_players
from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.leagues.league import Slots
from soccer_env.optics.head_camera import camera_place, focal_y
from soccer_env.perception.legged.calibration import CALIBRATION
from soccer_env.records.beliefs import OWN_POSE, TRACK
from soccer_env.records.percepts import LEGGED_PERCEPT
from tests.scenes.projection import pixel_of_direction

LEAGUE = find_league("legged-2001")
STICKER_HEIGHT, STICKER_MIDDLE = 0.055, 0.13  # [m]
FACTORS = {"player_front": 1.0, "player_side": 1.1, "player_front_all": 2.0, "player_side_all": 2.2}
LEFT, RIGHT, AHEAD = (0.9, 0.4), (0.9, -0.4), (0.8, 0.0)  # [m] places in the picture of a head that looks ahead
Blob = tuple[int, int, int, int, int]  # left, right, high, low, area [px]


@compiled
def believe(percepts, owns, tracks, memories, constants, sensors, settings, tables):
    """Call the stage as its caller does, for some robots: percepts (N,), tracks (N, slots)."""
    k, s, w, table = constants[0], sensors[0], settings[0], tables[0]
    for n in range(percepts.shape[0]):
        believe_players(percepts[n], owns[n], tracks[n], memories[n], k, s, w, table)


def full_blob(u: float = 0.0, v: float = 0.0, height: int = 6, width: int | None = None) -> Blob:
    """Return a full blob whose middle lies u to the left and v above the picture's centre [px], in whole pixels."""
    width = height if width is None else width
    left, high = round(u + 0.5 * width), round(v + 0.5 * height)
    return left, left - width, high, high - height, width * height


class Onlooker:
    """One robot with its percept, memory and tracks; every call of `look` is a frame."""

    def __init__(self, teammates: int = 2, opponents: int = 3, **settings: Any) -> None:
        league = replace(LEAGUE, slots=Slots(teammates, opponents))
        self.constants, self.sensors = constants_of(league), league.sensors.record()
        self.settings = league.memory.changed(settings).record()
        self.tracks = np.zeros((1, teammates + opponents), TRACK)
        self.memories, self.owns, self.tables = np.zeros(1, PLAYERS_MEMORY), np.zeros(1, OWN_POSE), pinhole_tables()
        self.mates, self.dt = teammates, league.dt
        self.pan, self.tilt = 0.0, 0.0  # [rad] of the head

    @property
    def teammates(self) -> np.ndarray:
        return self.tracks[0, : self.mates]

    @property
    def opponents(self) -> np.ndarray:
        return self.tracks[0, self.mates :]

    def percept(self, opponents: list[Blob], teammates: list[Blob], infrared: float = 0.0, **body: float) -> np.ndarray:
        """Return a percept (1,) of blobs [px] after own motion [m, rad]; the ranger reads `infrared` [m]."""
        percepts = np.zeros(1, LEGGED_PERCEPT)
        for name, value in {"handedness": 1.0, "upright": 1, "active": 1, **body}.items():
            percepts["body"][name] = value
        percepts["pan"], percepts["tilt"], percepts["infrared"] = self.pan, self.tilt, infrared
        for name, blobs in (("opponents", opponents), ("teammates", teammates)):
            for i, blob in enumerate(blobs):
                percepts[name][0, i] = blob
        return percepts

    def look(self, opponents: list[Blob] | None = None, teammates: list[Blob] | None = None, **frame: float) -> None:
        """Believe a frame."""
        self.believe(self.percept(opponents or [], teammates or [], **frame))

    def wait(self, seconds: float, **frame: float) -> None:
        """Believe frames without players."""
        for _ in range(round(seconds / self.dt)):
            self.look(**frame)

    def believe(self, percepts: np.ndarray) -> None:
        """Believe a percept (1,) as it is."""
        believe(
            percepts, self.owns, self.tracks, self.memories, self.constants, self.sensors, self.settings, self.tables
        )

    def show(self, x: float, y: float) -> Blob:
        """Return the blob of a sticker of a player at x, y [m], robot frame, head as it is."""
        ahead, left, height = camera_place(self.pan, self.tilt, self.sensors[0])
        away = sqrt((x - ahead) ** 2 + (y - left) ** 2)
        bearing, elevation = atan2(y - left, x - ahead), atan2(STICKER_MIDDLE - height, away)
        u, v, inside = pixel_of_direction(bearing, elevation, self.pan, self.tilt, self.sensors[0])
        assert inside, f"a player at {x}, {y} is not in the picture"
        return full_blob(u, v, round(focal_y(self.sensors[0]) * STICKER_HEIGHT / away))


def pinhole_tables() -> np.ndarray:
    """Return the tables (1,) of a camera with the real one's focal length."""
    tables = np.zeros(1, CALIBRATION)
    for name, factor in FACTORS.items():
        heights = np.maximum(np.arange(tables[name].shape[1]), 1)
        tables[name] = factor * focal_y(LEAGUE.sensors.record()[0]) * STICKER_HEIGHT / heights
    return tables


def places(tracks: np.ndarray) -> list[tuple[float, float]]:
    """Return x, y [m] of the slots in use."""
    return [(float(t["x"]), float(t["y"])) for t in tracks if t["present"]]


def near(place: tuple[float, float]) -> Any:
    """Return a place that equals any within 8 cm: the picture has whole pixels."""
    return pytest.approx(place, abs=0.08)
