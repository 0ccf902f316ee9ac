"""When a player kicks other than at the goal: clear of opponents, aside, past what stands ahead, or to a mate.

A robot on legs kicks to the side to which its command turns its head (physics/kicker.py).

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, length
from soccer_env.skills.carrying import is_pressed
from soccer_env.skills.moves import (
    TURN_COST,
    free_roll_distance,
    lane_room,
    misalignment,
    rotate_vector,
    shot_room,
)
from soccer_env.skills.set_pieces import kick_strength_for
from soccer_env.skills.sight import is_opponent_near, side_of

BLOCKED = 0.35  # [m] ahead within which an opponent or a board makes a kick useless, assumed: a robot's length and more
OPEN = 0.5  # [m] that a ball kicked aside has to have free, assumed
CLEAR_WAY = 1.5  # [m] ahead that has to be free for a clearance, assumed
HURRIES = 1.0  # [m] from the ball of an opponent that leaves no time to turn the ball off a board, assumed
UPFIELD = 0.3  # cosine of the angle off straight upfield of a clearance at most, assumed
FOILED = 0.5  # [s] after the wind-up within which a kicked ball has left the feet, assumed
ROLLS_OUT = 0.8  # [1] of the way to the line that a clearance may roll, assumed
ALONE = 1.0  # [m] of a pass without a team-mate in sight, assumed
BESIDE_GOAL = 0.3  # [m] beside the own posts at which a kick may not aim, assumed


@compiled
def is_at_kicker(sight, play):
    """Tell whether the ball lies within reach of the kicker."""
    near = sight.now_ahead <= sight.touch + play.kick_gap
    return near and sight.now_ahead > 0.0 and abs(sight.now_left) <= play.kick_aside


@compiled
def wants_to_clear(sight, k, play):
    """Tell whether to kick the ball away now: an opponent presses in the own half, and the way upfield is free."""
    if play.clears == 0.0 or sight.ball_x > 0.0 or not is_at_kicker(sight, play) or not is_pressed(sight):
        return False
    ux, uy = sight.now_cosine, sight.now_sine
    return ux > UPFIELD and not is_blocked(sight, k, ux, uy, CLEAR_WAY)


@compiled
def clearance_strength(sight, k):
    """Return the strength [1] of a clearance straight ahead: the ball comes to rest on the pitch."""
    far = ROLLS_OUT * free_roll_distance(sight, k, sight.now_cosine, sight.now_sine)
    return kick_strength_for(k, far, 0.0)


@compiled
def is_blocked_ahead(sight, k):
    """Tell whether an opponent stands right ahead of the ball, or a board, with an opponent that presses.

    Before a board a player that nobody presses turns the ball out.
    """
    ux, uy = sight.now_cosine, sight.now_sine
    if lane_room(sight, k, ux, uy, BLOCKED) < 0.0:
        return True
    return free_roll_distance(sight, k, ux, uy) < BLOCKED and is_opponent_near(
        sight, sight.ball_x, sight.ball_y, HURRIES
    )


@compiled
def is_blocked(sight, k, ux, uy, far):
    """Tell whether a ball kicked along (ux, uy) would meet an opponent or a board within a distance [m]."""
    return lane_room(sight, k, ux, uy, far) < 0.0 or free_roll_distance(sight, k, ux, uy) < far


@compiled
def shot_side(sight, k, play):
    """Return the side to which a kick with one foreleg would be a free shot at the goal, 1 left or -1 right; else 0."""
    if play.plays_aside == 0.0 or sight.held == 0 or 0.5 * k.pitch_length - sight.ball_x > play.shot_range:
        return 0.0
    for side in (1.0, -1.0):
        ux, uy = rotate_vector(sight.now_cosine, sight.now_sine, side * k.kicker_aside)
        if shot_room(sight, k, ux, uy) > play.room:
            return side
    return 0.0


@compiled
def time_kick(sight, memory):
    """Measure the time [s] for which a kick has been commanded with the ball at the feet; it falls at other times."""
    kicks = sight.held == 1 and memory.kick > 0.0
    memory.kicking = max(memory.kicking + (sight.elapsed if kicks else -sight.elapsed), 0.0)


@compiled
def is_foiled(sight, memory, k):
    """Tell whether the ball lies at the feet after a kick that must be over: something unseen is in the way."""
    return sight.held == 1 and memory.kicking > k.kicker_wind_up + FOILED


@compiled
def kick_aside(command, sight, memory, k):
    """Kick to the better side, or not at all if both sides are blocked."""
    memory.kick_side = choose_kick_side(sight, k)
    command.kick = abs(memory.kick_side)


@compiled
def choose_kick_side(sight, k):
    """Return the side of the better kick aside, 1 left or -1 right; 0 if both are blocked or lead to the own goal.

    The better kick is the one that leads farther ahead; of two equal ones, the one towards the middle.
    """
    best, most = 0.0, -1e9
    for turn in range(2):
        side = side_of(sight.ball_y) * (2.0 * turn - 1.0)
        ux, uy = rotate_vector(sight.now_cosine, sight.now_sine, side * k.kicker_aside)
        if ux > most and not is_blocked(sight, k, ux, uy, OPEN) and not leads_to_own_goal(sight, k, ux, uy):
            best, most = side, ux
    return best


@compiled
def leads_to_own_goal(sight, k, ux, uy):
    """Tell whether a ball played along (ux, uy) would pass near the own goal."""
    x, y = -0.5 * k.pitch_length - sight.ball_x, -sight.ball_y
    return ux * x + uy * y > 0.0 and abs(ux * y - uy * x) < 0.5 * k.pitch_goal_width + BESIDE_GOAL


@compiled
def aim_kick(command, k, side):
    """Turn the head to the side of a commanded kick, or straight ahead for a kick ahead, as the kicker reads it."""
    if command.kick <= 0.0 or k.kicker_aside <= 0.0:
        return
    if side != 0.0:
        command.head, command.pan = 1.0, clip(side * k.kicker_aside / k.head_pan_limit, -1.0, 1.0)
    elif command.head >= 0.0:
        least = 0.4 * k.kicker_aside / k.head_pan_limit
        command.pan = clip(command.pan, -least, least)


# To whom a ball can be passed


@compiled
def choose_mate(sight, k):
    """Return the unit vector from the ball to the best team-mate for a pass, and the distance [m]."""
    best, best_x, best_y, far = -1e9, sight.now_cosine, sight.now_sine, ALONE
    for i in range(sight.others):
        x, y = sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y
        away = max(length(x, y), 1e-6)
        worth = lane_room(sight, k, x / away, y / away, away) - TURN_COST * misalignment(sight, x / away, y / away)
        if sight.mate[i] == 1 and worth > best:
            best, best_x, best_y, far = worth, x / away, y / away, away
    return best_x, best_y, far


@compiled
def count_mates(sight):
    """Return the number of team-mates whose places the player knows."""
    return sight.mate[: sight.others].sum()


@compiled
def mate_by_distance(sight, number):
    """Return the unit vector from the ball to a team-mate, 1 for the player's nearest, and the distance [m]."""
    for i in range(sight.others):
        if sight.mate[i] == 1 and nearer_mates(sight, i) == number - 1:
            x, y = sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y
            away = max(length(x, y), 1e-6)
            return x / away, y / away, away
    return sight.now_cosine, sight.now_sine, ALONE


@compiled
def nearer_mates(sight, i):
    """Return the number of team-mates that are nearer to the player than the mate i."""
    own, count = length(sight.other_x[i] - sight.x, sight.other_y[i] - sight.y), 0
    for j in range(sight.others):
        away = length(sight.other_x[j] - sight.x, sight.other_y[j] - sight.y)
        if sight.mate[j] == 1 and (away < own or (away == own and j < i)):
            count += 1
    return count
