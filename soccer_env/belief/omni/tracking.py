"""Tracking of an object over time: position and velocity (x, y, vx, vy).  [Heinemann et al. 2006, 1]  MH06

A thing is any record with x, y [m] in the robot frame and vx, vy [m/s], its velocity over the ground in the robot
frame's axes: the ball's memory, or a track. A filter goes with it.

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

import numpy as np

from soccer_env.belief.odometry import move_point, read_odometry
from soccer_env.belief.omni.kalman import COVARIANCE, fit_gains, predict_covariance, start_covariance, update_covariance
from soccer_env.compiled import compiled
from soccer_env.geometry import cosine_and_sine, from_polar, into_frame, length
from soccer_env.guards.ranges import COUNT, FLAG, NUMBER, Range, ranged_record
from soccer_env.leagues.omni_sensors import FILTERS
from soccer_env.optics.mirror_camera import metres_per_pixel, mirror_parameters

KALMAN, LEAST_SQUARES = FILTERS["kalman"], FILTERS["least-squares"]
DELAYS = 3  # frames that a picture may be late, at most
MOST_READINGS = 100  # at which the count of readings stops
NEAREST = 1e-6  # [m] below which a line of sight has no direction

FILTER = ranged_record(
    [
        ("along", COVARIANCE),  # along the line of sight
        ("across", COVARIANCE),  # across it
        ("readings", "i1", COUNT),  # taken since it was started; 0: not started
        ("surprises", "i1", COUNT),  # readings in a row that were too far off
        ("seen", "i1", Range(0, 2)),  # 1: it got a reading in this frame; 2: it is elsewhere than it was thought to be
        ("kind", "i1", FLAG),  # 1 team-mate, 0 opponent
    ]
)

MOTION = ranged_record(
    [  # odometry of a frame, in the axes of the frame before
        ("forward", "f4", NUMBER),  # [m]
        ("left", "f4", NUMBER),  # [m]
        ("turn", "f4", NUMBER),  # [rad]
    ]
)


@compiled
def note_motion(motions, body):
    """Store this frame's odometry in a buffer of the last DELAYS frames."""
    motion = motions[body.frame % DELAYS]
    motion.forward, motion.left, motion.turn = body.forward, body.left, body.turn


@compiled
def place_of_sighting(sighting, motions, frame, frames):
    """Convert a sighting `frames` frames old to a position in the present robot frame [m], for an object at rest."""
    distance, bearing = np.float64(sighting.distance), np.float64(sighting.bearing)
    x, y = from_polar(distance, bearing)
    for back in range(frames - 1, -1, -1):
        motion = motions[(frame - back) % DELAYS]
        forward, left, turn = read_odometry(motion)
        x, y = move_point(x, y, forward, left, turn)
    return x, y


@compiled
def to_present_frame(thing, motion):
    """Convert an object's position and velocity to the present robot frame, as if the object did not move."""
    forward, left, turn = read_odometry(motion)
    thing.x, thing.y = move_point(thing.x, thing.y, forward, left, turn)
    thing.vx, thing.vy = into_frame(thing.vx, thing.vy, *cosine_and_sine(turn))


@compiled
def predict(thing, filter, motion, agility, slowing, k, s):
    """Predict an object one frame ahead: x = F x with a deceleration `slowing` [m/s2], and P = F P F' + Q.  MH06"""
    share = 1.0
    if slowing > 0.0:
        speed = length(thing.vx, thing.vy)
        share = max(1.0 - slowing * k.dt / speed, 0.0) if speed > 0.0 else 1.0
    thing.x += thing.vx * 0.5 * (1.0 + share) * k.dt
    thing.y += thing.vy * 0.5 * (1.0 + share) * k.dt
    thing.vx, thing.vy = thing.vx * share, thing.vy * share
    forward, left, turn = read_odometry(motion)
    noise = s.odometry_noise * s.odometry_noise
    step = noise * (forward * forward + left * left)
    swing = noise * turn * turn * (thing.x * thing.x + thing.y * thing.y)
    predict_covariance(filter.along, k.dt, agility, step)
    predict_covariance(filter.across, k.dt, agility, step + swing)


@compiled
def start(thing, filter, x, y, speed, s):
    """Restart the track of an object at one reading (x, y), with unknown velocity of deviation `speed` [m/s]."""
    thing.x, thing.y, thing.vx, thing.vy = x, y, 0.0, 0.0
    along, across = reading_sd(length(x, y), s)
    start_covariance(filter.along, along * along, speed)
    start_covariance(filter.across, across * across, speed)
    filter.readings, filter.surprises = 1, 0


@compiled
def reading_sd(distance, s):
    """Return the standard deviation [m] of a reading along and across the line of sight: one pixel.  MH02"""
    along, across = metres_per_pixel(mirror_parameters(s), distance)
    return s.reading_noise * along, s.reading_noise * across


@compiled
def place_at_exposure(thing, age):
    """Return an object's position [m] at the exposure of a picture `age` [s] ago, in the present robot frame."""
    return thing.x - age * thing.vx, thing.y - age * thing.vy


@compiled
def correct_track(thing, filter, x, y, age, elapsed, s, w):
    """Correct an object's state by a reading (x, y) [m], `age` [s] old: x = x + K y.  MH06

    elapsed: time since the last reading [s]. The filter chosen in the settings gives the gains; without a filter the
    reading replaces the state, with velocity 0.
    """
    was_x, was_y = place_at_exposure(thing, age)
    distance = length(was_x, was_y)
    per_metre = 1.0 / max(distance, NEAREST)
    ux, uy = (was_x * per_metre, was_y * per_metre) if distance > NEAREST else (1.0, 0.0)
    along, across = (x - was_x) * ux + (y - was_y) * uy, (y - was_y) * ux - (x - was_x) * uy
    filter.readings = min(filter.readings + 1, MOST_READINGS)
    if w.filter == KALMAN:
        along_sd, across_sd = reading_sd(distance, s)
        K_along, G_along = update_covariance(filter.along, age, along_sd * along_sd)
        K_across, G_across = update_covariance(filter.across, age, across_sd * across_sd)
    elif w.filter == LEAST_SQUARES:
        K_along, G_along = fit_gains(filter.readings, w.window, elapsed, age)
        K_across, G_across = K_along, G_along
    else:
        thing.x, thing.y, thing.vx, thing.vy = x, y, 0.0, 0.0
        return
    thing.x += K_along * along * ux - K_across * across * uy
    thing.y += K_along * along * uy + K_across * across * ux
    thing.vx += G_along * along * ux - G_across * across * uy
    thing.vy += G_along * along * uy + G_across * across * ux
