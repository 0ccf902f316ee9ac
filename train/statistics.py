"""Say how sure results are: bootstrap over pairs, Wilson's interval, interquartile mean, required number of matches."""

from __future__ import annotations

from math import ceil, sqrt
from statistics import NormalDist

import numpy as np
from numpy.typing import ArrayLike

CONFIDENCE = 0.95
RESAMPLES = 10_000
BLOCK = 4_000_000  # numbers that a bootstrap holds at once, about 64 MB

Interval = tuple[float, float, float]  # mean, low, high


def paired_bootstrap(
    pairs: ArrayLike, *, resamples: int = RESAMPLES, confidence: float = CONFIDENCE, seed: int = 0
) -> Interval:
    """Return mean, low and high of a quantity by resampling pairs with replacement (percentile interval).

    `pairs` (P,) holds one number for each pair of matches, their mean; two matches from one seed are not independent,
    so the pair is the unit. The same pairs, in the same order, and seed give the same interval.
    """
    values = _numbers(pairs, "pairs")
    rng = np.random.default_rng(seed)
    rows = max(1, BLOCK // len(values))
    means = np.empty(resamples)
    for first in range(0, resamples, rows):
        last = min(first + rows, resamples)
        means[first:last] = values[rng.integers(0, len(values), (last - first, len(values)))].mean(axis=1)
    tail = 50.0 * (1.0 - _fraction(confidence))  # [%]
    low, high = np.percentile(means, [tail, 100.0 - tail])
    return float(values.mean()), float(low), float(high)


def wilson_interval(wins: int, trials: int, *, confidence: float = CONFIDENCE) -> Interval:
    """Return share, low and high of a proportion by Wilson's score interval, which is honest at 0 and 1 as well."""
    if not 0 <= wins <= trials or trials < 1:
        raise ValueError(f"wins must be 0 to trials and trials at least 1, got {wins} of {trials}")
    z = _quantile(confidence)
    share, spread = wins / trials, z * z / trials
    middle = (share + spread / 2) / (1 + spread)
    half_width = sqrt(spread * (share * (1 - share) + spread / 4)) / (1 + spread)
    low = 0.0 if wins == 0 else max(0.0, middle - half_width)  # exactly, whatever the rounding
    high = 1.0 if wins == trials else min(1.0, middle + half_width)
    return share, low, high


def interquartile_mean(values: ArrayLike) -> float:
    """Return the mean without the lowest and the highest quarter (each rounded down to whole values)."""
    ordered = np.sort(_numbers(values, "values"))
    cut = len(ordered) // 4
    return float(ordered[cut : len(ordered) - cut].mean())


def required_matches(pairs: ArrayLike, half_width: float, *, confidence: float = CONFIDENCE) -> int:
    """Return how many matches (even) an interval of +- half_width needs, if further pairs scatter as these (P,) do.

    From the normal approximation P = (z s / half_width)^2, where s is the standard deviation of the pairs.
    """
    values = _numbers(pairs, "pairs")
    if len(values) < 2:
        raise ValueError(f"at least two pairs are needed to see how they scatter, got {len(values)}")
    if not half_width > 0.0:
        raise ValueError(f"half_width must be above 0, got {half_width}")
    needed = (_quantile(confidence) * float(values.std(ddof=1)) / half_width) ** 2
    return 2 * max(1, ceil(needed))


def _numbers(values: ArrayLike, name: str) -> np.ndarray:
    array = np.asarray(values, dtype=np.float64)
    if array.ndim != 1 or len(array) == 0 or not np.isfinite(array).all():
        raise ValueError(f"{name} must be a list of at least one finite number, got {values!r}")
    return array


def _fraction(confidence: float) -> float:
    if not 0.0 < confidence < 1.0:
        raise ValueError(f"confidence must be between 0 and 1, got {confidence}")
    return confidence


def _quantile(confidence: float) -> float:
    """Return z such that a normal draw lies within +- z of its mean with that probability."""
    return NormalDist().inv_cdf(0.5 + _fraction(confidence) / 2)
