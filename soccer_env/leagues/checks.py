"""The base class of the parts of a league, and checks of their numbers: 0 or more, unless a part sets other bounds."""

import re

import numpy as np

from soccer_env.guards.checking import FROM_ZERO, CheckedFields, raise_not_allowed

PYTHON_ONLY = {"kernels": False}  # metadata of a field that is left out of the constants: no kernel reads it
FAMILY = re.compile(r"[a-z0-9][a-z0-9-]{0,63}")


class LeaguePart(CheckedFields):
    """A part of a league: a record of settings."""

    NUMBER = FROM_ZERO


def check_family(where: str, family: object) -> None:
    """Raise ValueError unless the name of a family of leagues is a short plain word."""
    if not isinstance(family, str) or not FAMILY.fullmatch(family):
        raise_not_allowed(where, "1 to 64 lower-case letters, digits and -", family)


def is_convex(corners: tuple[tuple[float, float], ...]) -> bool:
    """Tell whether the corners are finite and run counter-clockwise round a convex polygon."""
    points = np.asarray(corners, float)
    edges = np.roll(points, -1, axis=0) - points
    after = np.roll(edges, -1, axis=0)
    left_turns = edges[:, 0] * after[:, 1] - edges[:, 1] * after[:, 0] > 0.0
    return len(points) >= 3 and bool(np.isfinite(points).all() and left_turns.all())
