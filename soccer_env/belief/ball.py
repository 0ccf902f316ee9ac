"""The ball that a legged robot believes in.  [Sacks 2001, 3]"""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled

BALL_MEMORY = np.dtype([("unused", "f4")])


@compiled
def believe_ball(percept, own, ball, memory, k, s, w, table):
    """Bring the belief about the ball up to the percept."""
