"""What a mutant is: one mechanism switched off by one replaced piece of source."""

from __future__ import annotations

from typing import NamedTuple


class Mutant(NamedTuple):
    """One mechanism switched off, and the test that must notice."""

    id: str  # of the mechanism, as in soccer_env/REFERENCES.md
    file: str
    original: str  # stands exactly once in the file
    replacement: str
    test: str
