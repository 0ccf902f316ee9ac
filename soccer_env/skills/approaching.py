"""How a player gets to the ball: straight at it from behind, or round it first, with care for boards and its own goal.

`k`: the league's constants; `play`: the team's settings.
"""

from math import acos, sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, into_frame, length
from soccer_env.leagues.robot import WHEELS_OMNI
from soccer_env.skills.carrying import SLOW, is_opposed, line_speed
from soccer_env.skills.moves import braking_speed, go, push, rotate_vector
from soccer_env.skills.sight import predict_ball, side_of

MEET = 1.0  # [m/s] at which a base that steps aside runs in at most, assumed
MET = 0.3  # [m/s] of the ball and the robot towards each other when they meet, assumed
GIVE_TIME = 0.35  # [s] in which a robot slows down to that, assumed
PASSED = 0.03  # [m] kept between a robot and a ball that it goes round, assumed
NEAR_BALL = 0.8  # [m] to the ball within which it meets the ball with care, assumed
UPFIELD = ASIDE = sqrt(0.5)  # [1] way of a ball out of the mouth of the own goal: 45 degrees off its line, assumed
ALONG_LINE = 0.8  # cosine of the angle off its way at which a ball before the own goal may be run at, assumed


@compiled
def approach(command, sight, memory, k, play, ux, uy, most):
    """Go to the point where the player can meet the ball: straight at the ball from behind, else round it first.

    `most`: allowed speed on contact [m/s]; up to `MEET` an omnidirectional base slows down for the contact, above
    `MEET` it drives into the ball.
    """
    gap = max(sight.distance - sight.touch, 0.0)
    x, y = predict_ball(sight, k, clip(gap / (k.drive_forward * sight.pace), play.delay, play.lead))
    x, y = nearest_reachable_point(x, y, k)
    ux, uy = direction_clear_of_boards(x, y, ux, uy, sight, k)
    away_x, away_y = sight.x - x, sight.y - y
    away = max(length(away_x, away_y), 1e-6)
    behind = -(away_x * ux + away_y * uy) / away
    own_goal = lies_before_own_goal(x, y, k, 2.0 * sight.touch)
    near = away < play.near * sight.touch
    if behind > (ALONG_LINE if own_goal else play.near_cosine if near else play.run_in_cosine):
        run_at_ball(command, sight, k, play, x, y, ux, uy, most)
    elif own_goal and away < sight.touch + play.clearance:  # paws that step aside or turn push it on
        ahead, left = into_frame(away_x / away, away_y / away, sight.cosine, sight.sine)
        push(command, sight, k, ahead, left, k.drive_forward)
    else:
        go_round_ball(command, sight, memory, k, play, x, y, ux, uy)


@compiled
def run_at_ball(command, sight, k, play, x, y, ux, uy, most):
    """Run at a ball from behind; a base that can move sideways faces the direction (ux, uy) in which it will play."""
    if play.square_up > 0.0:
        into = sight.touch - play.square_up
        go(command, sight, k, play, x - into * ux, y - into * uy, atan2(uy, ux), play.bump)
        if sight.distance < NEAR_BALL and most <= MEET:
            run_into_ball(command, sight, k, x - into * ux - sight.x, y - into * uy - sight.y)
    else:
        go(command, sight, k, play, x, y, atan2(y - sight.y, x - sight.x), play.bump)


@compiled
def run_into_ball(command, sight, k, x, y):
    """Run along (x, y) into the ball, with a limited closing speed so that the ball hardly bounces off.

    Only the relative speed is limited: a player that tackles a ball carried past runs along with the ball.
    """
    away = max(length(x, y), 1e-6)
    x, y = x / away, y / away
    gap = max(sight.distance - sight.touch, 0.0)
    most = min(MET + gap / GIVE_TIME, MEET, SLOW if is_opposed(sight, x, y) else line_speed(sight, k, x, y))
    vx, vy = k.drive_forward * command.forward, k.drive_sideways * command.left
    ball_ahead, ball_left = into_frame(sight.ball_vx, sight.ball_vy, sight.cosine, sight.sine)
    speed = length(vx - ball_ahead, vy - ball_left)
    if speed > most:
        ahead = ball_ahead + most / speed * (vx - ball_ahead)
        left = ball_left + most / speed * (vy - ball_left)
        size = max(length(ahead, left), 1e-6)
        push(command, sight, k, ahead / size, left / size, size)


@compiled
def nearest_reachable_point(x, y, k):
    """Return the point [m] nearest to a ball at (x, y) that a paw can reach while the robot touches the boards."""
    if k.walled == 0:
        return x, y
    room = k.body_tip_y + k.body_tip_radius + k.legs * k.pitch_board_foot
    edge_x, edge_y = 0.5 * k.pitch_length - room, 0.5 * k.pitch_width - room
    if abs(y) > 0.5 * k.pitch_goal_width:
        x = clip(x, -edge_x, edge_x)
    return x, clip(y, -edge_y, edge_y)


