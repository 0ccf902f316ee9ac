"""Tables from sizes in the picture to ranges, made by rendering without noise.  [Sacks 2001, 3.1.1, 4.1.2]  MS09, MS33

A range counts along the ground, from the camera to the middle of the ball or player: what the memory adds to the
camera's own place on its neck. The camera looks at the middle of what is measured, as it does while it tracks it.
"""

from __future__ import annotations

from functools import lru_cache
from math import pi

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.leagues.league import League
from soccer_env.perception.picture import draw_scene
from soccer_env.perception.sketch import BALL as BALL_PIECES
from soccer_env.perception.sketch import OPPONENTS, make_sketch
from soccer_env.types import AWAY, BALL, MATCH, ROBOT

SIZES = 256  # [px] sizes that a table has room for; larger ones read as the last
RANGES = np.arange(0.15, 3.001, 0.05)  # [m] at which pictures are taken: every 5 cm from 15 to 300, FACTS 4
FRONT, SIDE = pi, 0.5 * pi  # [rad] headings of a player that faces the camera, or shows it a flank
FAR_OFF = 50.0  # [m] where what is not measured stands

CALIBRATION = np.dtype(
    [
        ("ball_width", "f8", (SIZES,)),  # [m] range of a ball that is i pixels wide
        ("ball_height", "f8", (SIZES,)),  # [m]
        ("player_front", "f8", (SIZES,)),  # [m] range of a player whose largest sticker is i pixels high, seen head-on
        ("player_side", "f8", (SIZES,)),  # [m] the same from the side
        ("player_front_all", "f8", (SIZES,)),  # [m] the same for the box round all its stickers
        ("player_side_all", "f8", (SIZES,)),  # [m]
    ]
)


@lru_cache(maxsize=16)
def calibrate(league: League) -> np.ndarray:
    """Return the (1,) record of tables for a league's camera.  MS09, MS33"""
    tables = np.zeros(1, CALIBRATION)
    widths, heights = ball_sizes(league)
    tables["ball_width"], tables["ball_height"] = invert(widths), invert(heights)
    for name, heading in (("front", FRONT), ("side", SIDE)):
        largest, together = player_heights(league, heading)
        tables[f"player_{name}"], tables[f"player_{name}_all"] = invert(largest), invert(together)
    return tables


def invert(sizes: np.ndarray) -> np.ndarray:
    """Return the range [m] for each whole size, by linear interpolation between the sizes at RANGES.

    Beyond either end of the pictures the range goes on as one over the size.
    """
    whole = np.arange(SIZES, dtype=np.float64)
    inverse = np.where(whole > 0.0, 1.0 / np.maximum(whole, 1e-9), 1.0)  # size 0 reads as size 1
    falling = np.maximum.accumulate(1.0 / sizes)  # what is farther never seems larger
    ranges = np.interp(inverse, falling, RANGES)
    ranges = np.where(inverse > falling[-1], RANGES[-1] * inverse / falling[-1], ranges)
    found: np.ndarray = np.where(inverse < falling[0], RANGES[0] * inverse / falling[0], ranges)
    return found


def stage(count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return empty scenes: matches, balls far off, a robot at the origin that looks ahead and an opponent far off."""
    matches, balls, robots = np.zeros(count, MATCH), np.zeros(count, BALL), np.zeros((count, 2), ROBOT)
    matches["handedness"] = matches["home_direction"] = 1.0
    robots["active"], robots["team"][:, 1] = 1, AWAY
    balls["x"], robots["x"][:, 1] = -FAR_OFF, -FAR_OFF
    return matches, balls, robots


def look_at(league: League, robots: np.ndarray, height: float) -> np.ndarray:
    """Tilt the heads so that they look at something of a height at RANGES; return the cameras' x [m]."""
    s, tilt = league.sensors, np.zeros(len(RANGES))
    for _ in range(20):  # the camera moves as the head tilts
        above = s.neck_height + s.camera_up * np.cos(tilt) + s.camera_ahead * np.sin(tilt) - height
        tilt = -np.arctan2(above, RANGES)
    robots["tilt"][:, 0] = tilt
    ahead: np.ndarray = s.neck_ahead + s.camera_ahead * np.cos(tilt) - s.camera_up * np.sin(tilt)
    return ahead


def ball_sizes(league: League) -> tuple[np.ndarray, np.ndarray]:
    """Return width and height [px] of the ball in pictures at RANGES."""
    matches, balls, robots = stage(len(RANGES))
    balls["x"] = look_at(league, robots, league.ball.radius) + RANGES
    boxes = render(league, matches, balls, robots, BALL_PIECES)
    return boxes[:, 0], boxes[:, 1]


def player_heights(league: League, heading: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the heights [px] of a player's largest sticker, and of the box round all, in pictures at RANGES."""
    matches, balls, robots = stage(len(RANGES))
    robots["x"][:, 1] = look_at(league, robots, league.sensors.trunk_sticker_middle) + RANGES
    robots["heading"][:, 1] = heading
    boxes = render(league, matches, balls, robots, OPPONENTS)
    return boxes[:, 1], boxes[:, 2]


def render(league: League, matches: np.ndarray, balls: np.ndarray, robots: np.ndarray, kind: int) -> np.ndarray:
    """Return width and height of the largest piece of a kind in each scene, and the height of all, (N, 3) [px]."""
    boxes = np.zeros((len(matches), 3))
    measure_pieces(matches, balls, robots, league.constants(), league.sensors.record(), kind, boxes)
    return boxes


@compiled
def measure_pieces(matches, balls, robots, constants, sensors, kind, boxes):
    """Fill in the boxes of `render`: from exact sketches, before the vision rounds and errs."""
    k, s = constants[0], sensors[0]
    sketches = make_sketch(k, s)
    for m in range(matches.shape[0]):
        sketch = sketches[0]
        draw_scene(matches[m], balls[m], robots[m], k, s, 0, sketch)
        largest, high, low = 0.0, -1e9, 1e9
        for i in range(sketch.found[kind]):
            piece = sketch.pieces[kind, i]
            high, low = max(high, piece.high), min(low, piece.low)
            if piece.area > largest:
                largest = piece.area
                boxes[m, 0], boxes[m, 1] = piece.left - piece.right, piece.high - piece.low
        boxes[m, 2] = max(high - low, 0.0)
