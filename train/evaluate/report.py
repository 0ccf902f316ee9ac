"""The report of an evaluation in Markdown and its terminal tables, computed from the result alone."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from math import isfinite
from typing import TYPE_CHECKING

import numpy as np

from soccer_env.train.evaluate.map_pictures import map_rows, pass_rows
from soccer_env.train.evaluate.results import HALF_WIDTH, EvaluationResult
from soccer_env.train.evaluate.statistics import goal_rows, play_rows
from soccer_env.train.statistics import interquartile_mean, wilson_interval

if TYPE_CHECKING:
    from rich.table import Table

    from soccer_env.train.evaluate.drills import DrillResult

PAIRS_SHOWN = 100
VERDICTS = {
    "beats clearly": "{home} beats {away} clearly.",
    "beats": "{home} beats {away}.",
    "loses": "{home} loses to {away}.",
    "loses clearly": "{home} loses clearly to {away}.",
    "no difference shown": "No difference between {home} and {away} is shown.",
}


def verdict_sentence(result: EvaluationResult, shown: Callable[[str], str] = str) -> str:
    """Return the verdict of an evaluation as a sentence; `shown` formats the teams' names."""
    text = VERDICTS.get(result.verdict, "There is {verdict}.")
    home, away = shown(result.conditions.home), shown(result.conditions.away)
    return text.format(home=home, away=away, verdict=result.verdict)


def rows(result: EvaluationResult) -> list[tuple[str, str, str]]:
    """Return the main numbers of a result as rows of name, value and 95 % interval."""
    conditions = result.conditions
    matches, minutes = conditions.matches, conditions.matches * conditions.minutes
    difference = result.goal_difference
    points = result.points
    rate = result.win_rate
    _, low, high = wilson_interval(result.wins, matches)
    middle = interquartile_mean([line.goals_for - line.goals_against for line in result.lines])
    return [
        ("matches", f"{matches}", "a seed each" if conditions.self_play else f"{matches // 2} pairs, sides swapped"),
        ("won, drawn, lost", f"{result.wins}, {result.draws}, {result.losses}", ""),
        (
            "goals",
            f"{result.goals_for} : {result.goals_against}",
            f"{result.goals_for / minutes:.2f} : {result.goals_against / minutes:.2f} a minute",
        ),
        ("goal difference a match", f"{difference.mean:+.2f}", f"{difference.low:+.2f} to {difference.high:+.2f}"),
        ("its interquartile mean", f"{middle:+.2f}", ""),
        ("points (a draw is half)", percent(points.mean), f"{percent(points.low)} to {percent(points.high)}"),
        ("win rate", percent(rate.mean), f"{percent(rate.low)} to {percent(rate.high)}"),
        ("win rate, Wilson", percent(rate.mean), f"{percent(low)} to {percent(high)}"),
    ]


def percent(share: float) -> str:
    """Return a share (0 to 1) as a percentage."""
    return f"{100 * share:.1f} %"


def markdown(result: EvaluationResult, about: dict[str, str]) -> str:
    """Return the report in Markdown; `about`: command, date and commit of the evaluation."""
    home, away = escape_text(result.conditions.home), escape_text(result.conditions.away)
    head, pairs, rest = pair_rows(result)
    command = about.get("command", "")
    fence = "`" * max(3, 1 + max(map(len, re.findall("`+", command)), default=0))  # longer than any in it
    lines = [
        f"# {home} against {away}",
        f"{verdict_sentence(result, escape_text)} Results are {home}'s; intervals are 95 % bootstraps over pairs.",
        table(("", "value", "95 % interval"), rows(result)),
        needed_matches_sentence(result),
        *statistics_tables(result),
        "## Conditions",
        table(("", ""), [(escape_text(name), escape_text(value)) for name, value in conditions_rows(result, about)]),
        "This command plays what is missing and writes this report again:",
        f"{fence}bash\n{command}\n{fence}",
        "## Matches",
        "Goals of the home team first." if result.conditions.self_play else f"Goals of {home} first.",
        table(head, pairs),
        rest,
    ]
    return "\n\n".join(line for line in lines if line) + "\n"


def conditions_rows(result: EvaluationResult, about: dict[str, str]) -> list[tuple[str, str]]:
    """Return rows (name, value) of the conditions, versions and hashes of the matches."""
    conditions = result.conditions
    return [
        ("league", conditions.league),
        ("players", conditions.sizes),
        ("minutes of play", f"{conditions.minutes:g}"),
        ("senses, pose", f"{conditions.senses_text}, {conditions.pose}"),
        *((f"{name} was trained with", setting) for name, setting in result.trained.items()),
        ("scene, rules, placement", f"{conditions.scene}, {conditions.rules}, {conditions.placement}"),
        *([("variation", conditions.variation)] if conditions.variation else []),
        ("seed", f"{conditions.seed}"),
        ("begun, commit", f"{about.get('date', '')}, {about.get('commit') or 'none'}"),
        ("settings hash", result.lines[0].settings),
        *((name.replace("_", " "), value) for name, value in result.made_with.items()),
    ]


