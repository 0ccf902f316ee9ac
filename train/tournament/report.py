"""The result of a tournament as a page for the browser, and as terminal tables."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from soccer_env.train.evaluate.report import percent
from soccer_env.train.evaluate.results import Estimate
from soccer_env.train.report import MISSING, ReportPage, can_draw
from soccer_env.train.report.charts import draw_heat_table
from soccer_env.train.tournament.results import Pairing, TournamentResult

if TYPE_CHECKING:
    from rich.table import Table

HEAD = ("", "team", "points", "won, drawn, lost", "goals", "openskill", "Elo")
ABOUT_RATINGS = (
    "A win is 1 point, a draw 0.5. Brackets are 95 % intervals: of Elo by a bootstrap over pairs of matches, of "
    "openskill by its own model. The Elo ratings fit all matches at once, with a mean of 1500."
)
FEW = "There are fewer than 10 matches in a pairing: the intervals say little."
SHOWN = 0.975  # probability from which one team counts as above another: a 95 % interval leaves as much beyond
CROSS = "Goals a match of the team in the row, less those of the team in the column, and its share of the points."
ABOVE = (
    "The probability that the Elo rating of the team in the row is above that of the team in the column; it follows "
    "from the matches against all teams, not from those of the two alone."
)
Rows = list[tuple[str, ...]]


def standing_rows(result: TournamentResult) -> Rows:
    """Return a row of HEAD for each team, the best first."""
    return [
        (
            f"{place}", one.team, f"{one.points:g} of {one.matches}", f"{one.wins}, {one.draws}, {one.losses}",
            f"{one.goals_for} : {one.goals_against}", with_interval(one.openskill, "{:.1f}"),
            with_interval(one.elo, "{:.0f}"),
        )
        for place, one in enumerate(result.standings, 1)
    ]  # fmt: skip


def with_interval(one: Estimate, form: str) -> str:
    """Return an estimate with its interval in brackets."""
    return f"{form.format(one.mean)} ({form.format(one.low)} to {form.format(one.high)})"


def differences(result: TournamentResult) -> dict[tuple[str, str], tuple[Estimate, Estimate]]:
    """Return goal difference and points of each pairing by the names of its teams, seen from either."""
    names, found = result.conditions["teams"], {}
    for pairing in result.pairings:
        first, second, (goals, points) = names[pairing.first], names[pairing.second], estimates(pairing)
        found[first, second] = goals, points
        found[second, first] = (
            Estimate(0.0 - goals.mean, 0.0 - goals.high, 0.0 - goals.low),  # without -0.00
            Estimate(1.0 - points.mean, 1.0 - points.high, 1.0 - points.low),
        )
    return found


def estimates(pairing: Pairing) -> tuple[Estimate, Estimate]:
    """Return goal difference and points of the first team of a pairing."""
    return pairing.result.goal_difference, pairing.result.points


def cross_rows(result: TournamentResult) -> Rows:
    """Return the cross table: a row and a column for each team, the best first."""
    found = differences(result)
    return [(row, *(cross_cell(found.get((row, column))) for column in result.names)) for row in result.names]


def cross_cell(found: tuple[Estimate, Estimate] | None) -> str:
    """Return a cell of the cross table; "-" for teams that did not meet."""
    return "-" if found is None else f"{with_interval(found[0], '{:+.2f}')}, {100 * found[1].mean:.0f} %"


def above_rows(result: TournamentResult) -> Rows:
    """Return the table of who is above whom."""
    return [
        (row, *("-" if row == column else percent(result.above[row][column]) for column in result.names))
        for row in result.names
    ]


def verdict(result: TournamentResult) -> str:
    """Return a sentence on which team is the best, and how surely."""
    best, *others = result.names
    rival = min(others, key=result.above[best].__getitem__)
    sure = result.above[best][rival]
    above = f"{best} is above {rival} with a probability of {percent(sure)}"
    return f"{above}, and so the best." if sure >= SHOWN else f"No team is shown to be the best: {above}."


def needed_matches_sentence(result: TournamentResult) -> str:
    """Return a sentence with the number of matches that the wanted interval takes."""
    few = f" {FEW}" if result.few else ""
    if result.matches_needed is None:
        return few.strip()
    return (
        f"For Elo intervals of ±{result.half_width:g}, {result.matches_needed} matches a pairing are needed if further "
        f"ones scatter as these {result.conditions['matches']} do.{few}"
    )


def conditions_rows(result: TournamentResult, about: dict[str, str]) -> Rows:
    """Return rows (name, value) of conditions and versions."""
    shown = {name: value for name, value in result.conditions.items() if name != "teams" and value is not None}
    begun = {"begun, commit": f"{about.get('date', '')}, {about.get('commit') or 'none'}"}
    return [(name.replace("_", " "), f"{value}") for name, value in {**shown, **begun, **result.made_with}.items()]


def title_of(result: TournamentResult) -> str:
    """Return the title of the report."""
    return f"{len(result.standings)} teams, {result.conditions['system']}, {result.conditions['league']}"


def page_of(result: TournamentResult, about: dict[str, str]) -> str:
    """Return the report as an HTML page, with links to the pairings' pages and replays."""
    page = ReportPage(title_of(result), "soccer tournament")
    page.section("Standings")
    page.table(HEAD, standing_rows(result))
    page.say(f"{verdict(result)} {ABOUT_RATINGS} {needed_matches_sentence(result)}")
    page.section("Cross table")
    if can_draw():
        page.figure(draw_cross_table(result), "Goal differences a match: blue, the team in the row scores more.")
    else:
        page.say(MISSING[0].upper() + MISSING[1:])
    page.table(("", *result.names), cross_rows(result))
    page.say(CROSS)
    page.section("Who is above whom")
    page.table(("", *result.names), above_rows(result))
    page.say(ABOVE)
    page.section("Pairings")
    page.links(("round", "", "", "goals", "won, drawn, lost", "pages and replays"), pairing_links(result))
    page.section("Conditions")
    page.say("This command plays what is missing and writes this report again:")
    page.command(about.get("command", ""))
    page.table(("", ""), conditions_rows(result, about))
    return page.html()


