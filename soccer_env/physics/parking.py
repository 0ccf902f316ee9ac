"""Where robots stand that do not play: well off the field, one beside the other."""

from __future__ import annotations

from math import pi

from soccer_env.compiled import compiled

PARKED_X = 50.0  # [m]
PARKED_STEP = 2.0  # [m]


@compiled
def parking_place(row):
    """Return the pose [m, m, rad] of an inactive robot."""
    return PARKED_X + PARKED_STEP * row, PARKED_X, 0.5 * pi
