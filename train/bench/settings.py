"""The settings of `soccer bench`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from soccer_env.train.written_settings import CommandSettings


@dataclass(frozen=True)
class BenchSettings(CommandSettings):
    """Measure the speed of both leagues against the bare physics; ratios are from one run, medians of repetitions."""

    quick: bool = False
    """Take a minute and trust the numbers less: fewer matches, steps and repetitions, no cold start."""
    out: Path | None = None
    """File for the numbers (JSON)."""
    json: bool = False
    """Print the same JSON on the screen instead of tables."""
    seed: int = 0
    """Seed of the play that is timed."""
    against: Path | None = None
    """Folder of another checkout of this repository, as `git worktree add` makes one: instead of all this, the rows of
    both are timed in turn, and each row's ratio is printed with its 95 % interval: above 1 is slower here. What is
    timed is processor time of one thread. The other checkout may be older than this option."""
    python: Path | None = None
    """Interpreter for the other checkout, if that has no .venv of its own."""
    rows: str = ""
    """Words: of two checkouts, only rows whose names contain all of them are timed; all take most of an hour."""

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.against is not None and not self.against.is_dir():
            raise ValueError(f"against must be the folder of a checkout, got {self.against}")
        if self.python is not None and self.against is None:
            raise ValueError("python is the interpreter of another checkout: give against as well")
        if self.rows and self.against is None:
            raise ValueError("rows chooses among those of two checkouts: give against as well")

    @property
    def matches(self) -> int:
        """Return how many matches run side by side."""
        return 128 if self.quick else 512

    @property
    def repetitions(self) -> int:
        """Return how often each load is timed."""
        return 3 if self.quick else 11

    @property
    def rounds(self) -> int:
        """Return how often the processes of two checkouts are started anew."""
        return 2 if self.quick else 5

    @property
    def steps(self) -> int:
        """Return the control steps of one timing."""
        return 25 if self.quick else 50
