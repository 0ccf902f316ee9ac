"""`soccer bench --peers`: time other environments beside the batched core, each in an environment of its own.

Every environment has a process (`peer_worker.py`), and processes are asked in the order A B C C B A, so that a machine
that grows warm or busy slows all alike. A peer and a league make two pairs in each repetition; the interval of a ratio
is a bootstrap over pairs, as for `--against`. pip installs a peer at its first use; a peer that cannot be installed or
run is left out, with the reason. hockey-env is not on the Python package index.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from soccer_env.compiling.cache import cache_folders
from soccer_env.guards.whole_files import write_atomically
from soccer_env.train.bench.against import Worker, ratio_of, select_rows
from soccer_env.train.bench.benchmark import machine
from soccer_env.train.bench.settings import BenchSettings
from soccer_env.train.bench.worker import LEAGUES
from soccer_env.train.progress import Progress

if TYPE_CHECKING:
    from rich.table import Table

WORKER = Path(__file__).with_name("peer_worker.py")
OWN = "soccer_env"
SIDES = (("theirs", "their_seconds"), ("ours", "our_seconds"))  # fields of a PeerRow
READY = "ready"  # file in the environment of a peer that pip has installed whole

Loads = tuple[tuple[int, int], ...]  # matches side by side, threads
Pairs = dict[str, list[tuple[float, float]]]  # row -> seconds of a match step of the peer and of ours


@dataclass(frozen=True)
class Peer:
    """An environment that pip installs, and the loads that are timed."""

    name: str  # in peer_worker.py
    title: str
    requirements: tuple[str, ...]  # of pip
    rate: float  # [Hz] control steps in a simulated second
    loads: Loads = ((1, 1),)


PEERS = (
    Peer(
        "vmas", "VMAS 1.5.2 football", ("torch==2.13.0", "vmas==1.5.2"), 10.0,
        ((1, 1), (32, 1), (512, 1), (4096, 1), (4096, 2)),
    ),
    Peer("psim", "pSim 0.2.4", ("psim==0.2.4", "gymnasium==1.2.3", "pettingzoo==1.25.0"), 60.0),
    Peer("rsoccer", "rSoccer 1.4 VSS", ("rsoccer-gym==1.4", "rc-robosim==1.2"), 40.0),
)  # fmt: skip


@dataclass(frozen=True)
class PeerRow:
    """The speed of a league beside the speed of a peer, at the same number of matches and threads."""

    name: str
    theirs: float  # [match steps/s] median
    ours: float
    their_seconds: float  # [simulated s/s]
    our_seconds: float
    ratio: float  # of match steps/s, ours over theirs
    low: float  # of its 95 % interval
    high: float


class LeftOutError(Exception):
    """The reason why a peer cannot be timed."""


def compare_peers(settings: BenchSettings, peers: tuple[Peer, ...] = PEERS, script: Path = WORKER) -> dict[str, Any]:
    """Measure all peers and return the report that --out writes: machine, rows, peers left out and pairs."""
    pairs: Pairs = {}
    left_out: dict[str, str] = {}
    before = machine()
    chosen = select_rows([row for peer in peers for row in row_names(peer)], settings.rows)
    wanted = [peer for peer in peers if not set(chosen).isdisjoint(row_names(peer))]
    with Progress("bench", sum(1 + settings.rounds * len(peer.loads) for peer in wanted)) as progress:
        for peer in wanted:
            progress.note(peer.title)
            try:
                python = install(peer)
                progress.advance(1)
                for _ in range(settings.rounds):
                    for _ in time_peer(peer, python, settings.repetitions, script, chosen, pairs):
                        progress.advance(1)
            except LeftOutError as reason:
                left_out[peer.title] = str(reason)
    rows = [asdict(peer_row(peer, name, pairs[name])) for peer in wanted for name in row_names(peer) if name in pairs]
    report = {"machine": before, "rows": rows, "left_out": left_out, "pairs": pairs}
    if settings.out is not None:
        settings.out.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(settings.out, json.dumps(report, indent=2) + "\n")
    return report


def row_names(peer: Peer) -> list[str]:
    """Return the names of a peer's rows: each league beside it, with each load."""
    return [row_name(peer, league, load) for load in peer.loads for league in LEAGUES]


def row_name(peer: Peer, league: str, load: tuple[int, int]) -> str:
    """Return the name of the row of a league beside a peer."""
    matches, threads = load
    return f"{league} over {peer.title}, {matches:,} at a time, {threads} thread{'s' if threads > 1 else ''}"


