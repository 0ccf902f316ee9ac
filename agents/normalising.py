"""Normalisation of a policy's observations before its network, as by stable-baselines3's VecNormalize.

    x' = min(max((x - mean) / deviation, -limit), limit)         of each input

A policy stores it as a table of plain numbers: "mean" and "deviation", one for each input, and "limit".
"""

from collections.abc import Mapping
from math import isfinite
from typing import Any

import numpy as np

from soccer_env.guards.checking import short_repr

KEYS = ("mean", "deviation", "limit")
MOST = 1e30  # of a mean, a deviation and the limit: nothing can overflow
LEAST = 1e-12  # of a deviation


def normaliser_table(normaliser: Any) -> dict[str, Any]:
    """Return the policy-file table of the normaliser used in training; {} for None.

    normaliser: a table of KEYS, VecNormalize of stable-baselines3, or an object whose `obs_rms` has `mean` and `var`,
    such as Gymnasium's NormalizeObservation: x' = (x - mean) / sqrt(var + epsilon), clipped at its `clip_obs`, if any.
    """
    if normaliser is None or getattr(normaliser, "norm_obs", True) is False:
        return {}
    if isinstance(normaliser, Mapping):
        plain = {key: np.asarray(value, np.float64).tolist() for key, value in normaliser.items()}
        return plain if "limit" in plain else {**plain, "limit": MOST}
    seen: Any = getattr(normaliser, "obs_rms", None)
    if not (hasattr(seen, "mean") and hasattr(seen, "var")):
        got = short_repr(normaliser)
        raise ValueError(
            f"normalise must be a table of {', '.join(KEYS)}, or have obs_rms with mean and var, got {got}"
        )
    epsilon = float(getattr(normaliser, "epsilon", 1e-8))
    return {
        "mean": np.asarray(seen.mean, np.float64).tolist(),
        "deviation": np.sqrt(np.asarray(seen.var, np.float64) + epsilon).tolist(),
        "limit": float(getattr(normaliser, "clip_obs", MOST)),
    }


def check_normalise(table: object, inputs: int) -> float:
    """Return the largest possible input to the network; ValueError unless the table is empty or has KEYS."""
    if not isinstance(table, Mapping) or (table and set(table) != set(KEYS)):
        raise ValueError(f"normalise must be empty or a table of {', '.join(KEYS)}, got {short_repr(table)}")
    if not table:
        return 1.0
    for key, least in (("mean", -MOST), ("deviation", LEAST)):
        values = table[key]
        if not isinstance(values, (list, tuple)) or len(values) != inputs:
            raise ValueError(f"normalise[{key!r}] must have {inputs} numbers, got {short_repr(values)}")
        for value in values:
            check_number(key, value, least)
    check_number("limit", table["limit"], LEAST)
    farthest = max((1.0 + abs(mean)) / deviation for mean, deviation in zip(table["mean"], table["deviation"]))
    return float(max(1.0, min(table["limit"], farthest)))


def check_number(key: str, value: object, least: float) -> None:
    """Raise ValueError unless a value of the table is a Python number from `least` to MOST."""
    if type(value) not in (int, float) or not isfinite(value) or not least <= value <= MOST:  # type: ignore[arg-type, operator]
        raise ValueError(f"normalise[{key!r}] must hold numbers from {least:g} to {MOST:g}, got {short_repr(value)}")


def pack_table(table: Mapping[str, Any]) -> np.ndarray:
    """Return the table as numbers (1 + 2 inputs,): limit, means, deviations; an empty array for an empty table."""
    return np.array([table["limit"], *table["mean"], *table["deviation"]] if table else [], np.float64)
