"""The settings of `soccer bench`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from soccer_env.train.evaluate.settings import whole


@dataclass(frozen=True)
class BenchSettings:
    """Measure the speed of both leagues against the bare physics; ratios are from one run, medians of repetitions."""

    quick: bool = False
    """Take a minute and trust the numbers less: fewer matches, steps and repetitions, no cold start."""
    out: Path | None = None
    """File for the numbers (JSON)."""
    seed: int = 0
    """Seed of the play that is timed."""

    def __post_init__(self) -> None:
        whole("seed", self.seed, 0)

    @property
    def matches(self) -> int:
        """Return how many matches run side by side."""
        return 128 if self.quick else 512

    @property
    def repetitions(self) -> int:
        """Return how often each load is timed."""
        return 3 if self.quick else 11

    @property
    def steps(self) -> int:
        """Return the control steps of one timing."""
        return 25 if self.quick else 50
