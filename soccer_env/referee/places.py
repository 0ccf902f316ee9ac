"""Free places: each robot that the referee must move gets the nearest place that is allowed and free.

The referee moves single robots at a restart, at a dropped ball and when robots are pulled apart; other robots stay. The
robot with the longest path chooses first. The choice depends on no team and no number, so that neither team is
favoured; the handedness of the match decides which side of the straight path is tried first.

`k`: the league's constants.
"""

from math import cos, pi, sin, sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, attack_direction, clip, cosine_and_sine, length
from soccer_env.types import Phase

PLAY, KICK_OFF, DROP_BALL = int(Phase.PLAY), int(Phase.KICK_OFF), int(Phase.DROP_BALL)
MARGIN = 0.02  # [m] between robots, assumed
STEP = 0.125  # [1] of a robot's reach: distance between the circles on which places are tried, assumed
DIRECTIONS = 48  # places on each circle, assumed
FARTHER = 0.28  # [m] beyond the rules' distance, the farthest that a robot is sent, assumed
HAIR = 1e-9  # [m] tolerance for rounding


@compiled
def assign_free_places(match, robots, settled, bans, goal_gap, k):
    """Give each robot that is not settled (R,) the nearest free place, the robot with the longest path first.

    `bans` (R, N, 3) are discs that a robot has to stay out of: x, y and radius [m], radius 0: none. A robot comes no
    nearer to the goal that it attacks than goal_gap (R,) [m], unless no such place is close.
    """
    for _ in range(robots.shape[0]):
        worst, longest, place_x, place_y = -1, -1.0, 0.0, 0.0
        for r in range(robots.shape[0]):
            if not settled[r]:
                x, y, way = find_place(match, robots, settled, r, bans[r], goal_gap[r], k)
                if way > longest:
                    worst, longest, place_x, place_y = r, way, x, y
        if worst < 0:
            return
        robots[worst].place_x, robots[worst].place_y = place_x, place_y
        settled[worst] = True


@compiled
def find_place(match, robots, settled, r, bans, goal_gap, k):
    """Return the free place nearest to robot r's place, and its distance [m, m, m]; the robot's own if none is free.

    A robot is sent at most FARTHER beyond the rules' distance. Without such a place it may come nearer to a goal, then
    nearer to its discs by a body's reach, or two in play, where it only has to get free; only then is it sent farther,
    in play and at a dropped ball just out of these smaller discs: a corner leaves no room beside a ball 0.5 m off it.
    """
    most = farthest_move(bans, k)
    if goal_gap > 0.0:
        x, y, way = search_place(match, robots, settled, r, bans, goal_gap, most, k)
        if way >= 0.0:
            return x, y, way
    x, y, way = search_place(match, robots, settled, r, bans, 0.0, most, k)
    fewer = bans
    for _ in range(2 if match.phase == PLAY else 1):
        if way < 0.0:
            fewer = shrink_discs(fewer, k)
            x, y, way = search_place(match, robots, settled, r, fewer, 0.0, most, k)
    if way < 0.0:
        last = fewer if match.phase == PLAY or match.phase == DROP_BALL else bans
        x, y, way = search_place(match, robots, settled, r, last, 0.0, k.pitch_length + k.pitch_width, k)
    return x, y, max(way, 0.0)


@compiled
def farthest_move(bans, k):
    """Return how far a robot that has to leave the discs may be sent [m]."""
    distance = k.rules_separation
    for i in range(bans.shape[0]):
        distance = max(distance, bans[i, 2] - k.body_reach)
    return distance + FARTHER


@compiled
def shrink_discs(bans, k):
    """Return copies of discs (N, 3), smaller by a body's reach, but large enough to keep a robot out of the ball."""
    smaller = bans.copy()
    for i in range(bans.shape[0]):
        smaller[i, 2] = max(bans[i, 2] - k.body_reach, min(bans[i, 2], k.body_reach + k.ball_radius + MARGIN))
    return smaller


@compiled
def search_place(match, robots, settled, r, bans, goal_gap, most, k):
    """Return the nearest allowed and free place within `most` [m], and its distance; -1: there is none."""
    robot = robots[r]
    ahead = direction_out_of_discs(match, robot, bans)
    step = STEP * k.body_reach
    for number in range(int(most / step) + 1):
        for i in range(DIRECTIONS if number > 0 else 1):
            turn = (i + 1) // 2 * (1.0 if i % 2 == 1 else -1.0) * match.handedness * 2.0 * pi / DIRECTIONS
            x = robot.place_x + number * step * cos(ahead + turn)
            y = robot.place_y + number * step * sin(ahead + turn)
            if is_allowed(match, robot, x, y, bans, goal_gap, k) and is_place_free(robots, settled, r, x, y, k):
                return x, y, number * step
    return robot.place_x, robot.place_y, -1.0


