"""Confidence of results: bootstraps, Wilson's interval, interquartile mean, required number of matches."""

from collections.abc import Callable, Mapping
from math import ceil, inf, isfinite, nan, sqrt
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
    """Return the mean of a quantity with low and high end of its interval, by resampling pairs (percentile bootstrap).

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
    """Return share, low and high of a proportion by Wilson's score interval, which also holds near 0 and 1."""
    if not 0 <= wins <= trials or trials < 1:
        raise ValueError(f"wins must be 0 to trials and trials at least 1, got {wins} of {trials}")
    return (wins / trials, *_wilson(wins / trials, trials, confidence))


def clustered_share(hits: ArrayLike, trials: ArrayLike, *, confidence: float = CONFIDENCE) -> Interval:
    """Return share, low and high of a proportion whose trials form dependent groups (units), as frames of one run do.

    hits, trials: (U,). Wilson's interval with an effective number of independent trials, estimated from the scatter
    between units (Kish's effective size): the number of units if all trials had one outcome. Without a trial the
    interval is 0 to 1.
    """
    hit, tried = _numbers(hits, "hits"), _numbers(trials, "trials")
    if len(hit) != len(tried) or (hit < 0).any() or (hit > tried).any():
        raise ValueError(f"hits must be 0 to trials in every unit, got {hits!r} of {trials!r}")
    total, units = float(tried.sum()), int((tried > 0).sum())
    if units == 0:
        return nan, 0.0, 1.0
    share = float(hit.sum()) / total
    variance = float(((hit - share * tried) ** 2).sum()) / total**2
    even = share * (1.0 - share)
    effective = float(units) if even == 0.0 else min(even / variance, total) if variance > 0.0 else total
    return (share, *_wilson(share, effective, confidence))


def unit_bootstrap(
    samples: Mapping[str, np.ndarray], value: Callable[[dict[str, np.ndarray]], float], *, resamples: int = 1000,
    confidence: float = CONFIDENCE, seed: int = 0,
) -> Interval:  # fmt: skip
    """Return `value` of the samples with low and high end of its interval, by resampling units (percentile bootstrap).

    Each array of `samples` has the same independent units along its first axis (runs, pairs, matches); units are drawn
    whole, which suits medians, ratios and paired differences alike. A value that is not finite (a median of nothing)
    in some resamples leaves that side of the interval open.
    """
    counts = {name: len(array) for name, array in samples.items()}
    if len(set(counts.values())) != 1 or not min(counts.values()):
        raise ValueError(f"samples must have the same units, at least one, in each array, got {counts}")
    units = next(iter(counts.values()))
    rng = np.random.default_rng(seed)
    tail = 0.5 * (1.0 - _fraction(confidence))
    drawn = np.empty(resamples)
    for index in range(resamples):
        rows = rng.integers(0, units, units)
        drawn[index] = value({name: array[rows] for name, array in samples.items()})
    estimate = float(value(dict(samples)))
    lows, highs = np.where(np.isnan(drawn), -inf, drawn), np.where(np.isnan(drawn), inf, drawn)
    if not isfinite(estimate):
        return estimate, -inf, inf
    # order statistics, not interpolation, which is NaN between two infinities
    low = np.quantile(lows, tail, method="inverted_cdf")
    high = np.quantile(highs, 1.0 - tail, method="inverted_cdf")
    return estimate, float(low), float(high)


def ratio_bootstrap(
    parts: np.ndarray, wholes: np.ndarray, *, resamples: int = 1000, confidence: float = CONFIDENCE, seed: int = 0
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return N ratios sum(parts) / sum(wholes), low and high, by resampling units, the same units for all ratios.

    parts, wholes: (U, N), a row for each independent unit. A ratio with sum(wholes) 0 is NaN, and so is its interval.
    """
    weights = np.random.default_rng(seed).multinomial(len(parts), [1.0 / len(parts)] * len(parts), size=resamples)
    tail = 50.0 * (1.0 - _fraction(confidence))  # [%]
    with np.errstate(divide="ignore", invalid="ignore"):
        drawn = (weights @ parts) / (weights @ wholes)
        low, high = np.percentile(drawn, [tail, 100.0 - tail], axis=0)
        return parts.sum(axis=0) / wholes.sum(axis=0), low, high


def interquartile_mean(values: ArrayLike) -> float:
    """Return the mean without the lowest and the highest quarter (each rounded down to whole values)."""
    ordered = np.sort(_numbers(values, "values"))
    cut = len(ordered) // 4
    return float(ordered[cut : len(ordered) - cut].mean())


def required_matches(pairs: ArrayLike, half_width: float, *, confidence: float = CONFIDENCE) -> int:
    """Return the even number of matches for an interval of +- half_width, if further pairs scatter as `pairs` (P,) do.

    From the normal approximation P = (z s / half_width)^2, where s is the standard deviation of the pairs.
    """
    values = _numbers(pairs, "pairs")
    if len(values) < 2:
        raise ValueError(f"at least two pairs are needed to see how they scatter, got {len(values)}")
    if not half_width > 0.0:
        raise ValueError(f"half_width must be above 0, got {half_width}")
    needed = (_quantile(confidence) * float(values.std(ddof=1)) / half_width) ** 2
    return 2 * max(1, ceil(needed))


def _wilson(share: float, trials: float, confidence: float) -> tuple[float, float]:
    """Return both ends of Wilson's interval for a share of successes in `trials` trials."""
    z = _quantile(confidence)
    spread = z * z / trials
    middle = (share + spread / 2) / (1 + spread)
    half_width = sqrt(spread * (share * (1 - share) + spread / 4)) / (1 + spread)
    low = 0.0 if share == 0.0 else max(0.0, middle - half_width)  # exactly, whatever the rounding
    high = 1.0 if share == 1.0 else min(1.0, middle + half_width)
    return low, high


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
    """Return z such that a standard normal variable lies within +- z with the probability `confidence`."""
    return NormalDist().inv_cdf(0.5 + _fraction(confidence) / 2)
