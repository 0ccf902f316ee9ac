"""The settings of a reproduction run: what the command line reads.

The help of `soccer reproduce` is the text beside each field here.
"""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from math import floor
from pathlib import Path
from typing import Annotated, Literal

import tyro

from soccer_env.guards.checking import Range, refuse, whole_number
from soccer_env.train.written_settings import CommandSettings


@dataclass(frozen=True)
class ReproduceSettings(CommandSettings):
    """Measure what the papers claim, and say of each claim whether it holds here.

    Samples are taken in batches, the same number from every seed, until the 95 % interval of all of them together
    decides a claim or its cap is reached; what each seed says by itself stands beside it. The same claims, seeds and
    budget give the same results whatever --threads is. A run that was stopped goes on with the claims that are
    missing when the same command is given again.
    """

    BOUNDS = {"minutes": Range(0.0, 100_000.0, above=True, below=True)}

    claims: tyro.conf.Positional[tuple[str, ...]] = ()
    """Ids such as S05 or H10, as `soccer list claims` names them; `sensors` draws all sensor errors over the range."""
    all: bool = False
    """Measure every claim that is built."""
    quick: bool = False
    """Take few samples: a first look, all claims within five minutes after compiling. Verdicts are marked "(quick)"
    wherever they are shown."""
    minutes: float | None = None
    """Take as many samples as fit in so many minutes, shared evenly over the claims, by the cost of a sample that
    each claim states for one core; not by the clock."""
    pose: Literal["particles", "percept"] = "particles"
    """How robots know where they are: a particle filter, or a noisy pose that is given. The report and results.json
    name it for every claim; a claim about the particles (H27) is measured with them."""
    rules: Literal["league", "simple"] = "league"
    """Rules of the claims that are judged from play: the league's whole rule book, or goals, restarts and dropped balls
    alone. Staged scenes, where nobody is whistled, and claims without matches do not depend on it and say so."""
    seeds: Annotated[tuple[int, ...], tyro.conf.arg(aliases=("--seed",))] = (1, 2, 3)
    """Seeds from which all samples follow, each 0 or more; their samples are put together."""
    threads: int = 1
    """Cores that share the work: several claims are measured in processes of their own, the matches of a single one
    are shared by threads. No result depends on them."""
    out: Path | None = None
    """Folder for claims.jsonl, results.json, report.md and plots; without it nothing is written."""
    anew: bool = False
    """Remove the files that an earlier run left in --out, instead of going on with it or refusing."""
    stored: bool = False
    """Print what was measured last, as the pages of the teams have it, and measure nothing."""
    json: bool = False
    """Print what results.json holds, as JSON, instead of tables."""

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "claims", tuple(self.claims))
        object.__setattr__(self, "seeds", tuple(self.seeds))
        for seed in self.seeds:
            whole_number("seeds", seed, low=0)
        if not self.seeds or len(set(self.seeds)) < len(self.seeds):
            refuse("seeds", "whole numbers, at least one and each once", self.seeds)
        if bool(self.claims) == self.all:
            raise ValueError("give the ids of claims, or --all; `soccer list claims` names them")
        if self.quick and self.minutes is not None:
            raise ValueError("give quick or minutes, not both")
        if self.stored and (self.quick or self.minutes is not None or self.out is not None):
            raise ValueError("stored measures nothing: give it without quick, minutes and out")

    @property
    def budget(self) -> str:
        """Return the budget in a word or two."""
        return "quick" if self.quick else "default" if self.minutes is None else f"{self.minutes:g} minutes"

    def cap(self, batches: int, quick: int, seconds: float, claims: int) -> int:
        """Return how many batches of a seed a claim may take of those it allows, with so many claims in the run."""
        if self.quick:
            return quick
        runs = claims * len(self.seeds)
        return batches if self.minutes is None else max(1, floor(60.0 * self.minutes / runs / seconds))


def command_of(settings: ReproduceSettings, claim: str = "") -> str:
    """Return the command that asks for these settings, or the one for a single claim with the same samples."""
    single = bool(claim) and settings.minutes is None  # the share of --minutes depends on all claims
    words = ["soccer", "reproduce", *((claim,) if single else settings.claims)]
    words += ["--all"] if settings.all and not single else []
    words += ["--quick"] if settings.quick else []
    words += ["--minutes", f"{settings.minutes:g}"] if settings.minutes is not None else []
    words += ["--pose", settings.pose] if settings.pose != ReproduceSettings.pose else []
    words += ["--rules", settings.rules] if settings.rules != ReproduceSettings.rules else []
    words += ["--seeds", *(f"{seed}" for seed in settings.seeds)] if settings.seeds != ReproduceSettings.seeds else []
    if not claim:
        words += ["--threads", f"{settings.threads}"] if settings.threads != 1 else []
        words += ["--out", str(settings.out)] if settings.out is not None else []
    return shlex.join(words)
