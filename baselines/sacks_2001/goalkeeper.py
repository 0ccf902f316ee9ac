"""The goalkeeper: meet a shot by the ball's angular velocity, clear a near ball, guard the goal.  MS53

The paper has the goalkeeper block balls (3.2) and react to their speed (5). It does not say how it blocks: here by a
sidestep or, in a league whose goalkeepers can, by lying down with its forelegs spread. Nor does it say what the
goalkeeper does with a ball that it has: kicking it clear is ours.

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, length
from soccer_env.skills.moves import clearing_direction, faces, go, turn_by

FAST = 0.6  # [m/s] a ball that comes nearer faster is met without delay; speed of a ball of unknown speed, assumed
CLEAR_COSINE = 0.77  # [1] of the angle to the way clear of the goal within which it kicks, 40 degrees, assumed
SLOW = 0.3  # [m/s] the goalkeeper goes to a slower ball, assumed


@compiled
def is_shot(ball, play):
    """Tell whether the ball approaches as fast as a shot."""
    return ball.radial < -play.keeper_alarm and ball.age <= 0.5


@compiled
def passing_distance(ball):
    """Return the distance [m] to the left at which a straight rolling ball will pass the robot: d^2 w / speed.  MS53

    The estimate needs only the radial and angular velocity relative to the robot.
    """
    across = ball.distance * ball.angular
    speed = max(length(ball.radial, across), 1e-3)
    return ball.distance * across / speed


@compiled
def meet_shot(command, sight, ball, k, play):
    """Move sideways to the point where the ball will pass, facing the ball, and block the ball if it is near.  MS53

    Without angular velocity the goalkeeper uses the bearing alone and keeps the ball straight ahead.
    """
    aside = passing_distance(ball) if play.angular_keeper == 1 else ball.distance * ball.bearing
    within = play.settle
    if play.keeper_speed == 1 and ball.radial < -FAST:
        within = 0.25 * play.settle
    if will_block(ball, aside, k, play):
        command.kick = 1.0
    widest = 0.5 * k.pitch_goal_width
    aside = clip(sight.y + sight.cosine * aside, -widest, widest) - sight.y
    command.left = clip(aside / (within * max(k.drive_sideways, 1e-6)), -1.0, 1.0) * sight.pace
    turn_by(command, sight, k, play, 0.5 * ball.bearing)


@compiled
def will_block(ball, aside, k, play):
    """Tell whether to spread the forelegs now against a ball that will pass `aside` [m] to the left.  MS53

    The legs must reach the ball, and the ball must arrive within half the time for which the legs stay spread. Where
    reactions do not depend on the ball's speed, all balls count as fast.
    """
    if play.keeper_blocks == 0 or k.block_raise_time <= 0.0:
        return False
    speed = -ball.radial if play.keeper_speed == 1 else FAST
    arrives = (ball.distance - k.block_paw_x) / speed
    reach = k.block_paw_y + k.body_tip_radius + k.ball_radius
    return abs(aside) < reach and arrives < k.block_raise_time + 0.5 * k.block_hold_time


@compiled
def guard(command, sight, k, play):
    """Stand on the line between the ball and the middle of the goal, play.keeper_out [m] from it."""
    x, y = sight.ball_x + 0.5 * k.pitch_length, sight.ball_y
    away = max(length(x, y), 1e-6)
    line = -0.5 * k.pitch_length + k.body_reach
    widest = 0.5 * k.pitch_goal_width - 0.5 * k.body_reach
    stand_x = max(-0.5 * k.pitch_length + play.keeper_out * x / away, line)
    stand_y = clip(play.keeper_out * y / away, -widest, widest)
    go(command, sight, k, play, stand_x, stand_y, atan2(sight.ball_y - sight.y, sight.ball_x - sight.x), 0.0)


@compiled
def may_clear(sight, play, k):
    """Tell whether the goalkeeper should go for the ball: the ball is slow and near the goal."""
    near = length(sight.ball_x + 0.5 * k.pitch_length, sight.ball_y) < play.keeper_zone
    speed = length(sight.ball_vx, sight.ball_vy)
    nearly_slow = play.keeper_speed == 1 and speed < 2.0 * SLOW and sight.distance < play.near
    return near and (speed < SLOW or nearly_slow)


@compiled
def can_clear(situation, sight, k, play):
    """Tell whether a goalkeeper with the ball can kick it clear now: it faces away from its own goal."""
    ux, uy = clearing_direction(sight, k)
    return play.keeper_clears == 1 and situation.keeper == 1 and faces(sight, ux, uy, CLEAR_COSINE)
