"""The list of mutants stays true: each can be made, each mechanism has one, and a sample is killed by its test."""

import ast
import importlib.util
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest

from tests.mutation.mutants import MUTANTS, PLAY, RULES, Mutant
from tests.mutation.quick import QUICK

ROOT = Path(__file__).parents[2]
SAMPLE = "MS32"  # one that is quick
NO_COUNTS = {ROOT / f"soccer_env/statistics/{name}.py" for name in ("__init__", "records", "figures")}

NO_RULES = {ROOT / f"soccer_env/referee/fouls/{name}__init__.py" for name in ("", "legged/", "middle_size/")}
NO_RULES |= {ROOT / "soccer_env/referee/fouls/judging.py"}  # calls the books of both leagues


def load(name: str) -> ModuleType:
    """Return a module of tests/ by its file, as pytest imports it."""
    spec = importlib.util.spec_from_file_location(f"loaded_{name.replace('/', '_')}", ROOT / "tests" / f"{name}.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def test_every_test_that_is_listed_has_a_mutant_to_kill() -> None:
    references = load("repository/test_references")
    rows, problems = references.rows_of((ROOT / references.TABLE).read_text(encoding="utf-8"))
    assert problems == []
    listed = {(row.mechanism, row.test) for row in rows}
    covered = {(mutant.id, mutant.test.partition("[")[0]) for mutant in MUTANTS}
    assert listed - covered == set()
    assert {mechanism for mechanism, _ in listed} == {mutant.id for mutant in MUTANTS}


@pytest.mark.parametrize("mutant", MUTANTS, ids=lambda mutant: f"{mutant.id}-{mutant.original.strip()[:30]}")
def test_a_mutant_can_be_made_and_its_test_exists(mutant: Mutant) -> None:
    text = (ROOT / mutant.file).read_text(encoding="utf-8")
    changed = ast.parse(mutant.changed(text))
    assert ast.dump(changed) != ast.dump(ast.parse(text))
    compile(changed, mutant.file, "exec")
    find_test: Callable[[str, Path], str | None] = load("repository/test_references").find_test
    found = find_test(mutant.test, ROOT)
    assert found is not None and mutant.id in found.upper().replace("_", " ")


@pytest.mark.parametrize("mutant", QUICK, ids=lambda mutant: mutant.id)
def test_a_slip_can_be_made_and_is_the_business_of_the_quick_tests(mutant: Mutant) -> None:
    text = (ROOT / mutant.file).read_text(encoding="utf-8")
    assert mutant.changed(text) != text
    assert load("repository/test_references").find_test(mutant.test, ROOT) is not None
    lines = (ROOT / "tests/quick.txt").read_text(encoding="utf-8").splitlines()
    assert any(mutant.test.startswith(line) for line in lines if line.startswith("tests/")), "not in tests/quick.txt"


@pytest.mark.parametrize("mutant", PLAY + RULES, ids=lambda mutant: f"{mutant.id}-{mutant.original[:30]}")
def test_a_mutant_of_what_is_counted_or_called_can_be_made_and_its_test_exists(mutant: Mutant) -> None:
    text = (ROOT / mutant.file).read_text(encoding="utf-8")
    changed = ast.parse(mutant.changed(text))
    assert ast.dump(changed) != ast.dump(ast.parse(text))
    compile(changed, mutant.file, "exec")
    assert load("repository/test_references").find_test(mutant.test, ROOT) is not None


def test_every_file_that_counts_has_mutants() -> None:
    counting = set((ROOT / "soccer_env/statistics").glob("*.py")) - NO_COUNTS
    assert {ROOT / mutant.file for mutant in PLAY} == counting


def test_every_rule_has_mutants() -> None:
    rules = set((ROOT / "soccer_env/referee/fouls").rglob("*.py")) - NO_RULES
    assert rules - {ROOT / mutant.file for mutant in RULES} == set()


def test_the_quick_tests_that_are_listed_exist() -> None:
    lines = (ROOT / "tests/quick.txt").read_text(encoding="utf-8").splitlines()
    assert lines[:2] == ["-m", "not slow"]
    assert [line for line in lines[2:] if not (ROOT / line).exists()] == []


def test_no_mutant_is_listed_twice() -> None:
    listed = MUTANTS + PLAY + RULES
    assert len(set(listed)) == len(listed)
    assert len({mutant.id for mutant in QUICK}) == len(QUICK) >= 12


def test_a_survivor_is_found_and_the_copy_is_put_right(tmp_path: Path) -> None:
    mutate = load("mutation/mutate")
    (tmp_path / "kept.py").write_text("ONE = 1\n", encoding="utf-8")
    mutant = Mutant("MS01", "kept.py", "ONE = 1", "ONE = 2", "")
    with mutate.mutated(tmp_path, mutant):
        assert (tmp_path / "kept.py").read_text(encoding="utf-8") == "ONE = 2\n"
    assert (tmp_path / "kept.py").read_text(encoding="utf-8") == "ONE = 1\n"
    with pytest.raises(ValueError, match="stands 0 times"), mutate.mutated(tmp_path, mutant._replace(original="TWO")):
        pass
    with pytest.raises(ValueError, match="unknown mechanisms"):
        mutate.chosen(["MS99"])
    assert 4 <= len(mutate.chosen(["--sample", "4"])) <= 6
    assert {mutant.id for mutant in mutate.chosen(["MH04", "MS14"])} == {"MH04", "MS14"}


@pytest.mark.slow
def test_a_sampled_mutant_is_killed_by_its_test() -> None:
    command = [sys.executable, "tests/mutation/mutate.py", SAMPLE]
    found = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert found.returncode == 0, found.stdout + found.stderr
    assert f"{SAMPLE}  killed" in found.stdout and "0 of 1 mutants survived" in found.stdout
