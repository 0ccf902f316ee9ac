"""Quantities of samples in which NaN means "no value": quiet about empty ones, unlike numpy's nan functions."""

from __future__ import annotations

from math import nan, sqrt
from typing import Any

import numpy as np


def known(values: Any) -> np.ndarray:
    """Return the values that are there, in one row."""
    array = np.asarray(values, float)
    return array[np.isfinite(array)]


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


def least_rise(values: Any) -> float:
    """Return the smallest rise from one value of a sequence to the next: above 0 if it rises throughout."""
    return float(np.min(np.diff(np.asarray(values, float))))
