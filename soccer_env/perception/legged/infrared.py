"""The infrared ranger on the camera's axis measures the distance to the first thing.  [Sacks 2001, 1, 2]  MS05, MS06

The beam is a ray. A robot is a trunk, a head and four legs: its trunk spans the hull, or shoulders and hips over the
legs; its legs are posts as thick as the paws, which stand in mid-stroke and between which a beam passes. The own body
is never in the way.

`k`: the league's constants; `s`: settings of the sensors.
"""

from math import inf, sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import cosine_and_sine, into_frame, out_of_frame, point_of_frame
from soccer_env.optics.head_camera import camera_place, tilt_point
from soccer_env.perception.legged.solids import (
    distance_to_boards,
    distance_to_box,
    distance_to_carpet,
    distance_to_post,
    distance_to_sphere,
)
from soccer_env.random_numbers import draw_normal
from soccer_env.types import RobotStream

INFRARED = int(RobotStream.INFRARED)
LAW_AT = 0.4  # [m] distance at which s.infrared_growth is the error


@compiled
def measure_range(match, ball, robots, k, s, r):
    """Return the range along the camera's axis [m]; 0 if there is no valid reading.  MS05

    Readings below s.infrared_near or above s.infrared_far are discarded.  [Sacks 2001, 2]
    """
    robot = robots[r]
    if robot.active == 0:
        return 0.0
    lateral = s.infrared_pointing * match.handedness * draw_normal(robot.noise, INFRARED)
    vertical = s.infrared_pointing * draw_normal(robot.noise, INFRARED)
    error = draw_normal(robot.noise, INFRARED)
    distance = trace_beam(ball, robots, k, s, r, lateral, vertical)
    if distance == inf:
        return 0.0
    reading = distance + range_error(distance, s) * error
    return reading if s.infrared_near <= reading <= s.infrared_far else 0.0


@compiled
def range_error(distance, s):
    """Return the standard deviation of a reading at a distance [m]: sqrt(a^2 + (b (d / 0.4 m)^p)^2).

    Beyond the far end of the window the deviation is constant, so that a thing far outside never reads as near.
    """
    grown = s.infrared_growth * (min(distance, s.infrared_far) / LAW_AT) ** s.infrared_power
    return sqrt(s.infrared_noise * s.infrared_noise + grown * grown)


@compiled
def trace_beam(ball, robots, k, s, r, lateral, vertical):
    """Return the distance [m] to the first thing in the beam, inf for none; `lateral`, `vertical`: errors [rad]."""
    robot = robots[r]
    x, y, z = camera_place(robot.pan, robot.tilt, s)
    dx, dy, dz = beam_direction(robot.pan, robot.tilt, lateral, vertical)
    cosine, sine = cosine_and_sine(robot.heading)
    x, y = point_of_frame(robot.x, robot.y, x, y, cosine, sine)
    dx, dy = out_of_frame(dx, dy, cosine, sine)
    nearest = min(distance_to_carpet(z, dz), distance_to_boards(x, y, z, dx, dy, dz, k, s))
    nearest = min(nearest, distance_to_sphere(x - ball.x, y - ball.y, z - k.ball_radius, dx, dy, dz, k.ball_radius))
    level = max(sqrt(dx * dx + dy * dy), 1e-9)
    extent = robot_extent(k, s)
    for other in range(robots.shape[0]):
        if other == r or robots[other].active == 0:
            continue
        to_x, to_y = robots[other].x - x, robots[other].y - y
        ahead, aside = to_x * dx + to_y * dy, to_x * dy - to_y * dx
        if abs(aside) > extent * level or ahead < -extent * level:
            continue  # the beam passes it by, or it lies behind
        if ahead > (nearest * level + extent) * level:
            continue  # it lies beyond the thing that the beam has met already
        nearest = min(nearest, distance_to_robot(-to_x, -to_y, z, dx, dy, dz, robots[other], k, s))
    return nearest


