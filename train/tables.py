"""The README's tables: measured by commands, kept as JSON beside this file, written between markers in README.md.

    python -m soccer_env.train.tables [NAME]     measure all tables, or one, anew and write both
    python -m soccer_env.train.tables --check    replay a small part of each and fail where it no longer agrees

The check plays the first pair of matches of every row again and compares score and final state; where versions or the
kind of machine differ from those of the table, play differs in its last bits, and it says so instead. For speed it
measures quickly and asks only that no ratio has grown beyond a factor.
"""

from __future__ import annotations

import json
import platform
import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any

from soccer_env.leagues import find_league
from soccer_env.train.bench import run as run_bench
from soccer_env.train.bench_settings import BenchSettings
from soccer_env.train.evaluate import contest_of, evaluate, play
from soccer_env.train.files import write_whole
from soccer_env.train.provenance import commit, version_of
from soccer_env.train.results import EvaluationResult
from soccer_env.train.settings import EvaluateSettings, command_of, conditions_of
from soccer_env.train.tables_claims import claims_table, measure_claims, measure_sensors, sensors_table

DATA = Path(__file__).with_name("tables.json")
README = Path(__file__).resolve().parents[1] / "README.md"
MATCHES = {"ideal": 200, "sensors": 100}
OPPONENTS = {  # by what fills the beliefs of both teams
    "ideal": ("still", "random", "chaser@0", "chaser@0.25", "chaser@0.5", "chaser@0.75"),
    "sensors": ("still", "random", "chaser@0", "chaser@0.5"),
}
LEAGUES = ("legged-2001", "middle-size-2006")
LIBRARIES = ("pymunk", "numba", "numpy")
SLOWER = 2.0  # factor by which a ratio may grow before the check fails; machines are noisy


def settings_of(league: str, away: str, senses: str) -> EvaluateSettings:
    """Return the evaluation behind one row."""
    matches = MATCHES[senses]
    return EvaluateSettings(
        league=league, home="chaser", away=away, senses=senses, matches=matches, players=3, seed=1, threads=2
    )


def measure_scripted() -> dict[str, Any]:
    """Measure the scripted teams against each other."""
    rows = []
    for league in LEAGUES:
        for senses, opponents in OPPONENTS.items():
            for away in opponents:
                settings = settings_of(league, away, senses)
                rows.append(row_of(settings, evaluate(settings)))
    return {"about": about(), "rows": rows}


def measure_speed(quick: bool = False) -> dict[str, Any]:
    """Measure the speed."""
    bench = run_bench(BenchSettings(quick=quick))
    command = "soccer bench --quick" if quick else "soccer bench"
    return {"about": about(), "command": command, "machine": bench["machine"], "rows": bench["rows"]}


MEASURE = {
    "sensors": lambda: {"about": about(), **measure_sensors()},
    "claims": lambda: {"about": about(), **measure_claims()},
    "scripted": measure_scripted,
    "speed": measure_speed,
}
SHOW = {  # a table in Markdown
    "sensors": lambda table: with_footer(sensors_table(table), table),
    "claims": lambda table: with_footer(claims_table(table), table),
    "scripted": lambda table: scripted_table(table),
    "speed": lambda table: speed_table(table),
}


def about() -> dict[str, str]:
    """Return what a table was made with."""
    import datetime

    versions = {name: version_of(name) for name in LIBRARIES}
    today = datetime.datetime.now(datetime.timezone.utc).date().isoformat()
    return {"date": today, "commit": commit(), "machine": machine(), **versions}


def machine() -> str:
    """Return the kind of machine, on which bits depend."""
    return f"{platform.system()} {platform.machine()}"


def row_of(settings: EvaluateSettings, result: EvaluationResult) -> dict[str, Any]:
    """Return what the table keeps of an evaluation."""
    first = [[line.goals_for, line.goals_against, line.state] for line in result.lines[:2]]
    return {
        "command": command_of(settings),
        "league": settings.league,
        "away": settings.away,
        "senses": settings.senses,
        "matches": settings.matches,
        "minutes": result.conditions.minutes,
        "settings_hash": result.lines[0].settings,
        "goals": [result.goals_for, result.goals_against],
        "goal_difference": asdict(result.goal_difference),
        "points": asdict(result.points),
        "first_pair": first,
    }


