"""Copies of the checkout, tests that run in them until one notices a slip, and the compiled code that they share.

A copy has its own folder of compiled code beside one that all read. What belongs to unchanged sources moves from the
first to the second after each mutant; what belongs to the mutant goes.
"""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections import namedtuple
from collections.abc import Iterator
from pathlib import Path

from soccer_env.compiling.cache import cache_folders
from soccer_env.compiling.sources import source_stamp
from tests.mutation.related import module_of

ROOT = Path(__file__).resolve().parents[2]
INNER = ("baselines", "agents", "train")  # stand at the top, are imported from inside the package
FOLDERS, FILES = ("soccer_env", *INNER, "tests"), ("pyproject.toml", "README.md", "CONTRIBUTING.md")
LONGEST = 1800.0  # [s] until a process that waits for something is ended
FAILING = re.compile(r"^(?:FAILED|ERROR) (\S.*?)(?: - .*)?$", re.MULTILINE)
BROKEN = re.compile(r"^E? +.*\b(SyntaxError|NameError|TypingError|LoweringError|UnsupportedError)\b", re.MULTILINE)
NONE_CHOSEN = 5  # pytest's exit code when there is no test to run
HOW = {-signal.SIGXCPU: "killed (time)", -signal.SIGKILL: "killed (time)"}
QUIET = ("-q", "-x", "-p", "no:cacheprovider", "-p", "tests.mutation.limits", "--tb=short")
Stage = tuple[list[str], tuple[str, ...]]  # files of tests, and options of pytest
Ran = namedtuple("Ran", "code output seconds last")  # negative for a signal; seconds of processor time; the last test


class StoppedError(Exception):
    """The time for all mutants is over."""


class Ground:
    """A folder in which mutants run: copies of the checkout, and the compiled code of the unchanged one."""

    def __init__(self, folder: Path, until: float) -> None:
        self.folder, self.until = folder, until
        self.shared = folder / "tmp" / f"soccer_env-{os.getuid()}"  # soccer_env reads it after SOCCER_ENV_CACHE
        self.shared.mkdir(mode=0o700, parents=True, exist_ok=True)
        for file in (file for kept in cache_folders()[:1] if kept.is_dir() for file in kept.glob("*.nbc")):
            with contextlib.suppress(OSError):
                os.link(file, self.shared / file.name)
        files = [file for top in FOLDERS for file in (ROOT / top).rglob("*.py")]
        stamps = (source_stamp(module_of(file.relative_to(ROOT).as_posix()), file) for file in files)
        self.stamps = {str(stamp)[:16] for stamp in stamps}  # names of what unchanged sources compile to begin so
        self.clean = Copy(self, "clean")
        self.clean.cache = self.shared
        self.failing: set[str] = set()  # tests that fail without any mutant
        self.passing = {""}
        self.lock = threading.Lock()

    def passes(self, test: str) -> bool:
        """Tell whether a test passes without a mutant; it is run once."""
        with self.lock:
            if test not in self.failing | self.passing:
                (self.failing if self.clean.run_tests([test]).code else self.passing).add(test)
            return test in self.passing


class Copy:
    """A copy of what tests need, imported instead of what is installed."""

    def __init__(self, ground: Ground, name: str) -> None:
        self.ground, self.where = ground, ground.folder / name
        self.cache = ground.folder / f"{name}-cache"
        for old in (self.where, self.cache):
            shutil.rmtree(old, ignore_errors=True)
        for folder in FOLDERS:
            shutil.copytree(ROOT / folder, self.where / folder, symlinks=True, ignore=shutil.ignore_patterns("*.pyc"))
        for file in FILES:
            shutil.copy2(ROOT / file, self.where / file)
        for folder in INNER:
            link = self.where / "soccer_env" / folder
            link.unlink(missing_ok=True)  # a checkout has some that lead out of the copy
            link.symlink_to(self.where / folder, target_is_directory=True)

    @contextlib.contextmanager
    def changed(self, name: str, text: str) -> Iterator[None]:
        """Put another text into a file for a while; then keep the compiled code of unchanged sources for all."""
        file = self.where / name
        content, status = file.read_bytes(), file.stat()
        file.write_text(text, encoding="utf-8")
        try:
            yield
        finally:
            file.write_bytes(content)
            os.utime(file, ns=(status.st_atime_ns, status.st_mtime_ns))  # byte code kept of it is true again
            for code in self.cache.glob("*.nbc"):
                if not self.ground.stamps.isdisjoint(code.name.split(".")):
                    os.replace(code, self.ground.shared / code.name)
            shutil.rmtree(self.cache, ignore_errors=True)

    def run_tests(self, tests: list[str], *options: str) -> Ran:
        base = self.ground.folder / "tmp" / f"base-{self.where.name}"
        return self.run_python("-m", "pytest", *QUIET, f"--basetemp={base}", *options, *tests)

    def run_python(self, *words: str) -> Ran:
        """Run Python in the copy, for a while at most; StoppedError when the time for all is over."""
        log = self.ground.folder / "tmp" / f"{self.where.name}.log"
        told = log.with_suffix(".test")
        told.write_text("", encoding="utf-8")
        paths = os.pathsep.join([str(self.where), *filter(None, [os.environ.get("PYTHONPATH")])])
        ours = {"PYTHONPATH": paths, "SOCCER_ENV_CACHE": str(self.cache), "TMPDIR": str(self.ground.shared.parent),
                "PYTHONDONTWRITEBYTECODE": "1"}  # fmt: skip
        ours |= {"SOCCER_ENV_QUIET": "1", "SOCCER_MUTANT_TEST": str(told), "OMP_NUM_THREADS": "1", "COLUMNS": "200"}
        with log.open("wb") as out:
            process = subprocess.Popen(
                [sys.executable, *words], cwd=self.where, env={**os.environ, **ours}, stdin=subprocess.DEVNULL,
                stdout=out, stderr=subprocess.STDOUT, start_new_session=True,
            )  # fmt: skip
        wait = min(LONGEST, self.ground.until + 0.1 - time.monotonic())
        timer = threading.Timer(wait, os.killpg, (process.pid, signal.SIGKILL))
        timer.start()
        _, status, used = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)  # what it left running
        if time.monotonic() > self.ground.until:
            raise StoppedError
        output = log.read_text(encoding="utf-8", errors="replace")
        return Ran(process.returncode, output, used.ru_utime + used.ru_stime, told.read_text(encoding="utf-8"))

    def verdict(self, file: str, text: str, asked: list[Stage]) -> tuple[str, str, float]:
        """Return what tests say to a file with another text: a word, by which test, after how much processor time."""
        with self.changed(file, text):
            ran = self.run_python("-c", f"import {module_of(file)}")
            seconds = ran.seconds
            if ran.code:
                return "invalid", "import", seconds
            for tests, options in asked:
                while chosen := [test for test in tests if test not in self.ground.failing]:
                    left = [f"--deselect={test}" for test in sorted(self.ground.failing)]
                    ran = self.run_tests(chosen, *options, *left)
                    seconds += ran.seconds
                    if ran.code in (0, NONE_CHOSEN):
                        break
                    if broken := BROKEN.search(ran.output):
                        return "invalid", broken[1], seconds
                    word = "killed" if ran.code > 0 else HOW.get(ran.code, "killed (died)")
                    for test in FAILING.findall(ran.output) or [ran.last]:
                        if self.ground.passes(test):
                            if word != "killed" or self.run_tests([test]).code:
                                return word, test, seconds
                            self.ground.failing.add(test)  # by chance: it is asked no more
        return "lived", "", seconds
