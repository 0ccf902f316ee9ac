"""The README of the team sacks-2001: what the paper says beside what was measured, and every setting with its source.

    python -m soccer_env.train.tables.sacks                 measure every claim of the paper (goes on where it stopped)
    python -m soccer_env.train.tables.sacks run FOLDER ...  take in what runs of `soccer reproduce` found
    python -m soccer_env.train.tables.sacks rules           measure the claims judged from play under league and simple
    python -m soccer_env.train.tables.sacks write           write README.md again from claims.json and the claims' notes

`rules --quick` takes few samples.

Measurements are kept in baselines/sacks_2001/claims.json; README.md beside it shows them between markers.
"""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from soccer_env.baselines.sacks_2001 import settings as sacks_settings
from soccer_env.train.files import read_lines
from soccer_env.train.reproduce.claim import SACKS
from soccer_env.train.reproduce.claims import all_claims
from soccer_env.train.reproduce.report import units_of, with_interval
from soccer_env.train.reproduce.results import ClaimResult, plot_name, rules_in_words, seeds_in_letters
from soccer_env.train.reproduce.verdicts import CONTEXT, NOT, VERDICTS
from soccer_env.train.results_folder import SETTINGS, read_settings
from soccer_env.train.tables import rule_sets
from soccer_env.train.tables.claims import RUN, measure_all
from soccer_env.train.tables.markers import between_markers
from soccer_env.train.tables.sacks_settings import constants_text, settings_table, variants_table
from soccer_env.whole_files import write_whole

FOLDER = Path(sacks_settings.__file__).resolve().parent
README, DATA = FOLDER / "README.md", FOLDER / "claims.json"
SHOWN = FOLDER.parents[1] / "soccer_env" / "pictures"
PICTURES = {"S06": 1, "S29": 1, "S35": 1, "S47": 1, "S63": 1}  # of the page: a claim's figure, by its number
CLAIMS = tuple(claim.id for claim in all_claims().values() if claim.paper == SACKS and not claim.study)
NOT_MEASURED = "not measured"
KEPT = (  # of a result
    "id", "statement", "section", "verdict", "by_seed", "quick", "n", "n_used", "command", "note", "changed", "without",
    "pose", "rules",
)  # fmt: skip


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


def take_folder(path: Path, claims: Sequence[str] = CLAIMS, paper: str = SACKS) -> dict[str, dict[str, Any]]:
    """Return the claims of a paper that a run of `soccer reproduce` left in a folder; ValueError without any."""
    about = read_settings(path / SETTINGS).get("about", {})
    results = [ClaimResult(**record) for record in read_lines(path / "claims.jsonl")]
    found = {result.id: taken(result, about) for result in results if result.id in claims}
    if not found:
        raise ValueError(f"{path} holds no claim of {paper}")
    return found


def take_pictures(path: Path, pictures: Mapping[str, int] = PICTURES) -> None:
    """Copy the figures that a page shows from a run's folder; those of claims that the run lacks stay as they are."""
    for claim, number in pictures.items():
        drawn = path / plot_name(claim, number)
        if drawn.exists():
            write_whole(SHOWN / f"claim-{claim}.png", drawn.read_bytes())


def measure() -> dict[str, dict[str, Any]]:
    """Measure every claim, in RUN, and return those of the paper."""
    measure_all()
    take_pictures(RUN)
    return take_folder(RUN)


def claims_table(measured: Mapping[str, Mapping[str, Any]], claims: Sequence[str] = CLAIMS) -> str:
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


def counted(measured: Mapping[str, Mapping[str, Any]], claims: Sequence[str] = CLAIMS) -> str:
    """Return how many claims got which verdict."""
    counts = Counter(row["verdict"] for row in measured.values())
    parts = [f"{counts[verdict]} {verdict}" for verdict in VERDICTS if counts[verdict]]
    missing = len(claims) - len(measured)
    quick = sum(row["quick"] for row in measured.values())
    few = f" {quick} of them from few samples, marked (quick)." if quick else ""
    return f"{len(claims)} claims: {', '.join([*parts, *([f'{missing} {NOT_MEASURED}'] if missing else [])])}.{few}"


def sources(measured: Mapping[str, Mapping[str, Any]], claims: Sequence[str] = CLAIMS) -> list[str]:
    """Return with what the rows were measured: one line for each run."""
    runs: dict[str, list[str]] = {}
    for name in claims:
        if name in measured:
            about = measured[name]["about"]
            runs.setdefault(f"{about.get('date', '')}, commit {about.get('commit') or 'none'}", []).append(name)
    return [f"Measured {run}: {', '.join(names)}." for run, names in runs.items()]


PARTS: dict[str, Callable[[Mapping[str, Mapping[str, Any]]], str]] = {
    "claims": claims_table,
    "rules": lambda _: rule_sets.shown(rule_sets.stored()),
    "constants": constants_text,
    "settings": lambda _: settings_table(),
    "variants": variants_table,
}


def with_parts(readme: str, measured: Mapping[str, Mapping[str, Any]]) -> str:
    """Return the README with its tables between their markers."""
    for name, show in PARTS.items():
        readme = between_markers(readme, name, show(measured))
    return readme


def stored() -> dict[str, dict[str, Any]]:
    """Return what claims.json holds."""
    found: dict[str, dict[str, Any]] = json.loads(DATA.read_text(encoding="utf-8")) if DATA.exists() else {}
    return found


def with_notes(measured: Mapping[str, Mapping[str, Any]]) -> dict[str, dict[str, Any]]:
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


def write(measured: Mapping[str, Mapping[str, Any]]) -> None:
    """Write claims.json and README.md."""
    ordered = with_notes({name: measured[name] for name in CLAIMS if name in measured})
    write_whole(DATA, json.dumps(ordered, indent=1) + "\n")
    write_whole(README, with_parts(README.read_text(encoding="utf-8"), ordered))


def main(arguments: Iterable[str]) -> int:
    """Measure, take in runs or write; return the exit code."""
    words = list(arguments)
    if not words:
        write(measure())
    elif words == ["write"]:
        write(stored())
    elif words in (["rules"], ["rules", "--quick"]):
        rule_sets.measure(quick="--quick" in words)
        write(stored())
    elif words[0] == "run" and len(words) > 1:
        measured = stored()
        for folder in words[1:]:
            measured |= take_folder(Path(folder))
            take_pictures(Path(folder))
        write(measured)
    else:
        choices = "[run FOLDER ... | rules [--quick] | write]"
        print(f"usage: python -m soccer_env.train.tables.sacks {choices}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
