"""Counts as bars, which hatches tell apart as well as colours."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from soccer_env.train.plots.style import COLOURS, HATCHES, INK, add_legend, canvas, count_along, label, plot

OUTCOMES = {"won": COLOURS[2], "drawn": COLOURS[0], "lost": COLOURS[5]}  # green, blue, red, whoever is missing
MARGIN = 1.12  # [1] height of the axes over the highest bar


@plot
def draw_bars(
    title: str, x_label: str, y_label: str, groups: Sequence[tuple[str, Sequence[float], Sequence[float]]],
    mark: tuple[str, float, float, float] | None = None,
) -> Any:  # fmt: skip
    """Draw bars: groups of (name, places, counts); `mark` is (words, value, low, high) of an estimate over them."""
    drawn, axes = canvas()
    top = max((count for _, _, counts in groups for count in counts), default=1.0)
    styles = zip(groups, COLOURS, HATCHES, strict=False)
    for (name, places, counts), usual, hatch in styles:
        colour = OUTCOMES.get(name, usual)
        axes.bar(places, counts, 0.82, color=colour + "55")
        look = {"color": "none", "edgecolor": colour, "hatch": hatch, "linewidth": 1.2}
        axes.bar(places, counts, 0.82, label=name, **look)  # by itself: in an SVG a hatch is as pale as what it is on
    if mark is not None:
        words, value, low, high = mark
        height = top * (MARGIN - 0.05)
        axes.plot([low, high], [height, height], color=INK, marker="|", markersize=9.0, linewidth=1.4)
        axes.plot([value], [height], color=INK, marker="D", linestyle="", label=words)
    axes.set_ylim(0.0, MARGIN * top)
    count_along(axes.xaxis)
    count_along(axes.yaxis)
    axes.grid(visible=False, axis="x")
    label(axes, title, x_label, y_label)
    add_legend(drawn, axes)
    return drawn