@compiled
def beam_direction(pan, tilt, lateral, vertical):
    """Return the beam's unit vector, robot frame: the optical axis turned left and up by small angles [rad]."""
    cosine, sine = cosine_and_sine(tilt)
    ahead, up = cosine - vertical * sine, sine + vertical * cosine
    scale = 1.0 / sqrt(1.0 + lateral * lateral + vertical * vertical)
    x, y = out_of_frame(ahead, lateral, *cosine_and_sine(pan))
    return scale * x, scale * y, scale * up


@compiled
def robot_extent(k, s):
    """Return the radius [m] of a circle round a robot's origin that holds the whole robot."""
    return max(k.body_reach, s.neck_ahead + s.camera_ahead + s.camera_up + s.head_size)


@compiled
def distance_to_robot(x, y, z, dx, dy, dz, other, k, s):
    """Return the distance [m] along a ray to another robot; the ray starts at x, y from that robot, field axes."""
    cosine, sine = cosine_and_sine(other.heading)
    x, y = into_frame(x, y, cosine, sine)
    dx, dy = into_frame(dx, dy, cosine, sine)
    back, front, half_width = hull_edges(k)
    middle, half_length = 0.5 * (front + back), 0.5 * (front - back)
    half_height = 0.5 * (s.trunk_height - s.trunk_low)
    high = z - s.trunk_low - half_height
    trunk = distance_to_box(x - middle, y, high, dx, dy, dz, half_length, half_width, half_height)
    head = distance_to_head(x, y, z, dx, dy, dz, other, s)
    return min(trunk, head, distance_to_legs(x, y, z, dx, dy, dz, back, k, s))


@compiled
def distance_to_head(x, y, z, dx, dy, dz, other, s):
    """Return the distance [m] along a ray, in a robot's frame, to that robot's head: an upright cube that turns with
    the pan, moves with the tilt and has the camera in the middle of its face.
    """
    half = 0.5 * s.head_size
    level, steep = cosine_and_sine(other.tilt)
    ahead, height = tilt_point(s.camera_ahead - half, s.camera_up, level, steep, s.neck_height)
    cosine, sine = cosine_and_sine(other.pan)
    x, y = into_frame(x - s.neck_ahead, y, cosine, sine)
    dx, dy = into_frame(dx, dy, cosine, sine)
    return distance_to_box(x - ahead, y, z - height, dx, dy, dz, half, half, half)


@compiled
def distance_to_legs(x, y, z, dx, dy, dz, back, k, s):
    """Return the distance along a ray to the nearest of a robot's four legs below the trunk [m], robot frame."""
    left = k.body_tip_y
    hind = k.body_hind_x if k.body_hind_y > 0.0 else back + k.body_tip_radius
    hind_left = k.body_hind_y if k.body_hind_y > 0.0 else left
    radius = k.body_tip_radius
    fore = min(
        distance_to_post(x - k.body_tip_x, y - left, z, dx, dy, dz, radius, s.trunk_low),
        distance_to_post(x - k.body_tip_x, y + left, z, dx, dy, dz, radius, s.trunk_low),
    )
    return min(
        fore,
        distance_to_post(x - hind, y - hind_left, z, dx, dy, dz, radius, s.trunk_low),
        distance_to_post(x - hind, y + hind_left, z, dx, dy, dz, radius, s.trunk_low),
    )


@compiled
def hull_edges(k):
    """Return the rear x, the front x and the half-width [m], robot frame, of the rectangle round a robot's hull.

    A hull over legs holds shoulders, hips and rump: the hind legs set its width and its rear, the chest its front.
    """
    if k.legs == 1:
        return k.body_hind_x - k.body_tip_radius, k.body_front, k.body_hind_y + k.body_tip_radius
    if k.corners == 0:
        back = k.body_disc_x - k.body_disc_back - k.body_disc_radius
        return back, k.body_disc_x + k.body_disc_radius, k.body_disc_radius
    back = front = k.corner_x[0]
    half_width = abs(k.corner_y[0])
    for i in range(1, k.corners):
        back, front = min(back, k.corner_x[i]), max(front, k.corner_x[i])
        half_width = max(half_width, abs(k.corner_y[i]))
    return back, front, half_width
