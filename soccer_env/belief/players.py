"""The other players that a legged robot believes in.  [Sacks 2001, 4.1]"""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled

PLAYERS_MEMORY = np.dtype([("unused", "f4")])


@compiled
def believe_players(percept, own, tracks, memory, k, s, w, table):
    """Bring the tracks of other players up to the percept."""
