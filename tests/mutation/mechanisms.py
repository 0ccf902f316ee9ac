"""The mutants that switch off a mechanism of a paper, read from `mechanisms.toml`."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import NamedTuple

from tests.mutation import syntax

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


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
    """Return all of them."""
    text = Path(__file__).with_suffix(".toml").read_text(encoding="utf-8")
    return [Mechanism(**row) for row in tomllib.loads(text)["mutant"]]
