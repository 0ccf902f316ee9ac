"""Put slips into the code, drawn at random, and see whether a test notices: `make mutants`.

    python tests/mutation/mutate.py --count 150 --seed 20261123     draw 150 and go on where FILE (--out) ends
    python tests/mutation/mutate.py --only soccer_env/rewards       draw in one folder or file
    python tests/mutation/mutate.py --again                         ask again about those of FILE that lived
    python tests/mutation/mutate.py --mechanisms MS12 MH06          switch those of the papers off instead; or all

A mutant takes one to two minutes of a core, one that lives about five. Each gets a line in FILE, as JSON. Tests about
the file are asked first, then the quick ones (related.py). What does not import or compile says nothing. mutmut's
variants cannot be compiled by numba; cosmic-ray and mutatest keep no compiled code, nor do they know these slips.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import islice
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from tests.mutation import mechanisms, sites  # noqa: E402  # the folder above has to be known first
from tests.mutation.related import Related  # noqa: E402  # the same
from tests.mutation.running import Copy, Ground, Stage, StoppedError  # noqa: E402  # the same

Row = dict[str, Any]
FIRST = "tests/test_geometry.py"  # quick, and needs all that tests need
FAST, SLOW = ("-m", "not slow"), ("-m", "slow")


def arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--count", type=int, default=20, help="mutants to draw that say something")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="mutants at a time")
    parser.add_argument("--only", default="", help="draw from files whose path begins so")
    parser.add_argument("--time", type=float, default=float("inf"), help="[s] until it ends; the same command goes on")
    parser.add_argument("--out", type=Path, default=ROOT / "runs" / "mutants.jsonl", help="a line for each mutant")
    parser.add_argument("--again", action="store_true", help="ask again about those that lived")
    parser.add_argument("--mechanisms", nargs="*", metavar="ID", help="switch mechanisms of the papers off instead")
    parser.add_argument("--list", action="store_true", help="show what is drawn, and stop")
    return parser.parse_args(words)


def drawn(asked: argparse.Namespace) -> Iterator[tuple[Row, str]]:
    """Yield the mutants of a draw, each as a row and the text of its file; those that change nothing are left out."""
    for site in sites.draw(ROOT, asked.seed, asked.only):
        other = site.replacement(asked.seed)
        row = {"id": site.rank(asked.seed)[:16], "seed": asked.seed, "file": site.file, "line": site.node.lineno}
        row |= {"function": site.function, "kind": site.kind, "original": site.original, "replacement": other}
        with contextlib.suppress(ValueError, SyntaxError):
            yield row, sites.changed((ROOT / site.file).read_text(encoding="utf-8"), site, other)


def switched_off(ids: list[str]) -> Iterator[tuple[Row, str]]:
    """Yield the mutants of mechanisms; ValueError for an unknown one."""
    known = mechanisms.read()
    if unknown := set(ids) - {one.id for one in known}:
        raise ValueError(f"unknown mechanisms {sorted(unknown)}")
    for number, one in enumerate(known):
        if not ids or one.id in ids:
            text = one.changed((ROOT / one.file).read_text(encoding="utf-8"))
            yield {"id": f"{one.id}-{number}", "kind": "mechanism", **one._asdict(), "line": 0}, text


class Run:
    """The mutants of one command: which are done, and what is said of them."""

    def __init__(self, asked: argparse.Namespace, mutants: Iterator[tuple[Row, str]], count: float) -> None:
        self.asked, self.mutants, self.left = asked, mutants, count
        asked.out.parent.mkdir(parents=True, exist_ok=True)
        lines = asked.out.read_text(encoding="utf-8").splitlines() if asked.out.is_file() else []
        rows = [json.loads(line) for line in lines if line.endswith("}")]  # the last may be torn
        self.known = {row["id"]: row for row in rows if not (asked.again and row["verdict"] == "lived")}
        self.done: list[Row] = []
        self.lock = threading.Lock()
        self.ground = Ground(asked.out.with_suffix(".work"), time.monotonic() + asked.time)
        self.related = Related(ROOT)

    def play(self) -> None:
        """Judge mutants, several at a time, until enough of them say something; StoppedError if the time is over."""
        if not self.ground.passes(FIRST):
            raise RuntimeError(f"without any mutant {FIRST} fails")
        with ThreadPoolExecutor(self.asked.jobs) as pool:
            list(pool.map(self.judge, [Copy(self.ground, f"copy-{i}") for i in range(self.asked.jobs)]))

    def judge(self, copy: Copy) -> None:
        """Judge one mutant after another in a copy; write a line on each, and print one."""
        while mutant := self.next_one():
            row, text = mutant
            known = mechanisms.reason(row)  # nobody can notice it
            word, test, seconds = ("lived", "", 0.0) if known else copy.verdict(row["file"], text, self.stages(row))
            row |= {"verdict": word, "by": test, "cpu": round(seconds, 1)}
            with self.lock, self.asked.out.open("a", encoding="utf-8") as out:
                out.write(json.dumps(row) + "\n")
                self.done.append(row)
                self.left += word == "invalid"
                print(f"{len(self.done)}: {word} ({seconds:.0f} s) {name_of(row)[:230]}  {test}", flush=True)

    def next_one(self) -> tuple[Row, str] | None:
        """Return the next mutant that was not judged before; None if there are enough."""
        with self.lock:
            while self.left > 0 and (mutant := next(self.mutants, None)):
                known = self.known.get(mutant[0]["id"])
                self.left -= known is None or known["verdict"] != "invalid"
                if known is None:
                    return mutant
                self.done.append(known)
        return None

    def stages(self, row: Row) -> list[Stage]:
        """Return which tests to ask, one stage after another: those about the file, the quick ones, the slow ones."""
        if "test" in row:
            return [([row["test"]], ())]
        first = self.related.first(row["file"])
        return [(first, FAST), *((quick, FAST) for quick in self.related.then(first)), (first[:6], SLOW)]


def name_of(row: Row) -> str:
    """Return which mutant a row is about."""
    where = f"{row['file']}:{row['line']} {row.get('function') or row.get('where', '')}"
    return f"{where} {row['kind']}: {row['original']!r} -> {row['replacement']!r}"


def main(words: list[str]) -> int:
    """Run the mutants; return 1 if one lives that is not known to be equivalent, 3 if the time was over first."""
    asked = arguments(words)
    named = asked.mechanisms is not None
    mutants, count = (switched_off(asked.mechanisms), float("inf")) if named else (drawn(asked), asked.count)
    if asked.list:
        for row, _ in islice(mutants, asked.count):
            print(json.dumps(row))
        return 0
    run = Run(asked, mutants, count)
    over = False
    try:
        run.play()
    except StoppedError:
        over = True
        print("the time is over: the same command goes on")
    living = [row for row in run.done if row["verdict"] == "lived"]
    lived = [row for row in living if not mechanisms.reason(row)]
    print(*(f"LIVED  {name_of(row)}\n" for row in lived), sep="", end="")
    print(*(f"FAILS WITHOUT ANY MUTANT  {test}\n" for test in sorted(run.ground.failing)), sep="", end="")
    nothing = sum(row["verdict"] == "invalid" for row in run.done)
    mean = sum(row["cpu"] for row in run.done) / max(len(run.done), 1)
    print(f"{len(run.done) - nothing} mutants, {len(lived)} lived, {len(living) - len(lived)} more are equivalent; "
          f"{nothing} said nothing; {mean:.0f} s of processor time each")  # fmt: skip
    return 3 if over else int(bool(lived))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
