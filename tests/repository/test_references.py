"""soccer_env/REFERENCES.md stays true: every mechanism named in the code has a row, every row a function and a test."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).parents[2]
TABLE = "soccer_env/REFERENCES.md"
FOLDERS = {"soccer_env.baselines": "baselines", "soccer_env.agents": "agents", "soccer_env.train": "train"}

MECHANISM = re.compile(r"\bM[SH]\d+\b")
# The mechanisms that the two papers describe: 56 of Sacks, 25 of Heinemann et al.
KNOWN = {f"MS{n:02}" for n in range(1, 57)} | {f"MH{n:02}" for n in range(1, 26)}
HEADER = ["id", "function", "test"]

Definition = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef
Node = Definition | ast.Assign | ast.AnnAssign


class Row(NamedTuple):
    """One row of the table, with its line in the file."""

    mechanism: str
    function: str
    test: str
    line: int


def rows_of(text: str) -> tuple[list[Row], list[str]]:
    """Return the rows of the table and what is wrong with its form."""
    rows: list[Row] = []
    problems: list[str] = []
    inside = headed = False
    for number, line in enumerate(text.splitlines(), start=1):
        if not line.lstrip().startswith("|"):
            inside = False
            continue
        cells = [cell.strip().strip("`") for cell in line.strip().strip("|").split("|")]
        if cells == HEADER:
            inside = headed = True
        elif set("".join(cells)) <= set("-: "):
            continue
        elif not inside or len(cells) != len(HEADER):
            problems.append(f"line {number}: not a row of | {' | '.join(HEADER)} |")
        else:
            rows.append(Row(cells[0], cells[1], cells[2], number))
    if not headed:
        problems.append(f"no table | {' | '.join(HEADER)} |")
    return rows, problems


def named_in_docstrings(root: Path) -> Iterator[tuple[str, str]]:
    """Yield each mechanism id in a docstring under soccer_env/ or baselines/, and where it stands."""
    for folder in ("soccer_env", "baselines"):
        for file in sorted((root / folder).rglob("*.py")):
            for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Module | Definition):
                    where = f"{file.relative_to(root)}, {getattr(node, 'name', 'the module')}"
                    yield from ((mechanism, where) for mechanism in MECHANISM.findall(ast.get_docstring(node) or ""))


def file_of(module: list[str], root: Path) -> Path | None:
    """Return the file of a dotted module name, or None."""
    package = ".".join(module[:2])
    path = root / FOLDERS[package] / Path(*module[2:]) if package in FOLDERS else root / Path(*module)
    return next((file for file in (path.with_suffix(".py"), path / "__init__.py") if file.is_file()), None)


def find_function(dotted: str, root: Path) -> str | None:
    """Return the text of `soccer_env.module.function`, `….Class.method` or `….CONSTANT`; None if there is none."""
    parts = dotted.split(".")
    for cut in range(len(parts) - 1, 0, -1):
        file = file_of(parts[:cut], root)
        if parts[0] == "soccer_env" and file:
            return find_in(file, parts[cut:])
    return None


def find_in(file: Path, names: list[str]) -> str | None:
    """Follow names through nested definitions; return the text of the last after the docstrings on the way."""
    source = file.read_text(encoding="utf-8")
    lines = source.splitlines()
    node: ast.AST = ast.parse(source)
    around = []
    for name in names:
        if isinstance(node, ast.Module | ast.ClassDef):
            around.append(ast.get_docstring(node) or "")
        inner = next((child for child in getattr(node, "body", []) if name in names_bound_by(child)), None)
        if inner is None:
            return None
        node = inner
    assert isinstance(node, Node)
    first = min([node.lineno, *(decorator.lineno for decorator in getattr(node, "decorator_list", []))])
    return "\n".join([*around, *lines[first - 1 : node.end_lineno]])


def names_bound_by(node: ast.stmt) -> set[str]:
    if isinstance(node, Definition):
        return {node.name}
    targets = node.targets if isinstance(node, ast.Assign) else [node.target] if isinstance(node, ast.AnnAssign) else []
    return {target.id for target in targets if isinstance(target, ast.Name)}


def find_test(name: str, root: Path) -> str | None:
    """Return the text of `tests/test_file.py::test_name` or `tests/test_file.py::TestClass::test_name`."""
    path, *names = name.partition("[")[0].split("::")
    file = root / path
    inside = path.startswith("tests/") and ".." not in path and file.is_file()
    if not (inside and names and names[-1].startswith("test")):
        return None
    return find_in(file, names)


def problems_of(root: Path) -> list[str]:
    """Return one sentence for each thing that is wrong with the table of a checkout."""
    rows, problems = rows_of((root / TABLE).read_text(encoding="utf-8"))
    listed = {row.mechanism for row in rows}
    for mechanism, where in named_in_docstrings(root):
        if mechanism not in KNOWN:
            problems.append(f"{where}: {mechanism} is no mechanism of the papers")
        elif mechanism not in listed:
            problems.append(f"{where}: {mechanism} has no row")
    for row in rows:
        start = f"line {row.line}: {row.mechanism}"
        if row.mechanism not in KNOWN:
            problems.append(f"{start} is no mechanism of the papers")
        for kind, name, find in (("function", row.function, find_function), ("test", row.test, find_test)):
            found = find(name, root)
            if found is None:
                problems.append(f"{start}: no {kind} {name!r}")
            elif row.mechanism not in MECHANISM.findall(found.upper().replace("_", " ")):
                problems.append(f"{start}: the {kind} {name} does not name it")
    return problems


def test_references_are_true() -> None:
    assert problems_of(ROOT) == []


GOOD_ROWS = [
    "| MS11 | `soccer_env.belief.ball.closer` | `tests/belief/test_ball.py::test_the_smaller_range_is_taken` |",
    "| MS11 | soccer_env.belief.ball.Ball.closer | tests/belief/test_ball.py::TestBall::test_ms11_is_used[legged] |",
    "| MS12 | soccer_env.belief.ball.RATIO | tests/belief/test_ball.py::TestBall::test_ms11_is_used |",
    "| MH25 | soccer_env.baselines.keeper.save.dive | tests/belief/test_ball.py::test_keeper_dives |",
]


def checkout_with(root: Path, rows: list[str]) -> Path:
    """Write a checkout with two mechanisms of Sacks and one of Heinemann in it, and a table with the given rows."""
    files = {
        TABLE: "\n".join(["# References", "", "| id | function | test |", "|---|---|---|", *rows, ""]),
        "soccer_env/belief/ball.py": '"""The ball."""\n\n'
        'def closer(blob):\n    """Return the smaller range.  [Sacks 2001, 3.1.1] MS11"""\n\n'
        'class Ball:\n    """Use MS11."""\n\n    def closer(self):\n        pass\n\n'
        "RATIO: float = 2 / 3  # MS12\n\n"
        "def other(): pass\n",
        "baselines/keeper/__init__.py": "",
        "baselines/keeper/save.py": '"""Save shots. MH25"""\n\ndef dive():\n    pass\n',
        "tests/belief/test_ball.py": 'def test_the_smaller_range_is_taken():\n    """MS11"""\n\n'
        "class TestBall:\n    def test_ms11_is_used(self):\n        assert MS12\n\n"
        "def test_keeper_dives():\n    assert True  # MH25\n\n"
        "def test_nothing():\n    pass\n\ndef helper():\n    '''MS11'''\n",
    }
    for name, text in files.items():
        file = root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return root


def test_a_true_table_passes(tmp_path: Path) -> None:
    assert problems_of(checkout_with(tmp_path, GOOD_ROWS)) == []


def test_a_named_mechanism_without_a_row_is_found(tmp_path: Path) -> None:
    problems = [problem.partition(": ")[2] for problem in problems_of(checkout_with(tmp_path, []))]
    assert problems == ["MS11 has no row", "MS11 has no row", "MH25 has no row"]


TAKEN = "test_ball.py::test_the_smaller_range_is_taken"


@pytest.mark.parametrize(("row", "complaint"), [
    (f"MS11 | soccer_env.belief.ball.nothing | tests/belief/{TAKEN} |", "no function"),
    (f"MS11 | soccer_env.belief.ball | tests/belief/{TAKEN} |", "no function"),
    ("MS11 | soccer_env.belief.ball.other | tests/belief/test_ball.py::test_nothing |", "does not name it"),
    ("MS11 | soccer_env.belief.ball.closer | tests/belief/test_ball.py::test_nothing |", "does not name it"),
    ("MS11 | soccer_env.belief.ball.closer | tests/belief/test_ball.py::test_absent |", "no test"),
    ("MS11 | soccer_env.belief.ball.closer | tests/belief/test_ball.py |", "no test"),
    ("MS57 | soccer_env.belief.ball.closer | tests/belief/test_ball.py::test_nothing |", "is no mechanism"),
    ("MS11 | soccer_env.belief.ball.closer |", "not a row"),
])  # fmt: skip
def test_a_wrong_row_is_found(tmp_path: Path, row: str, complaint: str) -> None:
    assert complaint in "\n".join(problems_of(checkout_with(tmp_path, [*GOOD_ROWS, f"| {row}"])))
