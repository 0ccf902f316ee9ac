"""The examples: short, self-explaining, known to make and to the page that names them, and no part of the package."""

import ast
import importlib
import re
import subprocess
import sys
from pathlib import Path
from unittest.mock import patch

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.train.examples import monte_carlo
from soccer_env.train.examples.__main__ import PAGES, main, needs

ROOT = Path(__file__).parents[3]
FOLDER = ROOT / "train/examples"
LINES = 40  # of code: without docstrings, imports, comments and blank lines


def code_lines(source: str) -> set[int]:
    """Return the numbers of the lines that do something."""
    tree = ast.parse(source)
    left_out: set[int] = set()
    for node in ast.walk(tree):
        told = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
        if told or isinstance(node, (ast.Import, ast.ImportFrom)):
            left_out |= set(range(node.lineno, (node.end_lineno or 0) + 1))
    lines = enumerate(source.splitlines(), 1)
    return {number for number, line in lines if line.strip() and not line.strip().startswith("#")} - left_out


def made(name: str) -> list[str]:
    """Return the words that a variable of the Makefile holds."""
    found = re.search(rf"^{name} := (.*)$", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
    assert found is not None
    return found[1].split()


@pytest.mark.parametrize("name", PAGES)
def test_a_page_is_short_and_says_what_it_needs_and_reached(name: str) -> None:
    source = (FOLDER / f"{name}.py").read_text(encoding="utf-8")
    assert len(code_lines(source)) <= LINES
    assert re.fullmatch(r"([\w-]+(\[\w+\])?==[\w.]+ ?)+", needs(name)), "each with its version, as pip takes it"
    assert re.search(r"^Reached: .*\d+ s", ast.get_docstring(ast.parse(source)) or "", re.MULTILINE)


def test_make_knows_every_page_and_where_it_can_run() -> None:
    here, apart = made("HERE"), made("APART")
    assert sorted(here + apart) == PAGES
    brought = {"torch", "stable-baselines3"}  # by the extra `train`
    assert {name for name in PAGES if {word.split("==")[0] for word in needs(name).split()} <= brought} == set(here)


def test_every_page_stands_in_the_table_with_what_it_needs() -> None:
    _, _, section = (ROOT / "train/README.md").read_text(encoding="utf-8").partition("\n### Examples\n")
    rows = re.findall(r"^\| `(\w+)` \| .*? \| `([^`]*)` \|", section, re.MULTILINE)
    assert dict(rows) == {name: needs(name) for name in PAGES}


def test_nothing_of_the_package_imports_the_examples() -> None:
    folders = [ROOT / name for name in ("soccer_env", "baselines", "agents", "train")]
    others = [file for folder in folders for file in folder.rglob("*.py") if file.parent != FOLDER]
    assert [file for file in others if "train.examples" in file.read_text(encoding="utf-8")] == []


@pytest.mark.parametrize("name", PAGES)
def test_what_a_page_takes_from_the_package_is_there(name: str) -> None:
    for node in ast.walk(ast.parse((FOLDER / f"{name}.py").read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("soccer_env"):
            module = importlib.import_module(node.module or "")
            assert [alias.name for alias in node.names if not hasattr(module, alias.name)] == []


def test_a_page_that_nobody_knows_or_whose_library_is_missing_is_one_line(tmp_path: Path) -> None:
    program = "import sys\nsys.modules['minari'] = None\nfrom soccer_env.train.examples.__main__ import main\nmain()"
    for name, expected in {
        "ppo_keras": "name an example: cloning_minari",
        "cloning_minari": "needs minari[hdf5]==",
    }.items():
        run = subprocess.run([sys.executable, "-c", program, name], cwd=tmp_path, capture_output=True, text=True)
        assert run.returncode == 1
        assert expected in run.stderr and len(run.stderr.splitlines()) == 1


def test_help_names_every_page_with_what_it_needs(capsys: pytest.CaptureFixture[str]) -> None:
    for flag in ("-h", "--help"):
        with patch.object(sys, "argv", ["examples", flag]):
            main()
        shown = capsys.readouterr().out
        assert [name for name in PAGES if f"  {name} " not in shown or f"needs: {needs(name)}\n" not in shown] == []


@pytest.mark.slow
def test_search_gets_past_where_chaser_does_not() -> None:
    assert [monte_carlo.play(seed) for seed in (1, 2)] == [True, True]
    assert [monte_carlo.play(seed, home="chaser") for seed in (1, 2)] == [False, False]


def test_a_search_changes_no_record_of_the_match() -> None:
    match = Match(seed=1, controllers={"away": "still"}, **monte_carlo.DRILL)
    planner, before = match.branch([0] * 8), match.state_hash()
    plan = monte_carlo.best_plan(match, planner, np.random.default_rng(1), np.zeros((monte_carlo.WALKS, 4)))
    assert match.state_hash() == before
    assert plan.shape == (monte_carlo.WALKS, 4) and np.abs(plan).max() <= 1.0
