"""A table of numbers whose cells are coloured by them, as of teams against teams: every number stands in its cell."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import Any

import numpy as np

from soccer_env.train.plots.style import COLOURS, INK, LINE, WIDTH, canvas, plot

ROW = 0.36  # [inch] of height
LETTER = 0.075  # [inch] of width
DEEPEST = 0.62  # [1] of a colour in the cell of the largest number: what is written on it stays readable


@plot
def draw_heat_table(
    title: str, rows: Sequence[str], columns: Sequence[str], values: Sequence[Sequence[float | None]],
    x_label: str = "", y_label: str = "", form_of_number: str = "{:+.2f}",
) -> Any:  # fmt: skip
    """Draw `values[row][column]`, None for an empty cell: blue above 0, orange and hatched below, deeper for more."""
    long = max(map(len, columns), default=1) * LETTER > (WIDTH - 1.5) / max(len(columns), 1)
    head = 0.5 + (max(map(len, columns), default=1) * LETTER * 0.75 if long else 0.25)
    drawn, axes = canvas(ROW * len(rows) + head + (0.7 if x_label else 0.3), WIDTH)
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
    """Draw one cell with its number."""
    depth = DEEPEST * min(abs(value) / largest, 1.0) if isfinite(value) else 0.0
    above = not value < 0.0
    colour = COLOURS[0 if above else 1]
    box: Any = {"facecolor": f"{colour}{round(255 * depth):02x}", "edgecolor": LINE, "hatch": None if above else "//"}
    from matplotlib.patches import Rectangle

    axes.add_patch(Rectangle((column, row), 1.0, 1.0, linewidth=1.0, **box))
    words = form_of_number.format(value) if isfinite(value) else "-"
    axes.text(column + 0.5, row + 0.5, words, ha="center", va="center", color=INK)
