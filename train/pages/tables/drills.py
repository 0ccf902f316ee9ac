"""The table of teams over drills: how often each succeeds, by its sensors."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.match import Match
from soccer_env.scenes import SCENES, Scene, find_scene
from soccer_env.train.casting import controllers_of, sizes_of
from soccer_env.train.statistics import wilson_interval

SEED, RUNS = 1, 400  # 400 runs of a share of a half: +-5 %
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


def run_drill(league: str, scene: str | Scene, team: str, runs: int, seed: int = SEED, threads: int = 2) -> int:
    """Play a drill by sensors under its own rules; return how many runs succeed."""
    scene = find_scene(scene)
    home, away = sizes_of(scene)
    match = Match(
        league, home=home, away=away, matches=runs, seed=seed, threads=threads, scene=scene, episode="drill",
        controllers=controllers_of(scene, team), senses="sensors",
    )  # fmt: skip
    succeeded = np.zeros(runs, bool)
    while not (match.terminated | match.truncated).all():
        match.step()
        succeeded |= match.events["drill"] == 1
    match.close()
    return int(succeeded.sum())


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
