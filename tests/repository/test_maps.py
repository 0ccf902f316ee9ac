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
    """Return the modules and packages in a folder as a map names them; other folders may be named as well."""
    modules = {file.name for file in folder.glob("*.py") if not file.name.startswith("_")}
    return modules | {f"{file.parent.name}/" for file in folder.glob("*/__init__.py")}


def mapped(docstring: str) -> list[str]:
    """Return the entries of the map in a docstring."""
    return ENTRY.findall(docstring)


@pytest.mark.parametrize("folder", packages(), ids=lambda folder: folder.relative_to(ROOT).as_posix())
def test_a_package_says_what_is_in_its_folder(folder: Path) -> None:
    docstring = ast.get_docstring(ast.parse((folder / "__init__.py").read_text(encoding="utf-8"))) or ""
    rows = mapped(docstring)
    assert sorted(contents(folder) - set(rows)) == [], "not in the map"
    assert [row for row in rows if not (folder / row).exists()] == [], "not in the folder"
    assert len(rows) == len(set(rows))


def test_rows_of_a_map_are_told_from_prose() -> None:
    text = "Things.\n\n    one.py    it, as two.py has it       three.py   more\n    four/     beside five/\n"
    assert mapped(text) == ["one.py", "three.py", "four/"]
