"""The tables of what `soccer reproduce` measures: errors of the sensors over the range, and the claims."""

from pathlib import Path
from typing import Any

from soccer_env.train.papers.report import units_of, with_interval
from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.results import ClaimResult
from soccer_env.train.papers.settings import ReproduceSettings, command_of

RUN = Path("runs/claims")  # where all claims are measured, so that it can be stopped
SENSING = (  # what robots see and believe; claims about what they do stand in baselines/sacks_2001/README.md
    *(f"S{n:02}" for n in (*range(5, 22), *range(32, 42), 61, 66, 69, 70, 72)), "H26", "H27",
)  # fmt: skip


def sensor_settings() -> ReproduceSettings:
    """Return the run behind the table of the sensors' errors."""
    return ReproduceSettings(claims=("sensors",), seeds=(1,), threads=2)


def measure_all() -> list[ClaimResult]:
    """Measure every claim in RUN, from where an earlier call stopped."""
    return reproduce(ReproduceSettings(all=True, threads=2, out=RUN))


def measure_sensors() -> dict[str, Any]:
    """Measure the errors of all sensors and estimates over the range."""
    settings = sensor_settings()
    (result,) = reproduce(settings)
    return {"command": command_of(settings), "n": result.n, "note": result.note}


def measure_claims() -> dict[str, Any]:
    """Measure all claims and return those about sensing."""
    results = {result.id: result for result in measure_all()}
    settings = ReproduceSettings(claims=SENSING, threads=2)
    return {"command": command_of(settings), "rows": [row_of(results[name]) for name in SENSING]}


def row_of(result: ClaimResult) -> dict[str, Any]:
    """Return what the table keeps of a claim."""
    found = next((one for one in result.findings if one["criterion"] == result.criterion), None)
    return {
        "id": result.id,
        "statement": result.statement,
        "criterion": result.criterion,
        "estimate": with_interval(found) if found else "",
        "verdict": result.verdict,
        "seeds": result.alone,
        "n": units_of(result.n_used, result.n),
    }


def sensors_table(table: dict[str, Any]) -> str:
    """Return the errors of the sensors in Markdown."""
    return f"{table['note'].strip()}\n\nCommand: `{table['command']}`, n = {table['n']}."


def claims_table(table: dict[str, Any]) -> str:
    """Return the claims in Markdown."""
    lines = [
        "| id | the paper says | deciding criterion | measured (95 % interval) | n | verdict | each seed |",
        "|---|---|---|---|---|---|---|",
    ]
    for row in table["rows"]:
        verdict = f"**{row['verdict']}**" if row["verdict"] == "not" else row["verdict"]
        cells = (row["id"], row["statement"], row["criterion"], row["estimate"], str(row["n"]), verdict, row["seeds"])
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join([*lines, "", f"Command: `{table['command']}`."])
