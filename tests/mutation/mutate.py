"""Put slips into the code, drawn at random, and see whether a test notices: `make mutants`.

    python tests/mutation/mutate.py --count 150 --seed 20261123     draw 150 and go on where FILE (--out) ends
    python tests/mutation/mutate.py --only soccer_env/rewards       draw in one folder or file
    python tests/mutation/mutate.py --again                         ask again about those of FILE that lived
    python tests/mutation/mutate.py --mechanisms MS12 MH06          switch those of the papers off instead; or all

A mutant takes one to two minutes of a core, one that lives about five. Each gets a line in FILE, as JSON. Tests about
the file are asked first, then the quick ones (related.py). What does not import or compile says nothing: another is
drawn. Libraries that mutate (mutmut, cosmic-ray, mutatest) do not serve: the first calls each variant through a
trampoline, which numba cannot compile, and the others neither keep compiled code between mutants nor know these slips.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from pathlib import Path
from queue import SimpleQueue
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from tests.mutation import equivalents, judging, mechanisms, sites  # noqa: E402  # the folder above has to be known first
from tests.mutation.related import Related  # noqa: E402  # the same
from tests.mutation.running import Copy, Ground, StoppedError  # noqa: E402  # the same

Row = dict[str, Any]
LAST = 40.0  # [s] before the time is over, when no mutant is begun any more


def arguments(words: list[str]) -> argparse.Namespace:
    """Return what the command line asks for."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--count", type=int, default=20, help="mutants to draw that say something")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="mutants at a time")
    parser.add_argument("--only", default="", help="draw from files whose path begins so")
    parser.add_argument("--shard", default="1/1", help="i/n: every n-th of the draw, from the i-th on")
    parser.add_argument(
        "--time", type=float, default=float("inf"), help="[s] after which to end; go on by the same command"
    )
    parser.add_argument("--out", type=Path, default=ROOT / "runs" / "mutants.jsonl", help="a line for each mutant")
    parser.add_argument(
        "--work", type=Path, default=ROOT / "build" / "mutants", help="folder of copies and compiled code"
    )
    parser.add_argument("--again", action="store_true", help="ask again about those that lived")
    parser.add_argument("--mechanisms", nargs="*", metavar="ID", help="switch mechanisms of the papers off instead")
    parser.add_argument("--list", action="store_true", help="show what is drawn, and stop")
    return parser.parse_args(words)


def drawn(asked: argparse.Namespace) -> Iterator[tuple[Row, str]]:
    """Yield the mutants of a draw, each as a row and the text of its file; those that change nothing are left out."""
    which, of = map(int, asked.shard.split("/"))
    for place, site in enumerate(sites.draw(ROOT, asked.seed, asked.only)):
        if place % of != which - 1:
            continue
        other = site.replacement(asked.seed)
        try:
            text = sites.changed((ROOT / site.file).read_text(encoding="utf-8"), site, other)
        except (ValueError, SyntaxError):
            continue
        row = {"id": site.rank(asked.seed)[:16], "seed": asked.seed, "file": site.file, "line": site.place.first_line}
        yield (
            {**row, "function": site.function, "kind": site.kind, "original": site.original, "replacement": other},
            text,
        )


def switched_off(ids: list[str]) -> Iterator[tuple[Row, str]]:
    """Yield the mutants of mechanisms; ValueError for an unknown one."""
    known = mechanisms.read()
    unknown = set(ids) - {one.id for one in known}
    if unknown:
        raise ValueError(f"unknown mechanisms {sorted(unknown)}")
    for number, one in enumerate(known):
        if not ids or one.id in ids:
            text = one.changed((ROOT / one.file).read_text(encoding="utf-8"))
            yield {"id": f"{one.id}-{number}", "kind": "mechanism", **one._asdict(), "line": 0}, text