def time_peer(
    peer: Peer, python: Path, repetitions: int, script: Path, chosen: list[str], pairs: Pairs
) -> Iterator[None]:
    """Time the chosen rows of a peer and of both leagues by turns, in new processes; add to `pairs`, yield per load."""
    with ExitStack() as stack:
        theirs = stack.enter_context(start(python, script, peer.name, peer.loads))
        own = stack.enter_context(start(Path(sys.executable), script, OWN, peer.loads))
        for load in peer.loads:
            rows = {row: league for league in LEAGUES if (row := row_name(peer, league, load)) in chosen}
            of_load = f"{load[0]} {load[1]}"
            calls = [(theirs, f"{peer.name} {of_load}"), *((own, f"{league} {of_load}") for league in rows.values())]
            if rows:
                answers(calls)  # untimed: they build and compile
                for _ in range(repetitions):
                    for there, *here in (answers(calls), answers(calls[::-1])[::-1]):
                        for row, seconds in zip(rows, here, strict=True):
                            pairs.setdefault(row, []).append((there, seconds))
            yield


def answers(calls: list[tuple[Worker, str]]) -> list[float]:
    """Return the seconds of a match step of each process and its row; LeftOutError if one cannot be timed."""
    times = []
    for process, row in calls:
        try:
            seconds = process.sample(row)
        except ValueError as died:
            raise LeftOutError(str(died)) from died
        if seconds is None:
            raise LeftOutError(process.error)
        times.append(seconds)
    return times


@contextmanager
def start(python: Path, script: Path, name: str, loads: Loads) -> Iterator[Worker]:
    """Run the process of a peer, or our own, in an empty folder for the time of a `with`."""
    pipe = subprocess.PIPE
    command = [str(python), str(script), name, *(f"{matches}x{threads}" for matches, threads in loads)]
    variables = {**os.environ, "OMP_NUM_THREADS": "1", **({} if name == OWN else {"PYTHONPATH": ""})}
    with ExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory())
        said = stack.enter_context(open(Path(folder, "said"), "w+", encoding="utf-8"))
        process = stack.enter_context(
            subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=said, text=True, cwd=folder, env=variables)
        )
        stack.callback(process.kill)
        try:
            yield Worker(process, name)
        except ValueError as died:
            raise LeftOutError(last_line(Path(said.name).read_text(encoding="utf-8")) or str(died)) from died


def install(peer: Peer) -> Path:
    """Return the Python of a peer's environment, made by pip if new; LeftOutError if pip cannot get all it needs."""
    versions = "-".join(one.replace("==", "-") for one in peer.requirements)
    folder = cache_folders()[0].with_name(f"{cache_folders()[0].name}-peers") / versions
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    if (folder / READY).exists():
        return python
    shutil.rmtree(folder, ignore_errors=True)
    print(f"bench: installing {peer.title} ({' '.join(peer.requirements)}) into {folder}", file=sys.stderr, flush=True)
    for command in (
        [sys.executable, "-m", "venv", str(folder)],
        [str(python), "-m", "pip", "install", "--no-compile", *peer.requirements],
    ):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            shutil.rmtree(folder, ignore_errors=True)
            raise LeftOutError(f"pip cannot install it: {last_line(done.stderr + done.stdout)}")
    (folder / READY).touch()
    return python


def last_line(said: str) -> str:
    """Return the last line of an output that reports an error, else its last line."""
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    return next((line for line in reversed(lines) if line.startswith("ERROR")), lines[-1] if lines else "")


def peer_row(peer: Peer, name: str, pairs: list[tuple[float, float]]) -> PeerRow:
    """Return the row of a league beside a peer from their pairs of times."""
    ratio = ratio_of(name, pairs)
    theirs, ours, rate = 1 / ratio.here, 1 / ratio.there, LEAGUES[name.partition(" ")[0]]
    return PeerRow(name, theirs, ours, theirs / peer.rate, ours / rate, ratio.value, ratio.low, ratio.high)


def screen_table(report: dict[str, Any]) -> Table:
    """Return the speeds and ratios of a report as a table for the terminal."""
    from rich.table import Table

    lines = [", ".join(f"{name} {value}" for name, value in report["machine"].items())]
    lines += [f"left out: {title}: {reason}" for title, reason in report["left_out"].items()]
    drawn = Table(title="soccer bench: match steps/s (simulated s/s), 3 v 3, random actions", caption="\n".join(lines))
    for title, side in (("", "left"), ("theirs", "right"), ("ours", "right"), ("ratio", "right"), ("95 %", "right")):
        drawn.add_column(title, justify=side)  # type: ignore[arg-type]
    for row in report["rows"]:
        speeds = [f"{row[side]:,.0f} ({row[seconds]:,.0f})" for side, seconds in SIDES]
        drawn.add_row(row["name"], *speeds, f"{row['ratio']:.3g}", f"{row['low']:.3g} to {row['high']:.3g}")
    return drawn
