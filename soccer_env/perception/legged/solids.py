"""Ray casting: the distance from a point along a ray to a ball, a box, a post, the boards or the carpet.

A ray starts at x, y, z [m] and goes along the unit vector dx, dy, dz; a distance is inf for a miss and 0 from within.

`k`: the league's constants; `s`: settings of the sensors.
"""

from math import inf, sqrt

from soccer_env.compiled import compiled

LEAST = 1e-12  # [1] least size of a direction's component as a divisor


@compiled
def nonzero_divisor(component):
    """Return a component of a direction for use as a divisor: numbers near 0 are replaced by +-LEAST."""
    if -LEAST < component < LEAST:
        return -LEAST if component < 0.0 else LEAST
    return component


@compiled
def distance_to_sphere(x, y, z, dx, dy, dz, radius):
    """Return the distance [m] along the ray to a sphere with its centre at the origin."""
    outside = x * x + y * y + z * z - radius * radius
    if outside <= 0.0:
        return 0.0
    along = -(x * dx + y * dy + z * dz)  # to the point of the ray that is nearest to the centre
    inside = along * along - outside
    if along <= 0.0 or inside < 0.0:
        return inf
    return max(along - sqrt(inside), 0.0)


@compiled
def distance_to_box(x, y, z, dx, dy, dz, half_length, half_width, half_height):
    """Return the distance [m] along the ray to a box about the origin with edges parallel to the axes."""
    dx, dy, dz = nonzero_divisor(dx), nonzero_divisor(dy), nonzero_divisor(dz)
    # Where the ray enters and leaves each of the three slabs whose common part is the box.
    x_reach, y_reach, z_reach = half_length / abs(dx), half_width / abs(dy), half_height / abs(dz)
    enter = max(-x / dx - x_reach, -y / dy - y_reach, -z / dz - z_reach)
    leave = min(-x / dx + x_reach, -y / dy + y_reach, -z / dz + z_reach)
    return inf if leave < max(enter, 0.0) else max(enter, 0.0)


@compiled
def distance_to_post(x, y, z, dx, dy, dz, radius, height):
    """Return the distance [m] along the ray to an upright cylinder at the origin, met from the side or from above."""
    level = max(dx * dx + dy * dy, LEAST)
    outside = x * x + y * y - radius * radius
    along = -(x * dx + y * dy)
    inside = along * along - level * outside
    if inside < 0.0:
        return inf
    root, fall = sqrt(inside), nonzero_divisor(dz)
    half = 0.5 * height / abs(fall)
    middle = (0.5 * height - z) / fall
    enter, leave = max((along - root) / level, middle - half), min((along + root) / level, middle + half)
    return inf if leave < max(enter, 0.0) else max(enter, 0.0)


@compiled
def distance_to_carpet(z, dz):
    """Return the distance along the ray to the ground [m]."""
    return max(z, 0.0) / -dz if dz < -LEAST else inf


@compiled
def distance_to_boards(x, y, z, dx, dy, dz, k, s):
    """Return the distance [m] along a ray from inside to the boards of a pitch, or to the walls of a goal.

    Boards are s.board_height high, goals s.goal_height; a pitch without boards has goals alone.
    """
    dx, dy = nonzero_divisor(dx), nonzero_divisor(dy)
    end = (0.5 * k.pitch_length - (x if dx > 0.0 else -x)) / abs(dx)  # to the goal line ahead
    side = (0.5 * k.pitch_width - (y if dy > 0.0 else -y)) / abs(dy)  # to the touchline ahead
    if k.walled == 1 and side <= end:
        return distance_if_within_height(side, z + side * dz, s.board_height)
    if abs(y + max(end, 0.0) * dy) > 0.5 * k.pitch_goal_width:
        return distance_if_within_height(end, z + end * dz, s.board_height) if k.walled == 1 else inf
    back = end + k.pitch_goal_depth / abs(dx)
    net = (0.5 * k.pitch_goal_width - (y if dy > 0.0 else -y)) / abs(dy)
    distance = min(back, net)
    return distance_if_within_height(distance, z + distance * dz, s.goal_height)


@compiled
def distance_if_within_height(distance, height, most):
    """Return the distance if it is positive and the ray's height there is between 0 and `most`; else inf."""
    return distance if distance >= 0.0 and 0.0 <= height <= most else inf
