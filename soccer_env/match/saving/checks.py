"""Whether the numbers of a save can come from a match: kernels trust what lies in the records."""

from math import inf
from typing import Any

import numpy as np

from soccer_env.guards.ranges import outside

Match = Any  # soccer_env.match.match.Match, which stands above this file

LONGEST = 6e13  # [s] of a half that ends: leagues and `minutes` have no longer ones
FIXED = ("team", "number", "keeper")  # of a robot: as the match lined up


def check_numbers(match: Match, arrays: dict[str, np.ndarray]) -> None:
    """Raise ValueError if a number of a save cannot come from this match."""
    for name, array in arrays.items():
        field = outside(array, len(match.agents))
        if field:
            raise ValueError(f"this save is damaged: {field} of {name} is out of range")
    robots = arrays["robots"]
    for field in FIXED:
        if not (robots[field] == match.robots[field][:1]).all():  # all matches line up alike
            raise ValueError(f"this save is damaged: {field} of robots is not that of the match")
    length = arrays["matches"]["half_length"]
    if ((length > LONGEST) & (length < inf)).any():
        raise ValueError("this save is damaged: half_length of matches is out of range")
    if robots["caught_by"].any():
        check_caught(robots, bool(match.batch.constants["legs"][0]))


def check_caught(robots: np.ndarray, legs: bool) -> None:
    """Raise ValueError unless every caught leg of robots (M, R) is held by another one, and both are on the pitch."""
    holder, active = robots["caught_by"] - 1, robots["active"] == 1
    held = active & np.take_along_axis(active, np.maximum(holder, 0), axis=1) & (holder != np.arange(robots.shape[1]))
    if not legs or not (held | (holder < 0)).all():
        raise ValueError("this save is damaged: caught_by of robots names a robot that cannot hold a leg")
