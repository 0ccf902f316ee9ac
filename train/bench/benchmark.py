"""`soccer bench`: ratios of interleaved timings in one run, as medians, with a description of the machine."""

from __future__ import annotations

import datetime
import json
import os
import platform
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING, Any

from soccer_env.guards.whole_files import write_atomically
from soccer_env.leagues import find_league
from soccer_env.train.bench.apis import (
    START_TIMES,
    interleave_samples,
    process_start_time,
    record_bytes,
    wrapper_bytes,
)
from soccer_env.train.bench.loads import CoreLoad, Load, OwnPhysicsLoad, PictureLoad, ReferencePhysicsLoad
from soccer_env.train.bench.plans import PlanLoad, TeamLoad
from soccer_env.train.bench.settings import BenchSettings
from soccer_env.train.bench.worker import api_timer, branch_timer
from soccer_env.train.progress import Progress
from soccer_env.train.provenance import LIBRARIES, commit, version_of

if TYPE_CHECKING:
    from rich.table import Table

LEAGUES = ("legged-2001", "middle-size-2006")
OWN_RATIO = 1.8  # core over its own scene, random load; this and all limits below are promises of the package
REFERENCE_RATIO = {"legged-2001": 5.0, "middle-size-2006": 2.5}
CHASER_SPEED = {"legged-2001": 8_000.0, "middle-size-2006": 20_000.0}  # [match steps/s]
SENSES_RATIO = 3.0  # all robots with sensors and beliefs, over ideal senses
PARTICLES_RATIO = 2.0  # localisation by particle filters, over a given noisy pose
VARIATION_RATIO = 1.05  # all numbers varied, over none, with sensors and beliefs
SENSES_BYTES = {"percept": 16 * 1024, "particles": 64 * 1024}  # of a match outside Chipmunk
BELIEF_API_SPEED = 6_000.0  # [steps/s] with observe="belief"
THREADS_RATIO = 1.7  # two threads over one
API_SPEED = 10_000.0  # [steps/s]
RESET_TIME = 1e-3  # [s]
BRANCH_TIME = 0.6e-3  # [s] to copy a match and its Space over another match in mid-play
PASS_TIME, PLAN_TIME = 25e-6, 60e-6  # [s] of the middle-size planner: one pass, one plan, over 5 m past nine others
PLAN_TIME_99 = 1e-3  # [s] of one plan in a hundred
PICTURE_TIME = 5e-3  # [s] of a frame, 960 px wide
TEAM_TIME, TEAM_SPEED = 25e-6, 2500.0  # [s] of a robot's decision in the team of 2006, [1/s] match steps of its 5 v 5
RECORD_BYTES = 16 * 1024  # of a match outside Chipmunk
START_LIMITS = {"import soccer_env": 1.5, "soccer --help": 0.6, "start of an evaluation": 3.0}  # [s]
COLD_LIMIT = 60.0  # [s]
BUSY = 0.5  # load of the last minute above which other programs disturb the timings

Samples = dict[str, list[float]]


@dataclass(frozen=True)
class Row:
    """A row of the report: a measured number and its target, if it has one."""

    name: str
    value: float
    text: str  # the value with its unit
    target: str = ""
    met: bool | None = None  # None: no target


def row_with_maximum(name: str, value: float, unit: str, limit: float, scale: float = 1.0) -> Row:
    """Return a row whose target is a value of at most `limit`; value and limit are shown multiplied by `scale`."""
    return Row(name, value, f"{value * scale:.3g} {unit}".strip(), f"<= {limit * scale:g}", value <= limit)


def row_with_minimum(name: str, value: float, unit: str, limit: float) -> Row:
    """Return a row whose target is a value of at least `limit`."""
    shown = f"{value:,.0f} {unit}" if value >= 100 else f"{value:.3g} {unit}"
    return Row(name, value, shown.strip(), f">= {limit:,g}", value >= limit)


def run_benchmark(settings: BenchSettings) -> dict[str, Any]:
    """Measure everything and return the report that --out writes: machine, rows and samples."""
    report: dict[str, Any] = {"machine": machine(), "settings": {**asdict(settings), "out": str(settings.out or "")}}
    rows: list[Row] = []
    samples: dict[str, Samples] = {}
    with Progress("bench", 4) as progress:
        for league in LEAGUES:
            progress.note(league)
            samples[league] = measure_core(league, settings)
            rows += core_rows(league, samples[league])
            loads = {
                "step": api_timer(league, False, 1, 125),
                "belief": api_timer(league, False, 1, 125, observe="belief"),
                "reset": api_timer(league, True, 1, 50),
                "branch": branch_timer(league, 1, 50),
                "branches": branch_timer(league, 1, 20, together=True),
            }
            samples[f"{league} APIs"] = interleave_samples(loads, settings.repetitions)
            rows += api_rows(league, samples[f"{league} APIs"])
            progress.advance(1)
        progress.note("planning")
        rows += plan_rows(settings)
        rows += team_rows(settings)
        progress.advance(1)
        rows += picture_rows(settings)
        progress.note("starting")
        rows += start_rows(settings)
    report |= {"rows": [asdict(row) for row in rows], "samples": samples}
    if settings.out is not None:
        settings.out.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(settings.out, json.dumps(report, indent=2) + "\n")
    return report


