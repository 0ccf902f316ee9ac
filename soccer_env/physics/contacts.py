"""Who touched what, from positions and velocities.

Chipmunk's own contacts come in an order that differs between processes.

`k`: the league's constants.
"""

from __future__ import annotations

from math import cos, sin

from soccer_env.compiled import compiled
from soccer_env.geometry import into_frame, length, point_of_frame

TOUCH_GAP = 0.004  # [m] assumed: a ball this near touches
KNOCK = 0.02  # [m/s] assumed: a change of velocity that friction does not explain


@compiled
def ball_gap(robot, k, ball_x, ball_y):
    """Return the distance [m] between the ball and a robot's outline; below 0 they overlap."""
    x, y = ball_x - robot.x, ball_y - robot.y
    cosine, sine = cos(robot.heading), sin(robot.heading)
    ahead, left = into_frame(x, y, cosine, sine)
    gap = length(ahead - k.body_tip_x, abs(left) - k.body_tip_y) - k.body_tip_radius
    body = disc_gap(k, ahead, left) if k.corners == 0 else hull_gap(k, ahead, left)
    return min(gap, body) - k.ball_radius


@compiled
def disc_gap(k, ahead, left):
    """Return the distance [m] of a point from a robot's disc."""
    return length(ahead - k.body_disc_x, left) - k.body_disc_radius


@compiled
def hull_gap(k, ahead, left):
    """Return the distance [m] of a point from a robot's convex hull, the depth below 0 inside."""
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
def find_touches(ball, robots, robot_events, k, knock_x, knock_y):
    """Mark the robots that touch the ball; return the row of the one that touched it last (the nearest), or -1.

    The knock [m/s] is the change of velocity that the contacts of this step made. A ball that was knocked may already
    be on its way: the nearest robot that it was knocked away from, within the distance that the two can have moved
    apart, touched it.
    """
    nearest, least = -1, 1e9
    knocked = knock_x * knock_x + knock_y * knock_y > KNOCK * KNOCK
    for r in range(robots.shape[0]):
        robot = robots[r]
        x, y = ball.x - robot.x, ball.y - robot.y
        gone = TOUCH_GAP
        if knocked:
            gone += k.dt * length(ball.vx - robot.vx, ball.vy - robot.vy)
        reach = k.body_reach + k.ball_radius + gone
        if robot.active == 0 or x * x + y * y > reach * reach:
            continue
        gap = ball_gap(robot, k, ball.x, ball.y)
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
def find_collisions(robots, robot_events, k):
    """Mark the robots that touch another robot."""
    near = 2.0 * k.body_reach + TOUCH_GAP
    for r in range(robots.shape[0]):
        for other in range(r + 1, robots.shape[0]):
            x, y = robots[other].x - robots[r].x, robots[other].y - robots[r].y
            if x * x + y * y < near * near and robots_touch(robots[r], robots[other], k):
                robot_events[r].collision = 1
                robot_events[other].collision = 1


@compiled
def robots_touch(robot, other, k):
    """Tell whether the outlines of two robots touch, judged by the points of each against the hull of the other."""
    return points_touch(robot, other, k) or points_touch(other, robot, k)


@compiled
def points_touch(robot, other, k):
    """Tell whether a corner or tip (or the disc) of one robot touches the outline of the other."""
    cosine, sine = cos(robot.heading), sin(robot.heading)
    slack = k.ball_radius - TOUCH_GAP  # ball_gap takes off the ball's radius, which is not wanted here
    for side in (-1.0, 1.0):
        x, y = point_of_frame(robot.x, robot.y, k.body_tip_x, side * k.body_tip_y, cosine, sine)
        if ball_gap(other, k, x, y) + slack < k.body_tip_radius:
            return True
    if k.corners == 0:
        x, y = robot.x + cosine * k.body_disc_x, robot.y + sine * k.body_disc_x
        return ball_gap(other, k, x, y) + slack < k.body_disc_radius
    for i in range(k.corners):
        x, y = point_of_frame(robot.x, robot.y, k.corner_x[i], k.corner_y[i], cosine, sine)
        if ball_gap(other, k, x, y) + slack < 0.0:
            return True
    return False
