"""What was measured beside what was asked for: a row each, on a scale of its own, with the numbers written out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, isfinite
from textwrap import shorten
from typing import Any

from soccer_env.train.plots.style import COLOURS, INK, WIDTH, canvas, plot

ROW = 0.4  # [inch] of height
LEFT, RIGHT = 0.44, 0.70  # [1] of the width: where the scales begin and end
LETTERS = 42  # of a row's name


@dataclass(frozen=True)
class Row:
    """An estimate with its interval, and the range that was asked for; an open side is infinite."""

    name: str
    text: str  # the numbers, with unit
    value: float
    low: float
    high: float
    least: float = -inf
    most: float = inf


@plot
def draw_intervals(title: str, rows: Sequence[Row], asked: str = "asked for") -> Any:
    """Draw rows; the band of a row is what was `asked`, the bar what was measured."""
    drawn, axes = canvas(ROW * len(rows) + 0.85, WIDTH)
    drawn.set_layout_engine("none")
    axes.set_position((0.0, 0.0, 1.0, 1.0))
    axes.set(xlim=(0.0, 1.0), ylim=(len(rows) + 0.55, -1.45))
    axes.axis("off")
    axes.text(0.01, -0.98, title, fontsize=10.5, fontweight="bold", va="center")
    for at, row in enumerate(rows):
        draw_row(axes, at, row)
    place = len(rows)
    axes.fill_betweenx([place - 0.2, place + 0.2], LEFT, LEFT + 0.05, **BAND)
    axes.text(LEFT + 0.06, place, asked, va="center", fontsize=8.5)
    axes.plot([LEFT + 0.26, LEFT + 0.31], [place, place], color=INK, linewidth=2.0, marker="|", markersize=7.0)
    axes.text(LEFT + 0.32, place, "measured, 95 %", va="center", fontsize=8.5)
    return drawn


BAND: Any = {"color": COLOURS[2] + "40", "edgecolor": COLOURS[2], "linewidth": 0.8, "hatch": "////"}


def draw_row(axes: Any, at: int, row: Row) -> None:
    """Draw one row: its name, its scale, and its numbers."""
    ends = [end for end in (row.value, row.low, row.high, row.least, row.most) if isfinite(end)]
    low, high = min(ends), max(ends)
    margin = 0.25 * (high - low) or 0.1 * abs(high) or 1.0
    low, high = low - margin, high + margin

    def place(value: float) -> float:
        return LEFT + (RIGHT - LEFT) * (min(max(value, low), high) - low) / (high - low)

    axes.plot([LEFT, RIGHT], [at, at], color="#d6dae1", linewidth=1.0, zorder=0)
    axes.fill_betweenx([at - 0.3, at + 0.3], place(row.least), place(row.most), **BAND)
    axes.plot([place(row.low), place(row.high)], [at, at], color=INK, linewidth=2.0, marker="|", markersize=7.0)
    axes.plot([place(row.value)], [at], color=INK, marker="D", markersize=5.0)
    axes.text(0.01, at, shorten(row.name, LETTERS, placeholder=" ..."), va="center", fontsize=8.5)
    axes.text(RIGHT + 0.015, at, row.text, va="center", fontsize=8.0)
