"""The settings of `soccer bench`."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from pathlib import Path

from soccer_env.train.written_settings import CommandSettings


@dataclass(frozen=True)
class BenchSettings(CommandSettings):
    """Measure the speed of both leagues against the bare physics; results are medians of repetitions in one run."""

    quick: bool = False
    """Finish in a minute, with less precision: fewer matches, steps and repetitions, and no cold start."""
    out: Path | None = None
    """JSON file to write the results to."""
    json: bool = False
    """Print the results as JSON, as --out holds them, instead of tables."""
    seed: int = 0
    """Seed of the timed matches."""
    profile: bool = False
    """Print instead the time of each mechanism in a match step, and its share: chaser against chaser, by sensors."""
    against: Path | None = None
    """Compare with another checkout of this repository in this folder, such as one made by `git worktree add`: time
    each row in both checkouts by turns and print the ratio with its 95 % interval; above 1 means slower here. Times are
    processor times of one thread."""
    peers: bool = False
    """Compare with other environments instead, such as VMAS football: pip installs each at its first use in an
    environment of its own, and both leagues are timed beside it by turns, with equal numbers of matches and threads.
    Prints match steps/s and the ratio, ours over theirs, with its 95 % interval."""
    growth: bool = False
    """Print instead how costs grow with robots, players seen, matches, threads, the length of a replay: the slope on
    logarithmic axes beside the order that the work needs. With --out also a picture. Linux only; memory: 8 GB."""
    soak: float = 0.0
    """Play so many million match steps instead, and compare memory, open files and time at the end with those at the
    beginning. Linux only."""
    rows: str = ""
    """With --against or --peers: time only rows whose names contain all these words; all rows take most of an hour."""

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.against is not None and not self.against.is_dir():
            raise ValueError(f"against must be the folder of a checkout, got {self.against}")
        kinds = self.profile, self.peers, self.growth, self.soak != 0, self.against is not None
        if sum(kinds) > 1:
            raise ValueError("these are measured one at a time: give profile, growth, soak, peers or against")
        if not 0 <= self.soak < inf:
            raise ValueError(f"soak must be a number of million match steps, got {self.soak}")
        if (self.growth or self.soak) and not Path("/proc/self/statm").exists():
            raise ValueError("growth and soak read the memory of the process from /proc, which this system lacks")
        if self.rows and self.against is None and not self.peers:
            raise ValueError("rows chooses among the rows of a comparison: give against as well, or peers")

    @property
    def matches(self) -> int:
        """Return the number of matches that run side by side."""
        return 128 if self.quick else 512

    @property
    def repetitions(self) -> int:
        """Return the number of timings of each load."""
        return 3 if self.quick else 11

    @property
    def rounds(self) -> int:
        """Return the number of times that the processes of the two checkouts are started."""
        return 2 if self.quick else 5

    @property
    def steps(self) -> int:
        """Return the number of control steps in one timing."""
        return 25 if self.quick else 50
