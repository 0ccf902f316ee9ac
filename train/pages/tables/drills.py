"""The table of teams over drills: how often each succeeds, by its sensors."""

from collections.abc import Iterator
from typing import Any

from soccer_env.leagues import find_league
from soccer_env.scenes import SCENES, Scene
from soccer_env.train.evaluate.drills import SEED, run_drill
from soccer_env.train.statistics import wilson_interval

RUNS = 400  # 400 runs of a share of a half: +-5 %
FIXED = ("still", "random", "walker")
TEAMS = {
    "legged-2001": (*FIXED, "chaser", "sacks-2001", "sacks-2001-tuned", "sacks-2001-future", "learned"),
    "middle-size-2006": (*FIXED, "chaser", "weigel-2001", "heinemann-2006"),
}


def drills_of(league: str) -> Iterator[Scene]:
    """Yield the drills that are for a league."""
    family = find_league(league).family
    for scene in SCENES.values():
        if scene.success != "none" and (not scene.families or family in scene.families):
            yield scene


def measure_drills() -> dict[str, Any]:
    """Let every team play every drill of its league."""
    rows = [
        {"league": league, "drill": scene.name, "rules": scene.rules, "team": team, "runs": RUNS,
         "successes": run_drill(league, scene, team, RUNS)}
        for league, teams in TEAMS.items()
        for scene in drills_of(league)
        for team in teams
    ]  # fmt: skip
    return {"seed": SEED, "rows": rows}


def drills_table(table: dict[str, Any]) -> str:
    """Return the shares of success in Markdown: a row a drill, a column a team."""
    teams = list(dict.fromkeys(row["team"] for row in table["rows"]))
    found = {(row["league"], row["drill"], row["team"]): row for row in table["rows"]}
    rules = {(row["league"], row["drill"]): row["rules"] for row in table["rows"]}
    head = ["league", "drill", "rules", *(f"`{team}`" for team in teams)]
    lines = [f"| {' | '.join(head)} |", "|" + "---|" * len(head)]
    for (league, drill), name in rules.items():
        shares = [share_of(found.get((league, drill, team))) for team in teams]
        lines.append(f"| {' | '.join([league, f'`{drill}`', f'`{name}`', *shares])} |")
    runs = table["rows"][0]["runs"]
    return "\n".join([*lines, "", f"{runs} runs each by sensors, seed {table['seed']}, 95 % intervals by Wilson."])


def share_of(row: dict[str, Any] | None) -> str:
    """Return how often a team succeeds, in percent, with the interval."""
    if row is None:
        return "-"
    share, low, high = wilson_interval(row["successes"], row["runs"])
    return f"{100 * share:.0f} % ({100 * low:.0f} to {100 * high:.0f})"
