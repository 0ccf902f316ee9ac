"""The goalkeeper: stand between ball and goal, meet shots on the line, clear a ball near the goal.

With a kicker it kicks the ball clear; without one, in the middle-size league, it clears by driving into the ball.

`k`: the league's constants; `play`: the team's settings.
"""

from math import pi

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, into_frame, length
from soccer_env.skills.approaching import approach
from soccer_env.skills.boards import is_ball_cornered
from soccer_env.skills.carrying import turn_to_goal
from soccer_env.skills.keeping_rules import is_in_own_area
from soccer_env.skills.kicking import BLOCKED, is_blocked, is_foiled, kick_aside
from soccer_env.skills.moves import clearing_direction, faces, go, push, step_to
from soccer_env.skills.sight import predict_ball, side_of

AT_GOAL = 0.2  # cosine of the angle to its own goal line within which a keeper on legs faces it, assumed
IN_LINE = 0.03  # [m] off the line through the ball, along the goal line, on which the keeper clears it, assumed
ALONG_LINE = 0.7  # sine of the heading at which it kicks such a ball aside: 45 degrees off the goal line, assumed
FOREVER = 60.0  # [s] any ball has stopped by then


@compiled
def keep_goal(command, sight, memory, k, play):
    """Keep the goal by the first applicable skill: meet a shot, clear the ball or guard."""
    line = -0.5 * k.pitch_length + play.keeper_line * k.body_reach
    coming, crossing = predict_shot_crossing(sight, k, play, line)
    if coming:
        go(command, sight, k, play, line, crossing, atan2(sight.ball_y - sight.y, sight.ball_x - sight.x), play.dive)
    elif may_clear(sight, k, play):
        clear_ball(command, sight, memory, k, play)
    else:
        guard(command, sight, k, play, line)


@compiled
def predict_shot_crossing(sight, k, play, line):
    """Return whether the ball will cross the keeper's line towards the goal, and the y [m] of the crossing."""
    if sight.ball_vx > -play.shot_speed or sight.ball_x < line:
        return False, 0.0
    end_x, _ = predict_ball(sight, k, FOREVER)
    crossing = sight.ball_y + sight.ball_vy * (line - sight.ball_x) / sight.ball_vx
    widest = 0.5 * k.pitch_goal_width
    return end_x < line and abs(crossing) < widest + k.body_reach, clip(crossing, -widest, widest)


@compiled
def guard(command, sight, k, play, line):
    """Stand on the line between the ball and the middle of the goal, a little way out.

    A keeper on wheels stands on the bisector of the angle to both posts instead: otherwise a shot from the side finds
    the near post open, and a ball along the goal line passes behind the keeper.
    """
    x, y = sight.ball_x + 0.5 * k.pitch_length, sight.ball_y
    away = max(length(x, y), 1e-6)
    out = play.keeper_out * k.body_reach
    stand_x = max(-0.5 * k.pitch_length + out * x / away, line)
    widest = 0.5 * k.pitch_goal_width - 0.5 * k.body_reach
    stand_y = clip(bisect_shot_angle(sight, k, stand_x) if k.walled == 0 else out * y / away, -widest, widest)
    facing = atan2(sight.ball_y - sight.y, sight.ball_x - sight.x)
    if k.legs == 1 and sight.distance < play.faces_ball:
        step_to(command, sight, k, play, stand_x, stand_y, facing)
    else:
        go(command, sight, k, play, stand_x, stand_y, facing, 0.0)


@compiled
def bisect_shot_angle(sight, k, x):
    """Return the y [m], at the keeper's x [m], of the bisector of the angle from the ball to both posts."""
    ahead, half = -0.5 * k.pitch_length - sight.ball_x, 0.5 * k.pitch_goal_width
    left, right = length(ahead, half - sight.ball_y), length(ahead, -half - sight.ball_y)
    along = ahead / max(left, 1e-6) + ahead / max(right, 1e-6)
    across = (half - sight.ball_y) / max(left, 1e-6) - (half + sight.ball_y) / max(right, 1e-6)
    if x >= sight.ball_x:
        return sight.ball_y
    return sight.ball_y + (x - sight.ball_x) * across / min(along, -1e-6)


