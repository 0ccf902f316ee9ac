"""Compare statistics of play with published figures of real matches.

Published figures come as ranges; a measured figure is inside if its interval meets the range. Little is published: no
figure of possession, passes or stuck balls was found for either league, so these have no verdict.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf
from typing import Any

from soccer_env.statistics import figures
from soccer_env.train.evaluate.evaluation import evaluate
from soccer_env.train.evaluate.report import table
from soccer_env.train.evaluate.results import EvaluationResult
from soccer_env.train.evaluate.settings import EvaluateSettings
from soccer_env.train.evaluate.statistics import Total, finite_or_none, sum_in_pairs, total_in_words
from soccer_env.train.pages.tables.teams import row_of, row_settings
from soccer_env.train.statistics import ratio_bootstrap

MATCHES, MINUTES, SEED = 60, 4.0, 5  # seeds that no other table has
PAIRINGS = (  # league, home, away, players a side
    ("legged-2001", "chaser", "chaser", 3),
    ("legged-2001", "sacks-2001", "chaser", 3),
    ("legged-2001", "learned", "sacks-2001", 3),
    ("middle-size-2006", "chaser", "chaser", 5),
)


@dataclass(frozen=True)
class Published:
    """A published range of a statistic in real matches, and its source."""

    low: float
    high: float
    text: str
    source: str


UNSW = "UNSW's results and diary of RoboCup 2000"
PUBLISHED = {  # by league and statistic
    ("legged-2001", "goals"): Published(
        1 / 20, 14 / 20, "0.26 (12 games of 20 min: 63 goals, 1 to 14 a game)", UNSW
    ),
    ("legged-2001", "one_sided"): Published(
        0.0, 14 / 20, "at most 0.70 (14-0 in 20 min)", UNSW
    ),
    ("middle-size-2006", "goals"): Published(
        0.05, 12 / 30, "0.05 in 1997, 0.10 in 2000; 0.24 in 2006 (10 games of 30 min: 72 goals, 3 to 12 a game)",
        "Isekenmeier, Nebel, Weigel; FU-Fighters' diary and Osnabrück's press note of Bremen 2006",
    ),
    ("middle-size-2006", "one_sided"): Published(
        0.0, 11 / 30, "at most 0.37 (11-1 in 30 min)", "Osnabrück's press note of Bremen 2006",
    ),
}  # fmt: skip
REMARKS = {  # remarks of UNSW's diary without a figure
    ("legged-2001", "in_corner"): 'scuffles in the corner "occurred so often" (1999)',
    ("legged-2001", "goals_pushed_in"): "the champions of 2000 ran the ball in",
}
RESTARTS = tuple(f"restarts_{phase.name.lower()}" for phase in figures.RESTARTS)
FOULS = tuple(figure.name for figure in figures.FIGURES if figure.name.startswith("fouls_"))
SHOWN: dict[str, tuple[str, tuple[str, ...]]] = {  # name -> words, and the statistics to add up
    "goals": ("goals of both teams", ("goals",)),
    "one_sided": ("goals of the better team", ()),
    "in_play": ("ball in play", ("in_play",)),
    "stoppages": ("stoppages", (*RESTARTS, "drops")),
    "possession": ("ball at one team alone", ("possession",)),
    "touches": ("touches", ("touches",)),
    "kicks": ("kicks", ("kicks",)),
    "shots": ("shots", ("shots",)),
    "passes": ("passes completed", ("passes",)),
    "still": ("ball lies still", ("still",)),
    "at_boards": ("ball at a board or line", ("at_boards",)),
    "in_corner": ("ball in a corner", ("in_corner",)),
    "scrum": ("scrum", ("scrum",)),
    "fouls": ("whistles for fouls", FOULS),
    "goals_clean_kick": ("goals by a clean kick", ("goals_clean_kick",)),
    "goals_clean_dribble": ("goals by a clean dribble", ("goals_clean_dribble",)),
    "goals_pushed_in": ("goals pushed in", ("goals_pushed_in",)),
}


def plausibility_rows() -> Iterator[EvaluateSettings]:
    """Yield the settings of the evaluations, one for each pairing of teams."""
    for league, home, away, players in PAIRINGS:
        yield row_settings(league, home, away, "sensors", MATCHES, MINUTES, players, SEED)


def measure_plausibility() -> dict[str, Any]:
    """Play the pairings, and return their rows."""
    rows = []
    for settings in plausibility_rows():
        result = evaluate(settings)
        rows.append(row_of(settings, result) | {"play": statistics_of_play(result)})
    return {"rows": rows}


def statistics_of_play(result: EvaluationResult) -> dict[str, list[Any]]:
    """Return value, low, high and unit of each statistic of the table, for both teams together."""
    lines = [line.statistics for line in result.lines]
    better = "goals_for" if result.goals_for >= result.goals_against else "goals_against"
    added = {name: columns_of(names) or [better] for name, (_, names) in SHOWN.items()}
    parts = sum_in_pairs([[sum(line[x] for x in columns) for columns in added.values()] for line in lines])
    wholes = sum_in_pairs([[line[divisor_name(columns[0])] for columns in added.values()] for line in lines])
    shown = {}
    for name, *numbers in zip(added, *ratio_bootstrap(parts, wholes), strict=True):
        timed = find_statistic(added[name][0]).kind == figures.SHARE
        shown[name] = [*(finite_or_none((100.0 if timed else 60.0) * x) for x in numbers), "%" if timed else "/min"]
    return shown


def columns_of(names: tuple[str, ...]) -> list[str]:
    """Return the names of the numbers in a match's line that are summed for some statistics, over both teams."""
    statistics = map(find_statistic, names)
    return [
        f"{x.name}_{side}" if x.team else x.name for x in statistics for side in (figures.SIDES if x.team else ("",))
    ]


