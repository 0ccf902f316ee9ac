"""The page of a team that was built from a paper: a table of the paper's claims, kept as JSON beside the page.

    python -m soccer_env.train.pages.tables.sacks                 measure each claim of the paper (goes on)
    python -m soccer_env.train.pages.tables.sacks run FOLDER ...  take in what runs of `soccer reproduce` found
    python -m soccer_env.train.pages.tables.sacks write           write README.md again from claims.json

The same of `tables.heinemann`. Tables stand between markers in the page.
"""

import json
import sys
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from soccer_env.guards.whole_files import write_whole
from soccer_env.train.files import read_lines
from soccer_env.train.pages.tables.markers import between_markers
from soccer_env.train.papers.claims import all_claims
from soccer_env.train.papers.report import units_of, with_interval
from soccer_env.train.papers.results import ClaimResult, plot_name, rules_in_words, seeds_in_letters
from soccer_env.train.papers.verdicts import CONTEXT, NOT, VERDICTS
from soccer_env.train.results_folder import SETTINGS, read_settings

SHOWN = Path(__file__).resolve().parents[3] / "soccer_env" / "pictures"
NOT_MEASURED = "not measured"
KEPT = (  # of a result
    "id", "statement", "section", "verdict", "by_seed", "quick", "n", "n_used", "command", "note", "changed", "without",
    "pose", "rules",
)  # fmt: skip

Measured = Mapping[str, Mapping[str, Any]]  # claim: what the table keeps of it


@dataclass(frozen=True)
class PaperPage:
    """The page of a team, in `folder`: README.md and claims.json."""

    folder: Path
    paper: str
    pictures: Mapping[str, int]  # that the page shows: a claim's figure, by its number
    measure: Callable[[], Path]  # measures every claim and returns the folder of the run
    tables: Mapping[str, Callable[[], str]]  # beside that of the claims

    @property
    def claims(self) -> tuple[str, ...]:
        """Return the ids of the paper's claims."""
        return tuple(claim.id for claim in all_claims().values() if claim.paper == self.paper and not claim.study)

    def stored(self) -> dict[str, dict[str, Any]]:
        """Return what claims.json holds."""
        path = self.folder / "claims.json"
        found: dict[str, dict[str, Any]] = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
        return found

    def take(self, run: Path) -> dict[str, dict[str, Any]]:
        """Return the paper's claims that a run of `soccer reproduce` left in a folder; ValueError without any.

        Figures that the page shows are copied; those of claims that the run lacks stay as they are.
        """
        about = read_settings(run / SETTINGS).get("about", {})
        results = [ClaimResult(**record) for record in read_lines(run / "claims.jsonl")]
        found = {result.id: taken(result, about) for result in results if result.id in self.claims}
        if not found:
            raise ValueError(f"{run} holds no claim of {self.paper}")
        for claim, number in self.pictures.items():
            drawn = run / plot_name(claim, number)
            if drawn.exists():
                write_whole(SHOWN / f"claim-{claim}.png", drawn.read_bytes())
        return found

    def with_tables(self, readme: str, measured: Measured) -> str:
        """Return the README with its tables between their markers."""
        tables = {"claims": claims_table(measured, self.claims), **{name: show() for name, show in self.tables.items()}}
        for name, table in tables.items():
            readme = between_markers(readme, name, table)
        return readme

    def write(self, measured: Measured) -> None:
        """Write claims.json and README.md."""
        ordered = with_notes({name: measured[name] for name in self.claims if name in measured})
        readme = self.folder / "README.md"
        write_whole(self.folder / "claims.json", json.dumps(ordered, indent=1) + "\n")
        write_whole(readme, self.with_tables(readme.read_text(encoding="utf-8"), ordered))

    def main(self, words: Sequence[str]) -> int:
        """Measure, take in runs or write; return the exit code."""
        if not words:
            self.write(self.take(self.measure()))
        elif [*words] == ["write"]:
            self.write(self.stored())
        elif words[0] == "run" and len(words) > 1:
            measured = self.stored()
            for folder in words[1:]:
                measured |= self.take(Path(folder))
            self.write(measured)
        else:
            print("usage: [run FOLDER ... | write], or nothing to measure every claim", file=sys.stderr)
            return 2
        return 0


def taken(result: ClaimResult, about: Mapping[str, str]) -> dict[str, Any]:
    """Return what the table keeps of a claim's result, with the date and commit of its run."""
    record = asdict(result)
    kept = {name: record[name] for name in KEPT}
    run = {name: about.get(name, "") for name in ("date", "commit")}
    kept |= {
        "findings": [short(one) for one in result.findings],
        "without_findings": [short(one) for one in result.without_findings],
        "criterion": result.criterion,
        "about": run,
    }
    return kept


