"""`soccer bench --against CHECKOUT`: time each row in both checkouts, and return the ratio with its interval.

Each checkout has a process with its own interpreter and code (`worker.py`), which times one row per request. Requests
go in the order A B B A, so that a machine that grows warm or busy slows both alike; each half is a pair, and the
interval of the ratio is a bootstrap over pairs. Processes are restarted a few times, because the layout of code and
data in memory makes a process faster or slower for its whole life.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median
from typing import IO, TYPE_CHECKING, Any, cast

import numpy as np

from soccer_env.compiling.sources import ROOT as PACKAGE
from soccer_env.guards.whole_files import write_atomically
from soccer_env.train.bench.benchmark import machine
from soccer_env.train.bench.settings import BenchSettings
from soccer_env.train.progress import Progress
from soccer_env.train.statistics import unit_bootstrap

if TYPE_CHECKING:
    from rich.table import Table

WORKER = Path(__file__).with_name("worker.py")
INNER = ("baselines", "agents", "train")  # at the top of a checkout, imported from inside the package
HERE, THERE = "this checkout", "the other"

Pairs = dict[str, list[tuple[float, float]]]  # row -> seconds here and there


@dataclass(frozen=True)
class Ratio:
    """The ratio of a row's time in this checkout to its time in the other checkout."""

    name: str
    here: float  # [s] median
    there: float
    value: float  # [1] ratio of the medians
    low: float  # of its 95 % interval
    high: float

    @property
    def verdict(self) -> str:
        """Return "slower" or "faster" for this checkout, or "" if the interval of the ratio contains 1."""
        return "slower" if self.low > 1.0 else "faster" if self.high < 1.0 else ""


class Worker:
    """The process that times the rows of one checkout."""

    def __init__(self, process: subprocess.Popen[str], name: str) -> None:
        self.process, self.name = process, name
        self.error = ""  # why the latest row could not be timed
        self.rows: list[str] = self._answer()["rows"]

    def sample(self, row: str) -> float | None:
        """Return the seconds of one step of a row, or None if the checkout has no such row."""
        cast(IO[str], self.process.stdin).write(json.dumps({"row": row}) + "\n")
        cast(IO[str], self.process.stdin).flush()
        answer = self._answer()
        self.error = answer.get("error", "")
        if self.error:
            print(f"{self.name} has no row {row!r}: {self.error}", file=sys.stderr)
        return answer.get("seconds")

    def _answer(self) -> dict[str, Any]:
        line = cast(IO[str], self.process.stdout).readline()
        if not line:
            raise ValueError(f"the process of {self.name} ended with {self.process.wait()}; see above")
        return cast(dict[str, Any], json.loads(line))


def compare_checkouts(settings: BenchSettings, script: Path = WORKER) -> dict[str, Any]:
    """Measure both checkouts and return the report that --out writes: machine, checkouts, rows and pairs."""
    assert settings.against is not None
    if not (PACKAGE.parent / "train").is_dir():
        raise ValueError("--against compares checkouts, and this soccer_env is installed outside of one")
    checkouts = {HERE: PACKAGE.parent, THERE: settings.against}
    paths = {name: str(path) for name, path in checkouts.items()}
    pairs: Pairs = {}
    lacking: dict[str, str] = {}
    with Progress("bench", settings.rounds) as progress:
        for _ in range(settings.rounds):
            with ExitStack() as stack:
                here, there = (stack.enter_context(start_worker(checkouts[n], n, settings, script)) for n in checkouts)
                names = select_rows(here.rows, settings.rows)
                lacking |= {row: "only here" for row in names if row not in there.rows}
                for row in names:
                    progress.note(row)
                    if row not in lacking:
                        lacking |= time_row_pairs(row, here, there, settings.repetitions, pairs)
            progress.advance(1)
    rows = [ratio_of(name, times) for name, times in pairs.items() if name not in lacking]
    report = {
        "machine": machine(), "checkouts": paths, "rows": [asdict(row) | {"verdict": row.verdict} for row in rows],
        "lacking": lacking, "pairs": pairs,
    }  # fmt: skip
    if settings.out is not None:
        settings.out.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(settings.out, json.dumps(report, indent=2) + "\n")
    return report


