"""The point and time at which a player can meet a rolling ball.  [Heinemann 2006, 1, 4]  MH20, MH21, MH22

    "we developed robot control algorithms that are incorporating the velocity of the objects for ball interception as
    goal keeper or pass receiver and for path planning"    [Heinemann 2006, 1]

A rolling ball has a constant deceleration, `k.ball_rolling` [m/s2]; a base has a reaction time, then accelerates
constantly up to its top speed.

`k`: the league's constants.
"""

from math import inf, sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, length
from soccer_env.skills.sight import predict_ball

STEP = 0.1  # [s] between two moments at which a ball could be met, assumed


@compiled
def rolling_time(speed, far, k):
    """Return the time [s] that a ball with an initial speed [m/s] takes to roll a distance [m]; inf if it stops before.

    far = v t - a t^2 / 2, solved for the earlier t.
    """
    if far <= 0.0:
        return 0.0
    under = speed * speed - 2.0 * k.ball_rolling * far
    return inf if under < 0.0 else (speed - sqrt(under)) / k.ball_rolling


@compiled
def moving_time(far, speed, reaction, k):
    """Return the time [s] that a base takes to drive `far` [m], from a speed [m/s] and after a reaction time [s].  MH21

    The base does not brake at the end. From rest: sqrt(2 s / a) up to the top speed v, and s / v + v / (2 a) beyond. An
    initial speed u is treated as a start from rest u^2 / (2 a) farther back and u / a earlier; so is a speed away from
    the place, u < 0.
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
    """Return the earliest time [s] at which a player at (x, y), velocity (vx, vy), can reach the rolling ball.  MH22

    Times are tried in steps of `STEP`, up to `most` [s]; the base drives straight to the ball's predicted place.
    """
    t = 0.0
    while t < most:
        dx, dy = predict_ball(sight, k, t)
        dx, dy = dx - x, dy - y
        away = max(length(dx, dy), 1e-6)
        speed = clip((vx * dx + vy * dy) / away, -k.drive_forward, k.drive_forward)
        if moving_time(away - sight.touch, speed, 0.0, k) <= t:
            return t
        t += STEP
    return most
