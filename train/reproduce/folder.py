"""What a reproduction run found: one line for each claim, and the files of its folder."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

from soccer_env.train.evaluate.results import check_same
from soccer_env.train.files import append_lines, read_lines
from soccer_env.train.provenance import settings_hash
from soccer_env.train.reproduce.claim import none_or_float
from soccer_env.train.reproduce.verdicts import Finding
from soccer_env.whole_files import write_whole

FILES = ("settings.json", "claims.jsonl", "results.json", "report.md")
PLOTS = "plots"  # folder of pictures, ID-1.png, ID-2.png, ...


@dataclass(frozen=True)
class ClaimResult:
    """A claim that has been measured. Numbers that are not finite are None: an open side of an interval."""

    id: str
    paper: str
    section: str
    statement: str
    method: str
    verdict: str
    quick: bool  # few samples were taken
    pose: str  # how robots knew where they are: "particles" or "percept"
    estimate: float | None  # of the criterion that decides
    low: float | None
    high: float | None
    criterion: str
    n: int  # independent units (runs, matches) that were reached
    cap: int  # units at which it would have been undecided
    seed: int
    command: str
    ingredients: list[str]
    note: str
    findings: list[dict[str, Any]]  # of every criterion
    without: str  # the ingredient that a by-construction claim rests on
    without_findings: list[dict[str, Any]]  # the same criteria with it off
    figures: list[dict[str, Any]]
    settings: str  # hash of the conditions and of what the run was made with

    @property
    def marked(self) -> str:
        """Return the verdict, marked if it comes from few samples."""
        return f"{self.verdict} (quick)" if self.quick else self.verdict

    def as_dict(self) -> dict[str, Any]:
        """Return what results.json holds of it; beside the verdict stands how it is shown, marked if it is quick."""
        record: dict[str, Any] = {}
        for name, value in asdict(self).items():
            if name not in ("figures", "settings"):
                record[name] = value
            if name == "verdict":
                record["shown"] = self.marked
        return record


def as_record(finding: Finding) -> dict[str, Any]:
    """Return a finding as JSON can hold it."""
    return asdict(finding) | {name: none_or_float(getattr(finding, name)) for name in ("estimate", "low", "high")}


def remove_files(path: Path | None) -> None:
    """Remove the files of a run from a folder; the settings last, since claims without them are refused."""
    if path is None:
        return
    for plot in (path / PLOTS).glob("*.png"):
        plot.unlink()
    for name in reversed(FILES):
        (path / name).unlink(missing_ok=True)


class ClaimFolder:
    """The files of one run: FILES and PLOTS; or, without a path, none.

    `results` are the claims already there, by id. Raises ValueError if the folder holds a run with other settings.
    """

    def __init__(self, path: Path | None, conditions: dict[str, Any], made_with: dict[str, str], about: dict[str, str]):
        mine = json.loads(json.dumps({"conditions": conditions, "made_with": made_with, "about": about}))
        self.path, self.about, self.made_with = path, about, made_with
        self.settings = settings_hash(mine["conditions"], made_with)
        self.results: dict[str, ClaimResult] = {}
        if path is None:
            return
        path.mkdir(parents=True, exist_ok=True)
        if (path / "settings.json").exists():
            self.about = check_same(path / "settings.json", mine, "a reproduction run")
            self.results = self._read(path / "claims.jsonl")
        elif (path / "claims.jsonl").exists():
            raise ValueError(f"{path} holds claims but no settings.json; give another folder")
        else:
            write_whole(path / "settings.json", json.dumps(mine, indent=2) + "\n")

    def add(self, result: ClaimResult) -> None:
        """Keep a claim that has been measured, on disk before this returns."""
        if self.path is not None:
            append_lines(self.path / "claims.jsonl", [asdict(result)])
        self.results[result.id] = result

    def write(self, name: str, content: str | bytes) -> None:
        """Write a file of the folder whole; without a folder nothing."""
        if self.path is not None:
            (self.path / name).parent.mkdir(exist_ok=True)
            write_whole(self.path / name, content)

    def _read(self, path: Path) -> dict[str, ClaimResult]:
        """Return the claims that the file holds, each once."""
        names = {field.name for field in fields(ClaimResult)}
        found: dict[str, ClaimResult] = {}
        for record in read_lines(path):
            if set(record) != names:
                raise ValueError(f"{path}: a claim has the fields {', '.join(sorted(names))}, got {sorted(record)}")
            result = ClaimResult(**record)
            if result.settings != self.settings or found.setdefault(result.id, result) != result:
                raise ValueError(f"{path}: claim {result.id} belongs to other settings; give another folder")
        return found
