"""The table of robustness: every team against the chaser while noise, delay or friction are others, for both sides."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from soccer_env.leagues import find_league
from soccer_env.match.variation import names_of
from soccer_env.train.evaluate.evaluation import evaluate
from soccer_env.train.evaluate.settings import EvaluateSettings
from soccer_env.train.pages.tables.teams import crosstable, result_of, row_of, row_settings
from soccer_env.train.written_settings import with_ray

TEAMS = {
    "legged-2001": ("chaser", "sacks-2001", "sacks-2001-tuned", "sacks-2001-future", "learned"),
    "middle-size-2006": ("chaser", "weigel-2001", "heinemann-2006", "learned-2006"),
}
MATCHES, MINUTES = 40, 4.0
CONDITIONS = {  # ends of the names of numbers, and their factor; of faults the rate itself
    "as the league says": ((), 1.0),
    "noise x 3": (("_noise", "dither", "scale_error"), 3.0),
    "misses x 4": (("_miss", "_loss", "false_balls"), 4.0),
    "delay x 2": (("drive.delay",), 2.0),
    "slippery carpet: friction x 0.5": (("ball.rolling", "ball.sliding", "traction"), 0.5),
    "rough carpet: friction x 2": (("ball.rolling", "ball.sliding", "traction"), 2.0),
    "a dropout a minute": (("faults.dropouts",), 1.0),
}


def robustness_rows() -> Iterator[tuple[str, EvaluateSettings]]:
    """Yield the name of a condition and the settings of an evaluation, for each league, team and condition."""
    for league, teams in TEAMS.items():
        for team in teams:
            for name in CONDITIONS:
                settings = row_settings(league, team, "chaser", "sensors", MATCHES, MINUTES)
                yield name, replace(settings, pose="particles", variation=variation_of(league, name))


def variation_of(league: str, condition: str) -> str:
    """Return a condition as the setting `variation` of a league."""
    ends, factor = CONDITIONS[condition]
    return ",".join(f"{name}={factor:g}" for name in names_of(find_league(league)) if name.endswith(ends))


def measure_robustness(ray: str | None = None) -> dict[str, Any]:
    """Play every team against the chaser under each condition, perhaps on a Ray cluster."""
    rows = []
    for name, settings in robustness_rows():
        more = {"condition": name, "variation": settings.variation, "rules": settings.rules, "pose": settings.pose}
        rows.append(row_of(settings, evaluate(with_ray(settings, ray))) | more)
    return {"rows": rows}


def robustness_table(table: dict[str, Any]) -> str:
    """Return the table in Markdown: a row for each condition, a column for each team; a table for each league."""
    parts = []
    for league in dict.fromkeys(row["league"] for row in table["rows"]):
        rows = [row for row in table["rows"] if row["league"] == league]
        parts.append(crosstable(league, {(row["condition"], f"`{row['home']}`"): result_of(row) for row in rows}))
        noisy = next(row for row in rows if row["condition"].startswith("noise"))
        parts.append(f"Command of a cell: `{noisy['command']}`")
    shown = (
        f"Goal difference a match against `chaser`, its interval, share of points: {MATCHES} matches of {MINUTES:g} "
        "minutes a cell. Both teams play under the condition."
    )
    return "\n\n".join([*parts, shown])
