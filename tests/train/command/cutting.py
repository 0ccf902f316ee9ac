"""Carry out a command in one forked child after the other, and end each at a random moment but the last.

    python -m tests.train.command.cutting FOLDER CUTS SEED WORDS...    {out} in the words is a folder, {replay} a file

Half of the moments follow a change of a file by up to 5 ms, the others are anywhere within the time of a whole run. A
child that gets to its end before leaves its folder to be compared, and the next one begins in another. Every third
child sees a clock that jumps by months.

It prints how each child was cut and ended, in which folder, and how long that took [s]. Of a command that writes its
files once, a file that is there under its own name has to be as in the undisturbed run.
"""

from __future__ import annotations

import datetime
import os
import random
import signal
import sys
import time
import traceback
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from soccer_env.train.command.command_line import main as soccer

MONTHS = 1e7  # [s] by which a clock jumps at most
POLL = 0.001  # [s] between two looks at the files
SOON = 0.005  # [s] after a change of a file
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)
PARTS = {  # modules that take long to import: a child has them, and is cut while it works
    "reproduce": "soccer_env.train.papers.reproduction",
    "evaluate": "soccer_env.train.evaluate.evaluation",
    "tournament": "soccer_env.train.tournament.playing",
    "export": "soccer_env.train.evaluate.exporting",
    "record": "soccer_env.train.evaluate.recording",
}
ONE_FILE = ("export", "record")  # commands that write their files once, whole


def jumping(draw: random.Random) -> None:
    """Let the clock of this process jump whenever it is looked at."""
    clock = time.time
    time.time = lambda: clock() + draw.uniform(-MONTHS, MONTHS)

    class Jumping(datetime.datetime):
        @classmethod
        def now(cls, tz: datetime.tzinfo | None = None) -> datetime.datetime:
            return datetime.datetime.fromtimestamp(time.time(), tz)

    datetime.datetime = Jumping  # type: ignore[misc]


class Child:
    """A process that carries out a command with its files in a folder."""

    def __init__(self, words: list[str], folder: Path, draw: random.Random, jumps: bool = False) -> None:
        self.folder = folder
        self.code: int | None = None
        self.number = os.fork()
        if not self.number:
            self._carry_out(
                [word.format(out=folder, replay=folder.parent / "match.replay") for word in words], draw, jumps
            )

    @staticmethod
    def _carry_out(words: list[str], draw: random.Random, jumps: bool) -> None:
        try:
            os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
            if jumps:
                jumping(draw)
            code = soccer(words)
        except KeyboardInterrupt:  # before or after the command
            code = 130
        except BaseException:
            traceback.print_exc()
            code = 70
        os._exit(code)

    def runs(self) -> bool:
        if self.code is None:
            number, status = os.waitpid(self.number, os.WNOHANG)
            self.code = os.waitstatus_to_exitcode(status) if number else None
        return self.code is None

    def ended(self) -> int:
        if self.code is None:
            self.code = os.waitstatus_to_exitcode(os.waitpid(self.number, 0)[1])
        return self.code

    def changes(self) -> Iterator[None]:
        before = files(self.folder)
        while self.runs():
            time.sleep(POLL)
            now = files(self.folder)
            if now != before:
                before = now
                yield


def files(folder: Path) -> list[Any]:
    """Return what can be seen of the files of a folder without reading them."""
    found = []
    for place, folders, names in os.walk(folder):  # which passes over what vanishes meanwhile
        for name in (*folders, *names):
            try:
                state = os.stat(os.path.join(place, name))
            except FileNotFoundError:
                continue
            found.append((place, name, state.st_ino, state.st_size, state.st_mtime_ns))
    return found


class Cutter:
    def __init__(self, words: list[str], folder: Path, seed: int) -> None:
        self.words, self.folder, self.draw = words, folder, random.Random(seed)
        begun = time.monotonic()
        whole = self.child("whole")
        self.changes = sum(1 for _ in whole.changes())
        self.lasted = time.monotonic() - begun
        print("whole", whole.ended(), "whole", flush=True)

    def child(self, name: str, jumps: bool = False) -> Child:
        return Child(self.words, self.folder / name, self.draw, jumps)

    def cut(self, name: str, number: int) -> bool:
        """Start the command and end it; return whether it got to its end."""
        kind, child = self.draw.choice(SIGNALS), self.child(name, jumps=number % 3 == 1)
        if self.draw.random() < 0.5:
            until = time.monotonic() + self.draw.uniform(0.0, self.lasted)
            while child.runs() and time.monotonic() < until:
                time.sleep(POLL)
        else:
            wanted = int(self.draw.random() ** 2 * self.changes)
            for seen, _ in enumerate(child.changes()):
                if seen >= wanted:
                    time.sleep(self.draw.uniform(0.0, SOON))
                    break
        sent, name_of_it = time.monotonic(), "late"
        if child.runs():
            os.kill(child.number, kind)
            name_of_it = kind.name
        code = child.ended()
        print(name_of_it, code, name, f"{time.monotonic() - sent:.2f}", flush=True)
        if self.words[0] in ONE_FILE:
            self.look(name)
        return code == 0

    def look(self, name: str) -> None:
        """Assert that a file, or a folder of files, is as in the undisturbed run, or absent."""
        whole = visible(self.folder / "whole")
        begun = visible(self.folder / name)
        there = {path.parts[0] for path in begun}
        assert begun == {path: data for path, data in whole.items() if path.parts[0] in there}, f"torn: {name}"


def visible(folder: Path) -> dict[Path, bytes]:
    """Return the files below a folder, but hidden ones and those in hidden folders, by their paths in it."""
    found = {path.relative_to(folder): path for path in sorted(folder.rglob("*")) if path.is_file()}
    hidden = [inside for inside in found if any(part.startswith(".") for part in inside.parts)]
    return {inside: path.read_bytes() for inside, path in found.items() if inside not in hidden}


def main() -> None:
    folder, cuts, seed, words = Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]), sys.argv[4:]
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a job in the background begins with it ignored
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    if any("{replay}" in word for word in words):
        recorded = ["record", "--minutes", "0.1", "--players", "1", "--senses", "ideal", "--out", "{replay}"]
        print("replay", Child(recorded, folder / "none", random.Random(0)).ended(), "none", flush=True)
    __import__(PARTS[words[0]])
    cutter = Cutter(words, folder, seed)
    ends = 0
    for number in range(cuts):
        ends += cutter.cut(f"cut-{ends}", number)
    last = f"cut-{ends}"
    print("last", cutter.child(last).ended(), last, flush=True)
    both = [cutter.child("both"), cutter.child("both")]
    print("both", both[0].ended(), "both", both[1].ended(), flush=True)


if __name__ == "__main__":
    main()
