"""Copies of the checkout, tests that run in them, and the compiled code that they share.

A copy has its own folder of compiled code beside one that all read. What belongs to unchanged sources moves from the
first to the second after each mutant; what belongs to the mutant goes.
"""

from __future__ import annotations

import contextlib
import functools
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from soccer_env.compiling.cache import folders
from soccer_env.compiling.sources import source_stamp
from tests.mutation.related import module_of
from tests.warm_up import PARTS

ROOT = Path(__file__).resolve().parents[2]
COPIED = ("soccer_env", "baselines", "agents", "train", "tests", "pyproject.toml", "README.md", "CONTRIBUTING.md")
INNER = ("baselines", "agents", "train")  # stand at the top, are imported from inside the package
FIRST = "tests/test_geometry.py"  # quick, and needs all that tests need
LONGEST = 1800.0  # [s] until a process that waits for something is ended
FAILING = re.compile(r"^(?:FAILED|ERROR) (\S.*?)(?: - .*)?$", re.MULTILINE)


class Ran(NamedTuple):
    """What became of a run of tests."""

    code: int  # the exit code, negative for a signal
    output: str
    seconds: float  # of processor time, its own and that of its ended children
    last: str  # the test that ran last


class StoppedError(Exception):
    """The time for all mutants is over."""


class Ground:
    """A folder in which mutants run: copies of the checkout, and the compiled code of the unchanged one."""

    def __init__(self, folder: Path, until: float) -> None:
        self.folder, self.until = folder, until
        self.shared = folder / "tmp" / f"soccer_env-{os.getuid()}"  # soccer_env reads it after SOCCER_ENV_CACHE
        self.shared.mkdir(mode=0o700, parents=True, exist_ok=True)
        for kept in (f for f in folders()[:1] if f.is_dir()):
            for file in kept.glob("*.nbc"):
                with contextlib.suppress(OSError):
                    os.link(file, self.shared / file.name)
        self.clean = Copy(self, "clean")
        self.failing: set[str] = set()  # tests that fail without any mutant
        self._locks: dict[str, threading.Lock] = defaultdict(threading.Lock)
        self._passing: set[str] = set()

    def warm_up(self, part: str) -> float:
        """Compile a part of what most tests need, or run a first test; return the processor time."""
        if part == FIRST:
            ran = self.clean.run_tests([part], cache=self.shared, name="first")
        else:
            words = f"from tests.warm_up import PARTS; PARTS[{part!r}]()"
            ran = self.clean.run_python("-c", words, cache=self.shared, name=part)
        if ran.code:
            raise RuntimeError(f"without any mutant {part} fails:\n{ran.output[-3000:]}")
        return ran.seconds

    def warm_ups(self) -> list[str]:
        """Return the parts that can be compiled at the same time."""
        return [FIRST, *PARTS]

    def passes(self, test: str) -> bool:
        """Tell whether a test passes without a mutant; it is run once."""
        with self._locks[test]:
            if test not in self.failing | self._passing:
                ran = self.clean.run_tests([test], cache=self.shared, name=f"t{abs(hash(test))}")
                (self._passing if ran.code == 0 else self.failing).add(test)
            return test in self._passing

    @functools.cached_property
    def stamps(self) -> set[str]:
        """The beginnings of the names of what is compiled from unchanged sources."""
        files = [f for top in COPIED[:5] for f in (ROOT / top).rglob("*.py")]
        return {str(source_stamp(module_of(f.relative_to(ROOT).as_posix()), f))[:16] for f in files}


