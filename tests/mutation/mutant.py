"""What a mutant is: one mechanism switched off by one replaced piece of source."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from tests.mutation import syntax


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
