"""The memory of a legged robot: ball, players, obstacle, own pose, gaze, what it hears.  [Sacks 2001, 2 to 4]  MS01"""

from __future__ import annotations

import numpy as np

from soccer_env.belief.legged.ball import BALL_MEMORY, believe_ball
from soccer_env.belief.legged.head import HEAD_MEMORY, choose_gaze
from soccer_env.belief.legged.obstacle import believe_obstacle
from soccer_env.belief.legged.own_pose import believe_pose_legged
from soccer_env.belief.legged.players import PLAYERS_MEMORY, believe_players
from soccer_env.belief.legged.talk import exchange
from soccer_env.belief.own_pose import POSE_MEMORY
from soccer_env.compiled import compiled

LEGGED_MEMORY = np.dtype(
    [("ball", BALL_MEMORY), ("players", PLAYERS_MEMORY), ("pose", POSE_MEMORY), ("head", HEAD_MEMORY)]
)


@compiled
def believe_slice(
    percepts, beliefs, tracks, memories, particles, messages, noise, gazes,
    constants, sensors, settings, tables, home, asleep, rows, first, last,
):  # fmt: skip
    """Bring beliefs (M, R) and tracks (M, R, slots) of some robots up to their percepts, in a slice of matches.

    memories (M, R), particles (M, R, N) and messages (M, R) are theirs; noise (M, R, streams) and gazes (M, R) are
    the robots' own; rows below `home` are team-mates of each other, as are those from it on.
    """
    k, s, w, table = constants[0], sensors[0], settings[0], tables[0]
    for m in range(first, last):
        if asleep[m]:
            continue
        for r in rows:
            percept, belief, memory = percepts[m, r], beliefs[m, r], memories[m, r]
            believe_pose_legged(percept, belief.own, memory.pose, particles[m, r], noise[m, r], k, s, w)
            believe_ball(percept, belief.own, belief.ball, memory.ball, k, s, w, table)
            believe_players(percept, belief.own, tracks[m, r], memory.players, k, s, w, table)
            believe_obstacle(percept, belief, tracks[m, r], k, s, w)
            choose_gaze(percept, belief, memory.head, gazes[m, r], k, s, w)
        exchange(percepts[m], beliefs[m], tracks[m], messages[m], noise[m], k, s, home, rows)
