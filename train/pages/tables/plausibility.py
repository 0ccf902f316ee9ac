"""Compare statistics of play with published figures of real matches.

Means are compared with means: a published figure is the mean of the games of one tournament, and both means have their
intervals. Little is published: no figure of possession, passes or stuck balls was found for either league, so these
have no verdict.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from soccer_env.statistics import figures
from soccer_env.train.evaluate.evaluation import evaluate
from soccer_env.train.evaluate.report import table
from soccer_env.train.evaluate.results import EvaluationResult
from soccer_env.train.evaluate.settings import EvaluateSettings
from soccer_env.train.evaluate.statistics import (
    Total,
    divisor_name,
    finite_or_none,
    statistics_by_name,
    sum_in_pairs,
    total_in_words,
)
from soccer_env.train.pages.tables.teams import row_of, row_settings
from soccer_env.train.statistics import Interval, paired_bootstrap, ratio_bootstrap
from soccer_env.train.written_settings import with_ray

MATCHES, MINUTES, SEED = 60, 4.0, 5  # seeds that no other table has
PAIRINGS = (  # league, home, away, players a side
    ("legged-2001", "chaser", "chaser", 3),
    ("legged-2001", "sacks-2001", "chaser", 3),
    ("legged-2001", "learned", "sacks-2001", 3),
    ("middle-size-2006", "chaser", "chaser", 5),
)


@dataclass(frozen=True)
class Published:
    """The goals of both teams in each game of a tournament, the length of a game [min], and the source."""

    goals: tuple[int, ...]
    minutes: float
    source: str

    @property
    def rate(self) -> Interval:
        """Return the mean of the goals a minute with its interval, by resampling games."""
        return paired_bootstrap([goals / self.minutes for goals in self.goals])

    @property
    def text(self) -> str:
        """Return mean, interval and games in words."""
        rate = total_in_words(Total(0.0, *self.rate, "/min"))
        games = f"{len(self.goals)} games of {self.minutes:g} min: {sum(self.goals)} goals"
        return f"{rate}, {games}, {min(self.goals)} to {max(self.goals)} a game"


PUBLISHED = {  # by league and statistic
    ("legged-2001", "goals"): Published(
        (3, 3, 6, 3, 2, 3, 14, 2, 6, 11, 1, 9), 20.0, "UNSW's results and diary of RoboCup 2000"
    ),
    ("middle-size-2006", "goals"): Published(
        (6, 10, 3, 4, 12, 6, 5, 8, 12, 6), 30.0, "FU-Fighters' diary and Osnabrück's press note of Bremen 2006"
    ),
}
REMARKS = {  # without the figures of single games
    ("middle-size-2006", "goals"): ("0.05/min in 1997, 0.10/min in 2000", "Isekenmeier, Nebel, Weigel"),
    ("legged-2001", "in_corner"): ('scuffles in the corner "occurred so often" (1999)', "UNSW's diary"),
    ("legged-2001", "goals_pushed_in"): ("the champions of 2000 ran the ball in", "UNSW's diary"),
}
STATISTICS = dict(statistics_by_name())  # by the name of a number in a match's line
RESTARTS = tuple(f"restarts_{phase.name.lower()}" for phase in figures.RESTARTS)
FOULS = tuple(figure.name for figure in figures.FIGURES if figure.name.startswith("fouls_"))
SHOWN: dict[str, tuple[str, tuple[str, ...]]] = {  # name -> words, and the statistics to add up
    "goals": ("goals of both teams", ("goals",)),
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


def measure_plausibility(ray: str | None = None) -> dict[str, Any]:
    """Play the pairings, perhaps on a Ray cluster, and return their rows."""
    rows = []
    for settings in plausibility_rows():
        result = evaluate(with_ray(settings, ray))
        rows.append(row_of(settings, result) | {"play": statistics_of_play(result)})
    return {"rows": rows}


def statistics_of_play(result: EvaluationResult) -> dict[str, list[Any]]:
    """Return value, low, high and unit of each statistic of the table, for both teams together."""
    lines = [line.statistics for line in result.lines]
    added = {
        name: [column for column, statistic in STATISTICS.items() if statistic.name in names]
        for name, (_, names) in SHOWN.items()
    }
    parts = sum_in_pairs([[sum(line[x] for x in columns) for columns in added.values()] for line in lines])
    firsts = [(columns[0], STATISTICS[columns[0]]) for columns in added.values()]
    wholes = sum_in_pairs([[line[divisor_name(*first)] for first in firsts] for line in lines])
    shown = {}
    for name, *numbers in zip(added, *ratio_bootstrap(parts, wholes), strict=True):
        timed = STATISTICS[added[name][0]].kind == figures.SHARE
        shown[name] = [*(finite_or_none((100.0 if timed else 60.0) * x) for x in numbers), "%" if timed else "/min"]
    return shown


def verdict(league: str, name: str, low: float | None, high: float | None) -> str:
    """Return "below" or "above" if the measured interval misses the published mean's, else "level"; "" without one."""
    known = PUBLISHED.get((league, name))
    if known is None or low is None or high is None:
        return ""
    _, least, most = known.rate
    return "below" if high < least else "above" if low > most else "level"


def plausibility_table(measured: dict[str, Any]) -> str:
    """Return the table in Markdown: a column for each pairing, then the published figures, then the commands."""
    rows = measured["rows"]
    head = ("", *(f"{row['home']} against {row['away']}, {row['league']}, {row['players']} a side" for row in rows))
    lines = [(words, *(cell_of(row, name) for row in rows)) for name, (words, _) in SHOWN.items()]
    known = [(*where, known.text, known.source) for where, known in PUBLISHED.items()]
    remarks = [(*where, *said) for where, said in REMARKS.items()]
    published = [(league, SHOWN[name][0], *said) for league, name, *said in known + remarks]
    commands = "\n".join(row["command"] for row in rows)
    tables = (table(head, lines), table(("league", "statistic", "published mean", "source"), published))
    return "\n\n".join((*tables, f"```bash\n{commands}\n```", ""))


def cell_of(row: dict[str, Any], name: str) -> str:
    """Return one statistic of a pairing, and its verdict beside the published mean."""
    value, low, high, unit = row["play"][name]
    return f"{total_in_words(Total(0.0, value, low, high, unit))} {verdict(row['league'], name, low, high)}".rstrip()
