"""The last results of the papers' claims: claims.json in the folder of each paper's team.

The teams' pages, the site and `soccer reproduce ID --stored` show them. The claim's own texts (statement, method,
bounds, note) are not stored.
"""

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from soccer_env import baselines
from soccer_env.train.papers.claim import HEINEMANN, SACKS, Claim
from soccer_env.train.papers.claims import all_claims, find_claims
from soccer_env.train.papers.results import ClaimResult

FILE = "claims.json"
FOLDERS = {
    paper: Path(baselines.__path__[0]) / team for paper, team in ((SACKS, "sacks_2001"), (HEINEMANN, "heinemann_2006"))
}
KEPT = ("verdict", "by_seed", "quick", "n", "n_used", "command", "pose", "rules", "criterion", "seeds")  # of a result

Measured = Mapping[str, Mapping[str, Any]]  # claim: its stored result


def read_stored(folder: Path) -> dict[str, dict[str, Any]]:
    """Return the stored results, by claim, from the claims.json of a folder; empty without this file."""
    path = folder / FILE
    results: dict[str, dict[str, Any]] = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    return results


def stored_results(names: Iterable[str]) -> list[ClaimResult]:
    """Return the stored results of the named claims, or of all; ValueError for a claim that is not stored."""
    known = all_claims()
    rows = {name: row for folder in FOLDERS.values() for name, row in read_stored(folder).items()}
    claims = find_claims([*names] or rows, known)
    for claim in claims:
        if claim.id not in rows:
            raise ValueError(f"no result of {claim.id} is stored; measure it without --stored")
    return [restore_result(claim, rows[claim.id]) for claim in claims]


def restore_result(claim: Claim, row: Mapping[str, Any]) -> ClaimResult:
    """Convert a stored result to a ClaimResult, without figures and with numbers as text."""
    about = row["about"]
    measured = f"Measured {about['date']}, commit {about['commit'] or 'none'}."
    note = claim.note if isinstance(claim.note, str) else ""
    return ClaimResult(
        **{name: getattr(claim, name) for name in ("id", "paper", "section", "statement", "method")},
        **{name: row[name] for name in KEPT},
        estimate=None,
        low=None,
        high=None,
        cap=row["n"],
        ingredients=list(claim.ingredients),
        note=f"{note}\n\n{measured}".strip(),
        findings=[add_bounds(claim, row, found) for found in row["findings"]],
        without=claim.without.ingredient if claim.without else "",
        without_findings=[add_bounds(claim, row, found) for found in row["without_findings"]],
        figures=[],
        settings="",
    )


def add_bounds(claim: Claim, row: Mapping[str, Any], finding: Mapping[str, Any]) -> dict[str, Any]:
    """Add the bounds of its criterion to a stored finding, and the number of its units if known."""
    bounds = next((one.asked for one in claim.criteria if one.text == finding["criterion"]), "")
    units = row["n_used"] if finding["criterion"] == row["criterion"] else None
    return {"n": units, **finding, "asked": bounds}
