"""Kicks: an electromagnet that fires at once, or a leg that winds up while the robot stands.  MH04

`k`: the league's constants.
"""

from __future__ import annotations

from math import cos, sin

from soccer_env.compiled import compiled
from soccer_env.geometry import into_frame
from soccer_env.random_numbers import normal
from soccer_env.types import RobotStream

KICK = int(RobotStream.KICK)


@compiled
def work_kicker(robot, events, k, ball, handedness):
    """Advance a robot's kicker by one control step: start a kick that is asked for, or finish one."""
    if robot.kick_clock < 0.0:
        robot.kick_clock = min(robot.kick_clock + k.dt, 0.0)
        return
    if robot.kick_clock > 0.0:
        robot.kick_clock -= k.dt
        if robot.kick_clock <= 1e-9:
            finish_kick(robot, events, k, ball, handedness)
        return
    if may_kick(robot, k):
        robot.kick_strength = robot.command.kick
        if k.kicker_wind_up > 0.0:
            robot.kick_clock = k.kicker_wind_up
        else:
            finish_kick(robot, events, k, ball, handedness)


@compiled
def may_kick(robot, k):
    """Tell whether the robot asks for a kick that it can start."""
    asks = robot.command.kick > 0.0 and robot.command.kick >= k.kicker_least
    able = robot.active == 1 and robot.fallen <= 0.0 and (robot.keeper == 0 or k.keeper_kicks == 1)
    return asks and able and robot.has_ball == 1


@compiled
def finish_kick(robot, events, k, ball, handedness):
    """Push the ball off, if it still lies in the pocket; pushes of two robots at once add up, whoever comes first."""
    robot.kick_clock = -k.kicker_recharge
    if not holds_ball(robot, k, ball.x, ball.y):
        return
    direction = robot.heading + handedness * k.kicker_spread * normal(robot.noise, KICK)
    ahead, aside = cos(direction), sin(direction)
    speed = kick_speed(k, robot.kick_strength)
    ball.vx += speed * ahead
    ball.vy += speed * aside
    events.kick = 1
    events.touch = 1


@compiled
def kick_speed(k, strength):
    """Return the speed [m/s] that a kick adds to the ball's: slowest at the least strength, fastest at strength 1."""
    share = (strength - k.kicker_least) / max(1.0 - k.kicker_least, 1e-9)
    return k.kicker_slowest + (k.kicker_fastest - k.kicker_slowest) * min(share, 1.0)


@compiled
def holds_ball(robot, k, ball_x, ball_y):
    """Tell whether the ball lies in the robot's pocket or at its kicker."""
    x, y = ball_x - robot.x, ball_y - robot.y
    far = k.body_front + k.ball_radius + k.kicker_reach + k.kicker_half_width
    if x * x + y * y > far * far:  # most robots are nowhere near
        return False
    cosine, sine = cos(robot.heading), sin(robot.heading)
    ahead, left = into_frame(x, y, cosine, sine)
    gap = ahead - k.body_front - k.ball_radius
    return -0.5 * k.ball_radius < gap < k.kicker_reach and -k.kicker_half_width < left < k.kicker_half_width
