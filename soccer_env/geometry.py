"""Angles, frames and discs."""

from __future__ import annotations

from math import floor, pi, sqrt

from soccer_env.compiled import compiled

TURN = 2.0 * pi


@compiled
def wrap(angle):
    """Return the angle [rad] in (-pi, pi]."""
    if -pi < angle <= pi:
        return angle
    return pi - (pi - angle - TURN * floor((pi - angle) / TURN))


@compiled
def clip(value, low, high):
    """Return the value held between low and high."""
    return low if value < low else (high if value > high else value)


@compiled
def length(x, y):
    """Return the length of a vector (`math.hypot` differs between compiled and plain Python)."""
    return sqrt(x * x + y * y)


@compiled
def toward(value, goal, step):
    """Return the value moved towards the goal by at most `step`."""
    if goal > value:
        return goal if goal - value <= step else value + step
    return goal if value - goal <= step else value - step
