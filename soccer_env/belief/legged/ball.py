"""The ball in a legged robot's belief.  [Sacks 2001, 2, 3.1.1, 3.2]  MS02, MS03, MS08 to MS18

Every frame, the remembered places are moved against the robot's own steps, the picture is searched for the ball, and
the last few sightings are averaged; every third of a second the velocity is measured. A robot that lies on its side or
is sent off does not look, and a robot that was carried away forgets the ball.

    BALL_BELIEF          distance and bearing of the latest sighting and of the filtered one (MS02); x, y: see below
    BALL_MEMORY          the same in Cartesian coordinates, the sightings of the last second, the last reading

`x`, `y` are the filtered place, whether the ball is seen or not. For a still ball the mean is the better estimate (and
nobody knows whether a hidden ball moves); for a rolling one it lags by about a tenth of a second. With `averaged` 1 it
is the latest sighting.

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from math import inf

import numpy as np

from soccer_env.belief.legged.ball_blob import choose_blob, place_of_ball
from soccer_env.belief.legged.velocity import ROUNDING, turn_velocity, update_velocity
from soccer_env.belief.odometry import read_odometry
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, cosine_and_sine, into_frame, length
from soccer_env.guards.ranges import FLAG, LATELY, NUMBER, Range, ranged_record
from soccer_env.leagues.legged_sensors import AVERAGED_MOST, ODOMETRY
from soccer_env.records.percepts import POSE_TOLD

SURE = 100.0  # confidence of what is seen, Sacks 2001, 2  MS03
HELD_TIME = 0.5  # [s] unseen after which no ball is believed to lie in the pocket, assumed
FULL, ROTATION = ODOMETRY["full"], ODOMETRY["rotation"]

BALL_SIGHTING = ranged_record(
    [
        ("x", "f4", NUMBER),  # [m] robot frame of now: moved by odometry since
        ("y", "f4", NUMBER),  # [m]
        ("frame", "i4", LATELY),  # in which it was seen
    ]
)

BALL_MEMORY = ranged_record(
    [
        ("known", "i1", FLAG),  # 1: it has been seen since the robot was last told its own pose
        ("has_sample", "i1", FLAG),  # 1: there is a reading for the velocity
        ("count", "i1", Range(0, AVERAGED_MOST)),  # sightings in `recent`
        ("seen", "i4", LATELY),  # frame of the last sighting
        ("x", "f4", NUMBER),  # [m] robot frame: the last sighting, moved by odometry since
        ("y", "f4", NUMBER),  # [m]
        ("height", "f4", NUMBER),  # [m] of the line of sight over the ground there: the radius, if the range is right
        ("filtered_x", "f4", NUMBER),  # [m] mean of the recent sightings, moved by odometry since
        ("filtered_y", "f4", NUMBER),  # [m]
        ("recent", BALL_SIGHTING, (AVERAGED_MOST,)),  # newest first
        ("period", "i4", LATELY),  # number of the velocity interval that the last frame fell into
        ("sampled", "i4", LATELY),  # frame of the last reading for the velocity
        ("sample_distance", "f4", NUMBER),  # [m] that reading
        ("sample_bearing", "f4", NUMBER),  # [rad]
        ("sample_x", "f4", NUMBER),  # [m] the same place of the ground in the robot frame of now
        ("sample_y", "f4", NUMBER),  # [m]
    ]
)


@compiled
def believe_ball(percept, own, ball, memory, k, s, w, table):
    """Update the belief about the ball from the percept of a frame.

    ball: BALL_BELIEF, memory: BALL_MEMORY, table: CALIBRATION; own motion is taken from the percept's odometry.
    """
    body = percept.body
    frame = int(body.frame)
    if body.pose == POSE_TOLD:
        forget_ball(memory)
    move_remembered_ball(ball, memory, body, frame, k, w)
    forget_old_sightings(memory, frame, k, w)
    if body.active == 1 and body.upright == 1:
        index = choose_blob(percept, was_ball_near(memory, frame, k, w), s, w)
        if index >= 0:
            x, y, height = place_of_ball(percept, percept.ball[index], k, s, w, table)
            remember_sighting(memory, x, y, frame, w)
            memory.height = height
    fill_ball_belief(ball, memory, frame, k, w)
    update_velocity(ball, memory, frame, k.dt, w)


@compiled
def forget_ball(memory):
    """Forget the ball's position and motion because the robot was carried, and perhaps the ball too."""
    memory.known = memory.has_sample = memory.count = 0


