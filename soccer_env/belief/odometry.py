"""Correction of remembered positions for the robot's own motion.  [Sacks 2001, 3.1.1, 4.1.2]  MS15, MS36"""

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import cosine_and_sine, into_frame


@compiled
def read_odometry(odometry):
    """Return a frame's odometry in double precision: forward and left [m], turn [rad].

    odometry: a record that holds them in single precision, a BODY_PERCEPT or a MOTION.
    """
    return np.float64(odometry.forward), np.float64(odometry.left), np.float64(odometry.turn)


@compiled
def move_point(x, y, forward, left, turn):
    """Convert a fixed point on the ground from the old to the new robot frame, after the robot's motion.  MS15, MS36

    x, y: the point in the old frame [m]; forward, left: the displacement [m] in the old axes; turn [rad], left
    positive. Exact for any motion: only the first and the last pose of a rigid body count, not the path between.
    """
    return into_frame(x - forward, y - left, *cosine_and_sine(turn))
