"""Steps from cell to cell: the next cell, the time to reach it, and the time to predict obstacles for.  MH11, MH15"""

from math import floor, sqrt

from soccer_env.baselines.weigel_2001.planner.settings import STEPPINGS
from soccer_env.compiled import compiled

QUANTISED = STEPPINGS["quantised"]
HALF_OF_45 = sqrt(2.0) - 1.0  # tan(22.5 degrees): a direction nearer to an axis than to a diagonal


@compiled
def cell_of(place, half, settings):
    """Return the index, along one axis, of the grid cell nearest to a coordinate [m]; NaN becomes the lowest index.

    Halves are rounded away from the middle on both sides, so that a mirrored place has the mirrored cell.
    """
    far = (half + 0.5) * settings.cell
    if not place > -far:
        return -half
    if place >= far:
        return half
    cell = floor(abs(place) / settings.cell + 0.5)
    cell = min(int(cell), half)
    return cell if place >= 0.0 else -cell


@compiled
def sign(value):
    """Return the sign of a value: -1, 0 or +1."""
    return (1 if value > 0.0 else 0) - (1 if value < 0.0 else 0)


@compiled
def next_cell(down_x, down_y, rest_x, rest_y, settings):
    """Return the step (du, dv) to the neighbour cell in a direction, and remainders in x and y to carry on.  MH11

    "carried": one cell along the longer axis; the component along the other axis adds up until it exceeds half a cell,
    so that the way keeps the direction. "quantised": the nearest of eight directions, with no remainders.
    """
    along, across = abs(down_x), abs(down_y)
    if settings.stepping == QUANTISED:
        du = sign(down_x) if along > HALF_OF_45 * across else 0
        dv = sign(down_y) if across > HALF_OF_45 * along else 0
        return du, dv, 0.0, 0.0
    if along == 0.0 and across == 0.0:
        return 0, 0, rest_x, rest_y
    if along >= across:
        rest_y += down_y / along
        dv = sign(rest_y) if abs(rest_y) > 0.5 else 0
        return sign(down_x), dv, rest_x, rest_y - dv
    rest_x += down_x / across
    du = sign(rest_x) if abs(rest_x) > 0.5 else 0
    return du, sign(down_y), rest_x - du, rest_y


@compiled
def step_length(du, dv, settings):
    """Return the length [m] of a step by (du, dv) cells: 1 or sqrt(2) cells to a neighbour."""
    return settings.cell * sqrt(float(du * du + dv * dv))


@compiled
def step_time(du, dv, settings):
    """Return tau [s], the time of a step to a neighbour cell at full speed: step / v_max.  MH15"""
    return step_length(du, dv, settings) / settings.speed


@compiled
def obstacle_time(t, settings):
    """Return the time [s] from now for which to predict obstacles: 0 for the planner of Weigel.  MH15, MH17

    Unlike in the paper, obstacles are never moved back before the present where T was guessed too short.
    """
    if settings.time_variant == 0:
        return 0.0
    return t if settings.literal == 1 or t > 0.0 else 0.0
