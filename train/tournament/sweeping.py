"""`soccer evaluate --sweep NAME=LOW:HIGH:COUNT`: results of one or several teams over a number of the league.

Each point of the curve is an evaluation with `variation` NAME=FACTOR in a folder of its own below --out, so that a
sweep that was stopped goes on, and `--recheck` checks each point.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.guards.checking import raise_not_allowed
from soccer_env.guards.whole_files import write_atomically
from soccer_env.teams import Team
from soccer_env.train.evaluate.evaluation import evaluate, prepare_evaluation
from soccer_env.train.evaluate.results import EvaluationResult
from soccer_env.train.evaluate.settings import EvaluateSettings
from soccer_env.train.report import can_draw, draw_curves
from soccer_env.train.written_settings import split_distinct_names

MOST = 1000  # points of a curve
ALONE = ("at_least", "picture", "keep", "recheck")  # settings of a single evaluation


@dataclass(frozen=True)
class SweepPoint:
    """The result of a team at one factor of the number that was swept."""

    home: str
    factor: float
    result: EvaluationResult

    def as_dict(self) -> dict[str, Any]:
        """Return team, factor, points and goal difference as plain values."""
        plain: dict[str, Any] = {"home": self.home, "factor": self.factor}
        for name, one in (("points", self.result.points), ("goals", self.result.goal_difference)):
            plain |= {name: one.mean, f"{name}_low": one.low, f"{name}_high": one.high}
        return plain


def split_sweep(text: str) -> tuple[str, list[float]]:
    """Parse "kicker.fastest=0.5:2:7"; return the name and its factors, evenly spaced."""
    name, _, numbers = text.partition("=")
    try:
        low, high, count = numbers.split(":")
        factors = [float(factor) for factor in np.linspace(float(low), float(high), int(count)).round(6)]
    except ValueError:
        factors = []
    if not (name and 2 <= len(set(factors)) == len(factors) <= MOST and all(map(isfinite, factors))):
        raise_not_allowed("sweep", f"written as NAME=LOW:HIGH:COUNT, of 2 to {MOST} factors", text)
    return name, factors


def sweep(settings: EvaluateSettings, *, teams: Mapping[str, Team] | None = None) -> list[SweepPoint]:
    """Evaluate each team of settings.home, separated by commas, at each factor of settings.sweep.

    Raises ValueError before the first match if any of the evaluations cannot be played.
    """
    name, factors = split_sweep(settings.sweep)
    for alone in ALONE:
        if getattr(settings, alone):
            raise ValueError(f"{alone} is for a single evaluation, and does not go with sweep")
    asked = [
        (home, factor, settings_at(settings, home, name, factor))
        for home in split_distinct_names("home", settings.home)
        for factor in factors
    ]
    for _, _, one in asked:
        prepare_evaluation(one, None, teams or {})
    points = [SweepPoint(home, factor, evaluate(one, teams=teams)) for home, factor, one in asked]
    write_sweep(settings, name, points)
    return points


def settings_at(settings: EvaluateSettings, home: str, name: str, factor: float) -> EvaluateSettings:
    """Return the settings of the evaluation of a team at one factor."""
    variation = ",".join([*([settings.variation] if settings.variation else []), f"{name}={factor:g}"])
    folder = f"{Path(home).stem}-{name}-{factor:g}"
    out = None if settings.out is None else settings.out / folder
    return replace(settings, home=home, sweep="", variation=variation, out=out)


def write_sweep(settings: EvaluateSettings, name: str, points: Sequence[SweepPoint]) -> None:
    """Write sweep.json, and sweep.png if Matplotlib is installed, into settings.out."""
    if settings.out is None:
        return
    rows = [point.as_dict() for point in points]
    write_atomically(
        settings.out / "sweep.json", json.dumps({"sweep": settings.sweep, "points": rows}, indent=1) + "\n"
    )
    if can_draw():
        write_atomically(settings.out / "sweep.png", draw_curves(sweep_figure(settings, name, points)))


def sweep_figure(settings: EvaluateSettings, name: str, points: Sequence[SweepPoint]) -> dict[str, Any]:
    """Return the figure of a sweep: points won over the factor, a curve for each team."""
    curves = []
    for home in dict.fromkeys(point.home for point in points):
        own = [point for point in points if point.home == home]
        shares = [[100.0 * getattr(point.result.points, end) for point in own] for end in ("mean", "low", "high")]
        curve = dict(zip(("y", "low", "high"), shares, strict=True))
        curves.append({"name": home, "x": [point.factor for point in own], **curve})
    against = f"against {settings.away}, {settings.league}"
    return {
        "title": f"Points {against}", "x_label": f"{name} [factor of the league's]", "y_label": "points [%]",
        "curves": curves, "rules": (50.0,), "rule": "even",
    }  # fmt: skip


def sweep_table(points: Sequence[SweepPoint]) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Return heads and rows of the table of a sweep."""
    rows: list[tuple[str, ...]] = [
        (
            point.home,
            f"{point.factor:g}",
            f"{100 * point.result.points.mean:.0f} % "
            f"({100 * point.result.points.low:.0f} to {100 * point.result.points.high:.0f})",
            f"{point.result.goal_difference.mean:+.2f} "
            f"({point.result.goal_difference.low:+.2f} to {point.result.goal_difference.high:+.2f})",
        )
        for point in points
    ]
    return ("team", "factor", "points", "goal difference a match (95 % interval)"), rows
