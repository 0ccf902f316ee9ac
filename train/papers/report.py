"""The report of a reproduction run in Markdown, on the screen and as a page, made from the results alone."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from math import inf
from typing import TYPE_CHECKING, Any

from soccer_env.match.staging import PATIENT
from soccer_env.train.evaluate.report import plain_number, table
from soccer_env.train.papers.results import ClaimResult, remarks_on, rules_in_words
from soccer_env.train.papers.verdicts import CONTEXT, NOT, UNDECIDED, VERDICTS
from soccer_env.train.report import MISSING, ReportPage, can_draw, draw_curves, draw_intervals
from soccer_env.train.report.charts import Row
from soccer_env.train.results_folder import ResultsFolder
from soccer_env.train.written_settings import POSES

if TYPE_CHECKING:
    from rich.markdown import Markdown
    from rich.table import Table

COLUMNS = ("id", "claim", "rules", "verdict", "seeds", "estimate (95 % interval)", "n")
DIGITS = 3  # significant digits of a number
FINDINGS = ("criterion", "asked", "estimate (95 % interval)", "n", "verdict")
BOUND = re.compile(r"(above|at least|below|at most) (-?[\d.]+(?:e[-+]?\d+)?)")
ROWS = 24  # of a picture of paper against measured
EXPLANATION = f"""\
* `reproduced`: the whole 95 % interval satisfies the criterion. `not`: the whole interval violates it. `undecided`: \
neither, at the cap on samples.
* `by construction`: satisfied because of something that was put in, which is named and switched off for comparison; \
never counted as reproduced. `context`: nothing to decide.
* A claim with several criteria needs all of them. It is `reproduced` if each holds at 95 %; it is `not` if one of m \
criteria is violated at a confidence of 1 - 5 % / m, for any of m may be violated by chance. Words of frequency: \
"almost always" is 95 %, "usually" and "in most cases" are more than 50 %, "sometimes" and "infrequently" 5 %.
* Looks at growing samples share the 5 % of an interval. n counts independent units (runs, matches) of all seeds \
together; "40 of 96": so many of them have a value in the criterion that decides.
* Rules: the set under which whole matches were played; staged scenes are under `{PATIENT}`, where nobody is \
whistled, pulled apart or given a dropped ball, whatever `--rules` asks for.
* Seeds: what the samples of each seed say alone, r reproduced, n not, u undecided, c context."""


def markdown(results: Sequence[ClaimResult], folder: ResultsFolder, plots: dict[str, list[str]], trouble: str) -> str:
    """Return the report as Markdown; `plots`: files of each claim's figures, `trouble`: the reason if it is empty."""
    quick = ' Few samples were taken: verdicts are marked "(quick)".' if any(result.quick for result in results) else ""
    lines = [
        "# Claims of the papers, measured",
        f"{verdicts_sentence(results)}{quick} {poses_sentence(results)}",
        table(COLUMNS, [row(result) for result in results]),
        EXPLANATION,
        trouble and trouble[0].upper() + trouble[1:] + ". The same data stand here as tables.",
        *(section(result, plots.get(result.id, [])) for result in results),
        "## Conditions",
        table(("", ""), conditions_rows(folder)),
        "This command measures what is missing and writes this report again:",
        f"```bash\n{folder.about.get('command', '')}\n```",
    ]
    return "\n\n".join(line for line in lines if line) + "\n"


def verdicts_sentence(results: Sequence[ClaimResult]) -> str:
    """Return the number of claims with each verdict."""
    counts = Counter(result.verdict for result in results)
    total = ", ".join(f"{counts[verdict]} {verdict}" for verdict in VERDICTS if counts[verdict])
    return f"{len(results)} claims: {total}."


def conditions_rows(folder: ResultsFolder) -> list[tuple[str, str]]:
    """Return rows (name, value) with the start of a run, its settings and its versions."""
    begun = f"{folder.about.get('date', '')}, {folder.about.get('commit') or 'none'}"
    made = [(name.replace("_", " "), value) for name, value in folder.made_with.items()]
    return [("begun, commit", begun), ("settings hash", folder.settings), *made]


