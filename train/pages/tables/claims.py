"""Measurements by `soccer reproduce` for the pages: errors of the sensors over the range, and all claims."""

from pathlib import Path
from typing import Any

from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.results import ClaimResult
from soccer_env.train.papers.settings import ReproduceSettings, command_of

RUN = Path("runs/claims")  # folder of the run, which can be stopped and resumed


def measure_all() -> list[ClaimResult]:
    """Measure every claim in RUN, resuming an earlier call."""
    return reproduce(ReproduceSettings(all=True, threads=2, out=RUN))


def measure_sensors() -> dict[str, Any]:
    """Measure the errors of all sensors and estimates over the range."""
    settings = ReproduceSettings(claims=("sensors",), seeds=(1,), threads=2)
    (result,) = reproduce(settings)
    return {"command": command_of(settings), "n": result.n, "note": result.note}


def sensors_table(table: dict[str, Any]) -> str:
    """Return the table of the sensors' errors in Markdown."""
    return f"{table['note'].strip()}\n\nCommand: `{table['command']}`, n = {table['n']}."
