"""The report of a reproduction run as a page for the browser: verdicts, paper against measured, all figures."""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from math import inf

from soccer_env.train.papers.report import (
    COLUMNS,
    EXPLANATION,
    estimate_with_interval,
    finding_rows,
    poses_sentence,
    row,
    rules_sentence,
)
from soccer_env.train.papers.results import ClaimResult
from soccer_env.train.papers.verdicts import VERDICTS
from soccer_env.train.report import MISSING, ReportPage, can_draw, draw_curves, draw_intervals
from soccer_env.train.report.charts import Row
from soccer_env.train.results_folder import ResultsFolder

ROWS = 24  # of a picture of paper against measured
BOUND = re.compile(r"(above|at least|below|at most) (-?[\d.]+(?:e[-+]?\d+)?)")
FINDINGS = ("criterion", "asked", "estimate (95 % interval)", "n", "verdict")


def page_of(results: Sequence[ClaimResult], folder: ResultsFolder) -> str:
    """Return the HTML page that reports a run."""
    page = ReportPage("Claims of the papers, measured", "soccer reproduce")
    counts = Counter(result.verdict for result in results)
    total = ", ".join(f"{counts[verdict]} {verdict}" for verdict in VERDICTS if counts[verdict])
    page.say(f"{len(results)} claims: {total}.", strong=True)
    quick = any(result.quick for result in results)
    page.say(f"{'Few samples were taken: verdicts are marked (quick). ' if quick else ''}{poses_sentence(results)}")
    page.section("Verdicts")
    page.table(COLUMNS, [row(result) for result in results], sorts=True)
    for line in EXPLANATION.splitlines():
        page.say(line.removeprefix("* "))
    add_comparison(page, results)
    page.section("Claims")
    for result in results:
        add_claim(page, result)
    page.section("Conditions")
    page.say("This command measures what is missing and writes this report again:")
    page.command(str(folder.about.get("command", "")))
    begun = f"{folder.about.get('date', '')}, {folder.about.get('commit') or 'none'}"
    made = [(name.replace("_", " "), value) for name, value in folder.made_with.items()]
    page.table(("", ""), [("begun, commit", begun), ("settings hash", folder.settings), *made])
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


def add_claim(page: ReportPage, result: ClaimResult) -> None:
    """Add the section of one claim's result to the page."""
    page.heading(f"{result.id}: {result.marked_verdict}")
    page.say(f"{result.statement} [{result.paper}{', ' if result.section else ''}{result.section}]")
    page.say(f"Measured: {result.method} n = {result.n}. Own pose: {result.pose}. {rules_sentence(result)}")
    if result.findings:
        page.table(FINDINGS, finding_rows(result.findings, result.n))
    if result.ingredients:
        page.say(f"Rests on: {'; '.join(result.ingredients)}.")
    if result.without:
        page.say(f"With the ingredient off ({result.without}):")
        page.table(FINDINGS, finding_rows(result.without_findings, result.n))
    page.say(result.note)
    for figure in result.figures if can_draw() else ():
        page.figure(draw_curves(figure, form="svg"), figure["title"])
    page.command(result.command)
