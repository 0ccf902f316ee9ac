"""What the sensors of a legged robot deliver: camera, infrared ranger, own body.  [Sacks 2001, 1, 2]  MS06"""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.perception.body import sense_body
from soccer_env.perception.ideal import situation
from soccer_env.perception.legged.infrared import measure_range
from soccer_env.perception.legged.picture import take_picture
from soccer_env.perception.legged.sketch import make_sketch
from soccer_env.perception.pose import POSE_ERROR

LEGGED_SENSOR_STATE = np.dtype(
    [  # what the sensors remember and do not deliver
        ("pose_error", POSE_ERROR),
        ("scale", "f4"),  # [1] of the sizes that the camera reports, drawn once an episode; 0: not yet
    ]
)


@compiled
def sense_slice(
    matches, balls, robots, robot_events, percepts, states, pending, beliefs,
    constants, sensors, pose_sensed, asleep, rows, first, last,
):  # fmt: skip
    """Fill the percepts (M, R) of some robots of a slice of matches, and what they are told of the game.

    Those of matches that are `asleep` (M,), over before this step, perceive nothing new.

    `pose_sensed` 1 gives them the noisy pose as a percept; `pending` is for cameras that deliver late, unused here.
    """
    k, s = constants[0], sensors[0]
    sketches = make_sketch(k, s)
    for m in range(first, last):
        if asleep[m]:
            continue
        match, ball, team = matches[m], balls[m], robots[m]
        for r in rows:
            percept, state, robot = percepts[m, r], states[m, r], team[r]
            sense_body(match, robot, robot_events[m, r], percept.body, state.pose_error, k, s, pose_sensed)
            situation(match, team, beliefs[m, r].situation, r)
            percept.pan, percept.tilt = robot.pan, robot.tilt
            take_picture(match, ball, team, percept, state, k, s, r, sketches)
            percept.infrared = measure_range(match, ball, team, k, s, r)
