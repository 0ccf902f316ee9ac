"""Where and when a rolling ball is met.  [Heinemann 2006, 1, 4]  MH20, MH21, MH22

    "we developed robot control algorithms that are incorporating the velocity of the objects for ball interception as
    goal keeper or pass receiver and for path planning"    [Heinemann 2006, 1]

A ball that rolls loses a constant share of its speed in a second, `k.ball_rolling` [m/s2]; a base goes from rest with
its acceleration up to its top speed, after a reaction.

`k`: the league's constants.
"""

from math import inf, sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, length
from soccer_env.skills.sight import rolls_to

STEP = 0.1  # [s] between two moments at which a ball could be met, assumed


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
def moving_time(far, speed, reaction, k):
    """Return the time [s] in which a base at a speed [m/s] towards a place goes to it, after a reaction [s].  MH21

    It does not brake there: sqrt(2 s / a) from rest up to the top speed v, and s / v + v / (2 a) beyond. A base that
    moves is where a base that began at rest v^2 / (2 a) behind would be after v / a; so is, with time run back, a base
    that moves away.
    """
    if far <= 0.0:
        return 0.0
    a, top = k.drive_acceleration, k.drive_forward
    whole = far + 0.5 * speed * speed / a
    if whole <= 0.5 * top * top / a:
        return reaction + sqrt(2.0 * whole / a) - speed / a
    return reaction + whole / top + 0.5 * top / a - speed / a


@compiled
def meeting_time(sight, x, y, vx, vy, most, k):
    """Return when [s] a player at (x, y) at (vx, vy) can first be at the rolling ball, by steps of `STEP`.  MH22

    At most `most` [s]. The ball is looked for where it will be by then, and the base goes straight there.
    """
    t = 0.0
    while t < most:
        dx, dy = rolls_to(sight, k, t)
        dx, dy = dx - x, dy - y
        away = max(length(dx, dy), 1e-6)
        speed = clip((vx * dx + vy * dy) / away, -k.drive_forward, k.drive_forward)
        if moving_time(away - sight.touch, speed, 0.0, k) <= t:
            return t
        t += STEP
    return most
