"""Commands that are interrupted, ended or killed at any moment go on, and end with the results of undisturbed ones.

What is compared is all that a run leaves but its logs of wall-clock time: `seconds` in a training's log.

    python -m tests.train.test_commands_cut 40    so many cuts of each command, at other moments
"""

import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
SHORT = "--players 1 --senses ideal --seed 3"
COMMANDS = {  # each with its file of lines, by which its progress is seen
    "evaluate": (f"evaluate --home chaser --away still --matches 6 --minutes 0.5 {SHORT}", "matches.jsonl"),
}
COMPARED = {"evaluate": ("matches.jsonl", "result.json")}

# Carries out a command in one forked child after the other until one gets to the end. All but the last are sent a
# signal, a random time after their files have grown; some of them see a clock that jumps. Children that a shell began
# in the background ignore Ctrl-C: here it does what it does in a terminal.
CUTTING = r"""
import os, random, signal, sys, time
from pathlib import Path
from soccer_env.train.command_line import main

words, out, lines, cuts, seed = sys.argv[1].split(), Path(sys.argv[2]), sys.argv[3], int(sys.argv[4]), int(sys.argv[5])
draw, clock = random.Random(seed), time.time
signal.signal(signal.SIGINT, signal.default_int_handler)
signal.signal(signal.SIGTERM, signal.SIG_DFL)

def command(folder, jumps=False):
    if jumps:
        time.time = lambda: clock() + draw.uniform(-1e7, 1e7)
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    try:
        os._exit(main([*words, "--out", str(folder)]))
    except BaseException:
        import traceback
        traceback.print_exc()
        os._exit(70)

def started(folder, jumps=False):
    child = os.fork()
    return child or command(folder, jumps)

def ended(child):
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])

def size():
    return (out / "cut" / lines).stat().st_size if (out / "cut" / lines).exists() else 0

begun = time.monotonic()
print("whole", ended(started(out / "whole")), flush=True)
lasted = time.monotonic() - begun
for number in range(cuts):
    before, kind = size(), draw.choice([signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
    child, until = started(out / "cut", jumps=number % 3 == 1), time.monotonic() + lasted
    while size() == before and time.monotonic() < until and draw.random() > 0.001:
        time.sleep(0.002)
    time.sleep(draw.uniform(0.0, 0.1) * lasted)
    os.kill(child, kind)
    print(kind.name, ended(child), size(), flush=True)
print("last", ended(started(out / "cut")), flush=True)
both = [started(out / "both") for _ in range(2)]
print("both", *map(ended, both), flush=True)
"""


def cut(name: str, folder: Path, cuts: int, seed: int) -> list[list[str]]:
    """Carry out a command whole, cut, and twice at once; return how its processes ended."""
    words, lines = COMMANDS[name]
    asked = [sys.executable, "-c", CUTTING, words, str(folder), lines, str(cuts), str(seed)]
    done = subprocess.run(asked, cwd=ROOT, capture_output=True, text=True, timeout=3600, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "Traceback" not in done.stderr, done.stderr
    return [line.split() for line in done.stdout.splitlines()]


def contents(folder: Path, name: str) -> dict[str, Any]:
    """Return what a run found: lines in order, and files without the times at which it began."""
    found: dict[str, Any] = {}
    for file in COMPARED[name]:
        text = (folder / file).read_text()
        found[file] = sorted(set(text.splitlines())) if file.endswith("l") else json.loads(text)
    return found


def check(name: str, folder: Path, cuts: int, seed: int) -> list[list[str]]:
    """Assert that a command that was cut ends as one that was not, and so do two at once."""
    ends = cut(name, folder, cuts, seed)
    assert ends[0] == ["whole", "0"] and ends[-2] == ["last", "0"], ends
    codes = {"SIGINT": ("130", "0"), "SIGTERM": ("-15", "0"), "SIGKILL": ("-9", "0")}
    assert all(end[1] in codes[end[0]] for end in ends[1:-2]), ends
    assert set(ends[-1][1:]) <= {"0", "2"} and "0" in ends[-1], ends
    whole = contents(folder / "whole", name)
    assert contents(folder / "cut", name) == whole
    assert contents(folder / "both", name) == whole
    return ends


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="needs signals and forks")
@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_that_is_cut_ends_as_one_that_is_not(name: str, tmp_path: Path) -> None:
    check(name, tmp_path, cuts=4, seed=1)


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


def main() -> None:
    """Cut every command many times, at moments of another seed."""
    cuts = int(sys.argv[1]) if len(sys.argv) > 1 else 40
    for name in COMMANDS:
        with tempfile.TemporaryDirectory() as folder:
            seed = random.SystemRandom().randrange(10**6)
            print(name, "seed", seed, flush=True)
            for end in check(name, Path(folder), cuts, seed):
                print("  ", *end)


if __name__ == "__main__":
    main()
