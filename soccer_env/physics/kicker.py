"""Kicks: an electromagnet that fires at once, or a leg that winds up while the robot stands.  MH04

A legged robot whose head is turned to a side kicks to that side with one foreleg, as Sony's own kick of the ERS-200 is
aimed by the pan of the head (`MakeKickingCommand(..., radians(panjoint_))`, SoccerLion200). A kick at a ball between
two robots, which flat bodies would hold like a vice, may lift it over the paws aside.

Direction and speed vary from kick to kick; the worse the ball lies, the wider the direction spreads and the likelier is
a miss, which leaves the ball alone. The robot recoils with the momentum of the ball. A kick off the robot's middle does
not turn it: wheels and paws bear the torque.

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, cosine_and_sine, into_frame, length, point_of_frame
from soccer_env.physics.block import begin_block, is_blocking, may_block, most_reach_walking
from soccer_env.physics.contacts import TOUCH_GAP, paws_gap
from soccer_env.random_numbers import draw_normal, draw_uniform
from soccer_env.types import RobotStream

KICK = int(RobotStream.KICK)


@compiled
def advance_kicker(robots, r, events, k, ball, handedness):
    """Advance robot r's kicker by one control step: start a commanded kick or block, or finish one."""
    robot = robots[r]
    if robot.kick_clock < 0.0:
        robot.kick_clock = min(robot.kick_clock + k.dt, 0.0)
        return
    if robot.kick_clock > 0.0:
        blocks = is_blocking(robot, k)
        robot.kick_clock -= k.dt
        if blocks:
            robot.kick_clock = max(robot.kick_clock, 0.0)
        elif robot.kick_clock <= 1e-9:
            finish_kick(robots, r, events, k, ball, handedness)
        return
    if may_kick(robot, k):
        robot.kick_strength = robot.command.kick
        robot.kick_side = kick_side(robot, k)
        if k.kicker_wind_up > 0.0:
            robot.kick_clock = k.kicker_wind_up if robot.kick_side == 0.0 else k.kicker_aside_wind_up
        else:
            finish_kick(robots, r, events, k, ball, handedness)
    elif may_block(robot, k):
        begin_block(robot, k)


@compiled
def may_kick(robot, k):
    """Tell whether the robot asks for a kick and can start it."""
    asks = robot.command.kick > 0.0 and robot.command.kick >= k.kicker_least
    able = robot.active == 1 and robot.fallen <= 0.0 and (robot.keeper == 0 or k.keeper_kicks == 1)
    return asks and able and robot.has_ball == 1


@compiled
def kick_side(robot, k):
    """Return the side to which a robot kicks: 1 left or -1 right if its command turns the head there, 0 ahead."""
    pan = robot.command.pan * k.head_pan_limit
    if k.kicker_aside <= 0.0 or robot.command.head < 0.0 or abs(pan) < 0.5 * k.kicker_aside:
        return 0.0
    return 1.0 if pan > 0.0 else -1.0


@compiled
def finish_kick(robots, r, events, k, ball, handedness):
    """Kick the ball, if it still lies in the pocket; the kicks of two robots in one step add up, in any order.

    Each kick draws five random numbers, whether it hits or not.
    """
    robot = robots[r]
    robot.kick_clock = -k.kicker_recharge
    stray = handedness * k.kicker_spread * draw_normal(robot.noise, KICK)
    pace = max(1.0 + k.kicker_speed_spread * draw_normal(robot.noise, KICK), 0.0)
    luck = draw_uniform(robot.noise, KICK)
    if not holds_ball(robot, k, ball.x, ball.y):
        return
    pinched = is_pinched(robots, r, k, ball, handedness)
    badness = 1.0 if pinched else kick_misalignment(robot, k, ball.x, ball.y)
    if luck < k.kicker_miss * badness * badness:
        return
    if pinched and luck > 1.0 - k.kicker_squirt * (1.0 - k.kicker_miss):
        left = luck > 1.0 - 0.5 * k.kicker_squirt * (1.0 - k.kicker_miss)
        events.squirt = int(handedness) if left else -int(handedness)
    direction = robot.heading + robot.kick_side * k.kicker_aside + (1.0 + badness) * stray
    ahead, aside = cosine_and_sine(direction)
    speed = pace * kick_speed(k, robot.kick_strength)
    ball.vx += speed * ahead
    ball.vy += speed * aside
    recoil = speed * k.ball_mass / k.body_mass
    robot.vx -= recoil * ahead
    robot.vy -= recoil * aside
    events.kick = 1
    events.touch = 1