def measure_core(league: str, settings: BenchSettings) -> Samples:
    """Return the samples [s per match step] of the core, and of the bare physics beneath it, in one league."""
    matches = settings.matches
    seed = settings.seed
    steps = settings.steps
    loads: dict[str, Load] = {
        "reference": ReferencePhysicsLoad(matches, seed),
        "random floor": OwnPhysicsLoad(league, None, matches, 1, seed),
        "random": CoreLoad(league, None, matches, 1, seed),
        "random, 2 threads": CoreLoad(league, None, matches, 2, seed),
        "senses": CoreLoad(league, None, matches, 1, seed, "percept"),
        "particles": CoreLoad(league, None, matches, 1, seed, "particles"),
        "varied": CoreLoad(league, None, matches, 1, seed, "percept", varied=True),
        "chaser floor": OwnPhysicsLoad(league, "chaser", matches, 1, seed),
        "chaser": CoreLoad(league, "chaser", matches, 1, seed),
        "chaser, 2 threads": CoreLoad(league, "chaser", matches, 2, seed),
    }
    return interleave_samples({name: partial(load.sample, steps) for name, load in loads.items()}, settings.repetitions)


def ratio(samples: Samples, above: str, below: str) -> float:
    """Return the ratio of the times of two loads: the median over the repetitions."""
    return median(a / b for a, b in zip(samples[above], samples[below], strict=True))


def core_rows(league: str, samples: Samples) -> Iterator[Row]:
    """Yield the core's ratios and speeds in one league."""
    rate = find_league(league).control_rate
    for name in ("reference", "random floor", "chaser floor"):
        yield Row(f"{league}: bare physics, {name}", median(samples[name]), f"{1e6 * median(samples[name]):.2f} us")
    yield row_with_maximum(
        f"{league}: random over its own scene", ratio(samples, "random", "random floor"), "", OWN_RATIO
    )
    limit = REFERENCE_RATIO[league]
    yield row_with_maximum(f"{league}: random over the reference", ratio(samples, "random", "reference"), "", limit)
    yield row_with_maximum(
        f"{league}: sensors and beliefs over the truth", ratio(samples, "senses", "random"), "", SENSES_RATIO
    )
    cost = ratio(samples, "particles", "senses")
    yield row_with_maximum(f"{league}: particle filters over a given pose", cost, "", PARTICLES_RATIO)
    cost = ratio(samples, "varied", "senses")
    yield row_with_maximum(f"{league}: variation of all numbers over none", cost, "", VARIATION_RATIO)
    for load in ("senses", "particles"):
        speed = 1 / median(samples[load])
        yield Row(f"{league}: {load}", speed, f"{speed:,.0f} match steps/s ({speed / rate:,.0f} simulated s/s)")
    for load in ("random", "chaser"):
        speed, double = 1 / median(samples[load]), 1 / median(samples[f"{load}, 2 threads"])
        unit = f"match steps/s ({speed / rate:,.0f} simulated s/s)"
        if load == "chaser":
            yield row_with_minimum(f"{league}: chaser against chaser", speed, unit, CHASER_SPEED[league])
            own = ratio(samples, "chaser", "chaser floor")
            yield Row(f"{league}: chaser over its own scene", own, f"{own:.3g}")
        else:
            yield Row(f"{league}: random", speed, f"{speed:,.0f} {unit}")
        gain = ratio(samples, load, f"{load}, 2 threads")
        unit = f"({double:,.0f} match steps/s)"
        yield row_with_minimum(f"{league}: {load}, two threads over one", gain, unit, THREADS_RATIO)


