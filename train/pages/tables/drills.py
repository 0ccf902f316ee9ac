"""The table of teams and drills: each team's share of successful runs, with sensors."""

from dataclasses import asdict
from typing import Any

from soccer_env.train.evaluate.drills import SEED, evaluate_drills
from soccer_env.train.evaluate.settings import ALL, EvaluateSettings
from soccer_env.train.pages.tables.teams import crosstable
from soccer_env.train.statistics import wilson_interval
from soccer_env.train.written_settings import with_ray

RUNS = 200  # the interval of a share of 50 % is then +-7 %
FIXED = ("still", "walker")
TEAMS = {
    "legged-2001": (*FIXED, "chaser", "sacks-2001", "sacks-2001-tuned", "learned"),
    "middle-size-2006": (*FIXED, "chaser", "weigel-2001", "heinemann-2006", "learned-2006"),
}


def measure_drills(ray: str | None = None) -> dict[str, Any]:
    """Let every team play every drill of its league, perhaps on a Ray cluster."""
    asked = [
        EvaluateSettings(
            league=league, scene=ALL, home=",".join(teams), matches=RUNS, seed=SEED, threads=2, pose="percept"
        )
        for league, teams in TEAMS.items()
    ]
    rows = [asdict(result) for settings in asked for result in evaluate_drills(with_ray(settings, ray))]
    return {"seed": SEED, "starts": "held-out", "rows": rows}


def drills_table(table: dict[str, Any]) -> str:
    """Return the shares of success [%] in Markdown: a table per league, with a row per drill and a column per team."""
    rows = table["rows"]
    parts = []
    for league in dict.fromkeys(row["league"] for row in rows):
        shares = {
            (f"`{row['drill']}`", f"`{row['team']}`"): f"{100 * row['successes'] / row['runs']:.0f}"
            for row in rows
            if row["league"] == league
        }
        parts.append(crosstable(f"{league} [%]", shares))
    widest = max(half_width(row) for row in rows)
    starts = f" from {table['starts']} starts" if "starts" in table else ""
    runs = f"{rows[0]['runs']} runs each{starts} by sensors, seed {table['seed']}"
    return "\n\n".join([*parts, f"{runs}; 95 % intervals (Wilson) are at most {widest:.0f} points to either side."])


def half_width(row: dict[str, Any]) -> float:
    """Return the longer half of a share's interval [%]."""
    share, low, high = wilson_interval(row["successes"], row["runs"])
    return 100 * max(share - low, high - share)
