"""How the chaser gets a ball out of a corner: come at it aslant, then turn with it along one of the boards.

    +-----------o+      A robot that faces the corner, rather the touchline than the end, presses the ball into it.
    |          / |      It turns inwards and walks on all the while: its outer paw rolls the ball along the end board
    |         D  |      to the goal. In the own half the boards change their parts: the ball goes along the touchline,
    |            |goal  away from the own goal.

`k`: the league's constants; `play`: the team's settings.
"""

from __future__ import annotations

from math import pi

from soccer_env.baselines.sight import side_of
from soccer_env.compiled import compiled
from soccer_env.geometry import clip, length, wrap

CORNER = 0.1  # [m] between ball and both boards: it lies in the corner, assumed
SLANT = 1.05  # [rad] between the board along which the ball is to go, square on, and the way to the ball, assumed
ALIGNED = 0.25  # [rad] off that way at which the sweep may begin, assumed
TOUCHING = 0.04  # [m] between front and ball at which it may begin, assumed
OUTWARD = 0.4  # [1] of the top speed aside while turning, assumed
LONGEST = 7.0  # [s] of a sweep, assumed
AWAY = 0.35  # [m] from the corner at which the ball is out of it, assumed


@compiled
def lies_in_corner(x, y, k):
    """Tell whether a ball at (x, y) lies in a corner between two boards."""
    room = k.ball_radius + CORNER
    return k.walled == 1 and abs(x) > 0.5 * k.pitch_length - room and abs(y) > 0.5 * k.pitch_width - room


@compiled
def corner_ways(x, y):
    """Return the direction of the way to a ball in a corner, and that in which it is to be swept [rad], team frame."""
    side = side_of(y)
    if x > 0.0:
        return side * SLANT, -side * 0.5 * pi
    return wrap(side * (0.5 * pi + SLANT)), 0.0


@compiled
def begin_sweep(sight, memory, k):
    """Begin to sweep a ball in a corner that the robot touches and faces as it must."""
    if not lies_in_corner(sight.ball_x, sight.ball_y, k) or sight.distance > sight.touch + TOUCHING:
        return
    way, out = corner_ways(sight.ball_x, sight.ball_y)
    if abs(wrap(sight.heading - way)) < ALIGNED or memory.stuck > memory.patience:
        memory.sweep, memory.sweep_way = LONGEST, out
        memory.sweep_side = side_of(wrap(out - way))


@compiled
def sweep(command, sight, memory, k):
    """Turn with the ball towards the way out and walk on; then walk along the board."""
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
    if gap > AWAY or sight.distance > 2.0 * sight.touch:
        memory.sweep = 0.0
