"""Calibration tables from sizes in the picture to ranges, computed from noiseless pictures.  MS09, MS33

As a team would do it on its field: a ball, then a robot, is put before a robot that looks at it, every 5 cm from 15 cm
to 3 m, and its size in the picture is noted. Sizes are taken from the sketch, before they become whole pixels, so that
entry i is the range at which a thing is i pixels large on average.

A range is the horizontal distance from the camera (not from the robot's origin, nor along the line of sight) to the
middle of the ball, or to the origin of the other robot. For a place in the robot's frame, add the camera's place: with
bearing b = direction_of_pixel(u, v, pan, tilt, s)[0] and (ahead, left, height) = camera_place(pan, tilt, s), both of
optics/head_camera.py, the thing is at (ahead + range cos b, left + range sin b).

`k`: the league's constants; `s`: settings of the sensors.
"""

from functools import lru_cache
from math import atan2, nan, pi

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.leagues.constants import constants_of
from soccer_env.leagues.league import League
from soccer_env.optics.head_camera import camera_place
from soccer_env.perception.legged.picture import draw_scene
from soccer_env.perception.legged.sketch import BALL, OPPONENTS, make_sketch
from soccer_env.types import AWAY, MATCH, ROBOT
from soccer_env.types import BALL as BALL_RECORD

SIZES = 256  # [px] sizes that a table has room for; larger ones read as the last
NEAREST = 0.15  # [m] nearest range that is rendered, assumed
FARTHEST = 3.0  # [m] farthest range that is rendered, assumed
STEP = 0.05  # [m] between two rendered ranges, assumed
LEAST = 0.01  # [m] least range that a table holds
ASIDE = 50.0  # [m] where all other things are put
HEAD_ON, FROM_THE_SIDE = pi, 0.5 * pi  # [rad] heading of the robot that is looked at
ROUNDS = 30  # iterations for the tilt, which moves the camera
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
SIZE = np.dtype(
    [  # sizes at one range, NaN for a thing that is cut off or not seen
        ("width", "f8"),  # [px] of the largest piece
        ("height", "f8"),  # [px]
        ("together", "f8"),  # [px] height of the box round all pieces
    ]
)


@lru_cache(maxsize=64)
def calibrate(league: League) -> np.ndarray:
    """Return the calibration tables (1,) of a league's camera.  [Sacks 2001, 3.1.1, 4.1.2]  MS09, MS33"""
    tables, s = np.zeros(1, CALIBRATION), league.sensors
    ranges = np.arange(round((FARTHEST - NEAREST) / STEP) + 1) * STEP + NEAREST
    ball = rendered_sizes(league, ranges, league.ball.radius, BALL, 0.0)
    tables["ball_width"] = range_table(ranges, ball["width"])
    tables["ball_height"] = range_table(ranges, ball["height"])
    trunk, middle = s.trunk_sticker_middle, 0.5 * (s.trunk_sticker_middle + s.head_sticker_middle)
    for view, heading in (("player_front", HEAD_ON), ("player_side", FROM_THE_SIDE)):
        tables[view] = range_table(ranges, rendered_sizes(league, ranges, trunk, OPPONENTS, heading)["height"])
        tables[view + "_all"] = range_table(
            ranges, rendered_sizes(league, ranges, middle, OPPONENTS, heading)["together"]
        )
    return tables


def rendered_sizes(league: League, ranges: np.ndarray, height: float, kind: int, heading: float) -> np.ndarray:
    """Return the SIZE in the picture of a kind of thing at each range; the camera aims at its `height` [m]."""
    match = np.zeros(1, MATCH)
    ball = np.zeros(1, BALL_RECORD)
    robots = np.zeros((1, 2), ROBOT)
    match["handedness"] = match["home_direction"] = 1.0
    robots["active"] = 1
    robots["team"][0, 1] = AWAY
    robots["heading"][0, 1] = heading
    ball["x"], robots["x"][0, 1] = ASIDE, ASIDE
    sizes = np.zeros(len(ranges), SIZE)
    render_sizes(match, ball, robots, constants_of(league), league.sensors.record(), ranges, height, kind, sizes)
    return sizes


@compiled
def render_sizes(matches, balls, robots, constants, sensors, ranges, height, kind, sizes):
    """Measure the sizes in the picture of robot 0 of the ball, or of robot 1, at each range."""
    k = constants[0]
    s = sensors[0]
    sketches = make_sketch(constants[0], sensors[0])
    for i in range(ranges.shape[0]):
        tilt = 0.0
        for _ in range(ROUNDS):
            tilt = atan2(height - camera_place(0.0, tilt, s)[2], ranges[i])
        robots[0, 0].tilt = tilt
        x = camera_place(0.0, tilt, s)[0] + ranges[i]
        if kind == BALL:
            balls[0].x = x
        else:
            robots[0, 1].x = x
        draw_scene(matches[0], balls[0], robots[0], k, s, 0, sketches[0])
        measure_size_in_sketch(sketches[0], kind, sizes[i])


@compiled
def measure_size_in_sketch(sketch, kind, size):
    """Measure the sizes [px] of the largest piece of a kind, and of the box round all its pieces."""
    size.width = size.height = size.together = nan
    largest = high = low = 0.0
    whole = True
    for i in range(sketch.counts[kind]):
        piece, camera = sketch.pieces[kind, i], sketch.camera
        aside, above = max(piece.left, -piece.right), max(piece.high, -piece.low)
        inside = aside < camera.half_width and above < camera.half_height
        if piece.area > largest:
            largest = piece.area
            size.width = piece.left - piece.right if inside else nan
            size.height = piece.high - piece.low if inside else nan
        high, low = (piece.high, piece.low) if i == 0 else (max(high, piece.high), min(low, piece.low))
        whole = whole and inside
    if largest > 0.0 and whole:
        size.together = high - low


def range_table(ranges: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Return a table of the range [m] for each whole size [px], interpolated between the rendered sizes.

    Beyond both ends the last two ranges are extrapolated in inverse proportion to the size; size 0 reads as size 1.
    """
    known = np.isfinite(sizes)
    ranges, sizes = ranges[known], np.minimum.accumulate(sizes[known])
    sizes, places = np.unique(sizes, return_index=True)
    ranges, pixels = ranges[places], np.maximum(np.arange(SIZES, dtype=float), 1.0)
    if len(sizes) < 2:
        return np.full(SIZES, FARTHEST)
    table = np.interp(pixels, sizes, ranges)
    for end, beyond in (((0, 1), pixels < sizes[0]), ((-1, -2), pixels > sizes[-1])):
        (size, range_), (inner, inner_range) = ((sizes[i], ranges[i]) for i in end)
        grows = (range_ - inner_range) / (1.0 / size - 1.0 / inner)
        table = np.where(beyond, range_ + grows * (1.0 / pixels - 1.0 / size), table)
    ranges = np.maximum(table, LEAST)
    return ranges