def find_statistic(name: str) -> figures.Statistic:
    """Return the Statistic of a number in a match's line: "kicks" for "kicks_for"."""
    return next(x for x in figures.FIGURES if name in (x.name, f"{x.name}_for", f"{x.name}_against"))


def divisor_name(name: str) -> str:
    """Return the name of the quantity that a number in a match's line is divided by."""
    return find_statistic(name).whole


def verdict(league: str, name: str, low: float | None, high: float | None) -> str:
    """Return "inside" if a measured interval meets the published range, else "outside"; "" without such a range."""
    known = PUBLISHED.get((league, name))
    if known is None:
        return ""
    return "inside" if (low if low is not None else -inf) <= known.high and (high or 0.0) >= known.low else "outside"


def plausibility_table(measured: dict[str, Any]) -> str:
    """Return the table in Markdown: a column for each pairing, then the published figures, then the commands."""
    rows = measured["rows"]
    head = ("", *(f"{row['home']} against {row['away']}, {row['league']}, {row['players']} a side" for row in rows))
    lines = [(words, *(cell_of(row, name) for row in rows)) for name, (words, _) in SHOWN.items()]
    known = [(*where, known.text, known.source) for where, known in PUBLISHED.items()]
    remarks = [(*where, text, "UNSW's diary") for where, text in REMARKS.items()]
    published = [(league, SHOWN[name][0], *said) for league, name, *said in known + remarks]
    commands = "\n".join(row["command"] for row in rows)
    tables = (table(head, lines), table(("league", "statistic", "published, a minute", "source"), published))
    return "\n\n".join((*tables, f"```bash\n{commands}\n```", ""))


def cell_of(row: dict[str, Any], name: str) -> str:
    """Return one statistic of a pairing, and whether it lies inside the published range."""
    value, low, high, unit = row["play"][name]
    return f"{total_in_words(Total(0.0, value, low, high, unit))} {verdict(row['league'], name, low, high)}".rstrip()
