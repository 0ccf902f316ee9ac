"""`soccer bench --growth`: how costs grow with robots, players seen, matches, threads and the length of a replay.

The order of a curve is the slope of its larger sizes on logarithmic axes: 0 constant, 1 linear, 2 quadratic. It must
not exceed the order that the work needs: robots move one by one, but collide, see and are observed in pairs.
Times are processor times, except with two threads.
"""

from __future__ import annotations

import json
import multiprocessing
import tempfile
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

import numpy as np

from soccer_env.guards.whole_files import write_atomically
from soccer_env.match import Match
from soccer_env.replay import Recorder, Replay
from soccer_env.train.bench.benchmark import LEAGUES, Row, machine
from soccer_env.train.bench.loads import PLAYERS
from soccer_env.train.bench.profile import STAGES, StagedLoad
from soccer_env.train.bench.settings import BenchSettings
from soccer_env.train.bench.soak import resident_bytes
from soccer_env.train.bench.worker import IDEAL, SENSING, core_player
from soccer_env.train.progress import Progress
from soccer_env.train.report import can_draw
from soccer_env.train.report.style import HEIGHT, LINES, WIDTH, canvas, curve_styles, label_axes, picture_maker

ROBOTS = (1, 2, 3, 5, 8, 11)  # a side
MATCHES = tuple(4**power for power in range(8))  # 1 to 16,384
LENGTHS = (1000, 2000, 4000, 8000, 16_000)  # control steps of a replay
CROWD = 64  # matches side by side while robots are added
TIMED = 2048  # match steps in one timing, at least one step of all matches
HELD = 256  # matches whose memory is measured while robots are added
TIME = {"s": 1.0, "ms": 1e-3, "us": 1e-6}
MEMORY = {"GiB": 2.0**30, "MiB": 2.0**20, "KiB": 2.0**10}
PLAYED = 10  # control steps before the memory is read: Chipmunk keeps contacts for three
FITTED = 3  # sizes, the largest, through which the line goes
SLACK = 0.15  # of an order: caches miss more often when there is more
APPENDED = 500  # control steps of which the mean is the time to append one
UNDRAWN = ("a step: drive", "a step: referee")  # the cheapest stages: a panel has six colours


@dataclass(frozen=True)
class Curve:
    """Costs by size; `costs` are seconds, or bytes where `memory` says so."""

    name: str
    axis: str  # what the sizes count
    needed: float  # the order that the work needs
    sizes: tuple[int, ...]
    costs: list[float]
    memory: bool = False

    @property
    def order(self) -> float:
        """Return the slope of the FITTED largest sizes on logarithmic axes."""
        sizes, costs = np.log(self.sizes[-FITTED:]), np.log(self.costs[-FITTED:])
        return float(np.polyfit(sizes, costs, 1)[0])

    def row(self, league: str) -> Row:
        """Return the row of the report; it is met if the order is at most the needed one."""
        units = MEMORY if self.memory else TIME
        text = f"{with_unit(self.costs[0], units)} to {with_unit(self.costs[-1], units)}, order {self.order:.2f}"
        name = f"{league}: {self.name}, {self.sizes[0]:,} to {self.sizes[-1]:,} {self.axis}"
        return Row(name, self.order, text, f"order <= {self.needed:g}", self.order <= self.needed + SLACK)


def with_unit(cost: float, units: dict[str, float]) -> str:
    """Return a cost in the largest unit of which it is at least one, or in the smallest."""
    unit = next((unit for unit, size in units.items() if cost >= size), [*units][-1])
    return f"{cost / units[unit]:.3g} {unit}"