class Run:
    """The mutants of one command: which are done, and what is said of them."""

    def __init__(self, asked: argparse.Namespace) -> None:
        self.asked, self.began = asked, time.monotonic()
        self.until = self.began + asked.time
        self.rows: dict[str, Row] = {}
        asked.out.parent.mkdir(parents=True, exist_ok=True)
        if asked.out.is_file():
            lines = asked.out.read_text(encoding="utf-8").splitlines()
            rows = [json.loads(line) for line in lines if line.endswith("}")]  # the last may be torn
            self.rows = {row["id"]: row for row in rows if not (asked.again and row["verdict"] == "lived")}
        self.ground = Ground(asked.work, self.until)
        self.related = Related(ROOT)
        self.copies: SimpleQueue[Copy] = SimpleQueue()
        self.lock = threading.Lock()
        self.said: set[str] = set()

    def play(self, mutants: Iterator[tuple[Row, str]], count: float) -> list[Row]:
        """Judge mutants, several at a time, until `count` say something; return the rows of all that are done."""
        done: list[Row] = []
        with ThreadPoolExecutor(self.asked.jobs) as pool:
            self.prepare(pool)
            waiting: dict[Future[Row | None], None] = {}
            while True:
                while len(waiting) < self.asked.jobs and said(done) + len(waiting) < count and self.goes_on():
                    row, text = next(mutants, ({}, ""))
                    if not row:
                        break
                    if finished(self.rows.get(row["id"])):
                        done.append(self.rows[row["id"]])
                    else:
                        waiting[pool.submit(self.judge, row, text)] = None
                if not waiting:
                    return done
                for future in wait(waiting, return_when=FIRST_COMPLETED).done:
                    del waiting[future]
                    row = future.result() or {}
                    done += [row] if row else []
                    self.tell(row, said(done), count)

    def goes_on(self) -> bool:
        """Tell whether there is time to begin another."""
        return time.monotonic() < self.until - LAST

    def prepare(self, pool: ThreadPoolExecutor) -> None:
        """Make the copies, and compile what most tests need."""
        print(f"compiling what most tests need; then {self.asked.jobs} mutants at a time", flush=True)
        self.ground.stamps  # noqa: B018  # once, before there are threads
        warming = [pool.submit(self.ground.warm_up, part) for part in self.ground.warm_ups()]
        for copy in pool.map(lambda i: Copy(self.ground, f"copy-{i}"), range(self.asked.jobs)):
            self.copies.put(copy)
        try:
            print(f"compiled in {sum(one.result() for one in warming):.0f} s of processor time", flush=True)
        except StoppedError:
            print("the time was over before everything was compiled", flush=True)

    def judge(self, row: Row, text: str) -> Row | None:
        """Return the row of a mutant with its verdict, None if the time is over first; write it in both cases."""
        began, before = time.monotonic(), self.rows.get(row["id"], {"by": "0", "cpu": 0.0})
        verdict = self.asked_tests(row, text, int(before["by"]))
        row |= {"verdict": verdict.word, "by": verdict.by, "cpu": round(before["cpu"] + verdict.seconds, 1)}
        row |= {"seconds": round(time.monotonic() - began, 1)}
        with self.lock, self.asked.out.open("a", encoding="utf-8") as out:
            out.write(json.dumps(row) + "\n")
        return row if finished(row) else None

    def asked_tests(self, row: Row, text: str, stage: int) -> judging.Verdict:
        """Return what tests say to a mutant, from a stage on; those that are known to change nothing are not asked."""
        if equivalents.reason(row):
            return judging.Verdict("lived", "", 0.0)
        tests = [([row["test"]], ())] if "test" in row else judging.stages(self.related, row["file"])
        copy = self.copies.get()
        try:
            return judging.verdict_on(copy, row["file"], text, tests, begin=stage)
        finally:
            self.copies.put(copy)

    def tell(self, row: Row, number: int, count: float) -> None:
        """Print the verdict on a mutant, and which tests were found to fail without any."""
        for test in sorted(self.ground.failing - self.said):
            print(f"WARNING: fails without any mutant and is left out: {test}", flush=True)
            self.said.add(test)
        if row:
            where = f"{row['file']}:{row['line']} {row['kind']}: {row['original']!r} -> {row['replacement']!r}"
            print(
                f"[{number}/{count}] {row['verdict']} ({row['cpu']:.0f} s) {where[:230]}  {row['by'][:150]}", flush=True
            )


def finished(row: Row | None) -> bool:
    """Tell whether there is a verdict on a mutant."""
    return row is not None and row["verdict"] != "unfinished"


def said(rows: list[Row]) -> int:
    """Return how many mutants said something."""
    return sum(row["verdict"] != "invalid" for row in rows)


def main(words: list[str]) -> int:
    """Run the mutants; return 1 if one lives that is not known to be equivalent, 3 if the time was over first."""
    asked = arguments(words)
    named = asked.mechanisms is not None
    mutants, count = (switched_off(asked.mechanisms), float("inf")) if named else (drawn(asked), asked.count)
    if asked.list:
        for (row, _), _ in zip(mutants, range(asked.count), strict=False):
            print(json.dumps(row))
        return 0
    run = Run(asked)
    rows = run.play(mutants, count)
    same = [row for row in rows if row["verdict"] == "lived" and equivalents.reason(row)]
    lived = [row for row in rows if row["verdict"] == "lived" and row not in same]
    for row in lived:
        print(f"LIVED  {row['file']}:{row['line']} {row['function' if 'function' in row else 'where']} "
              f"{row['kind']}: {row['original']} -> {row['replacement']}")  # fmt: skip
    mean = sum(row["cpu"] for row in rows) / max(len(rows), 1)
    took = f"{mean:.0f} s of processor time each, {time.monotonic() - run.began:.0f} s in all"
    print(f"{said(rows)} mutants, {len(lived)} lived, {len(same)} more are equivalent; "
          f"{len(rows) - said(rows)} said nothing; {took}")  # fmt: skip
    if not named and said(rows) < count:
        print("the time is over: the same command goes on")
        return 3
    return 1 if lived else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