def api_rows(league: str, samples: Samples) -> Iterator[Row]:
    """Yield the PettingZoo API's speed and the memory of a match in one league."""
    yield row_with_minimum(f"{league}: parallel_env.step", 1 / median(samples["step"]), "steps/s", API_SPEED)
    belief = 1 / median(samples["belief"])
    yield row_with_minimum(f"{league}: parallel_env.step, observe belief", belief, "steps/s", BELIEF_API_SPEED)
    yield row_with_maximum(f"{league}: parallel_env.reset", median(samples["reset"]), "ms", RESET_TIME, 1e3)
    for load, name in (("branch", "a branch of a sensing match"), ("branches", "the same, into 64 matches at once")):
        yield row_with_maximum(f"{league}: {name}", median(samples[load]), "ms", BRANCH_TIME, 1e3)
    name = f"{league}: memory of a match outside Chipmunk"
    yield row_with_maximum(name, record_bytes(league), "KiB", RECORD_BYTES, 1 / 1024)
    for pose, limit in SENSES_BYTES.items():
        yield row_with_maximum(f"{name}, sensing ({pose})", record_bytes(league, pose), "KiB", limit, 1 / 1024)
    wrappers = wrapper_bytes(league)
    yield Row(f"{league}: pymunk's Python objects of a match", wrappers, f"{wrappers / 1024:.3g} KiB")


def plan_rows(settings: BenchSettings) -> Iterator[Row]:
    """Yield the times of the middle-size planner."""
    passes, plans = PlanLoad(settings.seed).sample(200 if settings.quick else 1000)
    where = "over 5 m past nine obstacles"
    yield row_with_maximum(f"planner: one backward pass {where}", median(passes), "us", PASS_TIME, 1e6)
    yield row_with_maximum(f"planner: one plan {where}", median(plans), "us", PLAN_TIME, 1e6)
    slowest = sorted(plans)[round(0.99 * (len(plans) - 1))]
    yield row_with_maximum(f"planner: one plan {where}, 99 % are faster", slowest, "us", PLAN_TIME_99, 1e6)


def team_rows(settings: BenchSettings) -> Iterator[Row]:
    """Yield the time of a decision of the team of 2006, and the speed of its matches with sensors."""
    load = TeamLoad(settings.seed)
    tries = 3 if settings.quick else 9
    decision = median(load.decide(20) for _ in range(tries))
    yield row_with_maximum("heinemann-2006: a robot's decision", decision, "us", TEAM_TIME, 1e6)
    speed = 1 / median(load.sample(25) for _ in range(tries))
    yield row_with_minimum("heinemann-2006: 5 v 5 by sensors and particles", speed, "match steps/s", TEAM_SPEED)


def picture_rows(settings: BenchSettings) -> Iterator[Row]:
    """Yield the times to draw a picture, if the extra `render` is installed."""
    frames = 50 if settings.quick else 250
    for league in LEAGUES:
        try:
            load = PictureLoad(league, settings.seed)
        except ImportError:
            return
        plain = median(load.sample(frames, False))
        yield row_with_maximum(f"{league}: a picture, 960 px wide", plain, "ms", PICTURE_TIME, 1e3)
        over = median(load.sample(frames, True))
        yield row_with_maximum(f"{league}: the same with belief, trail and roles", over, "ms", PICTURE_TIME, 1e3)


def start_rows(settings: BenchSettings) -> Iterator[Row]:
    """Yield the start-up times."""
    for name, program in START_TIMES.items():
        yield row_with_maximum(name, process_start_time(program, 3 if settings.quick else 7), "s", START_LIMITS[name])
    if not settings.quick:
        cold = process_start_time(START_TIMES["start of an evaluation"], 1, cold=True)
        yield row_with_maximum("the same with an empty cache", cold, "s", COLD_LIMIT)


def machine() -> dict[str, str]:
    """Return the processor, system, versions, commit and date of the measurement."""
    return {
        "processor": processor(),
        "cores": f"{os.cpu_count()}",
        "load before": f"{os.getloadavg()[0]:.2f}" if hasattr(os, "getloadavg") else "nan",
        "system": f"{platform.system()} {platform.release()} {platform.machine()}",
        "python": platform.python_version(),
        **{name: version_of(name) for name in LIBRARIES},
        "commit": commit() or "none",
        "date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
    }


def processor() -> str:
    """Return the name of the processor."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8", errors="replace").splitlines() if info.exists() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or "unknown"


def screen_table(report: dict[str, Any]) -> Table:
    """Return the rows of a report as a table for the terminal."""
    from rich.table import Table

    caption = ", ".join(f"{name} {value}" for name, value in report["machine"].items())
    if float(report["machine"]["load before"]) > BUSY:
        caption += f"\nThe machine was busy at the start (load above {BUSY:g}): do not trust these times."
    drawn = Table(title="soccer bench", caption=caption)
    for name, side in (("", "left"), ("measured", "right"), ("target", "right"), ("", "left")):
        drawn.add_column(name, justify=side)  # type: ignore[arg-type]
    for row in report["rows"]:
        drawn.add_row(row["name"], row["text"], row["target"], {True: "ok", False: "MISSED", None: ""}[row["met"]])
    return drawn
