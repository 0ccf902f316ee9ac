"""The world model of a middle-size robot: tracked ball and players, own pose, radio.  [Heinemann et al. 2006, 1]"""

from __future__ import annotations

import numpy as np

from soccer_env.belief.own_pose import POSE_MEMORY
from soccer_env.compiled import compiled

OMNI_MEMORY = np.dtype([("pose", POSE_MEMORY)])


@compiled
def believe_slice(
    percepts, beliefs, tracks, memories, particles, messages, noise, gazes,
    constants, sensors, settings, tables, home, rows, first, last,
):  # fmt: skip
    """Bring beliefs (M, R) and tracks (M, R, slots) of some robots up to their percepts, in a slice of matches."""
