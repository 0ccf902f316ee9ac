"""The other robots in the view of a robot's omnidirectional camera, and the parts of things that they hide.

The camera stands 0.75 m high and robots are 0.8 m tall: a robot hides everything on the ground that lies behind it,
within the angle that its round body fills.

`k`: the league's constants; `s`: settings of the sensors.
"""

from math import sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, cosine_and_sine, into_frame, length, wrap

AROUND = np.dtype(
    [  # another robot, in the axes of the robot that looks
        ("distance", "f8"),  # [m]
        ("bearing", "f8"),  # [rad]
        ("half", "f8"),  # [rad] half of the angle that it fills
        ("teammate", "i8"),
    ]
)


@compiled
def find_bodies_around(robots, r, k, around):
    """List in `around` the other active robots as seen from robot r; return their number.

    Team-mates come first, then opponents, each by number: the same order on both sides of the field.
    """
    me, radius = robots[r], body_radius(k)
    cosine, sine = cosine_and_sine(me.heading)
    count = 0
    for teammate in (1, 0):
        for other in range(robots.shape[0]):
            robot = robots[other]
            if other == r or robot.active == 0 or (robot.team == me.team) != (teammate == 1):
                continue
            x, y = robot.x - me.x, robot.y - me.y
            one = around[count]
            one.distance = length(x, y)
            ahead, left = into_frame(x, y, cosine, sine)
            one.bearing = atan2(left, ahead)
            one.half = half_angle(radius, one.distance)
            one.teammate = teammate
            count += 1
    return count


@compiled
def body_radius(k):
    """Return the radius [m] of a robot's round base, or of the circle round a hull or capsule."""
    return k.body_disc_radius if k.body_disc_radius > 0.0 and k.body_disc_back <= 0.0 else k.body_reach


@compiled
def half_angle(radius, distance):
    """Return half of the angle [rad] that a disc fills in the view at a distance; pi / 2 from inside the disc."""
    return atan2(radius, sqrt(max(distance * distance - radius * radius, 0.0)))


@compiled
def visible_part(around, count, bearing, half, distance, height, k, s, handedness):
    """Return the angle [rad] from a thing's middle to the middle of its visible part, and the visible share [1].  MH02

    The thing fills `half` to both sides of `bearing`; nearer robots hide it where the line of sight over their heads
    passes it above `height` [m]. Share 0: all of it is hidden. Of two visible parts the larger one counts.
    """
    above = k.body_height - s.camera_height  # [m] by which robots are taller than the camera
    low, high = -half, half
    for j in range(count):
        other = around[j]
        if other.distance >= distance:
            continue
        if other.distance * s.camera_height + distance * above < other.distance * height:
            continue
        middle = wrap(other.bearing - bearing)
        right, left = middle - other.half, middle + other.half
        if right <= low:
            low = max(low, left)
        elif left >= high:
            high = min(high, right)
        elif high - left > right - low or (high - left == right - low and handedness > 0.0):
            low = left
        else:
            high = right
        if low >= high:
            return 0.0, 0.0
    return 0.5 * (low + high), (high - low) / (2.0 * half) if half > 0.0 else 1.0
