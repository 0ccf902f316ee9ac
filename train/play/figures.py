"""A number of many matches with its interval: shares, rates and percentiles, resampled over the matches.

Samples are arrays with a row for each match: numbers that are added up, or arrays of values that are pooled.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import isfinite, nan
from typing import TYPE_CHECKING

import numpy as np

from soccer_env.train.statistics import unit_bootstrap

if TYPE_CHECKING:
    from soccer_env.train.play.recording import Recording

RESAMPLES = 400

Samples = dict[str, np.ndarray]
PLAYED, IN_PLAY = "played", "in_play"  # [s] of each match: all of it, and with the ball in play


@dataclass(frozen=True)
class Figure:
    """A number that follows from the samples of any matches."""

    name: str
    unit: str
    value: Callable[[Mapping[str, np.ndarray]], float]
    sure: bool = True  # False: an extreme, for which resampling gives no interval


@dataclass(frozen=True)
class Measure:
    """What is taken from a recording, and the figures that follow; the function's docstring is the definition."""

    samples: Callable[[Recording], Samples]
    figures: tuple[Figure, ...]

    @property
    def definition(self) -> str:
        """Return the first paragraph of what the function says of itself."""
        return " ".join((self.samples.__doc__ or "").split("\n\n")[0].split())


@dataclass(frozen=True)
class Found:
    """A figure as measured; what is not finite (of nothing) is None."""

    name: str
    unit: str
    value: float | None
    low: float | None
    high: float | None


def work_out(figure: Figure, samples: Samples) -> Found:
    """Return a figure of samples with its 95 % interval."""
    if figure.sure:
        numbers = unit_bootstrap(samples, figure.value, resamples=RESAMPLES)
    else:
        numbers = (figure.value(samples), nan, nan)
    value, low, high = (float(number) if isfinite(number) else None for number in numbers)
    return Found(figure.name, figure.unit, value, low, high)


def share(name: str, part: str, whole: str = IN_PLAY) -> Figure:
    """Return the share [%] of one time in another."""
    return Figure(name, "%", lambda found: 100.0 * ratio(found[part].sum(), found[whole].sum()))


def a_minute(name: str, count: str) -> Figure:
    """Return how often something happens in a minute of a match."""
    return Figure(name, "/min", lambda found: 60.0 * ratio(found[count].sum(), found[PLAYED].sum()))


def percentile(name: str, values: str, percent: float, unit: str, scale: float = 1.0) -> Figure:
    """Return a percentile of pooled values, times a scale."""
    return Figure(name, unit, lambda found: scale * of_pooled(found[values], lambda all_: np.percentile(all_, percent)))


def most(name: str, values: str, unit: str, scale: float = 1.0) -> Figure:
    """Return the largest of pooled values, times a scale."""
    return Figure(
        name, unit, lambda found: scale * of_pooled(found[values], lambda all_: float(all_.max())), sure=False
    )


def share_from(name: str, values: str, least: float) -> Figure:
    """Return the share [%] of pooled values that are so large or larger."""
    return Figure(name, "%", lambda found: 100.0 * of_pooled(found[values], lambda all_: float((all_ >= least).mean())))


def often_from(name: str, values: str, least: float) -> Figure:
    """Return how often in a minute of a match a value is so large or larger."""
    return Figure(
        name,
        "/min",
        lambda found: 60.0 * ratio(sum((one >= least).sum() for one in found[values]), found[PLAYED].sum()),
    )


def of_pooled(values: np.ndarray, take: Callable[[np.ndarray], float]) -> float:
    """Return something of the values (M,) of all matches together; NaN of none."""
    pooled = np.concatenate(values)
    return float(take(pooled)) if len(pooled) else nan


def ratio(part: float, whole: float) -> float:
    """Return part of a whole, NaN of nothing."""
    return float(part / whole) if whole > 0.0 else nan
