"""`soccer bench --soak 20`: play millions of match steps, and see that memory, open files and time stay flat."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median
from time import process_time
from typing import Any

from soccer_env.guards.whole_files import write_atomically
from soccer_env.match import Match
from soccer_env.replay import Recorder, Replay
from soccer_env.train.bench.benchmark import Row, machine, row_with_maximum
from soccer_env.train.bench.loads import CoreLoad
from soccer_env.train.bench.settings import BenchSettings
from soccer_env.train.progress import Progress

TEAMS, RECORDED = 0.03, 0.02  # [1] share of the steps: teams by sensors; matches that are recorded. The others: random
CLIP = 50  # control steps of a recording
LAPS = 9  # at least: the first is not counted, thirds of the others are compared
MEMORY_GROWTH, TIME_GROWTH = 1.02, 1.2  # [1] last third over first; no file may stay open


@dataclass(frozen=True)
class Lap:
    """A part of a soak: match steps played by its end, processor time of each, and what the process then held."""

    steps: int
    seconds: float  # a match step
    memory: float  # [bytes] resident
    files: int  # open


class Mixture:
    """Random play on two threads, teams that sense, and matches whose recordings are written, read and checked."""

    def __init__(self, matches: int, seed: int) -> None:
        self.random = CoreLoad("legged-2001", None, matches, 2, seed)
        self.teams = CoreLoad("middle-size-2006", "chaser", max(1, matches // 4), 1, seed, "particles")
        both = {"home": "chaser", "away": "chaser"}
        self.recorded = Match(matches=4, controllers=both, autoreset="same_step", minutes=1.0, seed=seed)

    def play(self, steps: int, path: Path) -> int:
        """Play about so many match steps; return how many. Recordings lie at `path` meanwhile."""
        played = 0
        for load, share in ((self.random, 1.0 - TEAMS - RECORDED), (self.teams, TEAMS)):
            turns = max(1, round(share * steps / load.match.count))
            load.run(turns)
            played += turns * load.match.count
        for _ in range(max(1, round(RECORDED * steps / (2 * CLIP * self.recorded.count)))):
            played += self.record(path)
        return played

    def record(self, path: Path) -> int:
        """Record CLIP control steps, write them, read them and play them again; return the number of match steps."""
        recorder = Recorder(self.recorded)
        for _ in range(CLIP):
            self.recorded.step()
        again = Replay.read(recorder.stop().write(path)).check()
        return (CLIP + again) * self.recorded.count


def measure_soak(settings: BenchSettings) -> dict[str, Any]:
    """Play `settings.soak` million match steps in laps; return the report that --out writes: machine, rows, laps."""
    count = max(LAPS, round(settings.soak))
    mixture, laps = Mixture(settings.matches, settings.seed), []
    total, each = 0, round(1e6 * settings.soak / count)
    with tempfile.TemporaryDirectory() as folder, Progress("bench", count) as progress:
        for _ in range(count):
            start = process_time()
            played = mixture.play(each, Path(folder, "soak.replay"))
            total += played
            laps.append(
                Lap(total, (process_time() - start) / played, resident_bytes(), len(os.listdir("/proc/self/fd")))
            )
            progress.note(lap_text(laps[-1]))
            progress.advance(1)
    report = {"machine": machine(), "rows": [asdict(row) for row in soak_rows(laps)], "laps": [*map(asdict, laps)]}
    if settings.out is not None:
        settings.out.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(settings.out, json.dumps(report, indent=2) + "\n")
    return report


def soak_rows(laps: list[Lap]) -> Iterator[Row]:
    """Yield a row for each lap, and what the last third of them has more than the first; the first lap warms up."""
    for lap in laps:
        yield Row(f"after {lap.steps:,} match steps", lap.seconds, lap_text(lap))
    third = (len(laps) - 1) // 3
    first, last = laps[1 : 1 + third], laps[-third:]
    for name, limit in (("memory", MEMORY_GROWTH), ("seconds", TIME_GROWTH)):
        before, after = (median(getattr(lap, name) for lap in part) for part in (first, last))
        yield row_with_maximum(f"{name}, last third over first", after / before, "", limit)
    grown = max(lap.files for lap in last) - max(lap.files for lap in first)
    yield row_with_maximum("files opened and not closed", float(grown), "", 0.0)


def lap_text(lap: Lap) -> str:
    """Return what a lap took and left."""
    return f"{1e6 * lap.seconds:.2f} us a step, {lap.memory / 2**20:,.1f} MiB, {lap.files} files"


def resident_bytes() -> int:
    """Return the resident memory of this process."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")
