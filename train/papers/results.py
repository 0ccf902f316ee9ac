"""The result of a claim, and the files of a reproduction run."""

import re
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from soccer_env.match.staging import PATIENT
from soccer_env.train.papers.claim import none_or_float
from soccer_env.train.papers.verdicts import NOT, REPRODUCED, Finding
from soccer_env.train.results_folder import RunKind


@dataclass(frozen=True)
class ClaimResult:
    """The result of a claim. Non-finite numbers, such as an open side of an interval, are stored as None."""

    id: str
    paper: str
    section: str
    statement: str
    method: str
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
    settings: str  # hash of the conditions and of what the run was made with

    @property
    def marked_verdict(self) -> str:
        """Return the verdict, marked "(quick)" if it comes from few samples."""
        return f"{self.verdict} (quick)" if self.quick else self.verdict

    @property
    def alone(self) -> str:
        """Return each seed's verdict by its letter (reproduced, undecided, not): "r r u", or "r r n, they disagree"."""
        return seeds_in_letters(self.by_seed)

    def as_dict(self) -> dict[str, Any]:
        """Return the record for results.json, without figures; `shown` is the verdict, marked if it is quick."""
        record: dict[str, Any] = {}
        for name, value in asdict(self).items():
            if name not in ("figures", "settings"):
                record[name] = value
            if name == "verdict":
                record["shown"] = self.marked_verdict
        return record


def seeds_in_letters(verdicts: Sequence[str]) -> str:
    """Return the first letters of single seeds' verdicts, and whether the verdicts contradict each other."""
    letters = " ".join(verdict[0] for verdict in verdicts)
    return f"{letters}, they disagree" if {REPRODUCED, NOT} <= set(verdicts) else letters


def rules_in_words(rules: Sequence[str]) -> str:
    """Return a claim's rule sets as text for a table: "league", "simple, staged", "staged" or "no match"."""
    return ", ".join("staged" if name == PATIENT else name for name in rules) or "no match"


def as_record(finding: Finding) -> dict[str, Any]:
    """Return a finding as plain data for JSON."""
    return asdict(finding) | {name: none_or_float(getattr(finding, name)) for name in ("estimate", "low", "high")}


def plot_name(claim: str, number: object) -> str:
    """Return the file name of a claim's figure in the folder of a run: plots/ID-1.png, ID-2.png, ..."""
    return f"plots/{re.sub(r'[^A-Za-z0-9]', '-', claim)}-{number}.png"


def plots_of(conditions: dict[str, Any]) -> list[str]:
    """Return glob patterns for the figure files of a run with these conditions."""
    return [plot_name(str(claim), "[0-9]*") for claim in conditions.get("claims", ())]


CLAIMS = "claims.jsonl"  # of a folder: a line for each claim that has been measured
REPRODUCTION = RunKind(
    "a reproduction run", ("claims", "budget"), (CLAIMS, "results.json", "report.md", "report.html"), plots_of
)
