"""The settings of a reproduction run.

The help of `soccer reproduce` is the text beside each field here.
"""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from math import floor
from pathlib import Path
from typing import Annotated, Literal

import tyro

from soccer_env.guards.checking import Range, check_whole_number, raise_not_allowed
from soccer_env.train.written_settings import CommandSettings


@dataclass(frozen=True)
class ReproduceSettings(CommandSettings):
    """Measure the claims of the papers and report whether each holds here.

    Each claim is sampled in batches, the same number for every seed, until the pooled 95 % interval decides the claim
    or its cap is reached; the report also shows each seed alone. The same claims, seeds and budget give the same
    results for any --threads. To resume a run that was stopped, give the same command again.
    """

    BOUNDS = {"minutes": Range(0.0, 100_000.0, above=True, below=True)}

    claims: tyro.conf.Positional[tuple[str, ...]] = ()
    """Ids of claims, such as S05 or H10 (`soccer list claims`); `sensors` plots all sensor errors over distance."""
    all: bool = False
    """Measure every claim."""
    quick: bool = False
    """Take few samples, for a first look: all claims together take a quarter of an hour of processor time. Verdicts are
    marked "(quick)"."""
    minutes: float | None = None
    """Budget in minutes of one core, split evenly among the claims; the number of samples follows from each claim's
    stated cost."""
    pose: Literal["particles", "percept"] = "particles"
    """How robots know where they are: by a particle filter, or by a given noisy pose (percept). A claim about the
    particle filter (H27) always uses it."""
    rules: Literal["league", "simple"] = "league"
    """Rule set for claims that are measured in matches: the league's whole rule book, or only goals, restarts and
    dropped balls. Other claims do not depend on it."""
    seeds: Annotated[tuple[int, ...], tyro.conf.arg(aliases=("--seed",))] = ()
    """Seeds, each 0 or more; the samples of all seeds are pooled. Leave out for 1 2 3, with --quick for 1 2."""
    threads: int = 1
    """Number of cores: several claims run in parallel processes, a single claim in threads. The results do not depend
    on it."""
    ray: str | None = None
    """Measure on a Ray cluster, a claim in each task: --ray alone starts one on this machine, auto or HOST:PORT joins
    one. Its cores replace --threads, and the results do not depend on it."""
    out: Path | None = None
    """Folder for claims.jsonl, results.json, report.md and plots; leave out to write no files."""
    anew: bool = False
    """Start afresh: remove the files of an earlier run from --out."""
    stored: bool = False
    """Print the stored results of the last measurement, and measure nothing."""
    json: bool = False
    """Print the contents of results.json instead of tables."""

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "claims", tuple(self.claims))
        object.__setattr__(self, "seeds", tuple(self.seeds) or self.usual_seeds)
        for seed in self.seeds:
            check_whole_number("seeds", seed, low=0)
        if len(set(self.seeds)) < len(self.seeds):
            raise_not_allowed("seeds", "whole numbers, each once", self.seeds)
        if bool(self.claims) == self.all:
            raise ValueError("give the ids of claims, or --all; `soccer list claims` names them")
        if self.quick and self.minutes is not None:
            raise ValueError("give quick or minutes, not both")
        if self.stored and (self.quick or self.minutes is not None or self.out is not None):
            raise ValueError("stored measures nothing: give it without quick, minutes and out")

    @property
    def usual_seeds(self) -> tuple[int, ...]:
        """Return the seeds of a run that names none."""
        return (1, 2) if self.quick else (1, 2, 3)

    @property
    def budget(self) -> str:
        """Return the budget of samples in words: "quick", "default" or "30 minutes"."""
        return "quick" if self.quick else "default" if self.minutes is None else f"{self.minutes:g} minutes"

    def cap(self, batches: int, quick: int, seconds: float, claims: int) -> int:
        """Return the largest number of batches that a claim may take for each seed, in a run of `claims` claims."""
        if self.quick:
            return quick
        runs = claims * len(self.seeds)
        return batches if self.minutes is None else max(1, floor(60.0 * self.minutes / runs / seconds))


def command_of(settings: ReproduceSettings, claim: str = "") -> str:
    """Return the command line with these settings, or one for a single claim that draws the same samples."""
    single = bool(claim) and settings.minutes is None  # the share of --minutes depends on all claims
    words = ["soccer", "reproduce", *((claim,) if single else settings.claims)]
    words += ["--all"] if settings.all and not single else []
    words += ["--quick"] if settings.quick else []
    words += ["--minutes", f"{settings.minutes:g}"] if settings.minutes is not None else []
    words += ["--pose", settings.pose] if settings.pose != ReproduceSettings.pose else []
    words += ["--rules", settings.rules] if settings.rules != ReproduceSettings.rules else []
    words += ["--seeds", *(f"{seed}" for seed in settings.seeds)] if settings.seeds != settings.usual_seeds else []
    if not claim:
        words += ["--threads", f"{settings.threads}"] if settings.threads != 1 else []
        words += ["--ray", settings.ray] if settings.ray is not None else []
        words += ["--out", str(settings.out)] if settings.out is not None else []
    return shlex.join(words)
