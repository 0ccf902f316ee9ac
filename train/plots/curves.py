"""Curves with intervals, and arrows over a field: learning curves, robustness, error against range."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from soccer_env.train.plots.style import DIM, add_legend, canvas, count_along, label, looks, plot

FEW = 14  # points of a curve whose intervals are bars; a band of more


@plot
def draw_curves(figure: Mapping[str, Any]) -> Any:
    """Draw curves: `title`, `x_label`, `y_label` with units, `curves`, `rules` (heights of dashed lines).

    A curve has `name`, `x`, `y`, and `low` and `high`, which may be empty; None is a gap. `rule` says what the rules
    are; `arrows` (x, y, along_x, along_y) make it a picture of a field. Returned: the picture's bytes.
    """
    drawn, axes = canvas()
    for curve, look in zip(figure["curves"], looks(), strict=False):
        draw_curve(axes, curve, *look)
    for rule in figure["rules"]:
        words = figure.get("rule", f"in the criteria: {rule:g}")
        axes.axhline(rule, color=DIM, linestyle=(0, (6, 3)), linewidth=1.1, label=words)
    if "arrows" in figure:
        axes.quiver(*figure["arrows"].values(), color=DIM, scale=40.0, width=0.002)
        axes.set_aspect("equal")
    if all(isinstance(x, int) for curve in figure["curves"] for x in curve["x"]):
        count_along(axes.xaxis)
    label(axes, figure["title"], figure["x_label"], figure["y_label"])
    add_legend(drawn, axes)
    return drawn


def draw_curve(axes: Any, curve: Mapping[str, Any], colour: str, marker: str, line: Any) -> None:
    """Draw one curve; every other of many points goes without a marker."""
    x, y = numbers(curve["x"]), numbers(curve["y"])
    each = max(1, len(x) // 24)
    axes.plot(x, y, color=colour, marker=marker, linestyle=line, markevery=each, label=curve["name"])
    if not curve["low"]:
        return
    low, high = numbers(curve["low"]), numbers(curve["high"])
    if len(x) > FEW:
        axes.fill_between(x, low, high, color=colour, alpha=0.16, linewidth=0)
        for edge in (low, high):
            axes.plot(x, edge, color=colour, linestyle=line, linewidth=0.6)
    else:
        axes.vlines(x, low, high, color=colour, linewidth=1.0)
        for edge in (low, high):
            axes.plot(x, edge, color=colour, linestyle="", marker="_", markersize=6.0)


def numbers(values: Sequence[float | None]) -> list[float]:
    """Return numbers to draw, NaN where there is none."""
    return [float("nan") if value is None else value for value in values]
