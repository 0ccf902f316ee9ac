"""Pull apart opponents that have collided and do not come free.  [Sacks 2001, 1]  MS55

"The referee can, in many circumstances, separate robots that have collided after a set time". Unlike there it is in all
circumstances, for the paper does not say which, and the set time is assumed. The ball stays where it is and play goes
on.

`k`: the league's constants.
"""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import length
from soccer_env.physics.contacts import robots_touch
from soccer_env.referee.restarts import MARGIN, PASSES, STIR, SWIRL, push_of_others, put_robot, stay, stay_on_pitch

MOVED = 1e-6  # [m] a shorter move does not count


@compiled
def watch_contacts(robots, robot_events, k):
    """Count for how long each robot has been in contact with an opponent; time out of contact is taken off.

    Robots that push against each other lose contact for moments, which does not free them.
    """
    for r in range(robots.shape[0]):
        robot = robots[r]
        if robot_events[r].collision == 1 and touches_opponent(robots, r, k):
            robot.locked += k.dt
        elif robot.locked > 0.0:
            robot.locked = max(robot.locked - k.dt, 0.0)


@compiled
def touches_opponent(robots, r, k):
    """Tell whether robot r touches an opponent."""
    for other in range(robots.shape[0]):
        opponent = robots[other].team != robots[r].team
        if opponent and is_near(robots[r], robots[other], k) and robots_touch(robots[r], robots[other], k):
            return True
    return False


@compiled
def is_near(robot, other, k):
    """Tell whether two robots stand so near that they may touch."""
    x, y = other.x - robot.x, other.y - robot.y
    near = 2.0 * k.body_reach + MARGIN
    return other.active == 1 and x * x + y * y < near * near


@compiled
def is_overdue(robot, k):
    """Tell whether a robot has been in contact for too long."""
    return robot.locked >= k.rules_contact_time - 0.5 * k.dt


@compiled
def is_locked(robot, other, k):
    """Tell whether two opponents hold each other for too long."""
    return robot.team != other.team and is_overdue(robot, k) and is_overdue(other, k) and is_near(robot, other, k)


@compiled
def pull_apart(ball, robots, match, k):
    """Pull opponents in contact for too long apart, to the rules' distance; tell whether anybody was moved.  MS55"""
    count, found = robots.shape[0], False
    for r in range(count):
        found = found or is_overdue(robots[r], k)
    if not found:
        return False
    locked = np.zeros((count, count), np.bool_)
    found = False
    for r in range(count):
        stay(robots[r])
        for other in range(count):
            locked[r, other] = is_locked(robots[r], robots[other], k)
            found = found or locked[r, other]
    if found:
        spread_places(ball, robots, match, locked, k)
        for r in range(count):
            x, y = robots[r].place_x - robots[r].x, robots[r].place_y - robots[r].y
            if robots[r].active == 1 and length(x, y) > MOVED:
                put_robot(robots[r])
    return found


@compiled
def spread_places(ball, robots, match, locked, k):
    """Move places until locked pairs stand apart, nobody in anybody, in the ball or off the pitch.

    All moves of a pass are made at once, so that no robot is favoured by its number.
    """
    count = robots.shape[0]
    move_x, move_y = np.zeros(count), np.zeros(count)
    for number in range(PASSES):
        busy = False
        swirl = SWIRL * match.handedness if number // STIR % 2 == 1 else 0.0
        for r in range(count):
            move_x[r], move_y[r] = push_of_others(robots, r, k)
            for other in range(count):
                if locked[r, other]:
                    x, y = push_from(robots[r], robots[other], k)
                    move_x[r], move_y[r] = move_x[r] + x, move_y[r] + y
            busy = busy or move_x[r] != 0.0 or move_y[r] != 0.0
        for r in range(count):
            if robots[r].active == 1 and (move_x[r] != 0.0 or move_y[r] != 0.0):
                robots[r].place_x += move_x[r]
                robots[r].place_y += move_y[r]
                leave_alone(ball, robots[r], k, swirl)
                stay_on_pitch(match, robots[r], k)
        if not busy:
            return


@compiled
def push_from(robot, other, k):
    """Return how far a robot's place has to move from that of the opponent it is locked with [m, m]."""
    apart = k.rules_separation + k.body_reach
    x, y = robot.place_x - other.place_x, robot.place_y - other.place_y
    gap = max(length(x, y), 1e-6)
    move = 0.5 * (apart - gap) if gap < apart - MOVED else 0.0
    return move * x / gap, move * y / gap


@compiled
def leave_alone(ball, robot, k, swirl):
    """Move a place that overlaps the ball away from it, and `swirl` times as far round it."""
    x, y = robot.place_x - ball.x, robot.place_y - ball.y
    gap, far = max(length(x, y), 1e-6), k.body_reach + k.ball_radius + MARGIN
    if gap < far:
        along = swirl * (far - gap)
        robot.place_x = ball.x + (x * far - y * along) / gap
        robot.place_y = ball.y + (y * far + x * along) / gap
