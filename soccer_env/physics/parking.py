"""Places of inactive robots: well off the field, side by side."""

from __future__ import annotations

from math import pi

from soccer_env.compiled import compiled

PARKED_X = 50.0  # [m]
PARKED_STEP = 2.0  # [m]


@compiled
def parking_place(row):
    """Return the pose [m, m, rad] of the inactive robot in a row."""
    return PARKED_X + PARKED_STEP * row, PARKED_X, 0.5 * pi