@compiled
def direction_out_of_discs(match, robot, bans):
    """Return the direction [rad] straight out of a robot's discs, towards its own goal if it is in none."""
    x = y = 0.0
    for i in range(bans.shape[0]):
        away_x, away_y = robot.place_x - bans[i, 0], robot.place_y - bans[i, 1]
        away = length(away_x, away_y)
        if 1e-6 < away < bans[i, 2]:
            x, y = x + (bans[i, 2] - away) * away_x / away, y + (bans[i, 2] - away) * away_y / away
    if length(x, y) < 1e-6:
        x, y = -attack_direction(match, robot.team), 0.0
    return atan2(y, x)


@compiled
def is_allowed(match, robot, x, y, bans, goal_gap, k):
    """Tell whether the rules let a robot stand at a place [m, m], other robots aside."""
    room, ramp = k.body_reach + MARGIN, k.legs * k.pitch_board_foot
    ramp_x = ramp if abs(y) > 0.5 * k.pitch_goal_width - k.body_reach else 0.0  # none in the mouth of a goal
    if abs(x) > 0.5 * k.pitch_length - room - ramp_x + HAIR or abs(y) > 0.5 * k.pitch_width - room - ramp + HAIR:
        return False
    side = attack_direction(match, robot.team)
    if match.phase == KICK_OFF and side * x > -k.body_reach + HAIR:
        return False
    if length(x - side * 0.5 * k.pitch_length, y) < goal_gap - HAIR:
        return False
    return is_outside_discs(x, y, bans)


@compiled
def is_outside_discs(x, y, bans):
    """Tell whether a place [m, m] lies in none of the discs (N, 3)."""
    clear = True
    for i in range(bans.shape[0]):
        clear = clear and length(x - bans[i, 0], y - bans[i, 1]) >= bans[i, 2] - HAIR
    return clear


@compiled
def is_place_free(robots, settled, r, x, y, k):
    """Tell whether robot r can stand at a place [m, m] with its heading, clear of all settled robots."""
    heading = robots[r].place_heading
    for other in range(robots.shape[0]):
        if other != r and settled[other] and robots[other].active == 1:
            there = robots[other]
            if are_robots_too_near(k, x, y, heading, there.place_x, there.place_y, there.place_heading):
                return False
    return True


@compiled
def are_robots_too_near(k, x, y, heading, other_x, other_y, other_heading):
    """Tell whether two robots at poses [m, m, rad], taken as capsules, stand nearer than the margin."""
    away = length(x - other_x, y - other_y)
    if away >= 2.0 * k.body_reach + MARGIN:
        return False
    half, radius = capsule(k)
    near = 2.0 * radius + MARGIN
    for i in range(3):
        along = (i - 1) * half
        if spine_gap(x + along * cos(heading), y + along * sin(heading), other_x, other_y, other_heading, half) < near:
            return True
        there_x, there_y = other_x + along * cos(other_heading), other_y + along * sin(other_heading)
        if spine_gap(there_x, there_y, x, y, heading, half) < near:
            return True
    return False


@compiled
def capsule(k):
    """Return half the spine's length and the radius [m, m] of a capsule that contains a robot."""
    width = max(k.body_disc_radius, k.body_tip_y + k.body_tip_radius, k.body_hind_y + k.body_tip_radius)
    for i in range(k.corners):
        width = max(width, abs(k.corner_y[i]))
    half = max(k.body_reach - width, 0.0)
    ahead = sqrt(max(k.body_reach * k.body_reach - width * width, 0.0))
    return half, length(ahead - half, width)


@compiled
def spine_gap(x, y, other_x, other_y, heading, half):
    """Return the distance [m] of a point from the spine of a robot."""
    ahead_x, ahead_y = cosine_and_sine(heading)
    along = clip((x - other_x) * ahead_x + (y - other_y) * ahead_y, -half, half)
    return length(x - other_x - along * ahead_x, y - other_y - along * ahead_y)


@compiled
def empty_bans(count, each):
    """Return empty arguments of `assign_free_places`: bans (count, each, 3), settled and goal gaps (count,)."""
    return np.zeros((count, each, 3)), np.zeros(count, np.bool_), np.zeros(count)
