"""The default control of the head: look at the ball's blob while it is seen, else search for it.  [Sacks 2001, 3]  MS07

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from math import asin, pi, sqrt

import numpy as np

from soccer_env.belief.odometry import move_point, read_odometry
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, from_polar, length
from soccer_env.guards.ranges import COUNT, NUMBER, UNIT, ranged_record
from soccer_env.records.percepts import POSE_TOLD

DEGREE = pi / 180.0
NEAR_TILT = -68.0 * DEGREE  # [rad] of a sweep over the ground at the feet, a ball between the paws too, assumed
FAR_TILT = -24.0 * DEGREE  # [rad] of a sweep over the ground farther out, up to the horizon, assumed
NEAR_BALL = 0.4  # [m] a ball believed nearer is searched for at the feet first, assumed
FOUND = 3  # sightings that end a search; fewer are a glimpse, of a patch perhaps, assumed
GLIMPSE = 0.25  # [s] unseen after which a search goes on that a glimpse interrupted, assumed
LEAST = 1e-9  # [m]

HEAD_MEMORY = ranged_record(
    [
        ("side", "f4", UNIT),  # 0: not searching; +1, -1: the first sweep of the cycle begins on the left, the right
        ("sightings", "i4", COUNT),  # frames with a ball since the search began
        ("clock", "f8", NUMBER),  # [s] in the cycle of two sweeps, a near one and a far one
    ]
)


@compiled
def choose_gaze(percept, belief, height, memory, gaze, k, s, w):
    """Choose the next pan and tilt [rad]: towards the ball, or in search of the ball.  [Sacks 2001, 3]  MS07

    A ball in the picture is brought to the picture's middle: the head turns to a point on the line of sight to the
    blob, `height` [m] over the ground at the believed distance. The believed place on the ground would not do: a
    half-hidden ball seems too far away, and the head would look over it. After the ball is lost, the head looks at its
    remembered place on the ground for w.search_after. Either point is predicted for the next picture from the robot's
    motion in the last frame: otherwise the head would lag behind a turning body. After a mere glimpse a search goes on
    where it was, so that a patch now and then taken for the ball does not keep the head from looking at the feet.
    """
    ball = belief.ball
    if percept.body.pose == POSE_TOLD:  # the robot was carried: a search begins anew
        memory.side, memory.sightings = 0.0, 0
    if memory.side != 0.0 and ball.age == 0.0:
        memory.sightings += 1
    if memory.sightings >= FOUND:
        memory.side, memory.sightings = 0.0, 0
    patience = w.search_after if memory.side == 0.0 else min(GLIMPSE, w.search_after)
    if ball.confidence > 0.0 and ball.age < patience:
        ahead, left = from_polar(ball.distance, ball.bearing)
        if ball.distance >= w.dribbling_distance:  # a nearer one comes along
            body = percept.body
            forward, aside, turn = read_odometry(body)
            ahead, left = move_point(ahead, left, forward, aside, turn)
        up = height if ball.age == 0.0 else k.ball_radius
        pan, tilt = gaze_at_point(ahead, left, up, s)
    else:
        pan, tilt = choose_search_gaze(ball, memory, np.float64(percept.body.handedness), k, w)
    gaze.pan = clip(pan, -k.head_pan_limit, k.head_pan_limit)
    gaze.tilt = clip(tilt, k.head_tilt_low, k.head_tilt_high)


@compiled
def gaze_at_point(ahead, left, height, s):
    """Return the pan and tilt [rad] that bring a point of the robot frame [m] to the image's centre.  MS07

    The camera moves with the head: it looks along a line that passes the neck's pivot s.camera_up above it, so that
    the tilt falls short of the point's elevation as seen from the pivot by asin(camera_up / distance).
    """
    ahead, up = ahead - s.neck_ahead, height - s.neck_height
    level = length(ahead, left)
    away = max(sqrt(level * level + up * up), LEAST)
    return atan2(left, ahead), atan2(up, level) - asin(clip(s.camera_up / away, -1.0, 1.0))


@compiled
def choose_search_gaze(ball, memory, handedness, k, w):
    """Return the pan and tilt [rad] for a search: sweeps between the pan limits, alternating two tilts.  MS07

    A sweep takes w.search_period. The first one begins on the side where the ball was believed last, low if it was
    believed at the robot's feet, or is unknown: a robot that has just been placed may have it there.
    """
    period = max(w.search_period, k.dt)
    if memory.side == 0.0:
        side = ball.bearing if ball.bearing != 0.0 else handedness
        near = ball.confidence <= 0.0 or ball.distance < NEAR_BALL
        memory.sightings = 0
        memory.side = (1.0 if side > 0.0 else -1.0) * (1.0 if near else -1.0)
        memory.clock = 0.0 if near else period  # the second sweep of a cycle is the far one, and runs the other way
    near_sweep = memory.clock < period
    share = memory.clock / period if near_sweep else memory.clock / period - 1.0
    pan = memory.side * k.head_pan_limit * (1.0 - 2.0 * share) * (1.0 if near_sweep else -1.0)
    memory.clock += k.dt
    if memory.clock >= 2.0 * period:
        memory.clock = 0.0
    return pan, NEAR_TILT if near_sweep else FAR_TILT
