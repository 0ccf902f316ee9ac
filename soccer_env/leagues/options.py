"""Flat settings of named numbers and switches: checked, changed by name, and turned into a record for compiled code."""

from __future__ import annotations

import inspect
import operator
import re
from collections.abc import Iterator, Mapping
from dataclasses import fields, replace
from typing import Any, ClassVar, TypeVar

import numpy as np

from soccer_env.known_names import unknown
from soccer_env.leagues.checks import is_number

GREATEST = 1e6  # no number of sensors or memory is larger
NUMBER = (0.0, GREATEST)  # least and greatest value of a field whose class says nothing else
SIGNED = (-GREATEST, GREATEST)
BELOW = {
    "at most": (operator.le, "at least"),
    "less than": (operator.lt, "more than"),
}  # test of a pair, and its converse

T = TypeVar("T", bound="Options")


class Options:
    """A frozen dataclass whose fields are numbers, switches (bool), or one of some names; see class attributes.

    What may stand in a field is checked and listed by the same four tables; BOUNDS of a class add to its parents'.
    """

    NAMES: ClassVar[Mapping[str, Mapping[str, int]]] = {}  # the names that a field may take, and their codes
    BOUNDS: ClassVar[Mapping[str, tuple[float, float]]] = {}  # least and greatest value, both allowed; else NUMBER
    ORDER: ClassVar[tuple[tuple[str, str, str], ...]] = ()  # (one field, "at most" or "less than", another)
    EVEN: ClassVar[Mapping[str, str]] = {}  # fields that must be even whole numbers, and why

    def __post_init__(self) -> None:
        for field in fields(self):  # type: ignore[arg-type]
            object.__setattr__(self, field.name, self._checked(field.name, str(field.type), getattr(self, field.name)))
        self._check_order()

    def _checked(self, name: str, kind: str, value: Any) -> Any:
        """Return a field's value as Python's own; ValueError says what is allowed."""
        where = f"{type(self).__name__}.{name}"
        if name in self.NAMES:
            if not isinstance(value, str) or value not in self.NAMES[name]:
                raise ValueError(f"{where} must be one of {', '.join(self.NAMES[name])}, got {value!r}")
            return value
        if kind == "bool":
            if not isinstance(value, (bool, np.bool_)):
                raise ValueError(f"{where} must be True or False, got {value!r}")
            return bool(value)
        if not is_number(value, kind):
            raise ValueError(f"{where} must be {'a whole number' if kind == 'int' else 'a number'}, got {value!r}")
        low, high = self.bounds(name)
        if not low <= value <= high:
            raise ValueError(f"{where} must be {span(low, high)}, got {value}")
        if name in self.EVEN and value % 2 != 0:
            raise ValueError(f"{where} must be an even whole number, {self.EVEN[name]}, got {value}")
        return int(value) if kind == "int" else float(value)

    def _check_order(self) -> None:
        """Raise ValueError for the first two values that are not in the order that ORDER asks for."""
        for one, relation, other in self.ORDER:
            value, bound = getattr(self, one), getattr(self, other)
            if not BELOW[relation][0](value, bound):
                raise ValueError(f"{type(self).__name__}.{one} must be {relation} {other} {bound}, got {value}")

    @classmethod
    def bounds(cls, name: str) -> tuple[float, float]:
        """Return the least and the greatest value of a field that holds a number."""
        return next((kind.BOUNDS[name] for kind in kinds_of(cls) if name in kind.BOUNDS), NUMBER)

    @classmethod
    def allowed(cls, name: str, kind: str) -> str:
        """Return in words what a field may hold."""
        if name in cls.NAMES:
            return ", ".join(cls.NAMES[name])
        if kind == "bool":
            return "True, False"
        words = ["whole"] if kind == "int" else []
        words += [span(*cls.bounds(name)), *(["even"] if name in cls.EVEN else [])]
        words += [f"{relation} {other}" for one, relation, other in cls.ORDER if one == name]
        words += [f"{BELOW[relation][1]} {one}" for one, relation, other in cls.ORDER if other == name]
        return ", ".join(words)

    def changed(self: T, changes: Mapping[str, Any]) -> T:
        """Return the settings with some of them changed by name; ValueError for an unknown name says which exist."""
        known = [field.name for field in fields(self)]  # type: ignore[arg-type]
        for name in changes:
            if name not in known:
                raise ValueError(unknown("name", name, known, where=type(self).__name__))
        return replace(self, **changes)  # type: ignore[type-var]

    def rows(self) -> Iterator[tuple[str, Any, str, str]]:
        """Yield name, value, what is allowed, and the note beside each field in its source; inherited fields last."""
        notes = notes_of(type(self))
        inherited = {field.name for kind in kinds_of(type(self))[1:] for field in fields(kind)}  # type: ignore[arg-type]
        for field in sorted(fields(self), key=lambda field: field.name in inherited):  # type: ignore[arg-type]
            allowed = self.allowed(field.name, str(field.type))
            yield field.name, getattr(self, field.name), allowed, notes.get(field.name, "")

    def record(self) -> np.ndarray:
        """Return the (1,) record for compiled code: f8 for numbers, i8 for whole numbers, switches and codes."""
        found = np.zeros(1, record_type(type(self)))
        for field in fields(self):  # type: ignore[arg-type]
            value = getattr(self, field.name)
            found[field.name] = self.NAMES[field.name][value] if field.name in self.NAMES else value
        return found


def span(low: float, high: float) -> str:
    """Return two bounds in words."""
    return " to ".join(f"{bound:.0f}" if bound == round(bound) else f"{bound:g}" for bound in (low, high))


def kinds_of(kind: type[Options]) -> tuple[type[Options], ...]:
    """Return a settings class and those settings classes that it inherits from, nearest first."""
    return kind.__mro__[: kind.__mro__.index(Options)]


def notes_of(kind: type[Options]) -> dict[str, str]:
    """Return the comment beside each field of a settings class, or else beside the field that it inherits."""
    notes: dict[str, str] = {}
    for parent in reversed(kinds_of(kind)):
        lines = inspect.getsource(parent).splitlines()
        found = (re.match(r"    (\w+): \w+(?: = .*?)?  # (.*)", line) for line in lines)
        notes |= {match[1]: match[2] for match in found if match}
    return notes


def record_type(kind: type[Options]) -> np.dtype:
    """Return the dtype of a kind's record; one object for each kind, so that kernels are compiled once."""
    if kind not in RECORD_TYPES:
        columns = [(field.name, "f8" if str(field.type) == "float" else "i8") for field in fields(kind)]  # type: ignore[arg-type]
        RECORD_TYPES[kind] = np.dtype(columns)
    return RECORD_TYPES[kind]


RECORD_TYPES: dict[type[Options], np.dtype] = {}