def measure_growth(settings: BenchSettings) -> dict[str, Any]:
    """Measure all curves; return the report that --out writes, and draw it beside as a PNG if matplotlib is there."""
    rows: list[Row] = []
    curves: dict[str, list[Curve]] = {}
    report: dict[str, Any] = {"machine": machine()}
    with Progress("bench", 4 * len(LEAGUES)) as progress:
        for league in LEAGUES:
            curves[league] = []
            for measure in (robot_curves, match_curves, memory_curves, replay_curves):
                progress.note(f"{league}: {measure.__name__}")
                curves[league] += measure(league, settings)
                progress.advance(1)
            rows += [curve.row(league) for curve in curves[league]]
    report["rows"] = [asdict(row) for row in rows]
    report["curves"] = {league: [asdict(curve) for curve in found] for league, found in curves.items()}
    if settings.out is not None:
        settings.out.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(settings.out, json.dumps(report, indent=2) + "\n")
        if can_draw():
            write_atomically(settings.out.with_suffix(".png"), draw_growth(curves))
    return report


def robot_curves(league: str, settings: BenchSettings) -> Iterator[Curve]:
    """Yield each stage of a step of chaser play by sensors and particles, and the sensors of one robot."""
    sides = ROBOTS[: 3 if settings.quick else None]
    loads = [StagedLoad(league, CROWD, settings.seed, players) for players in sides]
    rounds = [[load.stages(5) for load in loads] for _ in range(settings.repetitions)]  # loads take turns
    stages = {stage: [min(turn[n][stage] for turn in rounds) for n in range(len(sides))] for stage in STAGES}
    robots = tuple(2 * players for players in sides)
    for stage, costs in stages.items():
        yield Curve(f"a step: {stage}", "robots", 1.0 if stage == "drive" else 2.0, robots, costs)
    yield Curve("a step: all of it", "robots", 2.0, robots, [sum(costs) for costs in zip(*stages.values())])
    seen = tuple(count - 1 for count in robots)
    one = [cost / count for cost, count in zip(stages["sensors"], robots)]
    yield Curve("sensors of one robot", "players to see", 1.0, seen, one)


