"""The geometry of a camera on a moving head: pixels, directions, and the position of the camera.  MS08

Picture coordinates are pixels from the image's centre, u to the left, v up. Directions are a bearing (0 straight ahead
of the robot, left positive) and an elevation above the horizontal, both in the robot's frame. The head turns by pan
(left positive) about the vertical through the neck, then by tilt (up positive); it does not roll.

`s`: settings of the sensors, the record of a LeggedSensors.
"""

from math import sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, cosine_and_sine, from_polar, out_of_frame


@compiled
def image_width(s):
    """Return the width of the picture [px]."""
    return s.picture_width


@compiled
def image_height(s):
    """Return the height of the picture [px]."""
    return s.picture_height


@compiled
def focal_x(s):
    """Return the horizontal focal length [px]."""
    return s.focal_x


@compiled
def focal_y(s):
    """Return the vertical focal length [px]."""
    return s.focal_y


@compiled
def tilt_at(share, low, high):
    """Convert a position in the tilt's range (-1 lowest, 1 highest) to a tilt angle [rad]."""
    return 0.5 * (high + low) + 0.5 * (high - low) * share


@compiled
def share_of_tilt(tilt, low, high):
    """Convert a tilt angle [rad] to a position in the tilt's range: -1 lowest, 1 highest, not clipped."""
    return (tilt - 0.5 * (high + low)) / (0.5 * (high - low))


@compiled
def tilt_point(ahead, up, level, steep, pivot):
    """Return the position of a point of the tilted head: distance ahead of the neck, and height [m, m].

    ahead, up: the point from the neck's pivot while the head is level [m]; level, steep: cosine and sine of the tilt;
    pivot: height of the neck's pivot [m], 0 for heights above it.
    """
    return ahead * level - up * steep, pivot + up * level + ahead * steep


@compiled
def camera_place(pan, tilt, s):
    """Return the position of the camera: ahead, left, height [m], robot frame."""
    level, steep = cosine_and_sine(tilt)
    forward, height = tilt_point(s.camera_ahead, s.camera_up, level, steep, s.neck_height)
    ahead, left = from_polar(forward, pan)
    return s.neck_ahead + ahead, left, height


@compiled
def direction_of_pixel(u, v, pan, tilt, s):
    """Return bearing and elevation [rad], robot frame, of the pixel (u, v) of the picture [px]."""
    left, up = u / focal_x(s), v / focal_y(s)
    cosine, sine = cosine_and_sine(tilt)
    ahead, high = cosine - up * sine, sine + up * cosine
    x, y = out_of_frame(ahead, left, *cosine_and_sine(pan))
    return atan2(y, x), atan2(high, sqrt(x * x + y * y))
