"""Angles, vectors and frames.

A frame is given by the cosine and sine of its heading, which are computed once for all points of the frame.
"""

from math import floor, pi, sqrt

from soccer_env.compiled import compiled
from soccer_env.types import HOME

TURN = 2.0 * pi


@compiled
def wrap(angle):
    """Return the equivalent of an angle [rad] in (-pi, pi]."""
    if -pi < angle <= pi:
        return angle
    return pi - (pi - angle - TURN * floor((pi - angle) / TURN))


@compiled
def clip(value, low, high):
    """Return the value limited to between low and high."""
    return low if value < low else (high if value > high else value)


@compiled
def length(x, y):
    """Return the length of a vector (`math.hypot` differs between compiled and plain Python)."""
    return sqrt(x * x + y * y)


@compiled
def step_toward(value, goal, step):
    """Return the value moved towards the goal by at most `step`."""
    if goal > value:
        return goal if goal - value <= step else value + step
    return goal if value - goal <= step else value - step


@compiled
def into_frame(x, y, cosine, sine):
    """Convert a vector x, y to its components ahead and left in a frame whose heading has this cosine and sine."""
    return cosine * x + sine * y, cosine * y - sine * x


@compiled
def out_of_frame(ahead, left, cosine, sine):
    """Convert components ahead and left in a frame whose heading has this cosine and sine to a vector x, y."""
    return cosine * ahead - sine * left, sine * ahead + cosine * left


@compiled
def point_of_frame(x, y, ahead, left, cosine, sine):
    """Return x and y of the point ahead and left of the frame at x, y whose heading has this cosine and sine.

    The sums begin with x and y, so that the results differ in the last bit from `out_of_frame` added to x, y.
    """
    return x + cosine * ahead - sine * left, y + sine * ahead + cosine * left


@compiled
def attack_direction(match, team):
    """Return +1 if the team attacks +x in this half, -1 if -x: the factor from field frame to team frame."""
    return match.home_direction if team == HOME else -match.home_direction
