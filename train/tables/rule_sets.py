"""The claims that are judged from play, under the league's rules and under the simple ones, side by side.

Kept in rule_sets.json beside this file, by rule set and claim; `tables/sacks.py` has the commands and the page.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from soccer_env.train.reproduce.claim import LEAGUE
from soccer_env.train.reproduce.claims import all_claims
from soccer_env.train.reproduce.report import with_interval
from soccer_env.train.reproduce.reproduction import reproduce
from soccer_env.train.reproduce.results import ClaimResult, seeds_in_letters
from soccer_env.train.reproduce.settings import ReproduceSettings, command_of
from soccer_env.train.reproduce.verdicts import CONTEXT, NOT
from soccer_env.train.results_folder import SETTINGS, read_settings
from soccer_env.whole_files import write_whole

DATA = Path(__file__).with_name("rule_sets.json")
SETS = (LEAGUE, "simple")
PLAY = tuple(claim.id for claim in all_claims().values() if LEAGUE in claim.rules and not claim.study)
MISSING = "not measured"

Measured = Mapping[str, Mapping[str, Mapping[str, Any]]]  # rule set: claim: row


def settings_of(rules: str, quick: bool) -> ReproduceSettings:
    """Return the run behind a column; it goes on where it was stopped."""
    out = Path("runs") / f"claims-{rules}{'-quick' if quick else ''}"
    return ReproduceSettings(claims=PLAY, rules=rules, quick=quick, threads=2, out=out)  # type: ignore[arg-type]


def measure(quick: bool = False) -> None:
    """Measure all claims that are judged from play under both rule sets, and write rule_sets.json."""
    found = {rules: measured_under(settings_of(rules, quick)) for rules in SETS}
    write_whole(DATA, json.dumps(found, indent=1) + "\n")


def measured_under(settings: ReproduceSettings) -> dict[str, dict[str, Any]]:
    """Return what the table keeps of each claim of a run."""
    results = reproduce(settings)
    about = {} if settings.out is None else read_settings(settings.out / SETTINGS).get("about", {})
    run = {"command": command_of(settings), "date": about.get("date", ""), "commit": about.get("commit") or "none"}
    return {result.id: row_of(result) | {"about": run} for result in results}


def row_of(result: ClaimResult) -> dict[str, Any]:
    """Return what the table keeps of a claim."""
    deciding = [one for one in result.findings if one["verdict"] != CONTEXT]
    return {
        "verdict": result.verdict,
        "quick": result.quick,
        "by_seed": result.by_seed,
        "n": result.n,
        "criteria": {
            one["criterion"]: {"asked": one["asked"], "shown": with_interval(one), "verdict": one["verdict"]}
            for one in deciding
        },
    }


def shown(measured: Measured) -> str:
    """Return the claims under both rule sets in Markdown; what was not measured says so."""
    heads = (f"`{rules}`: {what}" for what in ("verdict", "measured (95 % interval)") for rules in SETS)
    lines = [f"| id | asked | {' | '.join(heads)} |", "|---|---|---|---|---|---|"]
    for name in PLAY:
        rows = [measured.get(rules, {}).get(name) for rules in SETS]
        criteria: Mapping[str, Any] = next((row["criteria"] for row in rows if row), {})
        asked = "<br>".join(f"{text} [{one['asked']}]" for text, one in criteria.items())
        values = ["<br>".join(f"**{one['shown']}**" for one in row["criteria"].values()) if row else "" for row in rows]
        lines.append(f"| {' | '.join((name, asked, *map(verdict_of, rows), *values))} |")
    return "\n".join([*lines, "", *sources(measured)])


def verdict_of(row: Mapping[str, Any] | None) -> str:
    """Return a verdict with those of single seeds, bold where the claim does not hold."""
    if row is None:
        return MISSING
    verdict = f"{row['verdict']} (quick)" if row["quick"] else row["verdict"]
    return f"{f'**{verdict}**' if row['verdict'] == NOT else verdict} ({seeds_in_letters(row['by_seed'])})"


def sources(measured: Measured) -> Iterable[str]:
    """Yield with what each column was measured."""
    for rules in SETS:
        runs = [row["about"] for row in measured.get(rules, {}).values()]
        if runs:
            yield f"`{runs[0]['command']}`, {runs[0]['date']}, commit {runs[0]['commit']}."


def stored() -> dict[str, dict[str, dict[str, Any]]]:
    """Return what rule_sets.json holds; nothing if it was never measured."""
    found: dict[str, dict[str, dict[str, Any]]] = json.loads(DATA.read_text(encoding="utf-8")) if DATA.exists() else {}
    return found