class Copy:
    """A copy of what tests need, imported instead of what is installed."""

    def __init__(self, ground: Ground, name: str) -> None:
        self.ground, self.where = ground, ground.folder / name
        self.cache = ground.folder / f"{name}-cache"
        shutil.rmtree(self.where, ignore_errors=True)
        shutil.rmtree(self.cache, ignore_errors=True)
        for item in COPIED:
            source, to = ROOT / item, self.where / item
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copytree(source, to, ignore=left_out) if source.is_dir() else shutil.copy2(source, to)
        for item in INNER:
            (self.where / "soccer_env" / item).symlink_to(self.where / item, target_is_directory=True)

    @contextlib.contextmanager
    def changed(self, name: str, text: str) -> Iterator[None]:
        """Put another text into a file for a while."""
        file = self.where / name
        content, status = file.read_bytes(), file.stat()
        file.write_text(text, encoding="utf-8")
        try:
            yield
        finally:
            file.write_bytes(content)
            os.utime(file, ns=(status.st_atime_ns, status.st_mtime_ns))  # byte code kept of it is true again
            self.sort_code()

    def sort_code(self) -> None:
        """Keep the compiled code of unchanged sources for all, and delete the rest."""
        for file in self.cache.glob("*.nbc"):
            if not self.ground.stamps.isdisjoint(file.name.split(".")):
                os.replace(file, self.ground.shared / file.name)
        shutil.rmtree(self.cache, ignore_errors=True)

    def run_tests(self, tests: list[str], *options: str, cache: Path | None = None, name: str = "") -> Ran:
        """Run tests, up to the first that fails."""
        base = self.ground.folder / "tmp" / f"base-{self.where.name}{name}"
        quiet = [
            "-q",
            "-x",
            "-p",
            "no:cacheprovider",
            "-p",
            "tests.mutation.limits",
            "--tb=short",
            f"--basetemp={base}",
        ]
        try:
            return self.run_python("-m", "pytest", *quiet, *options, *tests, cache=cache or self.cache, name=name)
        finally:
            shutil.rmtree(base, ignore_errors=True)

    def run_python(self, *words: str, cache: Path, name: str = "") -> Ran:
        """Run Python in the copy; StoppedError when the time for all is over."""
        log = self.ground.folder / "tmp" / f"{self.where.name}{name}.log"
        told = log.with_suffix(".test")
        told.unlink(missing_ok=True)
        paths = os.pathsep.join([str(self.where), *filter(None, [os.environ.get("PYTHONPATH")])])
        ours = {"PYTHONPATH": paths, "SOCCER_ENV_CACHE": str(cache), "TMPDIR": str(self.ground.shared.parent)}
        ours |= {"SOCCER_ENV_QUIET": "1", "SOCCER_MUTANT_TEST": str(told), "OMP_NUM_THREADS": "1", "COLUMNS": "200"}
        if self.where.name != "clean":
            ours["PYTHONDONTWRITEBYTECODE"] = "1"
        with log.open("wb") as out:
            process = subprocess.Popen(
                [sys.executable, *words], cwd=self.where, env={**os.environ, **ours}, stdin=subprocess.DEVNULL,
                stdout=out, stderr=subprocess.STDOUT, start_new_session=True,
            )  # fmt: skip
            seconds = self.wait_for(process)
        test = told.read_text(encoding="utf-8") if told.is_file() else ""
        return Ran(process.returncode, log.read_text(encoding="utf-8", errors="replace"), seconds, test)

    def wait_for(self, process: subprocess.Popen[bytes]) -> float:
        """Wait until a process ends, or end it; return the processor time that it took."""
        began = time.monotonic()
        while True:
            ended, status, used = os.wait4(process.pid, os.WNOHANG)
            if ended:
                process.returncode = os.waitstatus_to_exitcode(status)
                with contextlib.suppress(ProcessLookupError):
                    os.killpg(process.pid, signal.SIGKILL)  # what it left running
                return used.ru_utime + used.ru_stime
            over = time.monotonic() > self.ground.until
            if over or time.monotonic() - began > LONGEST:
                os.killpg(process.pid, signal.SIGKILL)
                if over:
                    os.waitpid(process.pid, 0)
                    process.returncode = -signal.SIGKILL
                    raise StoppedError
            time.sleep(0.1)


def left_out(folder: str, names: list[str]) -> set[str]:
    """Return what is not copied: compiled files, and soft links to the inner folders, where a checkout has them."""
    inner = INNER if Path(folder) == ROOT / "soccer_env" else ()
    return shutil.ignore_patterns("__pycache__", "*.pyc", *inner)(folder, names)