def draw_cross_table(result: TournamentResult) -> bytes:
    """Draw the goal differences of all pairings as a table of coloured cells."""
    found = differences(result)
    values = [
        [found[row, column][0].mean if (row, column) in found else None for column in result.names]
        for row in result.names
    ]
    return draw_heat_table("Goal difference a match", result.names, result.names, values, form="svg")


def pairing_links(result: TournamentResult) -> Iterator[tuple[tuple[str, ...], list[tuple[str, str]]]]:
    """Yield a row for each pairing, with links to its page and to its replays."""
    names = result.conditions["teams"]
    for pairing in result.pairings:
        one = pairing.result
        texts = (
            f"{pairing.round}", names[pairing.first], names[pairing.second], f"{one.goals_for} : {one.goals_against}",
            f"{one.wins}, {one.draws}, {one.losses}",
        )  # fmt: skip
        links = [
            ("report", "report.html"),
            *((f"{kept.kind} {kept.match}", kept.page or kept.file) for kept in pairing.kept),
        ]
        yield texts, [(words, f"{pairing.folder}/{file}") for words, file in links]


def screen_tables(result: TournamentResult) -> Iterator[Table]:
    """Yield tables for the terminal: standings, cross table, who is above whom."""
    from rich.table import Table

    for title, caption, head, rows in (
        (title_of(result), f"{verdict(result)} {needed_matches_sentence(result)}", HEAD, standing_rows(result)),
        ("Goals a match of the team in the row, its points", "", ("", *result.names), cross_rows(result)),
        ("Probability that the team in the row is above", "", ("", *result.names), above_rows(result)),
    ):
        drawn = Table(title=title, caption=caption or None)
        for at, name in enumerate(head):
            drawn.add_column(name, justify="right" if at > 1 else "left")
        for row in rows:
            drawn.add_row(*row)
        yield drawn