def poses_sentence(results: Sequence[ClaimResult]) -> str:
    """Return a sentence on how robots localised: in most claims, and in the exceptions."""
    ids = {pose: [result.id for result in results if result.pose == pose] for pose in POSES}
    most, *rest = sorted(POSES, key=lambda pose: -len(ids[pose]))
    others = [f"{pose} for {', '.join(ids[pose])}" for pose in rest if ids[pose]]
    return f"Own pose: {'; '.join([most, *others])}."


def rules_sentence(result: ClaimResult) -> str:
    """Return a sentence on the rules of a claim's matches, and on whether --rules can change them."""
    played = [name for name in result.rules if name != PATIENT]
    if played:
        return f"Rules of play: {played[0]}{f'; of staged scenes: {PATIENT}' if PATIENT in result.rules else ''}."
    stated = f"staged scenes alone, {PATIENT}" if result.rules else "it makes no match"
    return f"Rules: {stated}; --rules changes nothing."


def row(result: ClaimResult) -> tuple[str, ...]:
    """Return the row of a claim for the summary table."""
    shown = next(
        (estimate_with_interval(found) for found in result.findings if found["criterion"] == result.criterion), ""
    )
    rules, n = rules_in_words(result.rules), units_of(result.n_used, result.n)
    return result.id, result.statement, rules, result.marked_verdict, result.alone, shown, n


def units_of(used: int | None, units: int) -> str:
    """Return the number of units with a value, such as "40 of 96" if some have none; "" if unknown."""
    return "" if used is None else f"{used}" if used == units else f"{used} of {units}"


def section(result: ClaimResult, plots: Sequence[str]) -> str:
    """Return the report's section on one claim, with its figures."""
    figures = (
        [f"![{figure['title']}]({file})" for figure, file in zip(result.figures, plots, strict=False)]
        if plots
        else [figure_table(figure) for figure in result.figures]
    )
    return "\n\n".join([claim_result_markdown(result), *figures, f"`{result.command}`"])


def claim_result_markdown(result: ClaimResult) -> str:
    """Return the result of one claim as Markdown."""
    parts = (part if isinstance(part, str) else table(FINDINGS, part) for part in claim_parts(result) if part)
    return "\n\n".join([f"## {result.id}: {result.marked_verdict}", *parts])


def claim_parts(result: ClaimResult) -> Iterator[str | list[tuple[str, ...]]]:
    """Yield the texts on one claim's result, and the rows of its tables: criteria, and those without an ingredient."""
    n = f"n = {result.n}" + (f" (cap {result.cap})" if result.verdict == UNDECIDED else "")
    yield f"{result.statement} [{result.paper}{', ' if result.section else ''}{result.section}]"
    yield f"Measured: {result.method} {n}. Own pose: {result.pose}. {rules_sentence(result)}"
    yield f"Each seed alone: {', '.join(f'{s}: {v}' for s, v in zip(result.seeds, result.by_seed, strict=True))}."
    yield finding_rows(result.findings, result.n)
    yield f"Rests on: {'; '.join(result.ingredients)}." if result.ingredients else ""
    yield f"With the ingredient off ({result.without}):" if result.without else ""
    yield finding_rows(result.without_findings, result.n)
    remarks = remarks_on(result.id, result.paper)
    yield f"Likely cause: {remarks['cause']}." if result.verdict == NOT and "cause" in remarks else ""
    yield f"[changed] {remarks['changed']}." if "changed" in remarks else ""
    yield result.note


def finding_rows(findings: Sequence[dict[str, Any]], units: int) -> list[tuple[str, ...]]:
    """Return one row of the findings table for each criterion of a claim."""
    verdicts = ["reported" if found["verdict"] == CONTEXT else found["verdict"] for found in findings]
    return [
        (found["criterion"], found["asked"], estimate_with_interval(found), units_of(found["n"], units), verdict)
        for found, verdict in zip(findings, verdicts, strict=True)
    ]


def figure_table(figure: dict[str, Any]) -> str:
    """Return a figure's data as a table with a column for each curve; for a picture of the field, only its title."""
    if "arrows" in figure:
        return f"{figure['title']}: a picture of the field, which needs matplotlib"
    places = sorted({x for curve in figure["curves"] for x in curve["x"]})
    columns = [dict(zip(curve["x"], curve["y"], strict=True)) for curve in figure["curves"]]
    cells = [(number(x), *(number(column.get(x)) for column in columns)) for x in places]
    head = (figure["x_label"], *(curve["name"] for curve in figure["curves"]))
    return f"{figure['title']} ({figure['y_label']})\n\n{table(head, cells)}"


