"""The docstring of every package is a true map of its folder: each module and folder with what it is about.

A row of a map begins with NAME.py or NAME/; several may stand on one line, at least two spaces apart.
"""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FOLDERS = ("soccer_env", "baselines", "agents", "train")
ENTRY = re.compile(r"(?:^|\s{2,})([a-z_0-9]+(?:\.py|/))(?=\s|$)", re.MULTILINE)


def packages() -> list[Path]:
    """Return the folders of all packages of the product."""
    return [file.parent for folder in FOLDERS for file in sorted((ROOT / folder).rglob("__init__.py"))]


def contents(folder: Path) -> set[str]:
    """Return the modules and folders of a package as a map names them."""
    modules = {file.name for file in folder.glob("*.py") if not file.name.startswith("_")}
    return modules | {f"{entry.name}/" for entry in folder.iterdir() if entry.is_dir() and entry.name[0] not in "_."}


def mapped(docstring: str) -> list[str]:
    """Return the entries of the map in a docstring."""
    return ENTRY.findall(docstring)


@pytest.mark.parametrize("folder", packages(), ids=lambda folder: folder.relative_to(ROOT).as_posix())
def test_a_package_says_what_is_in_its_folder(folder: Path) -> None:
    docstring = ast.get_docstring(ast.parse((folder / "__init__.py").read_text(encoding="utf-8"))) or ""
    assert sorted(mapped(docstring)) == sorted(contents(folder))


def test_rows_of_a_map_are_told_from_prose() -> None:
    text = "Things.\n\n    one.py    it, as two.py has it       three.py   more\n    four/     beside five/\n"
    assert mapped(text) == ["one.py", "three.py", "four/"]
