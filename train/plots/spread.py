"""Discs that would hide one another, moved apart."""

from __future__ import annotations

import numpy as np

ROUNDS = 200  # at most; eleven players in one place need 60


def spread(places: np.ndarray, distance: float) -> np.ndarray:
    """Return places (N, 2) moved until they are that far from one another, across rather than along; repeatable."""
    moved = np.array(places, np.float64).reshape(-1, 2)
    if len(moved) < 2:
        return moved
    crowded = np.flatnonzero((np.hypot(*(moved[:, None] - moved).transpose(2, 0, 1)) < distance).sum(1) > 1)
    crowded = crowded[np.argsort(moved[crowded, 0], kind="stable")]  # along x they keep their order
    number = np.arange(len(crowded))
    moved[crowded] += distance * np.stack([0.01 * number, 0.4 * (-1.0) ** number], 1)
    for _ in range(ROUNDS):
        apart = moved[:, None] - moved
        far = np.hypot(*apart.transpose(2, 0, 1)) + np.eye(len(moved)) * distance
        short = np.maximum(distance - far, 0.0)
        if short.max() < 1e-3 * distance:
            break
        moved += 0.5 * (apart / far[..., None] * short[..., None]).sum(1)
    return moved