def short(found: dict[str, Any]) -> dict[str, str]:
    """Return what the table keeps of a criterion."""
    return {"criterion": found["criterion"], "verdict": found["verdict"], "shown": with_interval(found)}


def claims_table(measured: Measured, claims: Sequence[str]) -> str:
    """Return every claim of a paper in Markdown: those without a result are shown as not measured."""
    says = {name: f"{claim.statement} [{claim.section}]" for name, claim in all_claims().items()}
    lines = [
        "| id | the paper says | measured (95 % interval) | n | verdict | seeds | rules | note |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for name in claims:
        row = measured.get(name)
        cells = (name, says.get(name, ""), "", "", NOT_MEASURED, "", "", "") if row is None else cells_of(row)
        lines.append("| " + " | ".join(cell.replace("|", "\\|").replace("\n", " ") for cell in cells) + " |")
    return "\n".join([counted(measured, claims), "", *lines, "", *sources(measured, claims)])


def cells_of(row: Mapping[str, Any]) -> tuple[str, ...]:
    """Return a row of the table of claims: every criterion, what decides in bold, what is reported in the note."""
    deciding = [one for one in row["findings"] if one["verdict"] != CONTEXT]
    shown = "<br>".join(f"{one['criterion']}{asked(one)}: **{one['shown']}**" for one in deciding or row["findings"])
    verdict = f"{row['verdict']} (quick)" if row["quick"] else row["verdict"]
    bold = f"**{verdict}**" if row["verdict"] == NOT else verdict
    marked = f"{bold} [changed]" if row["changed"] else bold
    says, n = f"{row['statement']} [{row['section']}]", units_of(row["n_used"], row["n"])
    seeds, rules = seeds_in_letters(row["by_seed"]), rules_in_words(row["rules"])
    return row["id"], says, shown, n, marked, seeds, rules, " ".join(notes_of(row))


def asked(found: Mapping[str, Any]) -> str:
    """Return where a criterion has to lie, in brackets."""
    return f" [{found['asked']}]" if found["asked"] else ""


def notes_of(row: Mapping[str, Any]) -> list[str]:
    """Return what stands in the last column: what was put in, or asked before, the note, what is reported beside it."""
    decides = any(one["verdict"] != CONTEXT for one in row["findings"])
    off = "; ".join(
        f"{one['criterion']}: {one['shown']}" for one in row["without_findings"] if one["verdict"] != CONTEXT
    )
    beside = "; ".join(f"{one['criterion']}: {one['shown']}" for one in row["findings"] if one["verdict"] == CONTEXT)
    notes = [
        f"With {row['without']}: {off}." if row["without"] else "",
        row["changed"],
        first_paragraph(row["note"]),
        f"Beside it: {beside}." if decides and beside else "",
    ]
    return [note for note in notes if note]


def first_paragraph(note: str) -> str:
    """Return a note up to its first empty line: what follows are tables."""
    return note.strip().partition("\n\n")[0]


def counted(measured: Measured, claims: Sequence[str]) -> str:
    """Return how many claims got which verdict."""
    counts = Counter(row["verdict"] for row in measured.values())
    parts = [f"{counts[verdict]} {verdict}" for verdict in VERDICTS if counts[verdict]]
    missing = len(claims) - len(measured)
    quick = sum(row["quick"] for row in measured.values())
    few = f" {quick} of them from few samples, marked (quick)." if quick else ""
    return f"{len(claims)} claims: {', '.join([*parts, *([f'{missing} {NOT_MEASURED}'] if missing else [])])}.{few}"


def sources(measured: Measured, claims: Sequence[str]) -> list[str]:
    """Return with what the rows were measured: one line for each run."""
    runs: dict[str, list[str]] = {}
    for name in claims:
        if name in measured:
            about = measured[name]["about"]
            runs.setdefault(f"{about.get('date', '')}, commit {about.get('commit') or 'none'}", []).append(name)
    return [f"Measured {run}: {', '.join(names)}." for run, names in runs.items()]


def with_notes(measured: Measured) -> dict[str, dict[str, Any]]:
    """Return results with the notes that their claims have now: a note that is a text was never measured."""
    claims = all_claims()
    bounds = {(name, one.text): one.asked for name, claim in claims.items() for one in claim.criteria}
    notes = {name: claim.note for name, claim in claims.items() if isinstance(claim.note, str)}
    return {
        name: {
            **row,
            "note": notes.get(name, row["note"]),
            "statement": claims[name].statement,
            "changed": claims[name].changed,
            "findings": [
                one | {"asked": bounds.get((name, one["criterion"]), "") if one["verdict"] != CONTEXT else ""}
                for one in row["findings"]
            ],
        }
        for name, row in measured.items()
    }
