"""Geometry of a camera on a moving head: pixels, directions, and where the camera stands.  MS08

Picture coordinates are pixels from the image's centre, u to the left, v up. Directions are a bearing (0 straight ahead
of the robot, left positive) and an elevation above the horizontal, both in the robot's frame. The head turns by pan
(left positive) about the vertical through the neck, then by tilt (up positive); it does not roll. `s` is the record of
a LeggedSensors.
"""

from __future__ import annotations

from math import atan2, cos, sin, sqrt, tan

from soccer_env.compiled import compiled

SMALLEST_WIDTH, SMALLEST_HEIGHT = 44.0, 36.0  # [px] of the smallest layer; each step of resolution doubles them


@compiled
def image_width(s):
    """Return the width of the picture [px]."""
    return SMALLEST_WIDTH * (1 << s.resolution)


@compiled
def image_height(s):
    """Return the height of the picture [px]."""
    return SMALLEST_HEIGHT * (1 << s.resolution)


@compiled
def focal_x(s):
    """Return the focal length for widths [px]."""
    return 0.5 * image_width(s) / tan(0.5 * s.view_width)


@compiled
def focal_y(s):
    """Return the focal length for heights [px]."""
    return 0.5 * image_height(s) / tan(0.5 * s.view_height)


@compiled
def camera_place(pan, tilt, s):
    """Return where the camera is: ahead, left, height [m], robot frame."""
    forward = s.camera_ahead * cos(tilt) - s.camera_up * sin(tilt)
    height = s.neck_height + s.camera_up * cos(tilt) + s.camera_ahead * sin(tilt)
    return s.neck_ahead + forward * cos(pan), forward * sin(pan), height


@compiled
def direction_of_pixel(u, v, pan, tilt, s):
    """Return bearing and elevation [rad], robot frame, of a point of the picture [px]."""
    left, up = u / focal_x(s), v / focal_y(s)
    ahead = cos(tilt) - up * sin(tilt)
    high = sin(tilt) + up * cos(tilt)
    x, y = ahead * cos(pan) - left * sin(pan), ahead * sin(pan) + left * cos(pan)
    return atan2(y, x), atan2(high, sqrt(x * x + y * y))