@compiled
def move_remembered_ball(ball, memory, body, frame, k, w):
    """Correct the remembered ball in the robot frame for the robot's own motion since the last frame.  MS15

    `odometry` "rotation" corrects only for turns, the old memory of 3.1.1, and "none" not at all. There is no
    correction while the robot dribbles, footnote 2: the ball moves with the robot. Velocity and last reading belong to
    the ground and are always corrected.
    """
    forward, left, turn = read_odometry(body)
    if memory.known == 0 or (forward == 0.0 and left == 0.0 and turn == 0.0):
        return
    cosine, sine = cosine_and_sine(turn)
    turn_velocity(ball, memory, forward, left, cosine, sine)
    if w.odometry == ROTATION:
        forward, left = 0.0 * forward, 0.0 * left
    elif w.odometry != FULL:
        return
    if w.odometry_while_dribbling == 0 and is_dribbling(body, memory, frame, k, w):
        return
    memory.x, memory.y = into_frame(memory.x - forward, memory.y - left, cosine, sine)
    x, y = memory.filtered_x - forward, memory.filtered_y - left
    memory.filtered_x, memory.filtered_y = into_frame(x, y, cosine, sine)
    for i in range(memory.count):
        sighting = memory.recent[i]
        sighting.x, sighting.y = into_frame(sighting.x - forward, sighting.y - left, cosine, sine)


@compiled
def is_dribbling(body, memory, frame, k, w):
    """Tell whether the robot walks forward with the ball at its chest: near, and within 45 degrees (assumed).  MS15

    A robot with no confidence in the ball's place does not dribble.
    """
    x, y = np.float64(memory.x), np.float64(memory.y)
    near = x * x + y * y < w.dribbling_distance * w.dribbling_distance and abs(y) < x
    return near and body.forward > 0.0 and confidence_in_ball(memory, frame, k, w) > 0.0


@compiled
def confidence_in_ball(memory, frame, k, w):
    """Return the confidence in the ball's position: 100 while the ball is seen, then fading.  MS03"""
    if memory.known == 0:
        return 0.0
    return max(SURE - w.fading * (frame - memory.seen) * k.dt, 0.0)


@compiled
def was_ball_near(memory, frame, k, w):
    """Tell whether the robot has recently seen the ball nearby.  MS14"""
    if memory.known == 0 or (frame - memory.seen) * k.dt > w.area_recent + ROUNDING:
        return False
    return length(np.float64(memory.x), np.float64(memory.y)) < w.area_near


@compiled
def remember_sighting(memory, x, y, frame, w):
    """Store a new sighting, and average the last `averaged` sightings in Cartesian coordinates.  MS16, footnote 3"""
    count = min(memory.count + 1, w.averaged)
    for i in range(count - 1, 0, -1):
        older, newer = memory.recent[i], memory.recent[i - 1]
        older.x = newer.x
        older.y = newer.y
        older.frame = newer.frame
    newest = memory.recent[0]
    newest.x = x
    newest.y = y
    newest.frame = frame
    ahead = left = 0.0
    for i in range(count):
        ahead += np.float64(memory.recent[i].x)
        left += np.float64(memory.recent[i].y)
    memory.filtered_x, memory.filtered_y = ahead / count, left / count
    memory.x = x
    memory.y = y
    memory.count = count
    memory.known, memory.seen = 1, frame


@compiled
def forget_old_sightings(memory, frame, k, w):
    """Drop sightings older than `averaged_within`, so that they do not count when the ball is found again.  MS16"""
    while memory.count > 0 and (frame - memory.recent[memory.count - 1].frame) * k.dt > w.averaged_within + ROUNDING:
        memory.count -= 1


@compiled
def fill_ball_belief(ball, memory, frame, k, w):
    """Write the ball's distance, its bearing (0 straight ahead) and the confidence into the belief.  MS02, MS03

    A ball that was never seen is believed half a pitch ahead, with confidence 0.
    """
    if memory.known == 0:
        memory.x = memory.filtered_x = 0.5 * k.pitch_length
        memory.y = memory.filtered_y = 0.0
    x, y = np.float64(memory.x), np.float64(memory.y)
    ball.distance, ball.bearing = length(x, y), atan2(y, x)
    ball.x, ball.y = memory.filtered_x, memory.filtered_y
    ball.filtered_distance, ball.filtered_bearing = length(ball.x, ball.y), atan2(ball.y, ball.x)
    ball.confidence = confidence_in_ball(memory, frame, k, w)
    ball.age = (frame - memory.seen) * k.dt if memory.known == 1 else inf
    ball.held = 1 if ball.age <= HELD_TIME and is_between_paws(x, y, k) else 0


@compiled
def is_between_paws(x, y, k):
    """Tell whether a ball at x, y [m], robot frame, lies between the forepaws, within reach of the kicker.

    This is the kicker's own rule, extended to a ball that is believed to overlap the chest.
    """
    gap = x - k.body_front - k.ball_radius
    return -k.ball_radius < gap < k.kicker_reach and -k.kicker_half_width < y < k.kicker_half_width
