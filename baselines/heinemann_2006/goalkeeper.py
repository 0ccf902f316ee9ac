"""The goalkeeper: passive on the line from ball to goal, or active in the ball's trajectory.  MH19, MH20, MH21

    "Typical keepers try to minimize the angles under which the ball can be shot into the goal avoiding the goal keeper.
    This can be reached if the keeper takes a defense position on the line d going through the ball and the middle of
    the goal."

    "Then, the goal keeper is able to predict the trajectory of the ball t and can actively defend the goal by moving
    into the trajectory to intercept the ball. Even considering the reaction time of the goal keeper and its maximum
    acceleration, there is a high chance of intercepting the ball, as the goal keeper moves perpendicular into the
    predicted trajectory resulting in a very short distance."    [Heinemann 2006, 4]

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.baselines.heinemann_2006.driving import command_velocity
from soccer_env.baselines.heinemann_2006.intercepting import moving_time, rolling_time
from soccer_env.baselines.heinemann_2006.settings import KEEPERS, STANCES
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, length
from soccer_env.leagues.robot import WHEELS_DIFFERENTIAL
from soccer_env.skills.goalkeeping import clear_ball, may_clear
from soccer_env.skills.moves import braking_speed, go

ACTIVE, CIRCLE = KEEPERS["active"], STANCES["circle"]
POINTS = 12  # of the trajectory, between the nearest one and the goal line, that are tried, assumed


@compiled
def keep_goal(command, memory, k, play, scratch):
    """Keep the goal by the first applicable skill; "otherwise back to passive".  MH20"""
    sight = scratch.sight
    facing = atan2(sight.ball_y - sight.y, sight.ball_x - sight.x)
    if play.keeper == ACTIVE and is_shot(sight, k, play):
        x, y = interception(sight, k, play)
        drive_straight_to(command, memory, k, play, sight, x, y, facing)
    elif may_clear(sight, k, play.skills):
        clear_ball(command, sight, memory.skill, k, play.skills)
    else:
        x, y = passive_place(sight.ball_x, sight.ball_y, k, play)
        drive_straight_to(command, memory, k, play, sight, x, y, facing)


@compiled
def passive_place(ball_x, ball_y, k, play):
    """Return the passive place [m, m]: where the line from ball to goal meets a half circle or the keeper's line.

    Never nearer to the goal line than the keeper's line, nor beyond the posts.  MH19
    """
    line, wide = -0.5 * k.pitch_length + play.keeper_out, 0.5 * k.pitch_goal_width
    x, y = max(ball_x + 0.5 * k.pitch_length, 1e-6), ball_y
    if play.stance == CIRCLE:
        away = length(x, y)
        aside = clip(play.keeper_radius * y / away, -wide, wide)
        return max(-0.5 * k.pitch_length + play.keeper_radius * x / away, line), aside
    return line, clip(play.keeper_out * y / x, -wide, wide)


@compiled
def is_shot(sight, k, play):
    """Tell whether the ball is believed to roll across the goal line between the posts or just beside them.  MH20"""
    speed = length(sight.ball_vx, sight.ball_vy)
    ahead = sight.ball_x + 0.5 * k.pitch_length
    if sight.ball_vx > -1e-3 or speed < play.shot_speed or ahead <= 0.0:
        return False
    crossing = sight.ball_y - sight.ball_vy * ahead / sight.ball_vx
    far = -speed * ahead / sight.ball_vx
    rolls = rolling_time(speed, far, k) < 1e6
    return rolls and abs(crossing) < 0.5 * k.pitch_goal_width + play.shot_wide


@compiled
def interception(sight, k, play):
    """Return the point [m, m] at which to intercept a shot: the point of its path nearest to the keeper.  MH20, MH21

    If the ball would be there first, return the point of the trajectory before the goal line at which the keeper has
    the most time to spare, given its reaction time and acceleration.
    """
    speed = length(sight.ball_vx, sight.ball_vy)
    ux, uy = sight.ball_vx / speed, sight.ball_vy / speed
    line = -0.5 * k.pitch_length + play.keeper_out
    last = max((line - sight.ball_x) / ux, 0.0)  # [m] along the trajectory to the keeper's line
    nearest = distance_to_foot(sight.x - sight.ball_x, sight.y - sight.ball_y, ux, uy, last)
    if play.keeper_waits == 0:
        return sight.ball_x + nearest * ux, sight.ball_y + nearest * uy
    best, best_spare = nearest, spare_time(sight, ux, uy, speed, nearest, k, play)
    for i in range(1, POINTS + 1):
        if best_spare >= 0.0:
            break
        along = nearest + (last - nearest) * i / POINTS
        spare = spare_time(sight, ux, uy, speed, along, k, play)
        if spare > best_spare:
            best, best_spare = along, spare
    return sight.ball_x + best * ux, sight.ball_y + best * uy


@compiled
def distance_to_foot(x, y, ux, uy, last):
    """Return the distance [m], 0 to `last`, from the origin along (ux, uy) to the point nearest to (x, y)."""
    return clip(x * ux + y * uy, 0.0, last)


@compiled
def spare_time(sight, ux, uy, speed, along, k, play):
    """Return the time [s] by which the keeper reaches a point of the ball's path before the ball; < 0: after it.  MH21

    The sight already predicts the moment at which the command takes effect; a longer reaction time is added.
    """
    x, y = sight.ball_x + along * ux - sight.x, sight.ball_y + along * uy - sight.y
    away = max(length(x, y), 1e-6)
    towards = clip((sight.vx * x + sight.vy * y) / away, -k.drive_forward, k.drive_forward)
    late = max(play.reaction - k.dt * k.delay_steps, 0.0)
    far = away - play.keeper_reach - k.ball_radius
    return min(rolling_time(speed, along, k), 1e6) - moving_time(far, towards, late, k)


@compiled
def drive_straight_to(command, memory, k, play, sight, x, y, facing):
    """Drive straight to a point, limited only by the base's acceleration, since no other robot is in the goal area."""
    dx, dy = x - sight.x, y - sight.y
    away = length(dx, dy)
    if k.drive_kind == WHEELS_DIFFERENTIAL:
        go(command, sight, k, play.skills, x, y, facing, 0.0)
        return
    speed = min(braking_speed(k, play.skills, away), k.drive_forward * sight.pace)
    command_velocity(command, memory, k, play, sight, dx / max(away, 1e-9), dy / max(away, 1e-9), speed, facing)