def match_curves(league: str, settings: BenchSettings) -> Iterator[Curve]:
    """Yield the time of a step of all matches, with one thread and with two; random actions, the truth."""
    counts = MATCHES[: 4 if settings.quick else None]
    for threads, clock, sizes in ((1, process_time, counts), (2, perf_counter, counts[:-1])):
        costs = []
        for count in sizes:
            play = core_player(league, None, {**IDEAL, "threads": threads}, count)
            costs.append(timed(play, max(1, TIMED // count), clock, settings.repetitions))
        yield Curve(f"a step, {threads} thread{'s' * (threads > 1)}", "matches", 1.0, sizes, costs)


def timed(play: Callable[[int], None], steps: int, clock: Callable[[], float], repetitions: int) -> float:
    """Return the seconds of a control step, the mean of `steps`, in the repetition that was disturbed least."""
    times = []
    for _ in range(repetitions):
        start = clock()
        play(steps)
        times.append((clock() - start) / steps)
    return min(times)


def memory_curves(league: str, settings: BenchSettings) -> Iterator[Curve]:
    """Yield the memory that matches take, with all of Chipmunk, by their number and by their robots."""
    counts = MATCHES[2 : 5 if settings.quick else -1]
    costs = held_by([{"matches": count, "home": PLAYERS, "away": PLAYERS, **IDEAL} for count in counts], league)
    yield Curve("memory of all matches", "matches", 1.0, counts, costs, memory=True)
    sides = ROBOTS[: 3 if settings.quick else None]
    costs = held_by([{"matches": HELD, "home": players, "away": players, **SENSING} for players in sides], league)
    robots = tuple(2 * players for players in sides)
    yield Curve("memory of a match that senses", "robots", 2.0, robots, [cost / HELD for cost in costs], memory=True)


def held_by(kinds: list[dict[str, Any]], league: str) -> list[float]:
    """Return the bytes by which a new process, with no freed memory to use again, grows with a Match of each kind."""
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as process:
        return process.submit(grow_by, kinds, league).result()


def grow_by(kinds: list[dict[str, Any]], league: str) -> list[float]:
    """Make, play and keep a Match of chasers of each kind; return the bytes by which this process grew."""
    kept, grown = [], []
    for kind in ({**kinds[0], "matches": 1}, *kinds):  # the first loads the compiled code
        before = resident_bytes()
        kept.append(Match(league, controllers={"home": "chaser", "away": "chaser"}, seed=0, **kind))
        for _ in range(PLAYED):
            kept[-1].step()
        grown.append(float(max(resident_bytes() - before, 1)))
    return grown[1:]


def replay_curves(league: str, settings: BenchSettings) -> Iterator[Curve]:
    """Yield what a replay of chaser play costs by its length: append a step, write, open, play to the end."""
    lengths = LENGTHS[: 3 if settings.quick else None]
    needed = {"append a step": 0.0, "write a replay": 1.0, "open a replay": 1.0, "seek to its end": 1.0, "file": 1.0}
    costs: dict[str, list[float]] = {name: [] for name in needed}
    with tempfile.TemporaryDirectory() as folder:
        for length in lengths:
            for name, cost in replay_costs(league, length, Path(folder, "replay")).items():
                costs[name].append(cost)
    for name, order in needed.items():
        yield Curve(name, "control steps", order, lengths, costs[name], memory=name == "file")


def replay_costs(league: str, length: int, path: Path) -> dict[str, float]:
    """Return the costs of one replay of so many control steps [s or bytes]."""
    chasers = {"home": "chaser", "away": "chaser"}
    match = Match(
        league, home=PLAYERS, away=PLAYERS, controllers=chasers, senses="ideal", autoreset="same_step", seed=0
    )
    recorder = Recorder(match)
    for _ in range(length - APPENDED):
        match.step()
    times = [process_time()]
    for _ in range(APPENDED):
        match.step()
    times.append(process_time())
    recorder.stop().write(path)
    times.append(process_time())
    replay = Replay.read(path)
    times.append(process_time())
    replay.check()
    times.append(process_time())
    append, write, read, seek = np.diff(times).tolist()
    named = {
        "append a step": append / APPENDED,
        "write a replay": write,
        "open a replay": read,
        "seek to its end": seek,
    }
    return {**named, "file": float(path.stat().st_size)}


@picture_maker
def draw_growth(curves: dict[str, list[Curve]]) -> Any:
    """Plot all curves on logarithmic axes, a panel for each axis and one for memory; leagues differ by their lines."""
    panels = ("robots", "matches", "control steps", "memory")
    drawn, axes = canvas(2 * HEIGHT, 1.6 * WIDTH, 2, 2)
    for panel, place in zip(panels, axes.flat, strict=True):
        for league, line in zip(curves, LINES):
            drawable = [curve for curve in curves[league] if curve.name not in UNDRAWN]
            shown = [curve for curve in drawable if panel == ("memory" if curve.memory else curve.axis)]
            for curve, (colour, marker, _) in zip(shown, curve_styles()):
                label = f"{curve.name}, by {curve.axis}" if curve.memory else curve.name
                costs = np.array(curve.costs) / (1024 if curve.memory else 1e-6)
                look: dict[str, Any] = {"color": colour, "marker": marker, "linestyle": line}
                place.loglog(curve.sizes, costs, label=label if line == LINES[0] else None, **look)
        for axis in (place.xaxis, place.yaxis):
            axis.set_major_formatter("{x:,g}")
            axis.set_minor_formatter("")
        if panel == "robots":
            place.set_xticks(curves[next(iter(curves))][0].sizes)
        low, high = place.get_ylim()
        place.set_ylim(top=high * (high / low) ** 0.25)  # room for the legend
        place.legend(loc="upper left", ncols=1 if panel == "memory" else 2, fontsize=7)
        label_axes(place, "", panel if panel != "memory" else "number", "[KiB]" if panel == "memory" else "[us]")
    drawn.suptitle(", ".join(f"{league} {line}" for league, line in zip(curves, ("solid", "dashed"))))
    return drawn
