"""Carry out a restart: put the ball down, choose places, keep the distances, put robots there or let them drive.

Under instant placement the robots stand at their places at once. Under drive placement the referee steers them for up
to the league's placing time (steering.py); meanwhile the clock runs, and the ball lies still as an obstacle. Then the
taker is put at its place, and a robot too near the ball, in the wrong half or in another robot is moved to the nearest
place where it may stand; no other robot is moved. A dropped ball has no formation.

`k`: the league's constants.
"""

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction, clip, length
from soccer_env.physics.ball import stop_ball
from soccer_env.physics.contacts import robots_touch
from soccer_env.referee.areas import in_penalty_area
from soccer_env.referee.formation import choose_places, is_taker
from soccer_env.referee.places import (
    MARGIN,
    assign_free_places,
    empty_bans,
    is_allowed,
    is_outside_discs,
    is_place_free,
)
from soccer_env.referee.steering import ARRIVED, move_off_ball
from soccer_env.types import Phase

KICK_OFF, DROP_BALL = int(Phase.KICK_OFF), int(Phase.DROP_BALL)
STEP_ASIDE, STEPS_ASIDE = (
    0.01,
    60,
)  # [m] and number of the steps by which a robot makes room for a carried robot, assumed
TO_WALK_OUT = 3.0  # [s] to leave an area after being put there, assumed: a body's length at top speed
CARRIED = 0.03  # [m] a robot moved farther than this was carried, assumed


@compiled
def carry_out_restart(match, ball, robots, k, drive):
    """Put the ball on its spot; put the robots at their places, or let them drive there (drive 1)."""
    put_ball(ball, match.restart_x, match.restart_y)
    if match.phase == DROP_BALL:
        for r in range(robots.shape[0]):
            keep_present_pose(robots[r])
    else:
        choose_places(match, robots, k)
    keep_distances(match, robots, k)
    if drive == 1 and match.phase != DROP_BALL:
        match.placing = 1
        move_robots_off_ball(match, ball, robots, k)
    else:
        place_robots(robots)


@compiled
def move_robots_off_ball(match, ball, robots, k):
    """Move robots out of the ball that is laid down; a robot moved far counts as carried and is told its place."""
    for r in range(robots.shape[0]):
        if move_off_ball(robots[r], k, ball, match.handedness) > CARRIED:
            robots[r].placed = 1
    for _ in range(robots.shape[0]):
        for r in range(robots.shape[0]):
            if robots[r].placed == 1:
                make_room(robots, r, ball, k)


@compiled
def make_room(robots, r, ball, k):
    """Move robots that overlap the carried robot r farther away from the ball."""
    near = 2.0 * k.body_reach
    for other in range(robots.shape[0]):
        x, y = robots[other].x - robots[r].x, robots[other].y - robots[r].y
        if other == r or robots[other].active == 0 or x * x + y * y > near * near:
            continue
        x, y = robots[other].x - ball.x, robots[other].y - ball.y
        away = max(length(x, y), 1e-6)
        if away < length(robots[r].x - ball.x, robots[r].y - ball.y):
            continue
        for _ in range(STEPS_ASIDE):
            if not robots_touch(robots[r], robots[other], k):
                break
            room = k.body_reach + k.legs * k.pitch_board_foot
            edge_x = 0.5 * k.pitch_length + k.pitch_band_end - room
            edge_y = 0.5 * k.pitch_width + k.pitch_band_side - room
            robots[other].x = clip(robots[other].x + STEP_ASIDE * x / away, -edge_x, edge_x)
            robots[other].y = clip(robots[other].y + STEP_ASIDE * y / away, -edge_y, edge_y)
            robots[other].placed = 1


@compiled
def put_ball(ball, x, y):
    """Lay the ball down [m, field frame]."""
    ball.x, ball.y = x, y
    stop_ball(ball)


@compiled
def keep_present_pose(robot):
    """Make a robot stay: set its assigned place to its present pose."""
    robot.place_x, robot.place_y, robot.place_heading = robot.x, robot.y, robot.heading


@compiled
def place_robots(robots):
    """Put all active robots at their places, at rest."""
    for r in range(robots.shape[0]):
        if robots[r].active == 1:
            put_robot(robots[r])


@compiled
def put_robot(robot):
    """Put a robot at its place, at rest; a carried robot is told its place, and its head is set straight.

    So every kick-off begins like the first.
    """
    if length(robot.place_x - robot.x, robot.place_y - robot.y) > CARRIED:
        robot.placed = 1
        robot.pan = robot.tilt = 0.0
        robot.trespass = -TO_WALK_OUT
    robot.x, robot.y, robot.heading = robot.place_x, robot.place_y, robot.place_heading
    stop_robot(robot)


@compiled
def stop_robot(robot):
    """Stop a robot: no speed, no delayed walk, no kick begun."""
    robot.vx = robot.vy = robot.omega = 0.0
    robot.walk.forward = robot.walk.left = robot.walk.turn = 0.0
    robot.target.forward = robot.target.left = robot.target.turn = 0.0
    for i in range(robot.delayed.shape[0]):
        robot.delayed[i].forward = robot.delayed[i].left = robot.delayed[i].turn = 0.0
    robot.kick_clock = robot.locked = 0.0
    robot.has_ball = 0


