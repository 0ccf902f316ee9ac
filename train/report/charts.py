"""Plots: curves, bars of counts, intervals against a required range, and tables of numbers with coloured cells."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf, isfinite
from textwrap import shorten
from typing import Any

import numpy as np

from soccer_env.train.report import style

FEW = 14  # points of a curve whose intervals are bars; a band of more
OUTCOMES = {
    "won": style.COLOURS[2],
    "drawn": style.COLOURS[0],
    "lost": style.COLOURS[5],
}  # green, blue, red, whoever is missing
MARGIN = 1.12  # [1] height of the axes over the highest bar
ROW = 0.4  # [inch] of height of an interval
LEFT, RIGHT = 0.44, 0.70  # [1] of the width: where the scales begin and end
LETTERS = 42  # of a row's name
CELL = 0.36  # [inch] of height of a row of cells
LETTER = 0.075  # [inch] of width in a table's head
DEEPEST = 0.62  # [1] of a colour in the cell of the largest number: what is written on it stays readable


@style.picture_maker
def draw_curves(figure: Mapping[str, Any]) -> Any:
    """Plot curves: `title`, `x_label`, `y_label` with units, `curves`, `rules` (heights of dashed lines).

    A curve has `name`, `x`, `y`, and `low` and `high`, which may be empty; None is a gap. `rule` says what the rules
    are; `arrows` (x, y, along_x, along_y) make it a picture of a field. Returned: the picture's bytes.
    """
    drawn, axes = style.canvas()
    for curve, look in zip(figure["curves"], style.curve_styles(), strict=False):
        draw_curve(axes, curve, *look)
    for rule in figure["rules"]:
        words = figure.get("rule", f"in the criteria: {rule:g}")
        axes.axhline(rule, color=style.DIM, linestyle=(0, (6, 3)), linewidth=1.1, label=words)
    if "arrows" in figure:
        axes.quiver(*figure["arrows"].values(), color=style.DIM, scale=40.0, width=0.002)
        axes.set_aspect("equal")
    if all(isinstance(x, int) for curve in figure["curves"] for x in curve["x"]):
        style.use_whole_ticks(axes.xaxis)
    style.label_axes(axes, figure["title"], figure["x_label"], figure["y_label"])
    style.add_legend(drawn, axes)
    return drawn


def draw_curve(axes: Any, curve: Mapping[str, Any], colour: str, marker: str, line: Any) -> None:
    """Plot one curve with its interval; if it has many points, only some get a marker."""
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
    """Return the values to plot, with NaN in place of None."""
    return [float("nan") if value is None else value for value in values]


@style.picture_maker
def draw_bars(
    title: str, x_label: str, y_label: str, groups: Sequence[tuple[str, Sequence[float], Sequence[float]]],
    mark: tuple[str, float, float, float] | None = None,
) -> Any:  # fmt: skip
    """Plot counts as bars: groups (name, x of bars, counts); `mark`: an estimate (words, value, low, high) above."""
    drawn, axes = style.canvas()
    top = max((count for _, _, counts in groups for count in counts), default=1.0)
    styles = zip(groups, style.COLOURS, style.HATCHES, strict=False)
    for (name, places, counts), usual, hatch in styles:
        colour = OUTCOMES.get(name, usual)
        axes.bar(places, counts, 0.82, color=colour + "55")
        look = {"color": "none", "edgecolor": colour, "hatch": hatch, "linewidth": 1.2}
        axes.bar(places, counts, 0.82, label=name, **look)  # by itself: in an SVG a hatch is as pale as what it is on
    if mark is not None:
        words, value, low, high = mark
        height = top * (MARGIN - 0.05)
        axes.plot([low, high], [height, height], color=style.INK, marker="|", markersize=9.0, linewidth=1.4)
        axes.plot([value], [height], color=style.INK, marker="D", linestyle="", label=words)
    axes.set_ylim(0.0, MARGIN * top)
    style.use_whole_ticks(axes.xaxis)
    style.use_whole_ticks(axes.yaxis)
    axes.grid(visible=False, axis="x")
    style.label_axes(axes, title, x_label, y_label)
    style.add_legend(drawn, axes)
    return drawn


@dataclass(frozen=True)
class Row:
    """An estimate with its interval and its required range; inf marks an open side of either."""

    name: str
    text: str  # the numbers, with unit
    value: float
    low: float
    high: float
    least: float = -inf
    most: float = inf


@style.picture_maker
def draw_intervals(title: str, rows: Sequence[Row], asked: str = "asked for") -> Any:
    """Plot each estimate in a row: a band for the required range (labelled `asked`), a bar for its interval."""
    drawn, axes = style.canvas(ROW * len(rows) + 0.85, style.WIDTH)
    drawn.set_layout_engine("none")
    axes.set_position((0.0, 0.0, 1.0, 1.0))
    axes.set(xlim=(0.0, 1.0), ylim=(len(rows) + 0.55, -1.45))
    axes.axis("off")
    axes.text(0.01, -0.98, title, fontsize=10.5, fontweight="bold", va="center")
    for at, row in enumerate(rows):
        draw_interval_row(axes, at, row)
    place = len(rows)
    axes.fill_betweenx([place - 0.2, place + 0.2], LEFT, LEFT + 0.05, **BAND)
    axes.text(LEFT + 0.06, place, asked, va="center", fontsize=8.5)
    axes.plot([LEFT + 0.26, LEFT + 0.31], [place, place], color=style.INK, linewidth=2.0, marker="|", markersize=7.0)
    axes.text(LEFT + 0.32, place, "measured, 95 %", va="center", fontsize=8.5)
    return drawn


BAND: Any = {"color": style.COLOURS[2] + "40", "edgecolor": style.COLOURS[2], "linewidth": 0.8, "hatch": "////"}


def draw_interval_row(axes: Any, at: int, row: Row) -> None:
    """Draw one row of an interval plot: its name, its scale, and its numbers."""
    ends = [end for end in (row.value, row.low, row.high, row.least, row.most) if isfinite(end)]
    low, high = min(ends), max(ends)
    margin = 0.25 * (high - low) or 0.1 * abs(high) or 1.0
    low, high = low - margin, high + margin

    def place(value: float) -> float:
        return LEFT + (RIGHT - LEFT) * (min(max(value, low), high) - low) / (high - low)

    axes.plot([LEFT, RIGHT], [at, at], color="#d6dae1", linewidth=1.0, zorder=0)
    axes.fill_betweenx([at - 0.3, at + 0.3], place(row.least), place(row.most), **BAND)
    axes.plot([place(row.low), place(row.high)], [at, at], color=style.INK, linewidth=2.0, marker="|", markersize=7.0)
    axes.plot([place(row.value)], [at], color=style.INK, marker="D", markersize=5.0)
    axes.text(0.01, at, shorten(row.name, LETTERS, placeholder=" ..."), va="center", fontsize=8.5)
    axes.text(RIGHT + 0.015, at, row.text, va="center", fontsize=8.0)


@style.picture_maker
def draw_heat_table(
    title: str, rows: Sequence[str], columns: Sequence[str], values: Sequence[Sequence[float | None]],
    x_label: str = "", y_label: str = "", form_of_number: str = "{:+.2f}",
) -> Any:  # fmt: skip
    """Draw `values[row][column]` as a table of coloured cells: blue above 0, orange and hatched below, None empty."""
    long = max(map(len, columns), default=1) * LETTER > (style.WIDTH - 1.5) / max(len(columns), 1)
    head = 0.5 + (max(map(len, columns), default=1) * LETTER * 0.75 if long else 0.25)
    drawn, axes = style.canvas(CELL * len(rows) + head + (0.7 if x_label else 0.3), style.WIDTH)
    numbers = np.array([[np.nan if value is None else value for value in row] for row in values], float)
    numbers = numbers.reshape(len(rows), len(columns))
    largest = float(np.nanmax(np.abs(numbers))) if np.isfinite(numbers).any() else 1.0
    for row, column in np.ndindex(numbers.shape):
        draw_cell(axes, row, column, float(numbers[row, column]), largest or 1.0, form_of_number)
    axes.set(xlim=(0, len(columns)), ylim=(len(rows), 0), xlabel=x_label, ylabel=y_label)
    axes.set_xticks(
        np.arange(len(columns)) + 0.5, columns, rotation=40 if long else 0, ha="right" if long else "center"
    )
    axes.set_yticks(np.arange(len(rows)) + 0.5, rows)
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)
    axes.grid(visible=False)
    axes.set_title(title)
    return drawn


def draw_cell(axes: Any, row: int, column: int, value: float, largest: float, form_of_number: str) -> None:
    """Draw one table cell with its number, coloured by the number relative to `largest`."""
    depth = DEEPEST * min(abs(value) / largest, 1.0) if isfinite(value) else 0.0
    above = not value < 0.0
    colour = style.COLOURS[0 if above else 1]
    box: Any = {
        "facecolor": f"{colour}{round(255 * depth):02x}",
        "edgecolor": style.LINE,
        "hatch": None if above else "//",
    }
    from matplotlib.patches import Rectangle

    axes.add_patch(Rectangle((column, row), 1.0, 1.0, linewidth=1.0, **box))
    words = form_of_number.format(value) if isfinite(value) else "-"
    axes.text(column + 0.5, row + 0.5, words, ha="center", va="center", color=style.INK)
