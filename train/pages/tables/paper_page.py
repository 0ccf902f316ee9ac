"""The page of a team that was built from a paper: a short row for each claim, with details in claims.json beside it.

    python -m soccer_env.train.pages.tables.sacks [--ray [ADDRESS]]   measure each claim of the paper (resumes)
    python -m soccer_env.train.pages.tables.sacks run FOLDER ...  take over the results of runs of `soccer reproduce`
    python -m soccer_env.train.pages.tables.sacks write           write README.md again from claims.json

`tables.heinemann` has the same commands. Tables stand between markers in the page.
"""

import json
import sys
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from soccer_env.guards.whole_files import write_atomically
from soccer_env.train.command.parsing import fill_flag, take_out_flag
from soccer_env.train.files import read_lines
from soccer_env.train.papers import results
from soccer_env.train.papers.claim import Claim
from soccer_env.train.papers.claims import all_claims
from soccer_env.train.papers.report import estimate_with_interval
from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.settings import ReproduceSettings
from soccer_env.train.papers.verdicts import NOT, VERDICTS
from soccer_env.train.provenance import play_facts
from soccer_env.train.results_folder import SETTINGS, read_settings
from soccer_env.train.written_settings import with_ray
from soccer_env.types import WORLD

SHOWN = Path(__file__).resolve().parents[3] / "soccer_env" / "pictures"
DRAWN = Path(__file__).with_name("figures.json")  # the figures of each claim's last measurement, for the site
DIGITS = 4  # significant, of a number in a figure
NOT_MEASURED = "not measured"
SIGNS = {"at least ": "≥", "at most ": "≤", "above ": ">", "below ": "<", "and ": ""}  # of bounds, in short


@dataclass(frozen=True)
class PaperPage:
    """The page of a team, in `folder`: README.md and claims.json."""

    folder: Path
    paper: str
    pictures: Mapping[str, int]  # on the page: a claim's id, and the number of its figure
    run: Path  # the folder of a run of all claims, which can be stopped and resumed
    tables: Mapping[str, Callable[[], str]]  # besides the table of claims
    both_papers: bool = False  # whether that run measures the claims of the other paper, too
    drawn: Path = DRAWN

    @property
    def claims(self) -> tuple[str, ...]:
        """Return the ids of the paper's claims."""
        return tuple(claim.id for claim in all_claims().values() if claim.paper == self.paper and not claim.study)

    def stored(self) -> dict[str, dict[str, Any]]:
        """Return the contents of claims.json."""
        return results.read_stored(self.folder)

    def measure(self, ray: str | None = None) -> Path:
        """Measure every claim, perhaps on a Ray cluster, resuming an earlier call; return the folder of the run."""
        claims = () if self.both_papers else self.claims
        reproduce(with_ray(ReproduceSettings(claims=claims, all=self.both_papers, threads=2, out=self.run), ray))
        return self.run

    def take(self, run: Path) -> dict[str, dict[str, Any]]:
        """Take over the paper's claims from the folder of a run of `soccer reproduce`; ValueError if it holds none.

        Pictures for the page and figures for the site are taken over, too; those of other claims stay as they are.
        """
        about = read_settings(run / SETTINGS).get("about", {})
        names = [field.name for field in fields(results.ClaimResult)]
        records = read_lines(run / "claims.jsonl")
        taken = [results.ClaimResult(**{name: record[name] for name in names}) for record in records]
        claims = {result.id: claim_entry(result, about) for result in taken if result.id in self.claims}
        if not claims:
            raise ValueError(f"{run} holds no claim of {self.paper}")
        figures = {result.id: shorten(result.figures) for result in taken if result.id in self.claims}
        write_figures(self.drawn, figures)
        for claim, number in self.pictures.items():
            drawn = run / results.plot_name(claim, number)
            if drawn.exists():
                write_atomically(SHOWN / f"claim-{claim}.png", drawn.read_bytes())
        return claims

    def with_tables(self, readme: str, measured: results.Measured) -> str:
        """Return the README with its tables between their markers."""
        tables = {"claims": claims_table(measured, self.claims), **{name: show() for name, show in self.tables.items()}}
        for name, table in tables.items():
            readme = replace_between_markers(readme, name, table)
        return readme

    def write(self, measured: results.Measured) -> None:
        """Write claims.json and README.md."""
        ordered = {name: measured[name] for name in self.claims if name in measured}
        readme = self.folder / "README.md"
        write_atomically(self.folder / results.FILE, json.dumps(ordered, indent=1) + "\n")
        write_atomically(readme, self.with_tables(readme.read_text(encoding="utf-8"), ordered))

    def main(self, words: Sequence[str]) -> int:
        """Measure, take over runs or write; return the exit code."""
        ray, words = take_out_flag(fill_flag([*words], "--ray", "local"), "--ray")
        if not words:
            self.write(self.take(self.measure(ray)))
        elif [*words] == ["write"]:
            self.write(self.stored())
        elif words[0] == "run" and len(words) > 1:
            measured = self.stored()
            for folder in words[1:]:
                measured |= self.take(Path(folder))
            self.write(measured)
        else:
            print("usage: [run FOLDER ... | write]; nothing or --ray [ADDRESS] measures every claim", file=sys.stderr)
            return 2
        return 0


