"""Quantities of samples in which NaN means "no value": quiet about empty ones, unlike numpy's nan functions."""

from collections.abc import Mapping, Sequence
from math import nan, sqrt
from typing import Any

import numpy as np


def known(values: Any) -> np.ndarray:
    """Return the values that are there, in one row."""
    array = np.asarray(values, float)
    found: np.ndarray = array[np.isfinite(array)]
    return found


def median(values: Any) -> float:
    """Return the median, NaN of nothing."""
    found = known(values)
    return float(np.median(found)) if len(found) else nan


def mean(values: Any) -> float:
    """Return the mean, NaN of nothing."""
    found = known(values)
    return float(found.mean()) if len(found) else nan


def rms(values: Any) -> float:
    """Return the root mean square, NaN of nothing."""
    found = known(values)
    return sqrt(float((found * found).mean())) if len(found) else nan


def deviation(values: Any) -> float:
    """Return the standard deviation, NaN of nothing."""
    found = known(values)
    return float(found.std()) if len(found) else nan


def quantile(values: Any, share: float) -> float:
    """Return the quantile, NaN of nothing."""
    found = known(values)
    return float(np.quantile(found, share)) if len(found) else nan


def percent(hits: str, trials: str, samples: Mapping[str, np.ndarray]) -> float:
    """Return the share [%] of hits in trials, counts by their names, NaN without a trial."""
    total = samples[trials].sum()
    return 100.0 * float(samples[hits].sum() / total) if total else nan


def least_rise(values: Any) -> float:
    """Return the smallest rise from one value of a sequence to the next: above 0 if it rises throughout."""
    return float(np.min(np.diff(np.asarray(values, float))))


def in_bins(place: np.ndarray, edges: Sequence[float] | np.ndarray) -> list[np.ndarray]:
    """Return a mask of the shape of `place` for each bin: at its lower edge or above, below its upper edge."""
    return [(place >= low) & (place < high) for low, high in zip(edges, edges[1:], strict=False)]


def middles_of(edges: Sequence[float] | np.ndarray, scale: float = 1.0) -> list[float]:
    """Return the middles of the bins, times a scale: 100 for centimetres."""
    return [0.5 * scale * float(low + high) for low, high in zip(edges, edges[1:], strict=False)]


def about_own_mean(values: np.ndarray) -> np.ndarray:
    """Return values (M, T) about the mean of their row, over those that are there."""
    there = np.isfinite(values)
    total = np.where(there, values, 0.0).sum(axis=1) / np.maximum(there.sum(axis=1), 1)
    about: np.ndarray = values - total[:, None]
    return about
