"""Legs that get at the ball and at other legs: a model that is off by default.  [Sacks 2001, 4.3.2, 4.3.3]  MS51

A body of one piece never loses a ball that lies between its paws (claims S51, S59). The paper's robots kicked it away
with steps of 4 cm, kept it with 3.5 cm, lost it when they moved more than 45 degrees aside, and interlocked legs with
a robot right ahead unless they moved 55 degrees aside. The paper has no curves: those here are assumed, and zero
where it reports no trouble. `Drive.leg_disturbance` scales them; at 0 nothing is drawn.

                      ball between the paws                        another robot touches
    size of a push    40 (step - 3.5 cm) + 0.8 (angle - 45 deg)    + 0.1 m/s
    probability that the legs interlock for this step              1 straight ahead, down to 0 at 60 degrees, only if
                                                                   that robot stands ahead

`k`: the league's constants.
"""

from __future__ import annotations

from math import atan2, cos, pi, sin

from soccer_env.compiled import compiled
from soccer_env.geometry import into_frame, length, out_of_frame
from soccer_env.physics.contacts import robots_touch
from soccer_env.physics.kicker import holds_ball
from soccer_env.random_numbers import normal, uniform
from soccer_env.types import RobotStream

LEGS = int(RobotStream.LEGS)
SHORT_STEP = 0.035  # [m] "allows the robots to maintain control of the ball most of the time", Sacks 2001, 4.3.2
LENGTH_PUSH = 40.0  # [1/s] push for each metre more: 0.2 m/s at 4 cm, of which few send the ball 10 cm off, assumed
SMALL_ANGLE = 45.0 * pi / 180.0  # [rad] off straight ahead beyond which it "loses control", Sacks 2001, 4.3.3
ANGLE_PUSH = 0.8  # [m/s] for each radian more, assumed
CONTACT_PUSH = 0.1  # [m/s] while another robot touches, assumed
MOST_PUSH = 0.6  # [m/s] as much as a weak kick, assumed
SIDE_SHARE = 0.5  # [1] of a push that goes aside, assumed
FREE_ANGLE = 60.0 * pi / 180.0  # [rad] off straight ahead from which legs do not interlock, assumed; 55 helps, 4.3.3
RIGHT_AHEAD = 30.0 * pi / 180.0  # [rad] within which another robot stands ahead, assumed


@compiled
def disturb(robots, r, ball, k, handedness):
    """Let the legs of a robot whose gait step begins get at the ball, or be held by another robot's legs."""
    robot = robots[r]
    speed = length(robot.target.forward, robot.target.left)
    if k.drive_leg_disturbance <= 0.0 or robot.active == 0 or speed <= 0.0:
        return
    angle = abs(atan2(robot.target.left, robot.target.forward))
    other = toucher(robots, r, k)
    if holds_ball(robot, k, ball.x, ball.y):
        size = push_size(speed * k.gait_steps * k.dt, angle, other >= 0)
        push_ball(robot, ball, min(size * k.drive_leg_disturbance, MOST_PUSH), handedness)
    if other >= 0 and stands_ahead(robot, robots[other]):
        held = (1.0 - angle / FREE_ANGLE) * k.drive_leg_disturbance
        if uniform(robot.noise, LEGS) < held:
            robot.target.forward = robot.target.left = robot.target.turn = 0.0


@compiled
def push_size(step, angle, touched):
    """Return the size [m/s] of the pushes that a step of a length [m] at an angle [rad] off ahead gives the ball."""
    by_length = LENGTH_PUSH * max(step - SHORT_STEP, 0.0)
    by_angle = ANGLE_PUSH * max(angle - SMALL_ANGLE, 0.0)
    return by_length + by_angle + (CONTACT_PUSH if touched else 0.0)


@compiled
def push_ball(robot, ball, size, handedness):
    """Push the ball ahead and to a random side, `size` [m/s] being the deviation of the push."""
    if size <= 0.0:
        return
    ahead = size * abs(normal(robot.noise, LEGS))
    left = handedness * SIDE_SHARE * size * normal(robot.noise, LEGS)
    cosine, sine = cos(robot.heading), sin(robot.heading)
    vx, vy = out_of_frame(ahead, left, cosine, sine)
    ball.vx += vx
    ball.vy += vy


@compiled
def toucher(robots, r, k):
    """Return the row of the nearest robot that touches robot r, or -1."""
    row, least = -1, 2.0 * k.body_reach + 0.01
    for other in range(robots.shape[0]):
        if other == r or robots[other].active == 0:
            continue
        away = length(robots[other].x - robots[r].x, robots[other].y - robots[r].y)
        if away < least and robots_touch(robots[r], robots[other], k):
            row, least = other, away
    return row


@compiled
def stands_ahead(robot, other):
    """Tell whether another robot stands right ahead."""
    x, y = other.x - robot.x, other.y - robot.y
    cosine, sine = cos(robot.heading), sin(robot.heading)
    ahead, left = into_frame(x, y, cosine, sine)
    return abs(atan2(left, ahead)) < RIGHT_AHEAD
