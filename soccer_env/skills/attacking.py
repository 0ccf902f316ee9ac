"""The attacker: reach the ball, get behind it, turn it to the goal, shoot; free it when it is stuck.

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, into_frame, length, wrap
from soccer_env.random_numbers import draw_uniform
from soccer_env.skills.approaching import GIVE_TIME, MEET, MET, approach
from soccer_env.skills.boards import free_ball_from_corner, is_ball_cornered, sweep_along_board
from soccer_env.skills.carrying import turn_to_goal
from soccer_env.skills.deciding import TEAM
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
    choose_dribble_direction,
    choose_shot,
    clearing_direction,
    push,
    rotate_vector,
    shot_room,
    turn_by,
)
from soccer_env.skills.set_pieces import kick_strength_for
from soccer_env.skills.sight import side_of

RECEIVED = 0.35  # [m/s] at which a ball that comes is received, assumed
RECEIVE_TIME = 1.5  # [s] before it comes, at most, assumed
RECEIVE_ASIDE = 0.6  # [m] that it would pass beside the robot, at most, assumed
DEFENDED = 2.5  # [m] from the middle of the own goal within which the ball is played clear of it, assumed


@compiled
def attack(command, sight, memory, k, play):
    """Bring the ball to the goal, and kick by the first applicable skill: shoot, clear, or kick past what is ahead."""
    ux, uy = choose_aim(sight, k, play)
    ux, uy = rotate_vector(ux, uy, memory.aim_error)
    bring_ball(command, sight, memory, k, play, ux, uy)
    foiled = play.plays_aside > 0.0 and is_foiled(sight, memory, k)
    if shoot_if_free(command, sight, memory, k, play, foiled):
        return
    if wants_to_clear(sight, k, play):
        command.kick = clearance_strength(sight, k)
    elif play.plays_aside > 0.0 and sight.held == 1 and (foiled or is_blocked_ahead(sight, k)):
        kick_aside(command, sight, memory, k)


@compiled
def bring_ball(command, sight, memory, k, play, ux, uy):
    """Move the ball along (ux, uy) by the first applicable skill: free it, turn with it, receive or approach it."""
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


@compiled
def shoot_if_free(command, sight, memory, k, play, foiled):
    """Shoot ahead or aside if the way into the goal is free; return whether. `foiled`: a kick ahead has failed."""
    if not foiled and wants_to_shoot(sight, memory, k, play):
        goal = length(0.5 * k.pitch_length - sight.ball_x, sight.ball_y)
        command.kick = kick_strength_for(k, goal, play.arrival) if play.arrival > 0.0 else 1.0
        return True
    side = shot_side(sight, k, play)
    if side != 0.0:
        memory.kick_side, command.kick = side, 1.0
    return side != 0.0


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
def free_stuck_ball(command, sight, memory, k, play):
    """Free a stuck ball: push against it while turning at full rate towards the remembered side."""
    push(command, sight, k, play.wriggle_ahead, 0.0, k.drive_forward)
    command.turn = memory.wriggle_side * sight.pace


@compiled
def time_stuck_ball(sight, memory, noise, k, play):
    """Measure how long the ball is stuck at the player's feet, and start to free it when the patience is over."""
    memory.wriggle = max(memory.wriggle - sight.elapsed, 0.0)
    if memory.patience == 0.0:
        memory.patience = play.patience * (0.7 + 0.6 * draw_uniform(noise, TEAM))
    near = sight.distance < sight.touch + k.body_reach
    slow = length(sight.ball_vx, sight.ball_vy) < play.still
    memory.stuck = memory.stuck + sight.elapsed if near and slow else 0.0
    if memory.stuck > memory.patience:
        memory.stuck, memory.patience = 0.0, play.patience * (0.7 + 0.6 * draw_uniform(noise, TEAM))
        memory.wriggle = play.wriggle_time
        goal = atan2(-sight.ball_y, 0.5 * k.pitch_length - sight.ball_x)
        memory.wriggle_side = side_of(wrap(goal - sight.heading))
