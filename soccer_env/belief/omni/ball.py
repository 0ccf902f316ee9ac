"""The ball that a middle-size robot tracks: position and velocity.  [Heinemann et al. 2006, 1, 4]  MH06

frame    carried by the odometry, rolls on
reading  by the camera, or by the light barrier while the own body hides the ball
         near the prediction: filtered     far off: ignored, until some in a row agree with each other

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from math import inf

import numpy as np

from soccer_env.belief.odometry import move_point, read_odometry
from soccer_env.belief.omni.tracking import (
    FILTER,
    correct_track,
    place_at_exposure,
    place_of_sighting,
    predict,
    start,
    to_present_frame,
)
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, length
from soccer_env.guards.ranges import AMOUNT, CONFIDENCE, ENDLESS, NUMBER, ranged_record

SURE = 100.0  # confidence of what is seen
BALL_SPEED = 4.0  # [m/s] sd of the speed of a ball of which only one reading is known, assumed
NEAREST = 1e-3  # [m] below which rates of distance and bearing are those at this distance

BALL_MEMORY = ranged_record(
    [
        ("x", "f8", NUMBER),  # [m] robot frame
        ("y", "f8", NUMBER),  # [m]
        ("vx", "f8", NUMBER),  # [m/s] over the ground, axes of the robot frame
        ("vy", "f8", NUMBER),  # [m/s]
        ("raw_x", "f8", NUMBER),  # [m] robot frame: the last reading, moved to now
        ("raw_y", "f8", NUMBER),  # [m]
        ("odd_x", "f8", NUMBER),  # [m] robot frame: the last reading that was too far off
        ("odd_y", "f8", NUMBER),  # [m]
        ("age", "f8", ENDLESS),  # [s] since it was seen
        ("confidence", "f8", CONFIDENCE),  # [0, 100]
        ("held", "f8", AMOUNT),  # frames in a row in which the light barrier was broken
        ("filter", FILTER),
    ]
)


@compiled
def believe_ball(percept, own, believed, memory, motions, frames, k, s, w):
    """Update the tracked ball (`memory`) from the percept, and the belief from the tracked ball.  MH06

    The picture counts as `frames` old: a reading is compared with the ball's state at the exposure.
    """
    body = percept.body
    predict_ball(memory, motions[body.frame % motions.shape[0]], body.kicked == 1, k, s, w)
    if percept.ball.seen == 1:
        x, y = place_of_sighting(percept.ball, motions, body.frame, frames)
        correct_ball(memory, x, y, frames * k.dt, np.float64(percept.age), True, k, s, w)
    elif body.held == 1 and memory.held >= 1.0:  # the barrier errs now and then: one frame proves nothing
        correct_ball(memory, k.body_front + k.ball_radius, 0.0, 0.0, 0.0, False, k, s, w)
    else:
        memory.filter.surprises = 0  # no longer in a row
    memory.held = memory.held + 1.0 if body.held == 1 else 0.0
    if memory.filter.seen == 0:
        memory.confidence = max(memory.confidence - w.fading * k.dt, 0.0)
        if memory.confidence <= 0.0:  # its velocity is forgotten as well
            memory.vx = memory.vy = 0.0
    fill_ball_belief(believed, memory, own)
    believed.held = body.held


@compiled
def predict_ball(memory, motion, kicked, k, s, w):
    """Predict the rolling ball one frame ahead, relative to the moving robot; a kick makes the velocity uncertain."""
    filter = memory.filter
    memory.age += k.dt
    filter.seen = 0
    if filter.readings == 0:
        return
    predict(memory, filter, motion, w.ball_agility, k.ball_rolling, k, s)
    to_present_frame(memory, motion)
    forward, left, turn = read_odometry(motion)
    memory.raw_x, memory.raw_y = move_point(memory.raw_x, memory.raw_y, forward, left, turn)
    memory.odd_x, memory.odd_y = move_point(memory.odd_x, memory.odd_y, forward, left, turn)
    if kicked:
        filter.along.vv = filter.across.vv = BALL_SPEED * BALL_SPEED


@compiled
def correct_ball(memory, x, y, late, age, alone, k, s, w):
    """Correct the ball by a reading (x, y) [m], `age` [s] old; `late` [s]: the age that the robot assumes.  MH06

    `alone`: this reading may start a track without a second one that agrees.

    A reading off by more than `surprise` is ignored, unless `surprise_count` of them in a row agree with each other:
    then the ball was kicked, or the track followed something else, and it starts anew.
    """
    filter = memory.filter
    memory.raw_x, memory.raw_y = x, y
    was_x, was_y = place_at_exposure(memory, late)
    near = filter.readings > 0 and memory.confidence > 0.0 and length(x - was_x, y - was_y) <= w.surprise
    if near:
        correct_track(memory, filter, x, y, late, max(memory.age - age, k.dt), s, w)
        filter.surprises = 0
    elif not (alone and filter.readings == 0):
        within = w.surprise + k.ball_top_speed * k.dt
        agrees = filter.surprises > 0 and length(x - memory.odd_x, y - memory.odd_y) <= within
        filter.surprises = filter.surprises + 1 if agrees else 1
        memory.odd_x, memory.odd_y = x, y
        if filter.surprises < w.surprise_count:
            return
    if not near:
        start(memory, filter, x, y, BALL_SPEED, s)
    filter.seen = 1
    memory.age = age
    memory.confidence = SURE


@compiled
def fill_ball_belief(believed, memory, own):
    """Write the tracked ball into the belief; radial and angular velocity are relative to the turning robot."""
    believed.distance = length(memory.raw_x, memory.raw_y)
    believed.bearing = atan2(memory.raw_y, memory.raw_x)
    x, y = memory.x, memory.y
    distance = length(x, y)
    believed.filtered_distance, believed.filtered_bearing = distance, atan2(y, x)
    believed.x, believed.y, believed.vx, believed.vy = x, y, memory.vx, memory.vy
    vx = memory.vx - own.forward
    vy = memory.vy - own.left
    away = max(distance, NEAREST)
    believed.radial = (x * vx + y * vy) / away
    believed.angular = (x * vy - y * vx) / (away * away) - own.turn
    believed.confidence = memory.confidence
    believed.age = memory.age if memory.filter.readings > 0 else inf
