"""A page for each claim of the papers, made from its stored result and figures, and a list of each paper's claims."""

from __future__ import annotations

from typing import Any

from pages.markdown import table
from soccer_env.train.pages.pictures import paper_figures
from soccer_env.train.pages.pictures.paper_figures import FIGURES
from soccer_env.train.pages.tables.heinemann import PAGE as HEINEMANN_PAGE
from soccer_env.train.pages.tables.paper_page import DRAWN, NOT_MEASURED, SHOWN, PaperPage
from soccer_env.train.pages.tables.sacks import PAGE as SACKS_PAGE
from soccer_env.train.papers.claim import Claim
from soccer_env.train.papers.claims import all_claims
from soccer_env.train.papers.report import EXPLANATION, claim_result_markdown, figure_table
from soccer_env.train.papers.results import read_json, remarks_on, restore_result
from soccer_env.train.report import can_draw, draw_curves

PAPERS = (SACKS_PAGE, HEINEMANN_PAGE)


def pages() -> dict[str, str | bytes]:
    """Return the pages of all claims, and their plots, by path."""
    found: dict[str, str | bytes] = {"claims/figures.md": figures_page()}
    known, figures = all_claims(), read_json(DRAWN)
    for paper in PAPERS:
        stored, folder = paper.stored(), f"claims/{paper.folder.name}"
        lines = [(f"[{name}]({name}.md)", known[name].statement, verdict(known[name], stored)) for name in paper.claims]
        head = f"# Claims of {paper.paper}, measured"
        found[f"{folder}/index.md"] = "\n\n".join(
            [head, table(("id", "the paper says", "verdict"), lines), EXPLANATION]
        )
        for name in paper.claims:
            plots = drawn(name, figures.get(name, []))
            found |= {f"{folder}/{file}": plot for file, plot in plots.items() if isinstance(plot, bytes)}
            found[f"{folder}/{name}.md"] = "\n\n".join([*told(known[name], stored), *shown(name, plots), command(name)])
    return found


def verdict(claim: Claim, stored: dict[str, Any]) -> str:
    """Return the verdict on a claim, with its condition and whether its question changed after a first look."""
    words = restore_result(claim, stored[claim.id]).marked_verdict if claim.id in stored else NOT_MEASURED
    return f"{words} [changed]" if "changed" in remarks_on(claim.id, claim.paper) else words


def told(claim: Claim, stored: dict[str, Any]) -> list[str]:
    """Return the parts of a claim's page: its result with all criteria, or what it asks if it is not measured."""
    if claim.id in stored:
        return [claim_result_markdown(restore_result(claim, stored[claim.id])).removeprefix("#")]
    asked = table(
        ("criterion", "asked"), [(one.text, f"{one.asked} {one.unit}") for one in claim.criteria if one.decides]
    )
    changed = remarks_on(claim.id, claim.paper).get("changed", "")
    parts = [
        f"# {claim.id}: {NOT_MEASURED}",
        f"{claim.statement} [{claim.paper}, {claim.section}]",
        claim.method,
        asked,
    ]
    return [*parts, *([f"[changed] {changed}."] if changed else [])]


def drawn(name: str, figures: list[dict[str, Any]]) -> dict[str, str | bytes]:
    """Return the plots of a claim by file name; without matplotlib, tables in their place."""
    draws = can_draw()
    return {
        f"{name}-{number}.png": draw_curves(figure) if draws else figure_table(figure)
        for number, figure in enumerate(figures, 1)
    }


def shown(name: str, plots: dict[str, str | bytes]) -> list[str]:
    """Return the plots of a claim as Markdown; without stored figures the picture that the team's page shows."""
    if not plots and (SHOWN / f"claim-{name}.png").exists():
        return [f"![As measured](../../soccer_env/pictures/claim-{name}.png)"]
    return [f"![{name}]({file})" if isinstance(plot, bytes) else plot for file, plot in plots.items()]


def command(name: str) -> str:
    """Return the command that measures a claim."""
    return f"```bash\nsoccer reproduce {name} --out runs/{name}\n```\n"


def figures_page() -> str:
    """Return the page of the papers' figures, drawn from our own runs."""
    parts = ["# Figures of the papers", "Each is drawn from runs of this repository by the command below it."]
    for name, figure in FIGURES.items():
        picture = f"![{name}](../soccer_env/pictures/paper-{name}.png)"
        drawn = f"```bash\npython -m {paper_figures.__name__} {name}\n```"
        parts += [f"## {figure.paper}: {name}", figure.shows, picture, drawn]
    return "\n\n".join(parts) + "\n"


def navigation() -> list[object]:
    """Return the section of the claims."""
    papers: list[object] = [{paper.paper: contents(paper)} for paper in PAPERS]
    return [{"Claims": [*papers, {"Figures of the papers": "claims/figures.md"}]}]


def contents(paper: PaperPage) -> list[object]:
    """Return the pages of a paper's claims."""
    folder = f"claims/{paper.folder.name}"
    return [f"{folder}/index.md", *({name: f"{folder}/{name}.md"} for name in paper.claims)]