def needed_matches_sentence(result: EvaluationResult) -> str:
    """Return a sentence with the number of matches needed for an interval of +- HALF_WIDTH."""
    if result.matches_needed is None:
        return ""
    return (
        f"For an interval of ±{HALF_WIDTH:g} goals a match, {result.matches_needed} matches are needed "
        f"if further ones scatter as these do."
    )


def statistics_tables(result: EvaluationResult) -> list[str]:
    """Return the tables of statistics and of goals in Markdown; none if the result lines have no statistics."""
    if not result.statistics:
        return []
    head = ("", escape_text(result.conditions.home), escape_text(result.conditions.away))
    return [
        "## Play",
        "One value is of both teams together. `soccer list statistics` says what each of them is; result.json has all.",
        table(head, play_rows(result.statistics)),
        "How goals fell:",
        table(head, goal_rows(result.statistics)),
        *map_tables_markdown(result, head),
    ]


def map_tables_markdown(result: EvaluationResult, head: tuple[str, ...]) -> list[str]:
    """Return the tables of maps in Markdown; none if the result lines have no maps."""
    if not result.maps:
        return []
    return [
        "Where it happened; the middle of three thirds is a third of the pitch's length:",
        table(head, map_rows(result.maps)),
        "Completed passes; players are numbered from 0, the goalkeeper:",
        table(("from, to", *head[1:]), pass_rows(result.maps)),
        "`soccer export result.json --maps --out maps.png` draws heat maps, pass networks and shot maps.",
    ]


def pair_rows(result: EvaluationResult) -> tuple[tuple[str, ...], list[tuple[str, ...]], str]:
    """Return the head of the table of pairs, a row for each of the first PAIRS_SHOWN, a sentence on those left out."""
    both = list(zip(result.lines[::2], result.lines[1::2], strict=True))
    cells = [
        (
            f"{pair[0].pair}",
            ", ".join(dict.fromkeys(f"{line.seed}" for line in pair)),  # two in self-play
            *(f"{line.goals_for} : {line.goals_against}" for line in pair),
        )
        for pair in both[:PAIRS_SHOWN]
    ]
    rest = len(both) - len(cells)
    scores = ("first match", "second match") if result.conditions.self_play else ("as home", "as away")
    return ("pair", "seed", *scores), cells, f"{rest} more pairs stand in matches.jsonl." if rest else ""


def escape_text(text: str) -> str:
    """Escape a team's name for Markdown and HTML, because policy files of strangers may have malicious names."""
    return re.sub(r"([\\`*\[\]<>&#~]|\b_|_\b)", r"\\\1", " ".join(text.split()))


def table(head: tuple[str, ...], cells: Sequence[tuple[str, ...]]) -> str:
    """Return a Markdown table with the header `head` and the rows `cells`."""
    ruled = [head, ("---",) * len(head), *cells]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in ruled)


def plain_number(value: float, digits: int) -> str:
    """Return a number with `digits` significant digits and no exponent; larger numbers as integers."""
    if abs(value) >= 10**digits or not isfinite(value):
        return f"{value:.0f}"
    return np.format_float_positional(value, precision=digits, unique=False, fractional=False, trim="-")


def screen_tables(result: EvaluationResult) -> Iterator[Table]:
    """Yield tables for the terminal: the numbers of a result, statistics of play, and kinds of goals."""
    from rich.table import Table

    conditions, statistics = result.conditions, result.statistics
    title = (
        f"{conditions.home} against {conditions.away}, {conditions.league}, {conditions.sizes}, "
        f"{conditions.minutes:g} min"
    )
    trained = [f"{name} was trained with {setting}." for name, setting in result.trained.items()]
    parts = [(title, " ".join([verdict_sentence(result), *trained]), ("value", "95 % interval"), rows(result))]
    if statistics:
        teams = (conditions.home, conditions.away)
        parts += [("Play", "", teams, play_rows(statistics)), ("How goals fell", "", teams, goal_rows(statistics))]
    for title, caption, heads, cells in parts:
        drawn = Table(title=title, caption=caption or None)
        drawn.add_column("")
        for head in heads:
            drawn.add_column(head, justify="right")
        for row in cells:
            drawn.add_row(*row)
        yield drawn


def table_of_drills(results: Sequence[DrillResult]) -> Table:
    """Return the table for the terminal: a row for each drill, a column for each team."""
    from rich.table import Table

    first = results[0]
    title = f"{first.league}: successes [%] in {first.runs} runs each from held-out starts, 95 % intervals (Wilson)"
    names = list(dict.fromkeys(result.team for result in results))
    drawn = Table("drill", title=title)
    for name in names:
        drawn.add_column(name, justify="right")
    shares = ["{:.0f} ({:.0f} to {:.0f})".format(*(100.0 * end for end in result.share)) for result in results]
    for row in range(0, len(results), len(names)):
        drawn.add_row(results[row].drill, *shares[row : row + len(names)])
    return drawn
