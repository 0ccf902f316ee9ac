"""Where the head looks by itself: at the ball while it is seen, else in search of it.  [Sacks 2001, 3]  MS07"""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled

HEAD_MEMORY = np.dtype([("unused", "f4")])


@compiled
def choose_gaze(percept, belief, memory, gaze, k, s, w):
    """Choose pan and tilt for the next step."""