@compiled
def kick_speed(k, strength):
    """Return the mean speed [m/s] that a kick gives the ball: slowest at the least strength, fastest at 1."""
    share = (strength - k.kicker_least) / max(1.0 - k.kicker_least, 1e-9)
    return k.kicker_slowest + (k.kicker_fastest - k.kicker_slowest) * min(share, 1.0)


@compiled
def kick_misalignment(robot, k, ball_x, ball_y):
    """Return how badly a ball in the pocket lies for a kick: 0 in the middle of the front, 1 at the kicker's edge."""
    gap, left = place_at_kicker(robot, k, ball_x, ball_y)
    far, aside = gap / max(k.kicker_reach, 1e-9), abs(left) / max(k.kicker_half_width, 1e-9)
    return clip(max(far, aside), 0.0, 1.0)


@compiled
def is_pinched(robots, r, k, ball, handedness):
    """Tell whether another robot touches the ball that robot r kicks.

    A kicker cannot swing through a ball that is held from behind: such a ball lies as badly as possible. The solver
    lets the ball bounce between the two robots.
    """
    near = most_reach_walking(k) + k.ball_radius + TOUCH_GAP
    for other in range(robots.shape[0]):
        x, y = ball.x - robots[other].x, ball.y - robots[other].y
        if other == r or robots[other].active == 0 or x * x + y * y > near * near:
            continue
        if paws_gap(robots[other], k, ball.x, ball.y, handedness) < TOUCH_GAP:
            return True
    return False


@compiled
def squirt_ball(ball, robots, robot_events, k, handedness):
    """Put a ball that a kick has lifted out of a vice beside the two robots; return whether it was put there.

    The ball comes down `squirt_way` aside of the kicking robot's middle, on the drawn side or, if that place is taken,
    on the other one; if both are taken, it stays. It rolls on aside with the speed of the weakest kick.
    """
    for r in range(robots.shape[0]):
        if robot_events[r].squirt == 0:
            continue
        cosine, sine = cosine_and_sine(robots[r].heading)
        ahead, _ = into_frame(ball.x - robots[r].x, ball.y - robots[r].y, cosine, sine)
        for turn in range(2):
            side = float(robot_events[r].squirt) * (1.0 - 2.0 * turn)
            x, y = point_of_frame(robots[r].x, robots[r].y, ahead, side * k.kicker_squirt_way, cosine, sine)
            if is_free(x, y, robots, k, handedness):
                ball.x, ball.y = x, y
                speed = side * k.kicker_slowest
                ball.vx, ball.vy = -speed * sine, speed * cosine
                ball.roll_x, ball.roll_y, ball.spin = ball.vx, ball.vy, 0.0
                return True
    return False


@compiled
def is_free(x, y, robots, k, handedness):
    """Tell whether a ball at x, y [m] lies on the pitch and touches no robot."""
    if abs(x) > 0.5 * k.pitch_length - k.ball_radius or abs(y) > 0.5 * k.pitch_width - k.ball_radius:
        return False
    near = most_reach_walking(k) + k.ball_radius
    for r in range(robots.shape[0]):
        away_x, away_y = x - robots[r].x, y - robots[r].y
        if robots[r].active == 0 or away_x * away_x + away_y * away_y > near * near:
            continue
        if paws_gap(robots[r], k, x, y, handedness) < TOUCH_GAP:
            return False
    return True


@compiled
def holds_ball(robot, k, ball_x, ball_y):
    """Tell whether the ball lies in the robot's pocket or at its kicker."""
    x, y = ball_x - robot.x, ball_y - robot.y
    far = k.body_front + k.ball_radius + k.kicker_reach + k.kicker_half_width
    if x * x + y * y > far * far:  # most robots are nowhere near
        return False
    gap, left = place_at_kicker(robot, k, ball_x, ball_y)
    return -0.5 * k.ball_radius < gap < k.kicker_reach and -k.kicker_half_width < left < k.kicker_half_width


@compiled
def place_at_kicker(robot, k, ball_x, ball_y):
    """Return the distance of the ball's near side ahead of the front, and of its centre to the left [m, m]."""
    ahead, left = into_frame(ball_x - robot.x, ball_y - robot.y, *cosine_and_sine(robot.heading))
    return ahead - k.body_front - k.ball_radius, left


@compiled
def kicking_robot(ball, robots, robot_events):
    """Return the row of the robot that kicked in this step, or -1; if several kicked, of the nearest to the ball."""
    row, least = -1, 0.0
    for r in range(robot_events.shape[0]):
        distance = length(ball.x - robots[r].x, ball.y - robots[r].y)
        if robot_events[r].kick == 1 and (row < 0 or distance < least):
            row, least = r, distance
    return row
