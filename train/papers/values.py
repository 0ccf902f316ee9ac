"""Statistics of samples in which NaN means "no value": without warnings for empty ones, unlike numpy's."""

from collections.abc import Callable, Mapping, Sequence
from math import nan, sqrt
from typing import Any

import numpy as np


def known(values: Any) -> np.ndarray:
    """Return the finite values as a flat array."""
    array = np.asarray(values, float)
    return np.asarray(array[np.isfinite(array)])


def median(values: Any) -> float:
    """Return the median of the finite values, NaN without any."""
    numbers = known(values)
    return float(np.median(numbers)) if len(numbers) else nan


def mean(values: Any) -> float:
    """Return the mean of the finite values, NaN without any."""
    numbers = known(values)
    return float(numbers.mean()) if len(numbers) else nan


def rms(values: Any) -> float:
    """Return the root mean square of the finite values, NaN without any."""
    numbers = known(values)
    return sqrt(float((numbers * numbers).mean())) if len(numbers) else nan


def deviation(values: Any) -> float:
    """Return the standard deviation of the finite values, NaN without any."""
    numbers = known(values)
    return float(numbers.std()) if len(numbers) else nan


def quantile(values: Any, share: float) -> float:
    """Return the quantile `share` of the finite values, NaN without any."""
    numbers = known(values)
    return float(np.quantile(numbers, share)) if len(numbers) else nan


def percent(samples: Mapping[str, np.ndarray], hits: str, trials: str) -> float:
    """Return the sum of the counts `hits` over the sum of the counts `trials` [%], NaN without a trial."""
    total = samples[trials].sum()
    return 100.0 * float(samples[hits].sum() / total) if total else nan


def ratio(samples: Mapping[str, np.ndarray], above: str, below: str, of: Callable[[Any], float] = mean) -> float:
    """Return a statistic of the samples `above` divided by that of the samples `below`."""
    return of(samples[above]) / max(of(samples[below]), 1e-12)


def gain(samples: Mapping[str, np.ndarray], one: str, other: str, of: Callable[[Any], float] = mean) -> float:
    """Return a statistic of the samples `one` minus that of the samples `other`, in hundredths: [pp] of shares."""
    return 100.0 * (of(samples[one]) - of(samples[other]))


def reduction(samples: Mapping[str, np.ndarray], one: str, other: str, of: Callable[[Any], float] = mean) -> float:
    """Return by how much a statistic of the samples `one` is less than that of the samples `other` [%]."""
    return 100.0 * (1.0 - of(samples[one]) / of(samples[other]))


def least_rise(values: Any) -> float:
    """Return the smallest rise from one value of a sequence to the next: above 0 if all values rise."""
    return float(np.min(np.diff(np.asarray(values, float))))


def least_fall(values: Any) -> float:
    """Return the smallest fall from one value of a sequence to the next: above 0 if all values fall."""
    return least_rise(-np.asarray(values, float))


def bin_masks(place: np.ndarray, edges: Sequence[float] | np.ndarray) -> list[np.ndarray]:
    """Return for each bin a mask of the values of `place` in it: lower edge <= value < upper edge."""
    return [(place >= low) & (place < high) for low, high in zip(edges, edges[1:], strict=False)]


def middles_of(edges: Sequence[float] | np.ndarray, scale: float = 1.0) -> list[float]:
    """Return the middles of the bins, times `scale`: 100 for centimetres."""
    return [0.5 * scale * float(low + high) for low, high in zip(edges, edges[1:], strict=False)]


def row_means(values: np.ndarray) -> np.ndarray:
    """Return the means of the finite values along the last axis, NaN without any."""
    there = np.isfinite(values)
    total, count = np.where(there, values, 0.0).sum(axis=-1), there.sum(axis=-1)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


def subtract_row_mean(values: np.ndarray) -> np.ndarray:
    """Return values (M, T) minus the mean of the finite values in each row."""
    return np.asarray(values - row_means(values)[:, None])
