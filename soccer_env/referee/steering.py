"""Steer robots to their places at a restart, round the ball, which the referee holds.

Outside a ring round the ball a robot can turn without touching the ball. Robots drive round that ring; the taker, whose
place lies inside, drives to the ring behind its place, turns, and steps up to the ball.

`k`: the league's constants.
"""

from math import asin, cos, sin, sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, cosine_and_sine, into_frame, length, out_of_frame, wrap
from soccer_env.physics.contacts import paws_gap
from soccer_env.physics.gait import most_swing

ARRIVED = 0.10  # [m] from its place, assumed
SLOW_ZONE = 0.25  # [s] of travel before the place or the ring in which a robot slows down, assumed
CLEAR = 0.02  # [m] between the ball and the outermost point of a robot on the ring, assumed
BRAKING = 0.7  # [1] of the acceleration, used for braking before the ring, assumed
ALIGNED = 0.3  # [rad] off its place's heading within which the taker steps up, assumed
BEHIND = 0.98  # [1] cosine of the angle at the ball between taker and place within which it steps up, assumed
SET_BACK = 20  # most moves that take a robot out of the ball
SLACK = 0.0002  # [m] of overlap with the ball that is left, assumed


@compiled
def steer_to_place(match, robot, k):
    """Command a robot towards its place, round the ball, in place of its team's command.

    Places are relative to the ball; the robot's own place is predicted for the time when the command takes effect.
    """
    ring = k.body_reach + most_swing(k) + k.ball_radius + CLEAR
    lag = k.dt * (k.delay_steps + k.gait_steps)
    now_x, now_y = robot.x - match.restart_x, robot.y - match.restart_y
    x, y = now_x + lag * robot.vx, now_y + lag * robot.vy
    place_x, place_y = robot.place_x - match.restart_x, robot.place_y - match.restart_y
    turn = wrap(robot.place_heading - robot.heading)
    may_turn = length(now_x, now_y) > ring - CLEAR  # inside, a paw or a guide would sweep over the ball
    if is_behind_place(x, y, place_x, place_y, turn, ring):
        to_x, to_y = paced_velocity(k, place_x - x, place_y - y)
    else:
        place_x, place_y = move_out_to_ring(place_x, place_y, ring)
        to_x, to_y = path_round_ring(x, y, place_x, place_y, ring, match.handedness)
        to_x, to_y = paced_velocity(k, to_x, to_y)
        to_x, to_y = avoid_ring(k, x, y, to_x, to_y, ring)
        turn = turn if may_turn else 0.0
    ahead, left = into_frame(to_x, to_y, *cosine_and_sine(robot.heading))
    if k.drive_sideways <= 0.0:  # a differential base cannot step aside: it turns towards the place first
        ahead, left, turn = steer_without_sidestep(ahead, left, turn, length(place_x - x, place_y - y), may_turn)
    robot.command.forward = clip(ahead, -1.0, 1.0)
    robot.command.left = clip(left, -1.0, 1.0)
    robot.command.turn = clip(turn, -1.0, 1.0)
    robot.command.kick = 0.0


@compiled
def braking_speed(k, room):
    """Return the greatest speed [m/s] from which a robot can stop within a distance `room` [m]."""
    return min(room / SLOW_ZONE, sqrt(2.0 * BRAKING * k.drive_acceleration * room))


@compiled
def paced_velocity(k, x, y):
    """Return a velocity along the path x, y [m], a share of the top speed, from which a robot can stop at its end."""
    distance = max(length(x, y), 1e-9)
    share = min(braking_speed(k, distance) / k.drive_forward, 1.0) / distance
    return share * x, share * y


@compiled
def is_behind_place(x, y, place_x, place_y, turn, ring):
    """Tell whether a robot whose place lies inside the ring stands behind that place with its final heading."""
    near = length(place_x, place_y) < ring and abs(turn) < ALIGNED
    return near and x * place_x + y * place_y > BEHIND * length(x, y) * length(place_x, place_y)


@compiled
def move_out_to_ring(x, y, ring):
    """Return a place, moved straight out to the ring if it lies inside."""
    away = length(x, y)
    share = ring / away if 0.0 < away < ring else 1.0
    return share * x, share * y


@compiled
def path_round_ring(x, y, to_x, to_y, ring, handedness):
    """Return a vector from (x, y) along the path to (to_x, to_y): straight, or along a tangent of the ring.

    Its length is that of the straight path. If the straight path leads through the centre, handedness chooses the side.
    """
    to_x, to_y = to_x - x, to_y - y
    distance = length(to_x, to_y)
    along = -(x * to_x + y * to_y)
    across = x * to_y - y * to_x  # above 0: counter-clockwise round the ball
    if along <= 0.0 or along >= distance * distance or abs(across) >= ring * distance:
        return to_x, to_y
    away = length(x, y)
    side = handedness if across == 0.0 else (1.0 if across > 0.0 else -1.0)
    angle = -side * asin(min(ring / max(away, 1e-6), 1.0))
    ahead, left = out_of_frame(-x, -y, *cosine_and_sine(angle))
    share = distance / max(away, 1e-6)
    return share * ahead, share * left


@compiled
def avoid_ring(k, x, y, to_x, to_y, ring):
    """Return the velocity to_x, to_y (shares of the top speed), changed to stay out of the ring or to leave it."""
    away = max(length(x, y), 1e-6)
    room = away - ring
    most = (braking_speed(k, room) if room > 0.0 else room / SLOW_ZONE) / k.drive_forward
    closing = -(to_x * x + to_y * y) / away
    out = max(closing - most, 0.0) / away
    return to_x + out * x, to_y + out * y


@compiled
def steer_without_sidestep(ahead, left, turn, distance, may_turn):
    """Return the walk of a base that cannot move sideways: turn to the target, drive, turn to the final heading."""
    if distance < 0.5 * ARRIVED:
        return 0.0, 0.0, turn
    bearing = atan2(left, ahead)
    if not may_turn:  # drive out of the ring along the heading, ahead or back
        return ahead, 0.0, 0.0
    return (length(ahead, left) if abs(bearing) < 0.5 else 0.0), 0.0, bearing


@compiled
def move_off_ball(robot, k, ball, handedness):
    """Move a robot out of a ball that is laid down on it, until it only touches the ball; return how far [m].

    The robot loses its speed towards the ball. Afterwards no robot can move the ball (`physics.exchange.weigh_ball`).
    """
    x, y = robot.x - ball.x, robot.y - ball.y
    away = length(x, y)
    if robot.active == 0 or away >= k.body_reach + most_swing(k) + k.ball_radius:
        return 0.0
    if away < 1e-6:
        x, y, away = -cos(robot.heading), -sin(robot.heading), 1.0
    x, y = x / away, y / away
    moved = 0.0
    for _ in range(SET_BACK):
        gap = paws_gap(robot, k, ball.x, ball.y, handedness)
        if gap > -SLACK:
            break
        robot.x -= gap * x
        robot.y -= gap * y
        moved -= gap
    into = min(robot.vx * x + robot.vy * y, 0.0) if moved > 0.0 else 0.0
    robot.vx -= into * x
    robot.vy -= into * y
    return moved
