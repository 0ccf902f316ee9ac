"""The belief of a legged robot: ball, players, obstacle, own pose, gaze, heard words.  [Sacks 2001, 2 to 4]  MS01

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

import numpy as np

from soccer_env.belief.believing import make_belief_kernel
from soccer_env.belief.legged.ball import BALL_MEMORY, believe_ball
from soccer_env.belief.legged.head import HEAD_MEMORY, choose_gaze
from soccer_env.belief.legged.landmarks import believe_pose_legged
from soccer_env.belief.legged.obstacle import believe_obstacle
from soccer_env.belief.legged.players import PLAYERS_MEMORY, believe_players
from soccer_env.belief.legged.talk import exchange_words
from soccer_env.belief.own_pose import POSE_MEMORY, is_crowded
from soccer_env.compiled import compiled
from soccer_env.guards.ranges import ranged_record

LEGGED_MEMORY = ranged_record(
    [("ball", BALL_MEMORY), ("players", PLAYERS_MEMORY), ("pose", POSE_MEMORY), ("head", HEAD_MEMORY)]
)


@compiled
def make_scratch():
    """Return None: the beliefs of legged robots need no scratch arrays."""
    return 0


@compiled
def believe_robot(percept, belief, tracks, memory, particles, noise, gaze, scratch, k, s, w, table):
    """Update one robot's beliefs and memory from its percept, and choose the next gaze of its head."""
    believe_pose_legged(percept, belief.own, is_crowded(tracks, k), memory.pose, particles, noise, k, s, w)
    believe_ball(percept, belief.own, belief.ball, memory.ball, k, s, w, table)
    believe_players(percept, belief.own, tracks, memory.players, k, s, w, table)
    believe_obstacle(percept, belief, tracks, k, s, w)
    choose_gaze(percept, belief, np.float64(memory.ball.height), memory.head, gaze, k, s, w)


believe_slice = make_belief_kernel(make_scratch, believe_robot, exchange_words)
