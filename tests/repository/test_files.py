"""Files, functions and folders are small; packages map their folders, and kernels explain their one-letter records.

A row of a map begins with NAME.py or NAME/; several may stand on one line, at least two spaces apart.
"""

import ast
import re
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FOLDERS = ("soccer_env", "baselines", "agents", "train")
PRODUCT = [file for folder in FOLDERS for file in sorted((ROOT / folder).rglob("*.py"))]
PACKAGES = [file.parent for file in PRODUCT if file.name == "__init__.py"]
LINES = 300  # of a file
FUNCTION = 35  # lines of a function, with decorators and docstring
FILES = 16  # of a folder, beside its __init__.py
GROUND_FLOOR = 10  # files of soccer_env/ itself
ENTRY = re.compile(r"(?:^|\s{2,})([a-z_0-9]+(?:\.py|/))(?=\s|$)", re.MULTILINE)
LETTERS = ("k", "s", "w", "play")  # constants, sensors, memory; how a team plays

# Functions that are longer, each with the lines that it may have. This list may only shrink.
LONGER = {"train/ppo/vec_env.py __init__": 48}


def name_of(file: Path) -> str:
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
    lengths = {name_of(file): len(file.read_text(encoding="utf-8").splitlines()) for file in PRODUCT}
    assert {name: lines for name, lines in lengths.items() if lines > LINES} == {}


def test_functions_are_short_but_for_a_list_that_may_only_shrink() -> None:
    lengths = {name: lines for file in PRODUCT for name, lines in functions(file).items() if lines > FUNCTION}
    assert {name: lines for name, lines in lengths.items() if lines > LONGER.get(name, FUNCTION)} == {}
    assert sorted(set(LONGER) - set(lengths)) == [], "these are short now: take them off the list"


def test_folders_hold_few_files() -> None:
    counts = Counter(name_of(file.parent) for file in PRODUCT if file.name != "__init__.py")
    ground = counts.pop("soccer_env")
    assert ground <= GROUND_FLOOR
    assert {folder: count for folder, count in counts.items() if count > FILES} == {}


@pytest.mark.parametrize("folder", PACKAGES, ids=name_of)
def test_a_package_says_what_is_in_its_folder(folder: Path) -> None:
    docstring = ast.get_docstring(ast.parse((folder / "__init__.py").read_text(encoding="utf-8"))) or ""
    rows = ENTRY.findall(docstring)
    contents = {file.name for file in folder.glob("*.py") if not file.name.startswith("_")}
    contents |= {f"{file.parent.name}/" for file in folder.glob("*/__init__.py")}  # other folders may be named as well
    assert sorted(contents - set(rows)) == [], "not in the map"
    assert [row for row in rows if not (folder / row).exists()] == [], "not in the folder"
    assert len(rows) == len(set(rows))


def is_kernel(node: ast.AST) -> bool:
    if not isinstance(node, ast.FunctionDef):
        return False
    return any(isinstance(mark, ast.Name) and mark.id in ("compiled", "inlined") for mark in node.decorator_list)


def letters_of(tree: ast.Module) -> set[str]:
    """Return those of LETTERS that the kernels of a file take or set."""
    inside = [node for kernel in filter(is_kernel, ast.walk(tree)) for node in ast.walk(kernel)]
    taken = {node.arg for node in inside if isinstance(node, ast.arg)}
    set_here = {node.id for node in inside if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)}
    return (taken | set_here) & {*LETTERS}


def explained(tree: ast.Module) -> set[str]:
    """Return those of LETTERS that the docstring of a file explains, as `k`: ..."""
    text = ast.get_docstring(tree) or ""
    return {letter for letter in LETTERS if f"`{letter}`: " in text}


@pytest.mark.parametrize("file", PRODUCT, ids=name_of)
def test_a_file_explains_the_letters_that_it_uses_and_no_others(file: Path) -> None:
    tree = ast.parse(file.read_text(encoding="utf-8"))
    assert explained(tree) == letters_of(tree)
