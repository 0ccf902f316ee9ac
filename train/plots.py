"""Draw the figures of a reproduction run: matplotlib, imported only when there is something to draw."""

from __future__ import annotations

import io
import itertools
from collections.abc import Sequence
from typing import Any

from soccer_env.train.reproduce.results import ClaimResult, plot_name
from soccer_env.train.results_folder import ResultsFolder

SIZE = (6.4, 4.0)  # [inch] without the legend, which stands beside it, where it hides no curve
DOTS = 110  # [1/inch]
STYLES = ("o-", "s--", "^-.", "v:", "D-")  # marker and line of the curves in turn: one on top of another shows


def draw_all(results: Sequence[ClaimResult], folder: ResultsFolder) -> tuple[dict[str, list[str]], str]:
    """Draw every figure into the folder; return the files of each claim, and why nothing was drawn ("" if it was)."""
    if folder.path is None or not any(result.figures for result in results):
        return {}, ""
    try:
        import matplotlib
    except ImportError:
        return {}, 'plots need matplotlib: pip install "soccer_env[plot]" and run the same command again'
    matplotlib.use("agg")
    files: dict[str, list[str]] = {}
    for result in results:
        for number, figure in enumerate(result.figures, 1):
            name = plot_name(result.id, number)
            folder.write(name, draw(figure))
            files.setdefault(result.id, []).append(name)
    return files, ""


def draw(figure: dict[str, Any]) -> bytes:
    """Return a figure as a PNG that depends on its data alone."""
    import matplotlib.pyplot as plt

    canvas, axes = plt.subplots(figsize=SIZE, dpi=DOTS)
    for curve, style in zip(figure["curves"], itertools.cycle(STYLES), strict=False):
        (line,) = axes.plot(curve["x"], numbers(curve["y"]), style, markersize=3, label=curve["name"])
        if curve["low"]:
            low, high = numbers(curve["low"]), numbers(curve["high"])
            axes.fill_between(curve["x"], low, high, color=line.get_color(), alpha=0.2, linewidth=0)
    for rule in figure["rules"]:
        axes.axhline(
            rule, color="grey", linestyle="--", linewidth=0.8, label=figure.get("rule", f"in the criteria: {rule:g}")
        )
    if "arrows" in figure:
        axes.quiver(*figure["arrows"].values(), color="0.6", scale=40.0, width=0.002)
        axes.set_aspect("equal")
    axes.set(title=figure["title"], xlabel=figure["x_label"], ylabel=figure["y_label"])
    axes.grid(alpha=0.3)
    axes.legend(fontsize="small", loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0)
    file = io.BytesIO()
    canvas.savefig(file, format="png", bbox_inches="tight", metadata={"Software": ""})
    plt.close(canvas)
    return file.getvalue()


def numbers(values: Sequence[float | None]) -> list[float]:
    """Return numbers to draw, NaN where there is none."""
    return [float("nan") if value is None else value for value in values]