def select_rows(rows: list[str], words: str) -> list[str]:
    """Return the rows whose names contain every word of `words`; ValueError if no name does."""
    matching = [row for row in rows if all(word in row for word in words.split())]
    if not matching:
        raise ValueError(f"no row contains {words!r}; rows: {'; '.join(rows)}")
    return matching


def time_row_pairs(row: str, here: Worker, there: Worker, repetitions: int, pairs: Pairs) -> dict[str, str]:
    """Time a row in the order A B B A and add its pairs to `pairs`; return {row: reason} if a checkout lacks it."""
    firsts = {worker.name: worker.sample(row) for worker in (here, there)}  # untimed: it builds and compiles
    missing = [name for name, first in firsts.items() if first is None]
    if missing:
        return {row: f"not in {' or '.join(missing)}"}
    for _ in range(repetitions):
        a, b, c, d = (worker.sample(row) for worker in (here, there, there, here))
        pairs.setdefault(row, []).extend([(a or 0.0, b or 0.0), (d or 0.0, c or 0.0)])
    return {}


def ratio_of(name: str, pairs: list[tuple[float, float]]) -> Ratio:
    """Return the ratio of the two medians of a row's pairs of times, with its interval."""
    here, there = np.array(pairs).T
    value, low, high = unit_bootstrap(
        {HERE: here, THERE: there}, lambda sample: float(np.median(sample[HERE]) / np.median(sample[THERE]))
    )
    return Ratio(name, median(here), median(there), value, low, high)


@contextmanager
def start_worker(checkout: Path, name: str, settings: BenchSettings, script: Path) -> Iterator[Worker]:
    """Run the process of a checkout for the time of a `with`. It imports the checkout's code, not an installed one."""
    with tempfile.TemporaryDirectory() as folder:
        link_packages(checkout, Path(folder))
        command = [interpreter_of(checkout), str(script), str(settings.matches), str(settings.steps)]
        variables = {**os.environ, "PYTHONPATH": folder, "OMP_NUM_THREADS": "1"}
        pipe = subprocess.PIPE
        with subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True, cwd=checkout, env=variables) as process:
            try:
                yield Worker(process, name)
            finally:
                process.kill()


def link_packages(checkout: Path, folder: Path) -> None:
    """Link a checkout's packages into `folder`, laid out as if installed; ValueError if `checkout` is no checkout."""
    package = folder / "soccer_env"
    package.mkdir()
    if not (checkout / "soccer_env" / "__init__.py").is_file():
        raise ValueError(f"{checkout} is no checkout: it has no soccer_env/__init__.py")
    for item in [*(checkout / "soccer_env").iterdir(), *(checkout / name for name in INNER)]:
        if not (package / item.name).exists():
            (package / item.name).symlink_to(item.resolve())


def interpreter_of(checkout: Path) -> str:
    """Return the Python that runs a checkout: its .venv's, else the current one."""
    own = checkout / ".venv" / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    return str(own) if own.exists() else sys.executable


def screen_table(report: dict[str, Any]) -> Table:
    """Return the ratios of a report as a table for the terminal."""
    from rich.table import Table

    lines = [f"{name}: {path}" for name, path in report["checkouts"].items()]
    lines += [f"{row}: {why}" for row, why in report["lacking"].items()]
    drawn = Table(title="soccer bench: time here over time there", caption="\n".join(lines))
    for title, side in (("", "left"), ("here", "right"), ("there", "right"), ("ratio", "right"), ("95 %", "right")):
        drawn.add_column(title, justify=side)  # type: ignore[arg-type]
    drawn.add_column("")
    for row in report["rows"]:
        times = [f"{1e6 * row[side]:,.3g} us" for side in ("here", "there")]
        drawn.add_row(
            row["name"], *times, f"{row['value']:.3f}", f"{row['low']:.3f} to {row['high']:.3f}", row["verdict"]
        )
    return drawn
