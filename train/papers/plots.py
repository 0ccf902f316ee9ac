"""Figures of claims from few words: curves over places, over bins of a sample, over the time.

    figures=plot("Delay", "threshold [readings]", "time [s]", COUNTS, {"held robots": mean_latencies})

Each function returns a drawing: a function of a claim's samples that returns figures.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from soccer_env.train.papers.claim import Curve, Figure
from soccer_env.train.papers.values import bin_masks, mean, middles_of
from soccer_env.train.papers.verdicts import Samples, Statistic

Drawing = Callable[[Samples], Sequence[Figure]]
Places = Sequence[float] | np.ndarray
Values = str | Callable[[Samples], np.ndarray]  # the name of samples, or a function of all of them


def take(samples: Samples, values: Values) -> np.ndarray:
    """Return the samples with a name, or what a function makes of all samples."""
    return samples[values] if isinstance(values, str) else values(samples)


def part(name: str, *index: Any) -> Callable[[Samples], np.ndarray]:
    """Return a function of samples that gives the part `index` of the samples with a name."""
    return lambda samples: samples[name][index]


def plots(*drawings: Drawing) -> Drawing:
    """Return a drawing of all figures of several drawings."""
    return lambda samples: [figure for drawing in drawings for figure in drawing(samples)]


def each(values: Iterable[Any], of: Callable[..., float], *arguments: Any) -> Callable[[Samples], list[float]]:
    """Return a function of samples that gives of(samples, *arguments, value) for each of `values`."""
    return lambda samples: [of(samples, *arguments, value) for value in values]


def plot(
    title: str, x_label: str, y_label: str, x: Places, lines: Mapping[str, Callable[[Samples], Sequence[float]]],
    **more: Any,
) -> Drawing:  # fmt: skip
    """Return a drawing with a curve over the places x for each of `lines`; `more`: fields of the Figure."""
    return lambda samples: [
        Figure(title, x_label, y_label, tuple(Curve(name, list(x), of(samples)) for name, of in lines.items()), **more)
    ]


def plot_curves(
    title: str, x_label: str, y_label: str, curves: Mapping[str, Callable[[Samples], Sequence[Any]]], **more: Any
) -> Drawing:
    """Return a drawing of curves, whose functions give x and y, with or without the ends of the interval of y."""
    return lambda samples: [
        Figure(title, x_label, y_label, tuple(Curve(name, *of(samples)) for name, of in curves.items()), **more)
    ]


def plot_bins(
    title: str, x_label: str, y_label: str, lines: Mapping[str, Values], place: Values,
    edges: Places, of: Statistic, scale: float = 100.0, place_scale: float = 100.0, **more: Any,
) -> Drawing:  # fmt: skip
    """Return a drawing with a curve for each of `lines`: a statistic of its samples in each bin of `place`, scaled."""

    def draw(samples: Samples) -> Sequence[Figure]:
        inside = bin_masks(take(samples, place), edges)
        curves = tuple(
            Curve(name, middles_of(edges, place_scale), [scale * of(take(samples, line)[there]) for there in inside])
            for name, line in lines.items()
        )
        return [Figure(title, x_label, y_label, curves, **more)]

    return draw


def columns(values: Values, of: Statistic = mean, scale: float = 100.0) -> Callable[[Samples], list[float]]:
    """Return a function of samples that gives the statistic of each column (last axis) of `values`, scaled."""
    return lambda samples: [scale * of(column) for column in np.moveaxis(take(samples, values), -1, 0)]


def plot_shares(
    title: str, x_label: str, y_label: str, grid: Places, lines: Mapping[str, Values],
    holds: Callable[[np.ndarray, float], np.ndarray] = np.less_equal, place_scale: float = 1.0, **more: Any,
) -> Drawing:  # fmt: skip
    """Return a drawing of the shares [%] of known values that are at most x (or `holds`), for each of `lines`."""

    def share(samples: Samples, line: Values, x: float) -> float:
        values = take(samples, line)
        return 100.0 * mean(holds(values[~np.isnan(values)], x))

    drawn = {name: each(grid, share, line) for name, line in lines.items()}
    return plot(title, x_label, y_label, [place_scale * x for x in grid], drawn, **more)
