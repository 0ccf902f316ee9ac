"""What a left-right mirror does to observations of the truth or of beliefs, and to actions: it turns signs round."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

LATERAL = ("_y", "_vy", "_sin", "_left", "_turn", "pan", "_angular")  # endings of what a mirror turns round
UPRIGHT = ("gait_sin", "time_left")  # these end so and stay
ACTIONS = (1.0, -1.0, -1.0, 1.0, 1.0, -1.0, 1.0)  # forward, left, turn, kick, head, pan, tilt


def observation_signs(names: Sequence[str]) -> np.ndarray:
    """Return 1 or -1 (n,) for each entry of an observation of the truth or of beliefs."""
    return np.array([-1.0 if name.endswith(LATERAL) and name not in UPRIGHT else 1.0 for name in names])


def action_signs(size: int) -> np.ndarray:
    """Return 1 or -1 for each of the 4 or 7 numbers of an action."""
    return np.array(ACTIONS[:size])
