"""Files and functions stay small enough to be read at once, and folders small enough to be searched by eye."""

import ast
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).parents[2]
FOLDERS = ("soccer_env", "baselines", "agents", "train")
LINES = 300  # of a file
FUNCTION = 35  # lines of a function, with decorators and docstring
FILES = 16  # of a folder, beside its __init__.py
GROUND_FLOOR = 10  # files of soccer_env/ itself

# Functions that are longer, each with the lines that it may have. This list may only shrink.
LONGER = {
    "train/ppo/vec_env.py __init__": 51,
}


def files() -> list[Path]:
    """Return the files of the product."""
    return [file for folder in FOLDERS for file in sorted((ROOT / folder).rglob("*.py"))]


def name_of(file: Path) -> str:
    """Return a file's path in the repository."""
    return file.relative_to(ROOT).as_posix()


def functions(file: Path) -> dict[str, int]:
    """Return the functions of a file with their lines; of two with one name the longer."""
    found: dict[str, int] = {}
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef):
            first = min([node.lineno, *(mark.lineno for mark in node.decorator_list)])
            name = f"{name_of(file)} {node.name}"
            found[name] = max(found.get(name, 0), (node.end_lineno or 0) - first + 1)
    return found


def test_no_file_is_longer_than_300_lines() -> None:
    lengths = {name_of(file): len(file.read_text(encoding="utf-8").splitlines()) for file in files()}
    assert {name: lines for name, lines in lengths.items() if lines > LINES} == {}


def test_functions_are_short_but_for_a_list_that_may_only_shrink() -> None:
    lengths = {name: lines for file in files() for name, lines in functions(file).items() if lines > FUNCTION}
    assert {name: lines for name, lines in lengths.items() if lines > LONGER.get(name, FUNCTION)} == {}
    assert sorted(set(LONGER) - set(lengths)) == [], "these are short now: take them off the list"


def test_folders_hold_few_files() -> None:
    counts = Counter(name_of(file.parent) for file in files() if file.name != "__init__.py")
    ground = counts.pop("soccer_env")
    assert ground <= GROUND_FLOOR
    assert {folder: count for folder, count in counts.items() if count > FILES} == {}