def write_figures(path: Path, taken: Mapping[str, Any]) -> None:
    """Add the figures of claims to a file, a line for each claim."""
    figures = results.read_json(path) | {claim: figure for claim, figure in taken.items() if figure}
    lines = [f"{json.dumps(claim)}: {json.dumps(figures[claim])}" for claim in sorted(figures)]
    write_atomically(path, "{\n" + ",\n".join(lines) + "\n}\n")


def shorten(plain: Any) -> Any:
    """Return plain data with its numbers rounded to DIGITS."""
    if isinstance(plain, Mapping):
        return {name: shorten(part) for name, part in plain.items()}
    if isinstance(plain, list):
        return [shorten(part) for part in plain]
    return float(f"{plain:.{DIGITS}g}") if isinstance(plain, float) else plain


def claim_entry(result: results.ClaimResult, about: Mapping[str, str]) -> dict[str, Any]:
    """Return the entry of claims.json for the result of a claim, with the date and commit of the run."""
    return {
        **{name: getattr(result, name) for name in (*results.KEPT, *results.HASHES)},
        "findings": [finding_entry(one) for one in result.findings],
        "without_findings": [finding_entry(one) for one in result.without_findings],
        "about": {name: about[name] for name in ("date", "commit", *play_facts()) if name in about},
    }


def finding_entry(finding: Mapping[str, Any]) -> dict[str, Any]:
    """Return a finding (the result of one criterion) as claims.json holds it."""
    kept = {name: finding[name] for name in ("criterion", "asked", "verdict", "n")}
    return kept | {"shown": estimate_with_interval(dict(finding))}


def claims_table(measured: results.Measured, claims: Sequence[str]) -> str:
    """Return a table of every claim of a paper in Markdown; claims without a result are shown as not measured."""
    known = all_claims()
    lines = [
        "| id | the paper says | measured (95 % interval) | verdict | what was measured [what is asked] |",
        "|---|---|---|---|---|",
    ]
    for name in claims:
        cells = claim_cells(known[name], measured[name]) if name in measured else ("", NOT_MEASURED, "")
        row = " | ".join((name, known[name].statement, *cells))
        lines.append(f"| {row} |")
    runs = "; ".join(sorted({results.measured_where(row) for row in measured.values()}))
    sources = f"Measured {runs}. The present world is {WORLD}." if runs else ""
    return "\n".join([verdict_counts(measured, claims), "", *lines, "", sources])


def claim_cells(claim: Claim, row: Mapping[str, Any]) -> tuple[str, str, str]:
    """Return the cells of a claim: the number that decides the claim, the verdict, and the meaning of that number."""
    result = results.restore_result(claim, row)
    finding = next(one for one in result.findings if one["criterion"] == result.criterion)
    verdict = f"**{result.marked_verdict}**" if result.verdict == NOT else result.marked_verdict
    return estimate_with_interval(finding), verdict, f"{finding['criterion']}{bound_in_signs(finding['asked'])}"


def bound_in_signs(bound: str) -> str:
    """Return a bound with signs for words, in brackets: " [≥80]" for "at least 80"; "" without a bound."""
    for words, sign in SIGNS.items():
        bound = bound.replace(words, sign)
    return f" [{bound}]" if bound else ""


def verdict_counts(measured: results.Measured, claims: Sequence[str]) -> str:
    """Return the number of claims with each verdict, in words."""
    counts = Counter(row["verdict"] for row in measured.values())
    parts = [f"{counts[verdict]} {verdict}" for verdict in VERDICTS if counts[verdict]]
    missing = len(claims) - len(measured)
    quick = sum(row["quick"] for row in measured.values())
    few = f" {quick} of them from few samples, marked (quick)." if quick else ""
    return f"{len(claims)} claims: {', '.join([*parts, *([f'{missing} {NOT_MEASURED}'] if missing else [])])}.{few}"


def replace_between_markers(text: str, name: str, table: str) -> str:
    """Return a page with a table between its markers; ValueError for a marker that is missing."""
    begin, end = f"<!-- table: {name} -->", f"<!-- end of table: {name} -->"
    before, opened, rest = text.partition(begin)
    _, closed, after = rest.partition(end)
    if not opened or not closed:
        raise ValueError(f"the page lacks the markers of table {name}")
    return f"{before}{begin}\n{table}\n{end}{after}"