@compiled
def keep_distances(match, robots, k):
    """Move places until opponents keep their distance from the ball, and robots their half and their own room.

    The taker is settled first, then goalkeepers and other robots that may stay at their places, the nearest to the ball
    first; each remaining robot gets the nearest place where it may stand.
    """
    count = robots.shape[0]
    bans, settled, goal_gap = empty_bans(count, 1)
    for r in range(count):
        ball_gap = gap_to_keep(match, robots, r, k)
        bans[r, 0, 0], bans[r, 0, 1], bans[r, 0, 2] = match.restart_x, match.restart_y, ball_gap
        settled[r] = robots[r].active == 0 or is_taker(match, robots, r)
    for keepers in range(2):
        for _ in range(count):
            r = nearest_waiting(match, robots, settled, goal_gap, keepers == 0)
            if r < 0:
                break
            goal_gap[r] = 1.0  # looked at
            settled[r] = may_stay(match, robots, settled, r, bans[r], k)
    goal_gap[:] = 0.0
    assign_free_places(match, robots, settled, bans, goal_gap, k)


@compiled
def send_back(match, robots, r, k):
    """Move the place of robot r alone to the nearest free place at the required distance from the ball."""
    bans, settled, goal_gap = empty_bans(robots.shape[0], 1)
    settled[:] = True
    settled[r] = False
    bans[r, 0, 0], bans[r, 0, 1], bans[r, 0, 2] = match.restart_x, match.restart_y, gap_to_keep(match, robots, r, k)
    assign_free_places(match, robots, settled, bans, goal_gap, k)


@compiled
def nearest_waiting(match, robots, settled, seen, keepers):
    """Return the row of the robot (goalkeeper if `keepers`) nearest to the ball, neither settled nor seen; -1: none."""
    nearest, least = -1, 1e9
    for r in range(robots.shape[0]):
        if settled[r] or seen[r] > 0.0 or (keepers and robots[r].keeper == 0):
            continue
        away = length(robots[r].place_x - match.restart_x, robots[r].place_y - match.restart_y)
        if away < least:
            nearest, least = r, away
    return nearest


@compiled
def may_stay(match, robots, settled, r, bans, k):
    """Tell whether robot r may stand at its place.

    Robots that are not carried may stand close together, but at a restart with a taker they must not touch.
    """
    robot = robots[r]
    x, y = robot.place_x, robot.place_y
    if is_carried(robot):
        return is_allowed(match, robot, x, y, bans, 0.0, k) and is_place_free(robots, settled, r, x, y, k)
    if not is_outside_discs(x, y, bans) or (
        match.phase == KICK_OFF and attack_direction(match, robot.team) * x > -k.body_reach
    ):
        return False
    carried = np.zeros(robots.shape[0], np.bool_)
    for other in range(robots.shape[0]):
        carried[other] = settled[other] and is_carried(robots[other])
        near = settled[other] and not carried[other] and match.phase != DROP_BALL and robots[other].active == 1
        if near and other != r and robots_touch(robot, robots[other], k):
            return False
    return is_place_free(robots, carried, r, x, y, k)


@compiled
def is_carried(robot):
    """Tell whether a robot's place differs from the place where it stands."""
    return robot.place_x != robot.x or robot.place_y != robot.y


@compiled
def gap_to_keep(match, robots, r, k):
    """Return the least distance [m] of robot r's centre from the ball; a goalkeeper that may stay just clears it."""
    robot = robots[r]
    gap = distance_from_ball(match, robot, k) + k.body_reach
    if robot.keeper == 1 and (match.phase != DROP_BALL or in_penalty_area(match, robot, robot.team, k)):
        return min(gap, k.body_reach + k.ball_radius + MARGIN)
    return gap


@compiled
def distance_from_ball(match, robot, k):
    """Return the distance that a robot has to keep from the ball at the current restart [m]."""
    if match.phase == DROP_BALL:
        return k.rules_separation
    if robot.team == match.restart_team:
        return k.body_reach + k.ball_radius + 2.0 * MARGIN
    return k.rules_kick_off_distance if match.phase == KICK_OFF else k.rules_restart_distance


@compiled
def is_ready(match, robots, r, k):
    """Tell whether robot r is ready for a restart: the taker at its place, other robots where the rules allow."""
    robot = robots[r]
    if is_taker(match, robots, r):
        return length(robot.x - robot.place_x, robot.y - robot.place_y) <= ARRIVED
    if length(robot.x - match.restart_x, robot.y - match.restart_y) < distance_from_ball(match, robot, k):
        return False
    return match.phase != KICK_OFF or robot.x * attack_direction(match, robot.team) <= 0.0


@compiled
def end_placing(match, ball, robots, k):
    """End the placement when all robots are ready or the time is up: correct illegal places, stop all robots."""
    put_ball(ball, match.restart_x, match.restart_y)
    ready = True
    for r in range(robots.shape[0]):
        ready = ready and (robots[r].active == 0 or is_ready(match, robots, r, k))
    if not ready and match.phase_clock < k.rules_placing_time - 1.5 * k.dt:  # the referee's clock is one step behind
        return
    match.placing = 0
    match.phase_clock = 0.0
    for r in range(robots.shape[0]):
        if not is_taker(match, robots, r):
            keep_present_pose(robots[r])
    keep_distances(match, robots, k)
    place_robots(robots)
