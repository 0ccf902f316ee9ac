"""The white lines of a pitch: a robot's table of what it costs to see a line at a place.  MH08

+--------------+--------------+     border, halfway line, centre circle, and at both ends
|---+          |          +---|     penalty area and goal area; their widths are not modelled: a line is
|-+ |        .-+-.        | +-|     where its middle runs
| | |       (  |  )       | | |
|-+ |        '-+-'        | +-|
|---+          |          +---|
+--------------+--------------+
"""

from functools import lru_cache

import numpy as np

from soccer_env.belief.particles import OUTLIER
from soccer_env.leagues.league import League, Pitch

COLUMNS, ROWS = 80, 60  # cells of the grid for a quarter of the pitch, along x and along y
CELL = 0.10  # [m] side of a cell; more on a pitch that would not fit, so that tables of all pitches are of one type
MARGIN = 1.0  # [m] round the pitch that the grid covers as well

TABLES = np.dtype(
    [  # a middle-size robot's knowledge of its field. A point (x, y) of the team frame lies in the cell
        # i = floor(|x| / cell), j = floor(|y| / cell): the lines are symmetric about both axes.
        ("cell", "f8"),  # [m] side of a cell
        ("line_cost", "f4", (COLUMNS * ROWS,)),  # [1] of a line seen at the middle of cell i * ROWS + j
    ]
)


@lru_cache(maxsize=8)
def line_tables(league: League) -> np.ndarray:
    """Return the table of costs for a league's pitch and its robots' memory, a record TABLES (1,).  MH08"""
    pitch, table, noise = league.pitch, np.zeros(1, TABLES), league.memory.pose_line_noise
    cell = max(CELL, (0.5 * pitch.length + MARGIN) / COLUMNS, (0.5 * pitch.width + MARGIN) / ROWS)
    x, y = cell * (np.arange(COLUMNS) + 0.5), cell * (np.arange(ROWS) + 0.5)
    table["cell"] = cell
    square = (nearest_line(pitch, x[:, None], y[None, :]) / noise) ** 2
    table["line_cost"] = (0.5 * square * OUTLIER / (square + OUTLIER)).ravel()  # see `bounded_cost`
    return table


def nearest_line(pitch: Pitch, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return the distance [m] of points x, y (team or field frame) from the nearest white line."""
    x, y = abs(x), abs(y)  # the lines are symmetric about both axes
    distances = [abs(np.sqrt(x * x + y * y) - pitch.circle)]
    for from_x, from_y, to_x, to_y in lines_of_quarter_pitch(pitch):
        beside_x = np.maximum(np.maximum(from_x - x, x - to_x), 0.0)
        beside_y = np.maximum(np.maximum(from_y - y, y - to_y), 0.0)
        distances.append(np.sqrt(beside_x * beside_x + beside_y * beside_y))
    nearest: np.ndarray = np.min(np.broadcast_arrays(*distances), axis=0)
    return nearest


def lines_of_quarter_pitch(pitch: Pitch) -> list[tuple[float, float, float, float]]:
    """Return the straight lines of the quarter x, y >= 0 of a pitch as (from x, from y, to x, to y) [m]."""
    end, side = 0.5 * pitch.length, 0.5 * pitch.width
    pieces = [(0.0, 0.0, 0.0, side), (end, 0.0, end, side), (0.0, side, end, side)]
    areas = ((pitch.penalty_depth, pitch.penalty_width), (pitch.goal_area_depth, pitch.goal_area_width))
    for depth, width in areas:
        pieces += [(end - depth, 0.0, end - depth, 0.5 * width), (end - depth, 0.5 * width, end, 0.5 * width)]
    return pieces
