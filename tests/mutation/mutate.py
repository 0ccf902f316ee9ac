"""The mutation check: every mechanism is switched off in turn, and the test that names it has to fail.

    python tests/mutation/mutate.py              all mutants
    python tests/mutation/mutate.py MS12 MH06    those of some mechanisms
    python tests/mutation/mutate.py --sample 6   every so many-th, for continuous integration
    python tests/mutation/mutate.py --quick      the slips that `make test-quick` has to notice
    python tests/mutation/mutate.py --play       what the statistics of play count; `saves`, for one, is a name too
    python tests/mutation/mutate.py --rules      what the referee calls; so is `pushing`

A mutant is one replaced piece of source (tests/mutation/mutants.py). It runs in a copy of the checkout; the checkout
itself is never touched. The tests have to pass before anything is replaced. A mutant whose test passes all the same has
survived, and one that does not even compile says nothing: exit code 1. Those of statistics and rules run without
compiling, which is quicker: their tests write what happened into records, or play for seconds.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from tests.mutation.mutants import MUTANTS, PLAY, RULES, Mutant  # noqa: E402  # the folder above has to be known first
from tests.mutation.quick import QUICK  # noqa: E402  # the same

COPIED = ("soccer_env", "baselines", "agents", "train", "tests", "pyproject.toml", "README.md")
INNER = ("baselines", "agents", "train")  # stand at the top, are imported from inside the package
PASSED, FAILED = 0, 1  # pytest's exit codes when tests ran, and when some of them failed
LISTS = {"--quick": QUICK, "--play": PLAY, "--rules": RULES}
BROKEN = ("SyntaxError", "NameError", "TypingError", "LoweringError", "UnsupportedError")  # failures of no meaning


def left_out(folder: str, names: list[str]) -> set[str]:
    """Return what is not copied: compiled files, and soft links to the inner folders, where a checkout has them."""
    inner = INNER if Path(folder) == ROOT / "soccer_env" else ()
    return shutil.ignore_patterns("__pycache__", "*.pyc", *inner)(folder, names)


def copy_checkout(to: Path) -> None:
    """Copy what tests need, so that it is imported instead of what is installed."""
    for name in COPIED:
        source = ROOT / name
        shutil.copytree(source, to / name, ignore=left_out) if source.is_dir() else shutil.copy(source, to / name)
    for name in INNER:
        (to / "soccer_env" / name).symlink_to(to / name, target_is_directory=True)


@contextmanager
def mutated(where: Path, mutant: Mutant) -> Iterator[None]:
    """Replace the mutant's piece of source in the copy for a while; ValueError if it is not there exactly once."""
    file = where / mutant.file
    text = file.read_text(encoding="utf-8")
    file.write_text(mutant.changed(text), encoding="utf-8")
    try:
        yield
    finally:
        file.write_text(text, encoding="utf-8")


def run_tests(where: Path, *options: str, compiling: bool = True) -> subprocess.CompletedProcess[str]:
    """Run tests in the copy."""
    environment = {**os.environ, "PYTHONPATH": str(where), "SOCCER_ENV_QUIET": "1", "PYTHONDONTWRITEBYTECODE": "1"}
    environment |= {} if compiling else {"NUMBA_DISABLE_JIT": "1"}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *options]
    return subprocess.run(command, cwd=where, env=environment, capture_output=True, text=True, check=False)


def is_compiled(mutant: Mutant) -> bool:
    """Tell whether the test of a mutant needs compiled kernels, to be done in time."""
    return mutant not in PLAY and mutant not in RULES


def verdict_on(where: Path, mutant: Mutant) -> str:
    """Return "killed" if the test of a mutant notices it, and otherwise what happened, in capitals."""
    with mutated(where, mutant):
        ran = run_tests(where, "-x", mutant.test, compiling=is_compiled(mutant))
    broken = [name for name in BROKEN if name in ran.stdout]
    if broken:
        return f"BROKEN ({broken[0]})"
    return "killed" if ran.returncode == FAILED else f"SURVIVED (exit code {ran.returncode})"


def chosen(words: list[str]) -> list[Mutant]:
    """Return the mutants that the command line asks for; ValueError for an unknown id."""
    if len(words) == 1 and words[0] in LISTS:
        return LISTS[words[0]]
    known = MUTANTS + QUICK + PLAY + RULES
    if words[:1] == ["--sample"]:
        return known[:: max(len(known) // int(words[1]), 1)]
    unknown = set(words) - {mutant.id for mutant in known}
    if unknown:
        raise ValueError(f"unknown mechanisms {sorted(unknown)}")
    return [mutant for mutant in known if not words or mutant.id in words]


def main(words: list[str]) -> int:
    """Run the mutants; print a line for each, return 1 if one was not killed."""
    mutants, verdicts = chosen(words), []
    with tempfile.TemporaryDirectory() as folder:
        where = Path(folder)
        copy_checkout(where)
        for compiling in (True, False):
            tests = dict.fromkeys(mutant.test for mutant in mutants if is_compiled(mutant) == compiling)
            clean = run_tests(where, *tests, compiling=compiling) if tests else None
            if clean is not None and clean.returncode != PASSED:
                print(f"the tests have to pass before anything is switched off\n{clean.stdout}{clean.stderr}")
                return 1
        for mutant in mutants:
            verdicts.append(verdict_on(where, mutant))
            print(f"{mutant.id}  {verdicts[-1]}  {mutant.test}", flush=True)
    survivors = len(verdicts) - verdicts.count("killed")
    print(f"{survivors} of {len(mutants)} mutants survived")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
