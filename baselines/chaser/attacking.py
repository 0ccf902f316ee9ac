"""The attacker of the chaser: reach the ball, get behind it, turn it to the goal, shoot; free it when it is stuck.

`k`: the league's constants; `play`: the team's settings.
"""

from math import acos, sqrt

from soccer_env.baselines.chaser.boards import free_ball_from_corner, is_ball_cornered, sweep_along_board
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, into_frame, length, wrap
from soccer_env.leagues.robot import WHEELS_OMNI
from soccer_env.skills.carrying import SLOW, is_opposed, line_speed, turn_to_goal
from soccer_env.skills.kicking import (
    clearance_strength,
    is_at_kicker,
    is_blocked_ahead,
    is_foiled,
    kick_aside,
    shot_side,
    wants_to_clear,
)
from soccer_env.skills.moves import (
    braking_speed,
    choose_dribble_direction,
    choose_shot,
    clearing_direction,
    go,
    push,
    rotate_vector,
    shot_room,
    turn_by,
)
from soccer_env.skills.set_pieces import kick_strength_for
from soccer_env.skills.sight import predict_ball, side_of

MEET = 1.0  # [m/s] at which a base that steps aside runs in at most, assumed
MET = 0.3  # [m/s] of the ball and the robot towards each other when they meet, assumed
GIVE_TIME = 0.35  # [s] in which a robot slows down to that, assumed
RECEIVED = 0.35  # [m/s] at which a ball that comes is received, assumed
RECEIVE_TIME = 1.5  # [s] before it comes, at most, assumed
RECEIVE_ASIDE = 0.6  # [m] that it would pass beside the robot, at most, assumed
PASSED = 0.03  # [m] kept between a robot and a ball that it goes round, assumed
NEAR_BALL = 0.8  # [m] to the ball within which it meets the ball with care, assumed
DEFENDED = 2.5  # [m] from the middle of the own goal within which the ball is played clear of it, assumed
UPFIELD = ASIDE = sqrt(0.5)  # [1] way of a ball out of the mouth of the own goal: 45 degrees off its line, assumed
ALONG_LINE = 0.8  # cosine of the angle off its way at which a ball before the own goal may be run at, assumed


@compiled
def attack(command, sight, memory, k, play):
    """Bring the ball to the goal by the first applicable skill: free, turn, receive or approach it; then shoot."""
    ux, uy = choose_aim(sight, k, play)
    ux, uy = rotate_vector(ux, uy, memory.aim_error)
    if memory.sweep > 0.0:
        sweep_along_board(command, sight, memory, k)
    elif is_ball_cornered(sight.ball_x, sight.ball_y, k):
        free_ball_from_corner(command, sight, memory, k, play)
    elif memory.wriggle > 0.0:
        free_stuck_ball(command, sight, memory, k, play)
    elif sight.held == 1:
        turn_to_goal(command, sight, memory, k, play, ux, uy)
    elif ball_comes_to_me(sight, k):
        receive_ball(command, sight, k, play)
    else:
        approach(command, sight, memory, k, play, ux, uy, MEET)
    foiled = play.plays_aside > 0.0 and is_foiled(sight, memory, k)
    if not foiled and wants_to_shoot(sight, memory, k, play):
        goal = length(0.5 * k.pitch_length - sight.ball_x, sight.ball_y)
        command.kick = kick_strength_for(k, goal, play.arrival) if play.arrival > 0.0 else 1.0
    elif shot_side(sight, k, play) != 0.0:
        memory.kick_side, command.kick = shot_side(sight, k, play), 1.0
    elif wants_to_clear(sight, k, play):
        command.kick = clearance_strength(sight, k)
    elif play.plays_aside > 0.0 and sight.held == 1 and (foiled or is_blocked_ahead(sight, k)):
        kick_aside(command, sight, memory, k)


@compiled
def choose_aim(sight, k, play):
    """Return the unit vector along which to play the ball: at the goal if the shot is free, else past the opponents.

    A robot on wheels plays a ball near its own goal clear, never across the goal's mouth.
    """
    if k.walled == 0 and length(sight.ball_x + 0.5 * k.pitch_length, sight.ball_y) < DEFENDED:
        return clearing_direction(sight, k)
    if 0.5 * k.pitch_length - sight.ball_x < play.shot_range:
        ux, uy, room = choose_shot(sight, k)
        if room > play.room:
            return ux, uy
    return choose_dribble_direction(sight, k, play)


@compiled
def wants_to_shoot(sight, memory, k, play):
    """Tell whether a kick now would send the ball between the posts, past the opponents."""
    if not is_at_kicker(sight, play):
        return False
    if k.kicker_wind_up > 0.0 and sight.held == 0:
        return False
    ux, uy = rotate_vector(sight.now_cosine, sight.now_sine, memory.aim_error)
    return 0.5 * k.pitch_length - sight.ball_x < play.shot_range and shot_room(sight, k, ux, uy) > play.room


@compiled
def ball_comes_to_me(sight, k):
    """Tell whether the ball rolls towards a player that can move sideways and would bounce off that player."""
    speed = length(sight.ball_vx, sight.ball_vy)
    if k.drive_sideways <= 0.0 or k.walled == 1 or speed < RECEIVED:
        return False
    x, y = sight.x - sight.ball_x, sight.y - sight.ball_y
    along = (x * sight.ball_vx + y * sight.ball_vy) / speed
    across = abs(x * sight.ball_vy - y * sight.ball_vx) / speed
    far = min(RECEIVE_TIME * speed, 0.5 * speed * speed / k.ball_rolling)
    return 0.0 < along < far + sight.touch and across < RECEIVE_ASIDE


@compiled
def receive_ball(command, sight, k, play):
    """Receive a rolling ball: face it, move sideways into its path, and back off so that the ball does not bounce."""
    speed = length(sight.ball_vx, sight.ball_vy)
    ux, uy = sight.ball_vx / speed, sight.ball_vy / speed
    x, y = sight.ball_x - sight.x, sight.ball_y - sight.y
    gap = max(-(ux * x + uy * y) - sight.touch, 0.0)
    back = max(speed - MET - gap / GIVE_TIME, 0.0)
    across = uy * x - ux * y  # of the ball's way, to the right of it
    aside = clip(across / play.settle, -k.drive_sideways, k.drive_sideways)
    vx, vy = back * ux + aside * uy, back * uy - aside * ux
    size = max(length(vx, vy), 1e-6)
    ahead, left = into_frame(vx / size, vy / size, sight.cosine, sight.sine)
    push(command, sight, k, ahead, left, size)
    turn_by(command, sight, k, play, wrap(atan2(-uy, -ux) - sight.heading))


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


@compiled
def free_stuck_ball(command, sight, memory, k, play):
    """Free a stuck ball: push against it while turning at full rate towards the remembered side."""
    push(command, sight, k, play.wriggle_ahead, 0.0, k.drive_forward)
    command.turn = memory.wriggle_side * sight.pace
