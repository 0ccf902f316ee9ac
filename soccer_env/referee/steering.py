"""How robots drive to their places at a restart: round the ball, which is held and which nobody drives through.

Out of a ring round the ball a robot can turn as it likes without touching it. Robots go round that ring; the taker,
whose place lies within, first comes to the ring behind its place, turns, and steps up.

`k`: the league's constants.
"""

from math import asin, atan2, cos, sin, sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, into_frame, length, out_of_frame, wrap
from soccer_env.physics.contacts import paws_gap
from soccer_env.physics.gait import most_swing

ARRIVED = 0.10  # [m] from its place, assumed
SLOW_ZONE = 0.25  # [s] of travel before the place or the ring in which a robot slows down, assumed
CLEAR = 0.02  # [m] between the ball and the outermost point of a robot on the ring, assumed
BRAKING = 0.7  # [1] of the acceleration that is counted on before the ring, assumed
ALIGNED = 0.3  # [rad] off its place's heading within which the taker steps up, assumed
BEHIND = 0.98  # [1] cosine of the angle at the ball between taker and place within which it steps up, assumed
SET_BACK = 20  # moves, at most, until a robot is out of the ball
SLACK = 0.0002  # [m] that a robot may be left in the ball, assumed


@compiled
def steer_to_place(match, robot, k):
    """Command a robot towards its place, round the ball, whatever its team asked for.

    Places are seen from the ball; the robot's own is the one where it will be when the command takes effect.
    """
    ring = k.body_reach + most_swing(k) + k.ball_radius + CLEAR
    lag = k.dt * (k.delay_steps + k.gait_steps)
    now_x, now_y = robot.x - match.restart_x, robot.y - match.restart_y
    x, y = now_x + lag * robot.vx, now_y + lag * robot.vy
    place_x, place_y = robot.place_x - match.restart_x, robot.place_y - match.restart_y
    turn = wrap(robot.place_heading - robot.heading)
    may_turn = length(now_x, now_y) > ring - CLEAR  # within, a paw or a guide would sweep over the ball
    if steps_up(x, y, place_x, place_y, turn, ring):
        to_x, to_y = paced(k, place_x - x, place_y - y)
    else:
        place_x, place_y = out_to_ring(place_x, place_y, ring)
        to_x, to_y = way_round(x, y, place_x, place_y, ring, match.handedness)
        to_x, to_y = paced(k, to_x, to_y)
        to_x, to_y = hold_off(k, x, y, to_x, to_y, ring)
        turn = turn if may_turn else 0.0
    ahead, left = into_frame(to_x, to_y, cos(robot.heading), sin(robot.heading))
    if k.drive_sideways <= 0.0:  # a differential base cannot step aside: it turns towards the place first
        ahead, left, turn = aim_ahead(ahead, left, turn, length(place_x - x, place_y - y), may_turn)
    robot.command.forward = clip(ahead, -1.0, 1.0)
    robot.command.left = clip(left, -1.0, 1.0)
    robot.command.turn = clip(turn, -1.0, 1.0)
    robot.command.kick = 0.0


@compiled
def braking_speed(k, room):
    """Return the speed [m/s] from which a robot still stops within a room [m]."""
    return min(room / SLOW_ZONE, sqrt(2.0 * BRAKING * k.drive_acceleration * room))


@compiled
def paced(k, x, y):
    """Return a way [m, m] as a share of the top speed, slow enough to stop at its end."""
    distance = max(length(x, y), 1e-9)
    share = min(braking_speed(k, distance) / k.drive_forward, 1.0) / distance
    return share * x, share * y


@compiled
def steps_up(x, y, place_x, place_y, turn, ring):
    """Tell whether a robot whose place lies within the ring stands behind it, turned as it will stand there."""
    near = length(place_x, place_y) < ring and abs(turn) < ALIGNED
    return near and x * place_x + y * place_y > BEHIND * length(x, y) * length(place_x, place_y)


@compiled
def out_to_ring(x, y, ring):
    """Return a place that lies within the ring moved straight out to it, any other as it is."""
    away = length(x, y)
    share = ring / away if 0.0 < away < ring else 1.0
    return share * x, share * y


@compiled
def way_round(x, y, to_x, to_y, ring, handedness):
    """Return a vector from (x, y) along the way to (to_x, to_y): straight, or along a tangent of the ring.

    Its length is that of the straight way. Of a way right through the middle handedness says on which side it passes.
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
    ahead, left = out_of_frame(-x, -y, cos(angle), sin(angle))
    share = distance / max(away, 1e-6)
    return share * ahead, share * left


@compiled
def hold_off(k, x, y, to_x, to_y, ring):
    """Return a way, as a share of the top speed, that comes no nearer to the ball than the ring, or backs out of it."""
    away = max(length(x, y), 1e-6)
    room = away - ring
    most = (braking_speed(k, room) if room > 0.0 else room / SLOW_ZONE) / k.drive_forward
    closing = -(to_x * x + to_y * y) / away
    out = max(closing - most, 0.0) / away
    return to_x + out * x, to_y + out * y


@compiled
def aim_ahead(ahead, left, turn, distance, may_turn):
    """Return what a base that cannot step aside should do: face its way, drive, then take up the heading."""
    if distance < 0.5 * ARRIVED:
        return 0.0, 0.0, turn
    bearing = atan2(left, ahead)
    if not may_turn:  # drive along its heading, whichever way leads out
        return ahead, 0.0, 0.0
    return (length(ahead, left) if abs(bearing) < 0.5 else 0.0), 0.0, bearing


@compiled
def keep_off(robot, k, ball, handedness):
    """Set a robot back on whose place the ball is laid down, until it only touches it; return how far [m].

    It loses its speed towards the ball. Later the ball is too heavy for anybody (`physics.exchange.weigh_ball`).
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
