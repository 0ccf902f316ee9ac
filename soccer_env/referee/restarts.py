"""Carry out a restart: put the ball down, choose places, keep the distances, put robots there or let them drive.

Under instant placement the robots stand at their places at once. Under drive placement the referee steers them for up
to the league's placing time (steering.py), while the ball lies still, an obstacle to all, and the clock runs. Then the
taker is put at its place, and whoever stands too near the ball, in the wrong half or in another robot is moved as far
as it must be.

`k`: the league's constants.
"""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, direction_of, length
from soccer_env.physics.ball import hold
from soccer_env.physics.contacts import robots_touch
from soccer_env.referee.formation import choose_places, is_taker
from soccer_env.referee.steering import ARRIVED, keep_off
from soccer_env.types import Phase

KICK_OFF = int(Phase.KICK_OFF)
DROP_BALL = int(Phase.DROP_BALL)
PASSES = 200  # over the robots, to pull overlapping places apart
STIR = 20  # passes between two changes: straight out of the ring round the ball, or also along it, out of dead ends
SWIRL = 3.0  # [1] length of the move along the ring over that of the move out of it
MARGIN = 0.02  # [m] between robots, assumed
STEP_ASIDE, STEPS_ASIDE = 0.01, 60  # [m] by which, and how often, a robot makes room for one that is carried, assumed
CARRIED = 0.03  # [m] a robot that is moved farther was carried, assumed


@compiled
def carry_out_restart(match, ball, robots, k, drive):
    """Put the ball on its spot; put the robots at their places, or (drive 1) let them drive there."""
    put_ball(ball, match.restart_x, match.restart_y)
    if match.phase == DROP_BALL:
        for r in range(robots.shape[0]):
            stay(robots[r])
    else:
        choose_places(match, robots, k)
    keep_distances(match, robots, k)
    if drive == 1 and match.phase != DROP_BALL:
        match.placing = 1
        keep_all_off(match, ball, robots, k)
    else:
        place_robots(robots)


@compiled
def keep_all_off(match, ball, robots, k):
    """Set back who stands where the ball is laid down; who is set back far was carried, and is told where it is."""
    for r in range(robots.shape[0]):
        if keep_off(robots[r], k, ball, match.handedness) > CARRIED:
            robots[r].placed = 1
    for _ in range(robots.shape[0]):
        for r in range(robots.shape[0]):
            if robots[r].placed == 1:
                make_room(robots, r, ball, k)


@compiled
def make_room(robots, r, ball, k):
    """Carry those farther out, away from the ball, into whom a robot has been carried."""
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
            edge_x = 0.5 * k.pitch_length + k.pitch_band_end - k.body_reach
            edge_y = 0.5 * k.pitch_width + k.pitch_band_side - k.body_reach
            robots[other].x = clip(robots[other].x + STEP_ASIDE * x / away, -edge_x, edge_x)
            robots[other].y = clip(robots[other].y + STEP_ASIDE * y / away, -edge_y, edge_y)
            robots[other].placed = 1


@compiled
def put_ball(ball, x, y):
    """Lay the ball down [m, field frame]."""
    ball.x, ball.y = x, y
    hold(ball)


@compiled
def stay(robot):
    """Make a robot's present pose its place."""
    robot.place_x, robot.place_y, robot.place_heading = robot.x, robot.y, robot.heading


@compiled
def place_robots(robots):
    """Put all active robots at their places, at rest."""
    for r in range(robots.shape[0]):
        if robots[r].active == 1:
            put_robot(robots[r])


@compiled
def put_robot(robot):
    """Put a robot at its place, at rest; one that had to be carried is told where it is, and its head is put straight.

    Every kick-off then begins like the first one, whatever the heads were looking at.
    """
    if length(robot.place_x - robot.x, robot.place_y - robot.y) > CARRIED:
        robot.placed = 1
        robot.pan = robot.tilt = 0.0
    robot.x, robot.y, robot.heading = robot.place_x, robot.place_y, robot.place_heading
    stop(robot)


@compiled
def stop(robot):
    """Let a robot stand: no speed, no walk on its way, no kick begun."""
    robot.vx = robot.vy = robot.omega = 0.0
    robot.walk.forward = robot.walk.left = robot.walk.turn = 0.0
    robot.target.forward = robot.target.left = robot.target.turn = 0.0
    for i in range(robot.delayed.shape[0]):
        robot.delayed[i].forward = robot.delayed[i].left = robot.delayed[i].turn = 0.0
    robot.kick_clock = robot.locked = 0.0
    robot.has_ball = 0


