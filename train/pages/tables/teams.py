"""The tables of teams against teams: their evaluations, and the replay of a row."""

from collections.abc import Iterator, Mapping
from dataclasses import asdict, replace
from threading import Event
from typing import Any

from soccer_env.leagues import find_league
from soccer_env.train.evaluate.contest import contest_of, play
from soccer_env.train.evaluate.evaluation import evaluate
from soccer_env.train.evaluate.results import EvaluationResult
from soccer_env.train.evaluate.settings import EvaluateSettings, command_of, conditions_of
from soccer_env.train.written_settings import with_ray

SEED, PLAYERS, MINUTES = 1, 3, 4.0  # of a match
MATCHES = {"ideal": 200, "sensors": 100}
OPPONENTS = {  # of the chaser, by the senses of both teams
    "ideal": ("still", "random", "chaser@0", "chaser@0.25", "chaser@0.5", "chaser@0.75"),
    "sensors": ("still", "random", "chaser@0", "chaser@0.5"),
}
LEAGUES = ("legged-2001", "middle-size-2006")
SACKS_MATCHES = 200
SACKS = (  # home, against the chaser
    "sacks-2001@0", "sacks-2001@0.25", "sacks-2001@0.5", "sacks-2001@0.75", "sacks-2001-tuned", "sacks-2001-future",
)  # fmt: skip
WITHOUT = ("recovery=False", "avoidance=False", "recovery=False,avoidance=False")  # avoidance: dribbling as well
HEINEMANN = (  # players a side, home, away, matches; a team without one of its ideas is a team as well
    (3, "heinemann-2006", "chaser", 200),
    *((3, f"heinemann-2006@{strength}", "chaser", 100) for strength in ("0", "0.25", "0.5", "0.75")),
    (5, "heinemann-2006", "chaser", 200), (5, "weigel-2001", "chaser", 100), (5, "heinemann-2006", "weigel-2001", 200),
    (5, "heinemann-2006", "heinemann-2006:keeper=passive", 200),
    (5, "heinemann-2006", "heinemann-2006:planner=none", 100),
)  # fmt: skip

PASSES = "passes a minute"  # completed, of both teams: a column of the middle size
MEASURED = ("points", "goal difference a match")  # columns of `measured_cells`


def scripted_rows() -> Iterator[EvaluateSettings]:
    """Yield the settings of the evaluations of the chaser."""
    for league in LEAGUES:
        for senses, opponents in OPPONENTS.items():
            for away in opponents:
                yield row_settings(league, "chaser", away, senses, MATCHES[senses], MINUTES)


def sacks_rows() -> Iterator[EvaluateSettings]:
    """Yield the evaluations of sacks-2001: against the chaser, itself without one mechanism, and its variants."""
    opponents = ("chaser", *(f"sacks-2001:{off}" for off in WITHOUT))
    pairs = [("sacks-2001", away, 2 * SACKS_MATCHES) for away in opponents]
    pairs += [(home, "chaser", SACKS_MATCHES) for home in SACKS]
    pairs += [(home, "sacks-2001", SACKS_MATCHES) for home in ("sacks-2001-tuned", "sacks-2001-future")]
    for home, away, matches in pairs:
        yield row_settings("legged-2001", home, away, "sensors", matches, MINUTES)


def heinemann_rows() -> Iterator[EvaluateSettings]:
    """Yield the evaluations of the teams of 2006 with sensors: against the chaser, and without one mechanism."""
    for players, home, away, matches in HEINEMANN:
        yield row_settings("middle-size-2006", home, away, "sensors", matches, MINUTES, players)


def row_settings(
    league: str, home: str, away: str, senses: str, matches: int, minutes: float | None = None,
    players: int | str = PLAYERS, seed: int = SEED,
) -> EvaluateSettings:  # fmt: skip
    """Return the settings of the evaluation behind one row."""
    return EvaluateSettings(
        league=league, home=home, away=away, senses=senses, matches=matches, minutes=minutes, players=players,
        seed=seed, threads=2,
    )  # fmt: skip


def measure_rows(evaluations: Iterator[EvaluateSettings], ray: str | None = None) -> dict[str, Any]:
    """Play evaluations, on the Ray cluster at an address if one is given, and return their rows."""
    return {"rows": [row_of(settings, evaluate(with_ray(settings, ray))) for settings in evaluations]}


def row_of(settings: EvaluateSettings, result: EvaluationResult) -> dict[str, Any]:
    """Return the row of a table for an evaluation."""
    names = ("league", "home", "away", "senses", "players", "seed", "matches")
    return {
        "command": command_of(settings),
        **{name: getattr(settings, name) for name in names},
        "asked_minutes": settings.minutes,
        "minutes": result.conditions.minutes,
        "settings_hash": result.lines[0].settings,
        "goals": [result.goals_for, result.goals_against],
        "goal_difference": asdict(result.goal_difference),
        "points": asdict(result.points),
        "passes": [result.statistics[f"passes_{side}"].value for side in ("for", "against")],
        "first_pair": [[line.goals_for, line.goals_against, line.state] for line in result.lines[:2]],
    }


