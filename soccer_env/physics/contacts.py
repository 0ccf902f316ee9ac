"""Which robot touches the ball or another robot, judged by positions and velocities.

Chipmunk's own list of contacts is not used: its order differs between processes.

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, cosine_and_sine, into_frame, length, point_of_frame
from soccer_env.physics.block import (
    foreleg_spread,
    forelegs_gap,
    is_blocking,
    most_reach,
    most_reach_walking,
    paw_shift,
)
from soccer_env.physics.gait import LEGS, TIPS, paw_offset, stance

TOUCH_GAP = 0.004  # [m] assumed: a ball nearer than this touches
KNOCK = 0.02  # [m/s] assumed: a change of velocity that friction does not explain


@compiled
def ball_gap(robot, k, ball_x, ball_y):
    """Return the distance [m] between the ball and a robot's outline, its legs in mid-stroke; below 0 they overlap."""
    return outline_gap(robot, k, ball_x, ball_y) - k.ball_radius


@compiled
def paws_gap(robot, k, ball_x, ball_y, handedness):
    """Return the distance [m] between the ball and a robot's outline, its legs where they are in the stroke.  MS51"""
    if k.legs == 0:
        return ball_gap(robot, k, ball_x, ball_y)
    ahead, left = into_frame(ball_x - robot.x, ball_y - robot.y, *cosine_and_sine(robot.heading))
    gap = trunk_gap(k, ahead, left)
    blocks = is_blocking(robot, k)
    if blocks:
        gap = min(gap, forelegs_gap(robot, k, ahead, left, handedness, 1))
    for leg in range(TIPS if blocks else 0, LEGS):
        x, y = stance(k, leg, handedness)
        off_x, off_y = paw_offset(robot, k, leg, handedness)
        gap = min(gap, length(ahead - x - off_x, left - y - off_y) - k.body_tip_radius)
    return gap - k.ball_radius


@compiled
def outline_gap(robot, k, x, y):
    """Return the distance [m] of a point of the field from a robot's outline, its legs in mid-stroke."""
    return outline_gap_of(robot, k, x, y, *cosine_and_sine(robot.heading))


@compiled
def outline_gap_of(robot, k, x, y, cosine, sine):
    """Return `outline_gap`, given the cosine and sine of the robot's heading."""
    ahead, left = into_frame(x - robot.x, y - robot.y, cosine, sine)
    gap = trunk_gap(k, ahead, left)
    if is_blocking(robot, k):
        gap = min(gap, forelegs_gap(robot, k, ahead, left, 1.0, 0))
    else:
        gap = min(gap, length(ahead - k.body_tip_x, abs(left) - k.body_tip_y) - k.body_tip_radius)
    if k.body_hind_y > 0.0:
        gap = min(gap, length(ahead - k.body_hind_x, abs(left) - k.body_hind_y) - k.body_tip_radius)
    return gap


@compiled
def trunk_gap(k, ahead, left):
    """Return the distance [m] of a point from a robot's hull, disc or capsule."""
    if k.corners > 0:
        return hull_gap(k, ahead, left)
    nearest = clip(ahead, k.body_disc_x - k.body_disc_back, k.body_disc_x)
    return length(ahead - nearest, left) - k.body_disc_radius


@compiled
def hull_gap(k, ahead, left):
    """Return the distance [m] of a point from a robot's convex hull; inside the hull, minus the depth."""
    inside = -1e9
    outside = 1e9
    for i in range(k.corners):
        j = i + 1 if i + 1 < k.corners else 0
        edge_x, edge_y = k.corner_x[j] - k.corner_x[i], k.corner_y[j] - k.corner_y[i]
        x, y = ahead - k.corner_x[i], left - k.corner_y[i]
        edge = length(edge_x, edge_y)
        along = (x * edge_x + y * edge_y) / (edge * edge)
        inside = max(inside, (x * edge_y - y * edge_x) / edge)
        along = min(max(along, 0.0), 1.0)
        outside = min(outside, length(x - along * edge_x, y - along * edge_y))
    return outside if inside > 0.0 else inside


