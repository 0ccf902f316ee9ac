"""The mutants that are listed: mechanisms of papers, and slips that nobody can notice (`equivalents.toml`)."""

from __future__ import annotations

import functools
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from tests.mutation import syntax

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]


class Mechanism(NamedTuple):
    """One mechanism switched off, and the test that must notice."""

    id: str  # as in soccer_env/REFERENCES.md
    file: str
    original: str  # expression or statements that stand once in the file, in whatever layout; see syntax.py
    replacement: str
    test: str
    where: str = ""  # function or class to look in, if that stands in others as well

    def changed(self, text: str) -> str:
        """Return the text of the file with the mechanism switched off; ValueError if its piece is not there once."""
        return syntax.replace(text, self.original, self.replacement, self.where)


def read() -> list[Mechanism]:
    return [Mechanism(**row) for row in rows("mechanisms.toml")["mutant"]]


@functools.cache
def rows(name: str) -> dict[str, list[dict[str, str]]]:
    """Return what a file of this folder says."""
    return tomllib.loads((FOLDER / name).read_text(encoding="utf-8"))


def reason(row: Mapping[str, Any]) -> str:
    """Return why a mutant changes nothing that anybody could notice, or nothing."""
    line = ["", *(ROOT / row["file"]).read_text(encoding="utf-8").splitlines()][row["line"]]
    for one in rows("equivalents.toml")["equivalent"]:
        if all(one[name] == row[name] for name in ("file", "original", "replacement")) and one["text"] in line:
            return one["reason"]
    return ""
