"""Draw the figures of a reproduction run into its folder."""

from __future__ import annotations

from collections.abc import Sequence

from soccer_env.train.plots import MISSING, can_draw, draw_curves
from soccer_env.train.reproduce.results import ClaimResult, plot_name
from soccer_env.train.results_folder import ResultsFolder


def draw_all(results: Sequence[ClaimResult], folder: ResultsFolder) -> tuple[dict[str, list[str]], str]:
    """Draw every figure into the folder; return the files of each claim, and why nothing was drawn ("" if it was)."""
    if folder.path is None or not any(result.figures for result in results):
        return {}, ""
    if not can_draw():
        return {}, MISSING
    files: dict[str, list[str]] = {}
    for result in results:
        for number, figure in enumerate(result.figures, 1):
            name = plot_name(result.id, number)
            folder.write(name, draw_curves(figure))
            files.setdefault(result.id, []).append(name)
    return files, ""
