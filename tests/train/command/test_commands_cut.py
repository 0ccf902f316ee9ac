"""Commands that are interrupted, ended or killed at any moment go on, and end with the results of undisturbed ones.

All that a run leaves is compared bit for bit, but for the date at which it began, what a kill leaves of a file that was
half written (`.NAME.*.tmp`), and the lock. A training that is cut: tests/train/ppo/test_train_resume.py.
"""

import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.train.command.cutting import visible

ROOT = Path(__file__).parents[3]
SHORT = "--players 1 --senses ideal --seed 3"
EXPORT = "export {replay} --anew --out {out}"
COMMANDS = {
    "evaluate": f"evaluate --home chaser --away still --matches 6 --minutes 0.5 {SHORT} --out {{out}}",
    "tournament": f"tournament --teams chaser,still,random --matches 2 --minutes 0.3 {SHORT} --out {{out}}",
    "reproduce, in processes": "reproduce H12 H17 S15 --quick --threads 2 --out {out}",
    "record": f"record --home chaser --away chaser --minutes 0.1 {SHORT} --out {{out}}/match.replay",
    "export a film": f"{EXPORT}/match.gif --fps 5",
    "export a picture": f"{EXPORT}/match.png",
    "export a folder": f"{EXPORT}/match.cdf",
}
QUICK = ("record", "export a picture")
CODES = {"SIGINT": ("130", "0"), "SIGTERM": ("-15", "0"), "SIGKILL": ("-9", "0"), "late": ("0",)}


def cut(name: str, folder: Path, cuts: int, seed: int) -> list[list[str]]:
    """Carry out a command whole, cut, and twice at once; return how its processes ended."""
    asked = [
        sys.executable, "-m", "tests.train.command.cutting", str(folder), str(cuts), str(seed),
        *COMMANDS[name].split(),
    ]  # fmt: skip
    done = subprocess.run(asked, cwd=ROOT, capture_output=True, text=True, timeout=3600, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "Traceback" not in done.stderr, done.stderr
    return [line.split() for line in done.stdout.splitlines()]


def contents(folder: Path) -> dict[str, Any]:
    """Return what a run has left, by the names of its files: text and bytes without dates, lines in order."""
    return {str(path): content(path, folder, data) for path, data in visible(folder).items()}


def content(path: Path, folder: Path, data: bytes) -> Any:
    data = re.sub(rb"\b20\d\d-\d\d-\d\d\b", b"DATE", data.replace(str(folder).encode(), b"FOLDER"))
    return sorted(set(data.splitlines())) if path.suffix == ".jsonl" else data


def check(name: str, folder: Path, cuts: int, seed: int) -> None:
    """Assert that a command that was cut ends as one that was not, and so do two at once."""
    ends = cut(name, folder, cuts, seed)
    cuts_made = [end for end in ends if end[0] in CODES]
    assert all(end[1] == "0" for end in ends if end[0] in ("replay", "whole", "last")), ends
    assert all(end[1] in CODES[end[0]] for end in cuts_made), ends
    assert {ends[-1][1], ends[-1][3]} <= {"0", "2"} and "0" in ends[-1], ends
    whole = contents(folder / "whole")
    assert whole
    for at in sorted({end[2] for end in ends if end[1] == "0" and end[0] not in ("replay", "whole")}):
        found = contents(folder / at)
        assert [file for file in {*found, *whole} if found.get(file) != whole.get(file)] == [], (at, ends)


@pytest.mark.skipif(os.name != "posix", reason="needs signals and forks")
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=() if name in QUICK else pytest.mark.whole) for name in COMMANDS]
)
def test_a_command_that_is_cut_ends_as_one_that_is_not(name: str, tmp_path: Path) -> None:
    check(name, tmp_path, cuts=2 if name in QUICK else 5, seed=1)


SPAWNED = """
import multiprocessing
import numpy as np
from soccer_env import Match

def play(seed):
    match = Match(home=1, away=1, seed=seed, senses="ideal")
    for _ in range(5):
        match.step(np.zeros((1, 2, 4)))
    return match.state_hash()

if __name__ == "__main__":
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        print([*map(play, (1, 2))] == pool.map(play, (1, 2)))
"""


@pytest.mark.slow
def test_a_script_that_spawns_processes_plays_the_same_in_them(tmp_path: Path) -> None:
    script = tmp_path / "spawned.py"
    script.write_text(SPAWNED)
    done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, timeout=300, check=False)
    assert done.stdout == "True\n", done.stderr