def estimate_with_interval(found: dict[str, Any]) -> str:
    """Return an estimate with interval and unit as text; without the interval if exact, unchanged if stored as text."""
    if "shown" in found:
        return str(found["shown"])
    unit = f" {found['unit']}" if found["unit"] else ""
    if found["estimate"] is None:
        return "no value"
    if found["low"] == found["estimate"] == found["high"]:
        return f"{number(found['estimate'])}{unit}"
    return f"{number(found['estimate'])}{unit} ({number(found['low'])} to {number(found['high'])})"


def number(value: float | None) -> str:
    """Format a number with a few digits; None, an open side of an interval, as a question mark."""
    return "?" if value is None else plain_number(value, DIGITS)


def screen_parts(results: Sequence[ClaimResult], in_full: bool) -> Iterator[Table | Markdown]:
    """Yield the parts for the terminal: the table of verdicts and, if `in_full`, the result of each claim."""
    from rich.markdown import Markdown

    yield screen_table(results)
    yield from (Markdown(claim_result_markdown(result)) for result in results if in_full)


def screen_table(results: Sequence[ClaimResult]) -> Table:
    """Return the verdicts as a table for the terminal."""
    from rich.table import Table

    title = f"Claims of the papers, measured. {poses_sentence(results)} Staged: under {PATIENT}."
    drawn = Table(title=title, title_justify="left")
    for column in COLUMNS:
        drawn.add_column(column, overflow="fold")
    for result in results:
        drawn.add_row(*row(result))
    return drawn


def page_of(results: Sequence[ClaimResult], folder: ResultsFolder) -> str:
    """Return the HTML page that reports a run."""
    page = ReportPage("Claims of the papers, measured", "soccer reproduce")
    page.say(verdicts_sentence(results), strong=True)
    quick = any(result.quick for result in results)
    page.say(f"{'Few samples were taken: verdicts are marked (quick). ' if quick else ''}{poses_sentence(results)}")
    page.section("Verdicts")
    page.table(COLUMNS, [row(result) for result in results], sorts=True)
    for line in EXPLANATION.splitlines():
        page.say(line.removeprefix("* "))
    add_comparison(page, results)
    page.section("Claims")
    for result in results:
        page.heading(f"{result.id}: {result.marked_verdict}")
        for part in claim_parts(result):
            if isinstance(part, str):
                page.say(part)
            elif part:
                page.table(FINDINGS, part)
        for figure in result.figures if can_draw() else ():
            page.figure(draw_curves(figure, form="svg"), figure["title"])
        page.command(result.command)
    page.section("Conditions")
    page.say("This command measures what is missing and writes this report again:")
    page.command(str(folder.about.get("command", "")))
    page.table(("", ""), conditions_rows(folder))
    return page.html()


def add_comparison(page: ReportPage, results: Sequence[ClaimResult]) -> None:
    """Add figures that compare the papers' bounds with the measured intervals, criterion by criterion."""
    rows = list(rows_of(results))
    if not rows:
        return
    page.section("Paper against measured")
    if not can_draw():
        page.say(MISSING[0].upper() + MISSING[1:])
        return
    for first in range(0, len(rows), ROWS):
        svg = draw_intervals("Paper against measured", rows[first : first + ROWS], "the paper's claim", form="svg")
        page.figure(svg, "Each criterion on a scale of its own: where the claim has it, and the 95 % interval found.")


def rows_of(results: Sequence[ClaimResult]) -> Iterator[Row]:
    """Yield a row of the comparison for each criterion with a bound and an estimate."""
    for result in results:
        for finding in result.findings:
            bounds = dict(BOUND.findall(finding["asked"]))
            least = [float(bounds[word]) for word in ("above", "at least") if word in bounds]
            most = [float(bounds[word]) for word in ("below", "at most") if word in bounds]
            if (least or most) and finding["estimate"] is not None:
                low, high = finding["low"], finding["high"]  # None: open
                yield Row(
                    f"{result.id} {finding['criterion']}", estimate_with_interval(finding), finding["estimate"],
                    -inf if low is None else low, inf if high is None else high, *(least or [-inf]), *(most or [inf]),
                )  # fmt: skip