def scripted_table(table: dict[str, Any]) -> str:
    """Return the table of the scripted teams in Markdown."""
    lines = [
        "| league | senses | chaser against | matches | points | goal difference a match | goals a minute | settings |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for row in table["rows"]:
        minutes = row["matches"] * row["minutes"]
        points, difference = row["points"], row["goal_difference"]
        lines.append(
            f"| {row['league']} | {row['senses']} | {row['away']} | {row['matches']} "
            f"| {100 * points['mean']:.1f} % ({100 * points['low']:.1f} to {100 * points['high']:.1f}) "
            f"| {difference['mean']:+.2f} ({difference['low']:+.2f} to {difference['high']:+.2f}) "
            f"| {row['goals'][0] / minutes:.2f} : {row['goals'][1] / minutes:.2f} | `{row['settings_hash']}` |"
        )
    return "\n".join([*lines, "", f"Command of a row: `{table['rows'][0]['command']}`", footer(table["about"])])


def speed_table(table: dict[str, Any]) -> str:
    """Return the table of speeds in Markdown."""
    lines = ["| | measured | target |", "|---|---|---|"]
    for row in table["rows"]:
        missed = {False: " (missed)", True: "", None: ""}[row["met"]]
        lines.append(f"| {row['name']} | {row['text']}{missed} | {row['target']} |")
    host = table["machine"]
    where = f"{host['processor']}, {host['cores']} cores, load before {host['load before']}, Python {host['python']}"
    return "\n".join([*lines, "", f"Command: `{table['command']}`. {where}.", footer(table["about"])])


def with_footer(text: str, table: dict[str, Any]) -> str:
    """Return a table with the line under it."""
    return f"{text}\n{footer(table['about'])}"


def footer(facts: dict[str, str]) -> str:
    """Return the line under a table."""
    return "Made by `make tables`: " + ", ".join(f"{name} {value}" for name, value in facts.items()) + "."


def with_tables(readme: str, data: dict[str, Any]) -> str:
    """Return the README with the tables between their markers; ValueError for a marker that is missing."""
    for name, show in SHOW.items():
        if name not in data:
            continue
        text = show(data[name])
        begin, end = f"<!-- table: {name} -->", f"<!-- end of table: {name} -->"
        before, found, rest = readme.partition(begin)
        _, closed, after = rest.partition(end)
        if not found or not closed:
            raise ValueError(f"README.md lacks the markers of table {name}")
        readme = f"{before}{begin}\n{text}\n{end}{after}"
    return readme


def check(data: dict[str, Any], quick: bool = False) -> list[str]:
    """Return one sentence for each table, or part of it, that no longer agrees; `quick` leaves out the speed."""
    problems = []
    if with_tables(README.read_text(encoding="utf-8"), data) != README.read_text(encoding="utf-8"):
        problems.append("README.md does not show what tables.json holds: run make tables")
    made, now = data["scripted"]["about"], about()
    if all(made[name] == now[name] for name in (*LIBRARIES, "machine")):
        problems += [problem for row in data["scripted"]["rows"] for problem in replay_row(row)]
    else:
        print("tables: versions or machine differ from those of the table; matches are not compared", file=sys.stderr)
    return problems if quick else problems + slower_rows(data["speed"])


def replay_row(row: dict[str, Any]) -> list[str]:
    """Play the first pair of a row again; return what differs."""
    settings = settings_of(row["league"], row["away"], row["senses"])
    league = find_league(settings.league)
    contest = contest_of(conditions_of(settings, league), league, {})
    from soccer_env.random_numbers import seeds_for

    seeds = seeds_for(settings.seed, 1).tolist()
    found = []
    for number in (0, 1):
        (line,) = play(contest, [number], seeds, "", 1, lambda steps: None)
        found.append([line.goals_for, line.goals_against, line.state])
    if found == row["first_pair"]:
        return []
    return [f"{row['command']}: the first pair now ends {found}, the table has {row['first_pair']}"]


def slower_rows(table: dict[str, Any]) -> list[str]:
    """Measure quickly; return the ratios to the bare physics that have grown beyond the allowed factor."""
    before = {
        row["name"]: row["value"] for row in table["rows"] if " over " in row["name"] and "threads" not in row["name"]
    }
    now = {row["name"]: row["value"] for row in run_bench(BenchSettings(quick=True))["rows"]}
    return [
        f"{name}: {now[name]:.2f} now, {value:.2f} in the table"
        for name, value in before.items()
        if now[name] > SLOWER * value
    ]


def main(arguments: list[str]) -> int:
    """Measure and write the tables, or check them; return the exit code."""
    names = [name for name in arguments if name in MEASURE]
    if arguments not in (names, ["--check"], ["--check", "--quick"]):
        print(f"usage: python -m soccer_env.train.tables [{'|'.join(MEASURE)}] [--check [--quick]]", file=sys.stderr)
        return 2
    if arguments == names:
        data = json.loads(DATA.read_text(encoding="utf-8")) if names else {}
        data |= {name: MEASURE[name]() for name in names or MEASURE}
        write_whole(DATA, json.dumps(data, indent=1) + "\n")
        write_whole(README, with_tables(README.read_text(encoding="utf-8"), data))
        return 0
    problems = check(json.loads(DATA.read_text(encoding="utf-8")), quick="--quick" in arguments)
    for problem in problems:
        print(problem, file=sys.stderr)
    print("tables: " + ("all agree" if not problems else f"{len(problems)} no longer agree"))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
