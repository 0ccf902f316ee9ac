"""Check what a user's own reward terms and observations return, where it enters."""

from __future__ import annotations

from typing import Any

import numpy as np


def checked(values: Any, shape: tuple[int, ...], what: str, limit: float = np.inf) -> np.ndarray:
    """Return what user code returned as numbers of a shape; ValueError says what came from whom instead."""
    try:
        numbers = np.broadcast_to(np.asarray(values, np.float64), shape)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{what} must return numbers of shape {shape}, got shape {np.shape(values)}") from error
    with np.errstate(invalid="ignore"):
        wrong = ~(np.abs(numbers) <= limit) | ~np.isfinite(numbers)
    if wrong.any():
        at = tuple(int(i) for i in np.argwhere(wrong)[0])
        allowed = "finite numbers" if limit == np.inf else f"numbers in [{-limit:g}, {limit:g}]"
        raise ValueError(f"{what} must return {allowed}, got {numbers[at]} at {at}")
    return numbers