@compiled
def find_touches(ball, robots, robot_events, k, knock_x, knock_y, handedness):
    """Mark the robots that touch the ball; return the row of the nearest, which counts as the last to touch it, or -1.

    The knock [m/s] is the change of the ball's velocity by the contacts of this step. A knocked ball may have left its
    robot already: the robot touched it if the ball moves away from the robot, and the gap is no wider than the two can
    have moved apart.
    """
    nearest, least = -1, 1e9
    outline = most_reach_walking(k)
    knocked = knock_x * knock_x + knock_y * knock_y > KNOCK * KNOCK
    for r in range(robots.shape[0]):
        robot = robots[r]
        x, y = ball.x - robot.x, ball.y - robot.y
        gone = TOUCH_GAP
        if knocked:
            gone += k.dt * length(ball.vx - robot.vx, ball.vy - robot.vy)
        reach = outline + k.ball_radius + gone
        if robot.active == 0 or x * x + y * y > reach * reach:
            continue
        gap = paws_gap(robot, k, ball.x, ball.y, handedness)
        touches = gap < TOUCH_GAP
        if touches:
            robot_events[r].touch = 1
        elif not (knocked and gap < gone and x * knock_x + y * knock_y > 0.0):
            continue
        if gap < least:
            nearest, least = r, gap
    if nearest >= 0:
        robot_events[nearest].touch = 1
    return nearest


@compiled
def find_collisions(robots, robot_events, touching, k):
    """Mark the robots that touch another robot; bit `other` of touching[r] (R,) says whether r touches that robot."""
    near = 2.0 * most_reach(k) + TOUCH_GAP
    touching[:] = 0
    for r in range(robots.shape[0]):
        for other in range(r + 1, robots.shape[0]):
            x, y = robots[other].x - robots[r].x, robots[other].y - robots[r].y
            if x * x + y * y < near * near and robots_touch(robots[r], robots[other], k):
                robot_events[r].collision = 1
                robot_events[other].collision = 1
                touching[r] |= 1 << other
                touching[other] |= 1 << r


@compiled
def touches(touching, r, other):
    """Tell whether robot r touches the robot `other`, from the bits that `find_collisions` set."""
    return (touching[r] >> other) & 1 == 1


@compiled
def robots_touch(robot, other, k):
    """Tell whether the outlines of two robots touch: a point of one robot on the outline of the other.

    Legs are taken in mid-stroke, where they hold other robots (see `solver/posts.py`).
    """
    cosine, sine = cosine_and_sine(robot.heading)
    its_cosine, its_sine = cosine_and_sine(other.heading)
    return points_touch(robot, other, k, cosine, sine, its_cosine, its_sine) or points_touch(
        other, robot, k, its_cosine, its_sine, cosine, sine
    )


@compiled
def points_touch(robot, other, k, cosine, sine, its_cosine, its_sine):
    """Tell whether a post, a corner or an end of the trunk of one robot touches the outline of the other."""
    spread = foreleg_spread(robot, k, 0.0)
    for leg in range(LEGS if k.body_hind_y > 0.0 else TIPS):
        x, y = stance(k, leg, 1.0)
        out_x, out_y = paw_shift(k, leg, spread, 1.0)
        if disc_touches(robot, other, k, x + out_x, y + out_y, k.body_tip_radius, cosine, sine, its_cosine, its_sine):
            return True
    for i in range(k.corners):
        if disc_touches(robot, other, k, k.corner_x[i], k.corner_y[i], 0.0, cosine, sine, its_cosine, its_sine):
            return True
    if k.corners > 0:
        return False
    if disc_touches(robot, other, k, k.body_disc_x, 0.0, k.body_disc_radius, cosine, sine, its_cosine, its_sine):
        return True
    rear = k.body_disc_x - k.body_disc_back
    return k.body_disc_back > 0.0 and disc_touches(
        robot, other, k, rear, 0.0, k.body_disc_radius, cosine, sine, its_cosine, its_sine
    )


@compiled
def disc_touches(robot, other, k, ahead, left, radius, cosine, sine, its_cosine, its_sine):
    """Tell whether a disc of a robot, its centre in the robot's frame [m], touches the outline of another robot."""
    x, y = point_of_frame(robot.x, robot.y, ahead, left, cosine, sine)
    return outline_gap_of(other, k, x, y, its_cosine, its_sine) < radius + TOUCH_GAP