def replay_row(row: dict[str, Any]) -> list[str]:
    """Play the first pair of a row again; return a sentence if its scores or final states differ."""
    again = first_pair(row)
    if again == row["first_pair"]:
        return []
    return [f"{row['command']}: the first pair now ends {again}, the table has {row['first_pair']}"]


def first_pair(row: dict[str, Any]) -> list[list[Any]]:
    """Play the first pair of a row again; return goals for, goals against and the final state of both matches."""
    names = ("league", "home", "away", "senses", "matches", "asked_minutes", "players", "seed")
    settings = row_settings(*(row[name] for name in names))
    more = {name: row.get(name, getattr(settings, name)) for name in ("rules", "pose", "variation")}
    settings = replace(settings, **more)
    league = find_league(settings.league)
    contest = contest_of(conditions_of(settings, league), league, {})
    results = []
    for number in (0, 1):
        (line,) = play(contest, [number], "", 1, lambda steps: None, Event())
        results.append([line.goals_for, line.goals_against, line.state])
    return results


def scripted_table(table: dict[str, Any]) -> str:
    """Return the table of the chaser in Markdown: a row for each opponent, a column for each league and its senses."""
    rows = table["rows"]
    cells = {(f"`{row['away']}`", f"{row['league']}, {row['senses']}"): result_of(row) for row in rows}
    lengths = dict.fromkeys((row["league"], row["senses"], row["matches"], row["minutes"]) for row in rows)
    matches = ", ".join(f"{count} matches of {minutes:g} minutes" for _, _, count, minutes in lengths)
    shown = f"Goal difference a match, its interval, share of points.\nColumns: {matches}."
    return "\n\n".join([crosstable("against", cells), f"{shown}\nCommand of a cell: `{rows[0]['command']}`"])


def result_of(row: dict[str, Any]) -> str:
    """Return the goal difference of a row with its interval, and its share of points, in words."""
    return f"{goals_of(row)}, {100 * row['points']['mean']:.0f} %"


def sacks_table(table: dict[str, Any]) -> str:
    """Return the table of sacks-2001 in Markdown."""
    return table_with_command({"team": "team", "against": "away", "matches": "matches"}, table["rows"])


def heinemann_table(table: dict[str, Any]) -> str:
    """Return the table of the teams of 2006 in Markdown."""
    names = {"team": "team", "against": "away", "players": "sizes", "matches": "matches", PASSES: "passed"}
    passed = [" : ".join(f"{passes:.2f}" for passes in row["passes"]) for row in table["rows"]]
    sizes = [f"{row['players']}v{row['players']}" for row in table["rows"]]
    rows = [row | {"sizes": size, "passed": both} for row, size, both in zip(table["rows"], sizes, passed, strict=True)]
    return table_with_command(names, rows)


def table_with_command(names: dict[str, str], rows: list[dict[str, Any]]) -> str:
    """Return evaluations as a table in Markdown: the columns `names` (title: key), then MEASURED, and one command.

    The key "team" stands for the home team.
    """
    rows = [row | {"team": f"`{row['home']}`"} for row in rows]
    head = [*names, *MEASURED]
    lines = [f"| {' | '.join(head)} |", "|" + "---|" * len(head)]
    lines += [f"| {' | '.join(str(row[name]) for name in names.values())} | {measured_cells(row)} |" for row in rows]
    return "\n".join([*lines, "", f"Command of a row: `{rows[0]['command']}`"])


def measured_cells(row: dict[str, Any]) -> str:
    """Return the two last cells of a row: share of points and goal difference, with intervals."""
    points = row["points"]
    return f"{100 * points['mean']:.1f} % ({100 * points['low']:.1f} to {100 * points['high']:.1f}) | {goals_of(row)}"


Cells = Mapping[tuple[str, str], str]  # by the names of row and column


def crosstable(corner: str, cells: Cells) -> str:
    """Return the table of `cells`, by (row, column): both in order of first appearance, with "-" for missing cells."""
    rows = dict.fromkeys(row for row, _ in cells)
    columns = dict.fromkeys(column for _, column in cells)
    lines = [f"| {corner} | {' | '.join(columns)} |", "|" + "---|" * (len(columns) + 1)]
    for row in rows:
        lines.append(f"| {row} | {' | '.join(cells.get((row, column), '-') for column in columns)} |")
    return "\n".join(lines)


def goals_of(row: Mapping[str, Any]) -> str:
    """Return the goal difference a match of an evaluation, with its interval, in words."""
    goals = row["goal_difference"]
    return f"{goals['mean']:+.2f} ({goals['low']:+.2f} to {goals['high']:+.2f})"
