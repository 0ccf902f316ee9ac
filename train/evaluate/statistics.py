"""Statistics of play in evaluations: of one match, totals with intervals, and their tables.

`soccer list statistics` explains each statistic.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite
from typing import Any

import numpy as np

from soccer_env.statistics import figures
from soccer_env.statistics.records import GoalKind
from soccer_env.train.statistics import ratio_bootstrap

UNITS = {(figures.RATE, ""): "/min", (figures.RATE, "s"): "s/min", (figures.SHARE, "s"): "%"}


@dataclass(frozen=True)
class Total:
    """A statistic over all matches: its sum (or maximum, or length), and its reported value with a 95 % interval."""

    total: float
    value: float | None  # a rate per minute of play, or a share; None for a share of zero
    low: float | None
    high: float | None
    unit: str


def match_statistics(record: Any, team: int) -> dict[str, Any]:
    """Return the statistics for a match's result line, seen from `team`, with histograms of spell lengths."""
    lengths = {
        f"{figures.LENGTHS}_{side}": record[figures.LENGTHS][of].tolist()
        for side, of in zip(figures.SIDES, (team, 1 - team), strict=True)
    }
    return figures.flatten_statistics(record, team) | lengths


def totals(lines: Sequence[dict[str, Any]]) -> dict[str, Total]:
    """Return each statistic over all matches by name, from result lines sorted by pair; {} if any lacks statistics."""
    if not lines or not all(lines):
        return {}
    result: dict[str, Total] = {}
    rated = [(name, figure) for name, figure in statistics_by_name() if figure.kind in (figures.RATE, figures.SHARE)]
    parts = sum_in_pairs([[line[name] for name, _ in rated] for line in lines])
    wholes = sum_in_pairs([[line[divisor_name(name, figure)] for name, figure in rated] for line in lines])
    ratios = np.stack(ratio_bootstrap(parts, wholes), axis=-1)  # value, low, high
    for (name, figure), total, ratio in zip(rated, parts.sum(axis=0), ratios, strict=True):
        value, low, high = (finite_or_none((100.0 if figure.kind == figures.SHARE else 60.0) * x) for x in ratio)
        result[name] = Total(float(total), value, low, high, UNITS.get((figure.kind, figure.unit), figure.unit))
    for name, figure in statistics_by_name():
        if figure.kind == figures.MOST:
            most = max(line[name] for line in lines)
            result[name] = Total(most, most, None, None, figure.unit)
        elif figure.kind == figures.LENGTH:
            result[name] = spell_length(lines, name, figure)
    return {name: result[name] for name, _ in statistics_by_name()}


def statistics_by_name() -> list[tuple[str, figures.Statistic]]:
    """Return the name of each statistic in a result line ("kicks_for"), with its definition."""
    return [
        (f"{x.name}_{side}" if x.team else x.name, x)
        for x in figures.FIGURES
        for side in (figures.SIDES if x.team else figures.SIDES[:1])
    ]


def divisor_name(name: str, figure: figures.Statistic) -> str:
    """Return the name, in a result line, of the quantity by which a statistic is divided."""
    whole = next(x for x in figures.FIGURES if x.name == figure.whole)
    return f"{figure.whole}_{name.rpartition('_')[2]}" if whole.team else figure.whole


def sum_in_pairs(rows: list[list[float]]) -> np.ndarray:
    """Sum the rows of matches over the two matches of each pair; an odd last row stays alone."""
    numbers = np.array(rows, np.float64)
    return np.add.reduceat(numbers, np.arange(0, len(numbers), 2), axis=0)


def spell_length(lines: Sequence[dict[str, Any]], name: str, figure: figures.Statistic) -> Total:
    """Return a quantile of the lengths of all spells of possession, with an interval from resampled pairs."""
    counts = sum_in_pairs([line[f"{figures.LENGTHS}_{name.rpartition('_')[2]}"] for line in lines])
    weights = np.random.default_rng(0).multinomial(len(counts), [1.0 / len(counts)] * len(counts), size=1000)
    share = figures.PERCENTS[figure.name]
    value = float(figures.spell_quantile(counts.sum(axis=0), share))
    low, high = np.percentile(figures.spell_quantile(weights @ counts, share), [2.5, 97.5])
    return Total(value, value, float(low), float(high), figure.unit)


def finite_or_none(number: float) -> float | None:
    """Return a number, or None for infinity and NaN, which JSON lacks."""
    return float(number) if isfinite(number) else None


# Tables

TELLING = (  # name, words: a short table
    ("in_play", "ball in play"),
    ("possession", "ball at this team alone"),
    ("spell_median", "median time of one robot on the ball"),
    ("longest_spell", "longest time of one robot on the ball"),
    ("touches", "touches"),
    ("kicks", "kicks"),
    ("shots", "shots"),
    ("on_target", "shots on target"),
    ("saves", "saves"),
    ("passes", "passes completed"),
    ("idle", "mates idle"),
    ("keeper_away", "goalkeeper away from its goal"),
    ("fouls", "whistles"),
    ("separations", "separations"),
    ("drops", "dropped balls"),
    ("at_boards", "ball at a board or line"),
    ("scrum", "scrum"),
)
GOALS = (
    *((f"goals_{kind.name.lower()}", kind.name.lower().replace("_", " ")) for kind in GoalKind),
    ("goals_after_separation", "of these within 6 s of a separation"),
    ("goals_after_pushed_keeper", "of these within 10 s of a pushed goalkeeper"),
    ("goals_solo", "of these by one robot alone since the restart"),
)


def play_rows(totals: dict[str, Total]) -> list[tuple[str, str, str]]:
    """Return the main statistics as rows (name, first team, second team); the last cell is empty if shared by both."""
    rows = []
    for name, words in TELLING:
        if name in totals:
            rows.append((words, total_in_words(totals[name]), ""))
        elif name == "fouls":
            rows.append((words, whistles(totals, "for"), whistles(totals, "against")))
        else:
            rows.append((words, total_in_words(totals[f"{name}_for"]), total_in_words(totals[f"{name}_against"])))
    return rows


def goal_rows(totals: dict[str, Total]) -> list[tuple[str, str, str]]:
    """Return a row for each kind of goal: (kind, goals of the first team, goals of the second team)."""
    return [
        (words, f"{totals[f'{name}_for'].total:g}", f"{totals[f'{name}_against'].total:g}") for name, words in GOALS
    ]


def whistles(totals: dict[str, Total], side: str) -> str:
    """Return the rate of fouls whistled against the team of a side ("for" or "against"), such as "0.3/min"."""
    rates = [total.value or 0.0 for name, total in totals.items() if name.startswith("fouls_") and name.endswith(side)]
    return f"{sum(rates):.2g}/min"


def total_in_words(total: Total) -> str:
    """Return a statistic in words, with unit and interval; "-" without a value."""
    if total.value is None:
        return "-"
    unit = total.unit if total.unit.startswith("/") else f" {total.unit}".rstrip()
    if total.low is None or total.high is None:
        return f"{total.value:.3g}{unit}"
    return f"{total.value:.3g}{unit} ({total.low:.3g} to {total.high:.3g})"
