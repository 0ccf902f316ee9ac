"""Where a direction lies in the picture of a camera on a moving head: the way back of `optics.head_camera`."""

from math import cos, sin

from soccer_env.compiled import compiled
from soccer_env.optics.head_camera import focal_x, focal_y, image_height, image_width


@compiled
def pixel_of_direction(bearing, elevation, pan, tilt, s):
    """Return u, v [px] of a direction in the robot's frame, and 1 if it lies in the picture, else 0."""
    level = cos(elevation)
    x, y, z = level * cos(bearing - pan), level * sin(bearing - pan), sin(elevation)
    depth = x * cos(tilt) + z * sin(tilt)
    if depth <= 1e-6:
        return 0.0, 0.0, 0
    u, v = focal_x(s) * y / depth, focal_y(s) * (z * cos(tilt) - x * sin(tilt)) / depth
    inside = abs(u) <= 0.5 * image_width(s) and abs(v) <= 0.5 * image_height(s)
    return u, v, 1 if inside else 0