@compiled
def may_clear(sight, k, play):
    """Tell whether the keeper should go for the ball: it lies near the goal, and no mate is nearer to it.

    A ball farther out, in the own third, is the keeper's if nobody at all is nearer, but not in a corner, where the
    keeper would hold the ball for too long. The keeper clears a ball at its kicker from anywhere. In a penalty area
    that field players may not enter, every slow ball is the keeper's.
    """
    if sight.held == 1 and k.keeper_kicks == 1:
        return True
    if k.rules_illegal_defender == 1 and is_in_own_area(sight.ball_x, sight.ball_y, k, k.body_reach):
        return length(sight.ball_vx, sight.ball_vy) <= play.shot_speed
    x, y = sight.ball_x + 0.5 * k.pitch_length, sight.ball_y
    near = length(x, y) < play.keeper_zone
    fetched = play.fetches > 0.0 and x < k.pitch_length / 3.0 and not is_ball_cornered(sight.ball_x, sight.ball_y, k)
    if not (near or fetched):
        return False
    if length(sight.ball_vx, sight.ball_vy) > play.shot_speed:
        return False
    for i in range(sight.others):
        away = length(sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y)
        if away < sight.distance and (sight.mate[i] == 1 or not near):
            return False
    return True


@compiled
def clear_ball(command, sight, memory, k, play):
    """Play the ball away from the own goal, with a kick once the keeper faces away from its goal.

    A keeper on legs goes round a ball at its feet, on the side of its own goal, since turning with the ball would also
    carry it forward.
    """
    ux, uy = clearing_direction(sight, k)
    if play.plays_aside > 0.0 and is_in_own_mouth(sight, k):
        clear_goal_mouth(command, sight, memory, k, play)
    elif sight.held == 1 and (k.legs == 0 or not faces(sight, -1.0, 0.0, AT_GOAL)):
        turn_to_goal(command, sight, memory, k, play, ux, uy)
        command.kick = 1.0 if faces(sight, ux, uy, play.clear_cosine) else 0.0
        foiled = is_foiled(sight, memory, k) or is_blocked(sight, k, sight.now_cosine, sight.now_sine, BLOCKED)
        if play.plays_aside > 0.0 and (command.kick == 0.0 or foiled):
            kick_aside(command, sight, memory, k)
    else:
        approach(command, sight, memory, k, play, ux, uy, k.drive_forward)


@compiled
def is_in_own_mouth(sight, k):
    """Tell whether the ball lies between the own posts, too near to the line for the keeper to get behind it."""
    x, y = sight.ball_x + 0.5 * k.pitch_length, abs(sight.ball_y)
    return k.walled == 1 and x < sight.touch and y < 0.5 * k.pitch_goal_width and sight.x > sight.ball_x - IN_LINE


@compiled
def clear_goal_mouth(command, sight, memory, k, play):
    """Clear a ball between the own posts: step beside it on the goal line, face along the line, kick it aside upfield.

    A keeper that is still before the ball keeps off it, since its paws would push the ball in.
    """
    side = side_of(sight.ball_y - sight.y)
    if abs(sight.ball_y - side * sight.touch) > 0.5 * k.pitch_goal_width - k.body_tip_y - k.body_tip_radius:
        side = -side  # no room between ball and post
    in_line = abs(sight.x - sight.ball_x) < IN_LINE
    y = sight.ball_y - side * (sight.touch + (-IN_LINE if in_line else IN_LINE))
    beside = abs(sight.y - y) < 2.0 * IN_LINE or in_line
    keep_off = sight.touch + play.clearance
    if not beside and sight.distance < keep_off:
        ahead, left = into_frame(sight.x - sight.ball_x, sight.y - sight.ball_y, sight.cosine, sight.sine)
        push(command, sight, k, ahead / sight.distance, left / sight.distance, k.drive_forward)
        return
    x = sight.ball_x if beside else max(sight.x, sight.ball_x + keep_off)
    step_to(command, sight, k, play, x, y, side * 0.5 * pi)
    if sight.held == 1 and sight.sine * side > ALONG_LINE:
        memory.kick_side, command.kick = -side, 1.0
