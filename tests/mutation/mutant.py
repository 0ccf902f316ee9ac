"""What a mutant is: one mechanism switched off by one replaced piece of source."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from tests.mutation import syntax

By = dict[str, list[tuple[str, ...]]]  # by test: id, original, replacement, and where, if it stands in others as well


class Mutant(NamedTuple):
    """One mechanism switched off, and the test that must notice."""

    id: str  # of the mechanism, as in soccer_env/REFERENCES.md
    file: str
    original: str  # expression or statements that stand once in the file, in whatever layout; see syntax.py
    replacement: str
    test: str
    where: str = ""  # function or class to look in, if that stands in others as well

    def changed(self, text: str) -> str:
        """Return the text of the file with the mechanism switched off; ValueError if its piece is not there once."""
        if Path(self.file).suffix == ".py":
            return syntax.replace(text, self.original, self.replacement, self.where)
        if text.count(self.original) != 1:
            raise ValueError(f"{self.original!r} stands {text.count(self.original)} times in {self.file}")
        return text.replace(self.original, self.replacement)


def mutants_of(folder: str, parts: dict[str, By]) -> list[Mutant]:
    """Return the mutants of the files of a folder, given by their names without `.py`."""
    return [
        Mutant(row[0], f"{folder}{name}.py", row[1], row[2], test, *row[3:])
        for name, by_test in parts.items()
        for test, rows in by_test.items()
        for row in rows
    ]
