"""From orange blobs in the picture to a position of the ball.  [Sacks 2001, 3.1.1]  MS08 to MS14

    blob     the largest that is large enough (MS14) and not above the horizontal (MS13)
    bearing  head angles plus place in the picture (MS08)
    range    by the blob's size (MS09, MS11); by the infrared ranger if that says much less (MS12); almost under the
             head by height and angle (MS10)

A range counts along the ground, from the camera to the ball's centre. Blobs are boxes between edges of whole pixels:
their width is left less right.

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from math import cos, sqrt, tan

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import from_polar
from soccer_env.leagues.legged_sensors import RANGES, SIZES
from soccer_env.optics.head_camera import camera_place, direction_of_pixel, focal_x, focal_y
from soccer_env.records.percepts import BLOBS

BY_INFRARED = RANGES["infrared"]
BY_HEIGHT, BY_WIDTH = SIZES["height"], SIZES["width"]
FLATTEST = 1e-3  # [1] least tangent of the angle down to the ball, so that no range is infinite


@compiled
def choose_blob(percept, was_near, s, w):
    """Return the index of the largest orange blob that can be the ball, -1 if there is none.  MS13, MS14"""
    least = least_ball_area(was_near, s, w)
    best, largest = -1, 0
    for i in range(BLOBS):
        area = int(percept.ball[i].area)
        if area > largest and area >= least and not is_too_high(percept, percept.ball[i], s, w):
            best, largest = i, area
    return best


@compiled
def least_ball_area(was_near, s, w):
    """Return the smallest area [px] accepted as a ball: larger if the robot has just seen the ball nearby.  MS14

    The settings are given at 88x72; each step of resolution has four times as many pixels.
    """
    area = w.area_large if was_near and w.double_area == 1 else w.area_small
    return 0.25 * area * (1 << (2 * s.resolution))


@compiled
def is_too_high(percept, blob, s, w):
    """Tell whether the middle of a blob is too far above the horizontal to be the ball.  MS13"""
    if w.horizon == 0:
        return False
    u, v = blob_centre(blob)
    _, elevation = direction_of_pixel(u, v, np.float64(percept.pan), np.float64(percept.tilt), s)
    return elevation > w.horizon_angle


@compiled
def blob_centre(blob):
    """Return the middle of a blob's box [px], left and up of the image's centre."""
    return 0.5 * (int(blob.left) + int(blob.right)), 0.5 * (int(blob.high) + int(blob.low))


@compiled
def place_of_ball(percept, blob, k, s, w, table):
    """Return the position x, y [m], robot frame, of the ball in a blob, and the height [m] of the line of sight.

    The direction is head angles plus place in the picture (MS08). The range counts from the camera, which moves with
    the neck, and is converted to the body's origin here. The height [m] equals the ball's radius if the range is right.
    """
    pan, tilt = np.float64(percept.pan), np.float64(percept.tilt)
    u, v = blob_centre(blob)
    bearing, elevation = direction_of_pixel(u, v, pan, tilt, s)
    ahead, left, height = camera_place(pan, tilt, s)
    if w.under_head == 1 and elevation < -w.under_head_tilt:
        away = range_under_head(height, elevation, k)
    else:
        away = range_ahead(percept, blob, elevation, k, s, w, table)
    x, y = from_polar(away, bearing)
    return ahead + x, left + y, height + away * tan(elevation)


@compiled
def range_under_head(height, elevation, k):
    """Return the range [m] of a ball almost under the head: height of the camera / tan(angle down to it).  MS10

    Unlike the paper's "height of dog" the height counts from the ball's centre, at which the angle points.
    """
    return max(height - k.ball_radius, 0.0) / max(tan(-elevation), FLATTEST)


@compiled
def range_ahead(percept, blob, elevation, k, s, w, table):
    """Return the range [m] by the blob's size, or by the infrared ranger where that is more reliable.  MS09, MS12

    A reading of less than `infrared_share` of the range by size says that the ball is partly hidden and looks small.
    With `ball_range` "infrared" every reading on the ball counts, the experiment of 3.1.1.
    """
    by_size = range_by_size(blob, w, table)
    if percept.infrared <= 0.0 or not beam_meets_blob(blob, s, w):
        return by_size
    by_infrared = range_by_infrared(percept, blob, elevation, k, s)
    if w.ball_range == BY_INFRARED:
        return by_infrared
    overrides = w.infrared_override == 1 and by_infrared < w.infrared_share * by_size
    return by_infrared if overrides else by_size


@compiled
def range_by_size(blob, w, table):
    """Return the range [m] by the calibration tables: the shorter of the ranges by height and by width.  MS09, MS11

    A ball that is partly hidden or cut by the picture's border looks smaller and so farther: cut in one dimension, the
    other still gives the range; cut in both, the range is too long, and only the infrared ranger gives a better one.
    """
    by_height = read_table(table.ball_height, int(blob.high) - int(blob.low))
    by_width = read_table(table.ball_width, int(blob.left) - int(blob.right))
    if w.ball_size == BY_HEIGHT:
        return by_height
    if w.ball_size == BY_WIDTH:
        return by_width
    return min(by_height, by_width)


@compiled
def read_table(ranges, size):
    """Return the table's range [m] for a size in whole pixels; sizes beyond the table use its end values."""
    return ranges[min(max(size, 0), ranges.shape[0] - 1)]


@compiled
def beam_meets_blob(blob, s, w):
    """Tell whether the ranger's beam, the camera's axis, meets a blob or passes within `centred` of it.  MS12"""
    edge = tan(w.centred)
    aside, above = edge * focal_x(s), edge * focal_y(s)
    return blob.right - aside <= 0.0 <= blob.left + aside and blob.low - above <= 0.0 <= blob.high + above


@compiled
def range_by_infrared(percept, blob, elevation, k, s):
    """Return the range [m] along the ground to the centre of a ball whose surface the ranger's beam meets.  MS12

    The beam meets the surface at the reading d; the centre lies in a direction off the beam by delta, at D:
    D = d cos(delta) + sqrt(radius^2 - d^2 sin^2(delta)), the farther side of that triangle; without the root where
    the beam passes beside the ball.
    """
    u, v = blob_centre(blob)
    aside, above = u / focal_x(s), v / focal_y(s)
    square = aside * aside + above * above  # tan^2(delta)
    reading = np.float64(percept.infrared)
    half_chord = k.ball_radius * k.ball_radius - reading * reading * square / (1.0 + square)
    return (reading / sqrt(1.0 + square) + sqrt(max(half_chord, 0.0))) * cos(elevation)
