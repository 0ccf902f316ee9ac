"""Figures of claims from few words: curves over places, over bins of a sample, over the time.

    figures=plot("Delay", "threshold [readings]", "time [s]", COUNTS, {"held robots": mean_latencies})

Each function returns a drawing: a function of a claim's samples that returns figures.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from soccer_env.train.papers.claim import Curve, Figure
from soccer_env.train.papers.values import bin_masks, middles_of
from soccer_env.train.papers.verdicts import Samples, Statistic

Drawing = Callable[[Samples], Sequence[Figure]]
Places = Sequence[float] | np.ndarray


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


def plot_bins(
    title: str, x_label: str, y_label: str, names: Mapping[str, str], place: str | Callable[[Samples], np.ndarray],
    edges: Places, of: Statistic, scale: float = 100.0, place_scale: float = 100.0, **more: Any,
) -> Drawing:  # fmt: skip
    """Return a drawing with a curve for each of `names` (sample: title): its statistic in each bin of `place`, scaled.

    place: the name of a sample, or a function of the samples.
    """

    def draw(samples: Samples) -> Sequence[Figure]:
        inside = bin_masks(samples[place] if isinstance(place, str) else place(samples), edges)
        curves = tuple(
            Curve(text, middles_of(edges, place_scale), [scale * of(samples[name][there]) for there in inside])
            for name, text in names.items()
        )
        return [Figure(title, x_label, y_label, curves, **more)]

    return draw


def plot_done(title: str, y_label: str, grid: np.ndarray, names: Mapping[str, str]) -> Drawing:
    """Return a drawing of the shares [%] of known times, in samples `names` (sample: title), that are over by then."""

    def share(samples: Samples, name: str, time: float) -> float:
        times = samples[name][~np.isnan(samples[name])]
        return 100.0 * float((times <= time).mean())

    return plot(title, "time [s]", y_label, grid, {text: each(grid, share, name) for name, text in names.items()})