@compiled
def keep_distances(match, robots, k):
    """Move places until nobody overlaps, opponents keep their distance from the ball and all stand on the pitch.

    All moves of a pass are made at once, so that no robot is favoured by its number.
    """
    count = robots.shape[0]
    move_x, move_y = np.zeros(count), np.zeros(count)
    for number in range(PASSES):
        busy = False
        swirl = SWIRL * match.handedness if number // STIR % 2 == 1 else 0.0
        for r in range(count):
            move_x[r], move_y[r] = push_of_others(robots, r, k)
            busy = busy or move_x[r] != 0.0 or move_y[r] != 0.0
        for r in range(count):
            if robots[r].active == 1 and not is_taker(match, robots, r):
                robots[r].place_x += move_x[r]
                robots[r].place_y += move_y[r]
                busy = leave_ball(match, robots[r], k, swirl) or busy
                stay_on_pitch(match, robots[r], k)
        if not busy:
            return


@compiled
def push_of_others(robots, r, k):
    """Return how far the places that overlap with robot r's push it [m, m]."""
    push_x = push_y = 0.0
    if robots[r].active == 0:
        return push_x, push_y
    apart = 2.0 * k.body_reach + MARGIN
    for other in range(robots.shape[0]):
        if other == r or robots[other].active == 0:
            continue
        x, y = robots[r].place_x - robots[other].place_x, robots[r].place_y - robots[other].place_y
        gap = length(x, y)
        if gap >= apart:
            continue
        if gap < 1e-6:
            x = 0.0
            y = 1.0 if r > other else -1.0
            gap = 1.0
            push_y += 0.5 * apart * y
        else:
            push_x += 0.55 * (apart - gap) * x / gap
            push_y += 0.55 * (apart - gap) * y / gap
    return push_x, push_y


@compiled
def distance_from_ball(match, robot, k):
    """Return how far a robot has to stay from the ball at the current restart [m]."""
    if match.phase == DROP_BALL:
        return k.rules_separation
    if robot.team == match.restart_team:
        return k.body_reach + k.ball_radius + 2.0 * MARGIN
    return k.rules_kick_off_distance if match.phase == KICK_OFF else k.rules_restart_distance


@compiled
def leave_ball(match, robot, k, swirl):
    """Move a place out of the ring round the ball that is forbidden; return whether it had to.

    It also moves along the ring, `swirl` times as far as out of it, so that two robots that block each other get free.
    """
    far = distance_from_ball(match, robot, k) + k.body_reach
    x, y = robot.place_x - match.restart_x, robot.place_y - match.restart_y
    gap = length(x, y)
    if gap >= far:
        return False
    if robot.keeper == 1 and match.phase != DROP_BALL and gap >= k.body_reach + k.ball_radius:
        return False  # the goalkeeper may stand on its goal line
    if gap < 1e-6:
        x = -direction_of(match, robot.team)
        y = 0.0
        gap = 1.0
    along = swirl * (far - gap)
    robot.place_x = match.restart_x + (x * far - y * along) / gap
    robot.place_y = match.restart_y + (y * far + x * along) / gap
    return True


@compiled
def stay_on_pitch(match, robot, k):
    """Hold a place on the pitch, and in the own half at a kick-off."""
    room = k.body_reach + k.legs * k.pitch_board_foot + MARGIN
    edge_x, edge_y = 0.5 * k.pitch_length - room, 0.5 * k.pitch_width - room
    robot.place_x = clip(robot.place_x, -edge_x, edge_x)
    robot.place_y = clip(robot.place_y, -edge_y, edge_y)
    if match.phase == KICK_OFF:
        side = direction_of(match, robot.team)
        robot.place_x = side * min(side * robot.place_x, -k.body_reach)


@compiled
def is_ready(match, robots, r, k):
    """Tell whether robot r is ready for a restart: the taker at its place, the others where the rules let them."""
    robot = robots[r]
    if is_taker(match, robots, r):
        return length(robot.x - robot.place_x, robot.y - robot.place_y) <= ARRIVED
    if length(robot.x - match.restart_x, robot.y - match.restart_y) < distance_from_ball(match, robot, k):
        return False
    return match.phase != KICK_OFF or robot.x * direction_of(match, robot.team) <= 0.0


@compiled
def end_placing(match, ball, robots, k):
    """End the placement when all are ready or the time is up: correct illegal places, and stop all robots."""
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
            stay(robots[r])
    keep_distances(match, robots, k)
    place_robots(robots)
