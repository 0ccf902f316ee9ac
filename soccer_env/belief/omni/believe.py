"""The world model of a middle-size robot: ball, players, own pose, radio.  [Heinemann et al. 2006, 1]  MH06

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

import numpy as np

from soccer_env.belief.believing import make_belief_kernel
from soccer_env.belief.omni.ball import BALL_MEMORY, believe_ball
from soccer_env.belief.omni.field_lines import believe_pose_omni
from soccer_env.belief.omni.players import READING, SLOTS, believe_players
from soccer_env.belief.omni.radio import exchange_radio
from soccer_env.belief.omni.tracking import DELAYS, FILTER, MOTION, note_motion
from soccer_env.belief.own_pose import POSE_MEMORY, is_crowded
from soccer_env.compiled import compiled, scratch_records
from soccer_env.guards.ranges import ranged_record
from soccer_env.records.beliefs import TRACK, forget
from soccer_env.records.percepts import OTHERS, POSE_TOLD

OMNI_MEMORY = ranged_record(
    [
        ("ball", BALL_MEMORY),
        ("pose", POSE_MEMORY),
        ("motions", MOTION, (DELAYS,)),  # odometry of the last frames, a ring by frame
        ("players", FILTER, (SLOTS,)),  # the filters of the tracks
    ]
)


@compiled
def make_scratch():
    """Return scratch arrays: readings of other players, a track and the track's filter."""
    return scratch_records(OTHERS, READING), scratch_records(1, TRACK), scratch_records(1, FILTER)


@compiled
def believe_robot(percept, belief, tracks, memory, particles, noise, gaze, scratch, k, s, w, table):
    """Update one robot's beliefs and memory from its percept; `gaze` is unused, since there is no head."""
    believe_pose_omni(percept, belief.own, is_crowded(tracks, k), memory.pose, particles, noise, k, s, w, table)
    track_ball_and_players(percept, belief, tracks, memory, scratch, k, s, w)
    belief.obstacle.distance = belief.obstacle.bearing = 0.0  # there is no ranger


@compiled
def track_ball_and_players(percept, belief, tracks, memory, scratch, k, s, w):
    """Update ball and players from the percept; forget both first if the robot was placed anew.  MH06"""
    note_motion(memory.motions, percept.body)
    if percept.body.pose == POSE_TOLD:
        forget_ball_and_players(memory, tracks)
    frames = picture_age(percept, k, w)
    believe_ball(percept, belief.own, belief.ball, memory.ball, memory.motions, frames, k, s, w)
    believe_players(percept, tracks, memory.players, memory.motions, frames, scratch, k, s, w)


@compiled
def picture_age(percept, k, w):
    """Return the age of the picture in frames that the robot assumes: 0 if delay is not compensated."""
    if w.delay_compensation == 0:
        return 0
    return min(int(np.float64(percept.age) / k.dt + 0.5), DELAYS)


@compiled
def forget_ball_and_players(memory, tracks):
    """Forget the ball and all players."""
    ball = memory.ball
    ball.x = ball.y = ball.vx = ball.vy = 0.0
    ball.raw_x = ball.raw_y = ball.odd_x = ball.odd_y = 0.0
    ball.age = ball.confidence = 0.0
    ball.filter.readings = ball.filter.surprises = 0
    for slot in range(tracks.shape[0]):
        forget(tracks[slot])
        memory.players[slot].readings = memory.players[slot].surprises = 0


believe_slice = make_belief_kernel(make_scratch, believe_robot, exchange_radio)
