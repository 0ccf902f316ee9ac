"""Where a robot believes itself to be."""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled

POSE_MEMORY = np.dtype([("unused", "f4")])

PARTICLE = np.dtype(
    [
        ("x", "f4"),  # [m] team frame
        ("y", "f4"),  # [m]
        ("heading", "f4"),  # [rad]
        ("weight", "f4"),
    ]
)


@compiled
def believe_pose(percept, own, memory, particles, noise, k, s, w):
    """Bring the own pose up to the percept: the noisy pose where it is given, else the particles."""
