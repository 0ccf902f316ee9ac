"""Two filters for an object with constant velocity: a Kalman filter, and a line fit that forgets old readings.  MH06

Letters as the field uses them, along one axis: x the state (place [m], speed [m/s]), P its covariance, F the motion
(the place grows by speed times dt), Q what an unforeseen acceleration adds, z a reading of the place, H what such a
reading shows of the state, R its variance, y = z - H x the surprise, S = H P H' + R the variance of that, and
K = P H' / S the gain.

A reading is `age` old: it shows where the thing was then, H = (1, -age).  The axes are those of the line of sight,
along it and across it: there the errors of a mirror camera are independent, so that two filters of two numbers do for
four, and neither has to be turned when the robot turns (that the line of sight itself turns a little is left out).
"""

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.guards.ranges import AMOUNT, NUMBER, ranged_record

COVARIANCE = ranged_record(
    [
        ("xx", "f4", AMOUNT),  # [m2]
        ("xv", "f4", NUMBER),  # [m2/s]
        ("vv", "f4", AMOUNT),  # [m2/s2]
    ]
)
LEAST_VARIANCE = 1e-8  # [m2, m2/s2] below which single precision would lose the filter


@compiled
def start_covariance(P, R, speed):
    """Fill P with the initial covariance: variance R [m2] of the position, deviation `speed` [m/s] of the velocity."""
    P.xx, P.xv, P.vv = R, 0.0, speed * speed


@compiled
def predict_covariance(P, dt, agility, jitter):
    """Predict P one frame ahead: P = F P F' + Q.  MH06

    agility: sd of the unforeseen acceleration [m/s2]; jitter: variance of the own odometry [m2].
    """
    xx, xv, vv = np.float64(P.xx), np.float64(P.xv), np.float64(P.vv)
    q = agility * agility * dt * dt
    P.xx = xx + 2.0 * dt * xv + dt * dt * vv + 0.25 * dt * dt * q + jitter
    P.xv = xv + dt * vv + 0.5 * dt * q
    P.vv = vv + q


@compiled
def update_covariance(P, age, R):
    """Update P by a reading `age` [s] old, and return the gains K for position [1] and speed [1/s].  MH06"""
    xx, xv, vv = np.float64(P.xx), np.float64(P.xv), np.float64(P.vv)
    x_seen, v_seen = xx - age * xv, xv - age * vv  # P H'
    S_inverse = 1.0 / (x_seen - age * v_seen + R)
    K_x, K_v = x_seen * S_inverse, v_seen * S_inverse
    P.xx = max(xx - K_x * x_seen, LEAST_VARIANCE)
    P.xv = xv - K_x * v_seen
    P.vv = max(vv - K_v * v_seen, LEAST_VARIANCE)
    return K_x, K_v


@compiled
def fit_gains(readings, window, elapsed, age):
    """Return the gains for position and speed of a least-squares line through the last readings, up to `window`.  MH06

    readings: their number, with the present reading; elapsed: time since the last reading [s]; age: age of the reading
    [s]. From `window` readings on the gains stay constant, so that old readings fade.
    """
    n = max(min(1.0 * readings, window), 2.0)
    K_x, K_v = 2.0 * (2.0 * n - 1.0) / (n * (n + 1.0)), 6.0 / (n * (n + 1.0) * elapsed)
    return K_x + age * K_v, K_v
