"""Statistics of samples in which NaN means "no value": without warnings for empty ones, unlike numpy's."""

from collections.abc import Mapping, Sequence
from math import nan, sqrt
from typing import Any

import numpy as np


def known(values: Any) -> np.ndarray:
    """Return the finite values, flattened."""
    array = np.asarray(values, float)
    finite: np.ndarray = array[np.isfinite(array)]
    return finite


def median(values: Any) -> float:
    """Return the median, NaN of nothing."""
    numbers = known(values)
    return float(np.median(numbers)) if len(numbers) else nan


def mean(values: Any) -> float:
    """Return the mean, NaN of nothing."""
    numbers = known(values)
    return float(numbers.mean()) if len(numbers) else nan


def rms(values: Any) -> float:
    """Return the root mean square, NaN of nothing."""
    numbers = known(values)
    return sqrt(float((numbers * numbers).mean())) if len(numbers) else nan


def deviation(values: Any) -> float:
    """Return the standard deviation, NaN of nothing."""
    numbers = known(values)
    return float(numbers.std()) if len(numbers) else nan


def quantile(values: Any, share: float) -> float:
    """Return the quantile, NaN of nothing."""
    numbers = known(values)
    return float(np.quantile(numbers, share)) if len(numbers) else nan


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
    """Return values (M, T) minus the mean of the finite values of their row."""
    there = np.isfinite(values)
    total = np.where(there, values, 0.0).sum(axis=1) / np.maximum(there.sum(axis=1), 1)
    about: np.ndarray = values - total[:, None]
    return about
