"""Forge files as an attacker would, and watch what becomes of who loads them: `make fuzz`.

    python -m tests.fuzz.fuzz                              20,000 files, from seed 1
    python -m tests.fuzz.fuzz --files 500 --seed 2         others
    python -m tests.fuzz.fuzz --only 1234                  one of them again, as its line says

Every file is drawn from the seed and its own number alone. A child process loads it and plays on; a death,
a hang, an error that is no ValueError, and NaN without an error are findings. The exit code is 1 if there is one.
"""

from __future__ import annotations

import argparse
import random
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from tests.fuzz.children import Task, outcomes
from tests.fuzz.replays import SETTINGS as REPLAYS
from tests.fuzz.replays import make_source
from tests.fuzz.targets import SETTINGS as MATCHES
from tests.fuzz.targets import Target, make_target

REPLAY_SHARE = 0.15  # of the files; the others are saves
GROUP = 25  # files in one child, as long as none of them ends it


class Forger:
    """Forges files by their numbers; makes the matches that they come from when they are needed."""

    def __init__(self, seed: int, folder: Path, matches: tuple[str, ...], replays: tuple[str, ...]) -> None:
        self.seed = seed
        self.targets = [make_target(name) for name in matches]
        self.sources = [make_source(name, folder) for name in replays]

    def forge(self, number: int) -> tuple[str, Task]:
        """Return words for a file, and the task to use it."""
        draw = random.Random(f"{self.seed} {number}")
        if draw.random() < REPLAY_SHARE:
            return draw.choice(self.sources).forge(number, draw)
        target: Target = draw.choice(self.targets)
        return target.forge(draw)

    def tasks(self, numbers: list[int]) -> Iterator[tuple[tuple[int, str], Task]]:
        """Yield the number of each file with words for it, and its task."""
        for number in numbers:
            told, task = self.forge(number)
            yield (number, told), task


def found_by(forger: Forger, numbers: list[int], watch: bool = False) -> tuple[Counter[str], list[str]]:
    """Use files; return how many ended how, and a line for each finding."""
    counts: Counter[str] = Counter()
    findings = []
    begun = time.monotonic()
    for (number, told), outcome in outcomes(forger.tasks(numbers), GROUP):
        counts[outcome if outcome in ("played", "refused") else "findings"] += 1
        if outcome not in ("played", "refused"):
            findings.append(f"--seed {forger.seed} --only {number}\n    {told}\n    {outcome}")
            if watch:
                print(f"\n{findings[-1]}", flush=True)
        done = sum(counts.values())
        if watch and (done % 100 == 0 or done == len(numbers)):
            told = ", ".join(f"{count} {name}" for name, count in sorted(counts.items()))
            print(f"\r{done} of {len(numbers)} files in {time.monotonic() - begun:.0f} s: {told}", end="", flush=True)
    return counts, findings


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--files", type=int, default=20_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, nargs="*", help="numbers of files")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        forger = Forger(asked.seed, Path(folder), tuple(MATCHES), tuple(REPLAYS))
        _, findings = found_by(forger, asked.only or list(range(asked.files)), watch=True)
    print(f"\n{len(findings)} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
