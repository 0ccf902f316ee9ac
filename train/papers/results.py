"""The result of a claim, the files of a reproduction run, and the last results of all claims.

The last results are stored in claims.json in the folder of each paper's team, for the teams' pages, the site and
`soccer reproduce ID --stored`. The claim's own texts (statement, method, bounds, note) are not stored. remarks.json
beside it says of a claim when and how it "changed" after a first look, and the likely "cause" if it is not reproduced:
the paper, the simulator or our reading.
"""

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from soccer_env import baselines
from soccer_env.match.staging import PATIENT
from soccer_env.train.papers.claim import HEINEMANN, SACKS, Claim, none_or_float
from soccer_env.train.papers.claims import all_claims, find_claims
from soccer_env.train.papers.verdicts import CONTEXT, NOT, REPRODUCED, Finding
from soccer_env.train.results_folder import RunKind


@dataclass(frozen=True)
class ClaimResult:
    """The result of a claim. Non-finite numbers, such as an open side of an interval, are stored as None."""

    id: str
    paper: str
    section: str
    statement: str
    method: str
    condition: str  # of the verdict, in words; "": none
    verdict: str
    quick: bool  # few samples were taken
    pose: str  # how robots knew where they are: "particles" or "percept"
    rules: list[str]  # rule sets of its matches, that of play first; none: it makes no match
    estimate: float | None  # of the criterion that decides
    low: float | None
    high: float | None
    criterion: str
    n: int  # independent units (runs, matches) that were reached, of all seeds
    n_used: int  # of them with a value in that criterion
    cap: int  # units at which it would have been undecided
    seeds: list[int]
    by_seed: list[str]  # the verdict from each seed's samples alone
    command: str
    ingredients: list[str]
    note: str
    findings: list[dict[str, Any]]  # of every criterion
    without: str  # the ingredient that a by-construction claim rests on
    without_findings: list[dict[str, Any]]  # the same criteria with it off
    figures: list[dict[str, Any]]
    asks: str  # hash of the claim's question
    sample: str  # hash of the first batch of the first seed; "": of times, which no other run repeats
    settings: str  # hash of the conditions and of what the run was made with

    @property
    def marked_verdict(self) -> str:
        """Return the verdict with its condition, marked "(quick)" if it comes from few samples."""
        words = f"{self.verdict}, {self.condition}" if self.condition and self.verdict != CONTEXT else self.verdict
        return f"{words} (quick)" if self.quick else words

    @property
    def alone(self) -> str:
        """Return each seed's verdict by its letter (reproduced, undecided, not): "r r u", or "r r n, they disagree"."""
        letters = " ".join(verdict[0] for verdict in self.by_seed)
        return f"{letters}, they disagree" if {REPRODUCED, NOT} <= set(self.by_seed) else letters

    def as_dict(self) -> dict[str, Any]:
        """Return the record for results.json, without figures; `shown` is the verdict, marked if it is quick."""
        record: dict[str, Any] = {}
        for name, value in asdict(self).items():
            if name not in ("figures", "settings"):
                record[name] = value
            if name == "verdict":
                record["shown"] = self.marked_verdict
        return record


def rules_in_words(rules: Sequence[str]) -> str:
    """Return a claim's rule sets as text for a table: "league", "simple, staged", "staged" or "no match"."""
    return ", ".join("staged" if name == PATIENT else name for name in rules) or "no match"


def as_record(finding: Finding) -> dict[str, Any]:
    """Return a finding as plain data for JSON."""
    return asdict(finding) | {name: none_or_float(getattr(finding, name)) for name in ("estimate", "low", "high")}


def plot_name(claim: str, number: object) -> str:
    """Return the file name of a claim's figure in the folder of a run: plots/ID-1.png, ID-2.png, ..."""
    return f"plots/{re.sub(r'[^A-Za-z0-9]', '-', claim)}-{number}.png"


CLAIMS = "claims.jsonl"  # of a folder: a line for each claim that has been measured
REPRODUCTION = RunKind(
    "a reproduction run", ("claims", "budget"), (CLAIMS, "results.json", "report.md", "report.html"),
    lambda conditions: [plot_name(str(claim), "[0-9]*") for claim in conditions.get("claims", ())],
)  # fmt: skip


FILE, REMARKS = "claims.json", "remarks.json"
FOLDERS = {
    paper: Path(baselines.__path__[0]) / team for paper, team in ((SACKS, "sacks_2001"), (HEINEMANN, "heinemann_2006"))
}
FROM_CLAIM = ("id", "paper", "section", "statement", "method", "condition")  # fields that a result shares with it
HASHES = ("asks", "sample")  # of rows since world 4
KEPT = ("verdict", "by_seed", "quick", "n", "n_used", "command", "pose", "rules", "criterion", "seeds")  # of a result

Measured = Mapping[str, Mapping[str, Any]]  # claim: its stored result


def read_stored(folder: Path) -> dict[str, dict[str, Any]]:
    """Return the stored results, by claim, from the claims.json of a folder; empty without this file."""
    return read_json(folder / FILE)


def read_json(path: Path) -> dict[str, dict[str, Any]]:
    """Return the contents of a JSON file by claim; empty without this file."""
    found: dict[str, dict[str, Any]] = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    return found


def remarks_on(claim: str, paper: str) -> dict[str, str]:
    """Return the remarks on a claim: when and how it "changed", and the likely "cause" if it is not reproduced."""
    return read_json(FOLDERS[paper] / REMARKS).get(claim, {}) if paper in FOLDERS else {}


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
    measured = f"Measured {measured_where(row)}."
    note = claim.note if isinstance(claim.note, str) else ""
    return ClaimResult(
        **{name: getattr(claim, name) for name in FROM_CLAIM},
        **{name: row[name] for name in KEPT},
        **{name: row.get(name, "") for name in HASHES},
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


def measured_where(row: Mapping[str, Any]) -> str:
    """Return date, commit and world of a stored result, in words."""
    about = row["about"]
    return f"{about['date']} ({about['commit'] or 'no commit'}, world {about.get('world', '1')})"


def add_bounds(claim: Claim, row: Mapping[str, Any], finding: Mapping[str, Any]) -> dict[str, Any]:
    """Add the bounds of its criterion to a stored finding, and the number of its units if known."""
    bounds = next((one.asked for one in claim.criteria if one.text == finding["criterion"]), "")
    units = row["n_used"] if finding["criterion"] == row["criterion"] else None
    return {"n": units, **finding, "asked": bounds}
