"""Where and when a rolling ball is met.  [Heinemann 2006, 1, 4]  MH20, MH21

    "we developed robot control algorithms that are incorporating the velocity of the objects for ball interception as
    goal keeper or pass receiver and for path planning"    [Heinemann 2006, 1]

A ball that rolls loses a constant share of its speed in a second, `k.ball_rolling` [m/s2]; a base goes from rest with
its acceleration up to its top speed, after a reaction.

`k`: the league's constants.
"""

from __future__ import annotations

from math import inf, sqrt

from soccer_env.compiled import compiled


@compiled
def rolling_time(speed, far, k):
    """Return the time [s] in which a ball of a speed [m/s] rolls a distance [m]; inf if it stops before.

    far = v t - a t^2 / 2, solved for the earlier t.
    """
    if far <= 0.0:
        return 0.0
    under = speed * speed - 2.0 * k.ball_rolling * far
    return inf if under < 0.0 else (speed - sqrt(under)) / k.ball_rolling


@compiled
def moving_time(far, reaction, k):
    """Return the time [s] in which a base goes a distance [m] from rest, without braking, after a reaction [s].  MH21

    sqrt(2 s / a) up to the top speed v, and s / v + v / (2 a) beyond.
    """
    if far <= 0.0:
        return 0.0
    a, top = k.drive_acceleration, k.drive_forward if k.drive_sideways <= 0.0 else k.drive_sideways
    if far <= 0.5 * top * top / a:
        return reaction + sqrt(2.0 * far / a)
    return reaction + far / top + 0.5 * top / a
