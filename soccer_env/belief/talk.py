"""What team-mates tell each other: words of four bits by loudspeaker, or messages by radio."""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled

MESSAGE = np.dtype([("unused", "f4")])


@compiled
def exchange(percepts, beliefs, tracks, messages, noise, k, s, home, rows):
    """Let the robots of one match tell their team-mates something, and hear what was told."""
