"""Getting a ball out of a corner: approach it at an angle, then turn with it along one of the boards.

    +-----------o+      A robot that faces the corner, rather the touchline than the end, presses the ball into it.
    |          / |      It turns inwards and walks on all the while: its outer paw rolls the ball along the end board
    |         D  |      to the goal. In the own half the boards change their parts: the ball goes along the touchline,
    |            |goal  away from the own goal.

`k`: the league's constants; `play`: the team's settings.
"""

from math import pi

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, cosine_and_sine, length, wrap
from soccer_env.skills.moves import LARGE_TURN, go, leave_boards
from soccer_env.skills.sight import ball_room, side_of

CORNER = 0.1  # [m] between ball and board, less counts as at the board, assumed
SLANT, SQUARE = 1.05, 0.26  # [rad] off square to the end board: to a ball in the corner, and outside it, assumed
ALIGNED = 0.3  # [rad] off that way at which the sweep may begin, assumed
ON_LINE = 0.03  # [m] off it, assumed
TOUCHING = 0.04  # [m] between front and ball at which it may begin, assumed
RUN_UP = 0.12  # [m] from which it goes to the ball, assumed
OUTWARD = 0.4  # [1] of the top speed aside while turning, assumed
LONGEST = 7.0  # [s] of a sweep, assumed
AWAY = 0.35  # [m] from the corner at which the ball is out of it, assumed


@compiled
def is_ball_cornered(x, y, k):
    """Tell whether a ball at (x, y) lies in a corner of the own half, or at the opponents' end beside the goal."""
    if k.walled == 0:
        return False
    end, aside = end_board_gap(x, k), side_board_gap(y, k)
    if x > 0.0:
        return end < CORNER and abs(y) > 0.5 * k.pitch_goal_width
    return end < CORNER and aside < CORNER


@compiled
def end_board_gap(x, k):
    """Return the gap between a ball and the nearer end board [m]."""
    return 0.5 * k.pitch_length - ball_room(k) - abs(x)


@compiled
def side_board_gap(y, k):
    """Return the gap between a ball and the board of the nearer touchline [m]."""
    return 0.5 * k.pitch_width - ball_room(k) - abs(y)


@compiled
def sweep_directions(x, y, k):
    """Return two directions [rad], team frame: for the approach to a cornered ball, and for the sweep with the ball."""
    side = side_of(y)
    if x > 0.0:
        slant = SLANT + (SQUARE - SLANT) * clip(side_board_gap(y, k) / CORNER, 0.0, 1.0)
        return side * slant, -side * 0.5 * pi
    return wrap(side * (0.5 * pi + SLANT)), 0.0


@compiled
def free_ball_from_corner(command, sight, memory, k, play):
    """Move the ball out of a corner; after a failed attempt, step back from the ball first."""
    if memory.wriggle > 0.0:
        command.forward = -sight.pace
    else:
        approach_cornered_ball(command, sight, memory, k, play)


@compiled
def approach_cornered_ball(command, sight, memory, k, play):
    """Approach a ball in a corner: go to the approach line, then along it; begin the sweep on contact."""
    way, out = sweep_directions(sight.ball_x, sight.ball_y, k)
    ux, uy = cosine_and_sine(way)
    x, y = sight.ball_x - sight.x, sight.ball_y - sight.y
    off = wrap(way - sight.heading)
    touching = sight.distance < sight.touch + TOUCHING
    ready = (touching or abs(ux * y - uy * x) < ON_LINE) and abs(off) < ALIGNED
    back = sight.touch + (-ON_LINE if ready else RUN_UP)
    go(command, sight, k, play, sight.ball_x - back * ux, sight.ball_y - back * uy, way, play.bump)
    if abs(off) > LARGE_TURN:
        leave_boards(command, sight, k)
    if ready and touching:
        memory.sweep, memory.sweep_way = LONGEST, out
        memory.sweep_side = side_of(wrap(out - way))


@compiled
def sweep_along_board(command, sight, memory, k):
    """Turn with the ball to the direction of the sweep while walking, then walk along the board."""
    memory.sweep -= sight.elapsed
    memory.stuck = 0.0
    error = wrap(memory.sweep_way - sight.heading)
    command.forward = sight.pace
    if error * memory.sweep_side > 0.2:
        command.turn = memory.sweep_side * sight.pace
        command.left = -memory.sweep_side * OUTWARD * sight.pace
    else:
        command.turn = clip(error, -1.0, 1.0) * sight.pace
    gap = length(0.5 * k.pitch_length - abs(sight.ball_x), 0.5 * k.pitch_width - abs(sight.ball_y))
    if gap > AWAY and not is_ball_cornered(sight.ball_x, sight.ball_y, k) or sight.distance > 2.0 * sight.touch:
        memory.sweep = 0.0
