"""The signs of observations in a left-right mirror."""

from collections.abc import Sequence

import numpy as np

from soccer_env.observations.entry import Entry


def observation_signs(entries: Sequence[Entry]) -> np.ndarray:
    """Return the sign of each entry (n,) in a left-right mirror; ValueError names an entry without a known sign."""
    for entry in entries:
        if entry.frame is None:
            raise ValueError(
                f"a mirror needs to know the frame of every entry, and {entry.name!r} says none: "
                "give Entry(name, meaning, scale, frame, axis)"
            )
        if entry.mirror is None:
            raise ValueError(f"a mirror turns signs round alone, and {entry.name!r} would change places with another")
    return np.array([float(entry.mirror or 0) for entry in entries])