@compiled
def lies_before_own_goal(x, y, k, far):
    """Tell whether a ball lies in the own goal's mouth, or less than `far` [m] before it, on a pitch with boards."""
    return k.walled == 1 and x < far - 0.5 * k.pitch_length and abs(y) < 0.5 * k.pitch_goal_width


@compiled
def direction_clear_of_boards(x, y, ux, uy, sight, k):
    """Return the direction to push the ball, rotated away from boards so that a robot has room behind the ball.

    A corner leaves no such room: the player runs along one board and turns along the other with the ball. A ball in the
    mouth of the own goal is pushed along the goal line, to the side on which it lies, or away from a player beside it.
    """
    if k.walled == 0:
        return ux, uy
    if lies_before_own_goal(x, y, k, 0.5 * sight.touch):
        return UPFIELD, ASIDE * (side_of(y) if abs(y) > k.ball_radius else side_of(y - sight.y))
    room = k.body_tip_y + k.body_tip_radius + k.legs * k.pitch_board_foot
    edge_x, edge_y = 0.5 * k.pitch_length - room, 0.5 * k.pitch_width - room
    back_x = x - clip(x - sight.touch * ux, -edge_x, edge_x)
    back_y = y - clip(y - sight.touch * uy, -edge_y, edge_y)
    size = length(back_x, back_y)
    if size > 0.5 * k.ball_radius:
        return back_x / size, back_y / size
    return (0.0, side_of(y)) if abs(ux) > abs(uy) else (side_of(x), 0.0)


@compiled
def go_round_ball(command, sight, memory, k, play, x, y, ux, uy):
    """Go round the ball at (x, y) to the point behind it, at a distance that avoids touching the ball."""
    away_x, away_y = sight.x - x, sight.y - y
    away = max(length(away_x, away_y), 1e-6)
    radius = sight.touch + play.clearance
    angle = acos(clip(-(away_x * ux + away_y * uy) / away, -1.0, 1.0))
    way = choose_side_round(memory, k, x, y, away_x, away_y, ux, uy, angle, radius)
    step = min(angle, play.orbit_step + acos(min(radius / away, 1.0)))
    to_x, to_y = rotate_vector(away_x / away, away_y / away, way * step)
    facing = atan2(uy, ux) if play.square_up > 0.0 else atan2(-away_y, -away_x)
    go(command, sight, k, play, x + radius * to_x, y + radius * to_y, facing, play.orbit_speed)
    if k.drive_kind == WHEELS_OMNI:
        limit_closing_speed(command, sight, k, play)


@compiled
def limit_closing_speed(command, sight, k, play):
    """Limit the closing speed to the ball so that the player can still brake within the gap."""
    away = max(sight.distance, 1e-6)
    ux, uy = into_frame((sight.ball_x - sight.x) / away, (sight.ball_y - sight.y) / away, sight.cosine, sight.sine)
    rolls_x, rolls_y = into_frame(sight.ball_vx, sight.ball_vy, sight.cosine, sight.sine)
    vx, vy = k.drive_forward * command.forward, k.drive_sideways * command.left
    closing = (vx - rolls_x) * ux + (vy - rolls_y) * uy
    excess = max(closing - braking_speed(k, play, max(away - sight.touch - PASSED, 0.0)), 0.0)
    command.forward = clip((vx - excess * ux) / k.drive_forward, -1.0, 1.0)
    command.left = clip((vy - excess * uy) / k.drive_sideways, -1.0, 1.0)


@compiled
def choose_side_round(memory, k, x, y, away_x, away_y, ux, uy, angle, radius):
    """Choose the sense to go round a ball, +1 counter-clockwise: away from a near board, else the shorter way."""
    way = side_of(away_y * ux - away_x * uy)
    if k.walled == 1 and angle > 1.6:
        room = radius + k.body_tip_y + k.body_tip_radius + k.legs * k.pitch_board_foot
        side, end = 0.5 * k.pitch_width - abs(y), 0.5 * k.pitch_length - abs(x)
        if side < min(room, end):
            return choose_inner_side(away_x, away_y, ux, uy, 0.0, -side_of(y))
        if end < room:
            return choose_inner_side(away_x, away_y, ux, uy, -side_of(x), 0.0)
    if angle > 2.6 and memory.way != 0.0:
        way = memory.way
    memory.way = way
    return way


@compiled
def choose_inner_side(away_x, away_y, ux, uy, inner_x, inner_y):
    """Return the sense in which to go round a ball, +1 or -1, that does not lead between ball and board.

    (away_x, away_y): the player relative to the ball [m]; (ux, uy): unit vector along which the ball will be played;
    (inner_x, inner_y): unit vector away from the board.
    """
    now = atan2(inner_x * away_y - inner_y * away_x, inner_x * away_x + inner_y * away_y)
    back = atan2(inner_y * ux - inner_x * uy, -inner_x * ux - inner_y * uy)
    return side_of(back - now)
