"""Flat settings of named numbers and switches: checked, changed by name, and turned into a record for compiled code."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator, Mapping
from dataclasses import fields, replace
from math import inf, isfinite
from typing import Any, ClassVar, TypeVar

import numpy as np

from soccer_env.leagues.checks import is_number

GREATEST = 1e6  # no number of sensors or memory is larger

T = TypeVar("T", bound="Options")


class Options:
    """A frozen dataclass whose fields are numbers of zero or more, switches (bool), or one of some names.

    `NAMES` maps a field to the names that it may take and their codes; fields in `SIGNED` may be negative.
    """

    NAMES: ClassVar[Mapping[str, Mapping[str, int]]] = {}
    SIGNED: ClassVar[tuple[str, ...]] = ()

    def __post_init__(self) -> None:
        for field in fields(self):  # type: ignore[arg-type]
            object.__setattr__(self, field.name, self._checked(field.name, str(field.type), getattr(self, field.name)))
        self.check_together()

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
        if not isfinite(value) or (value < 0 and name not in self.SIGNED):
            raise ValueError(f"{where} must be {'finite' if name in self.SIGNED else 'zero or more'}, got {value}")
        if abs(value) > GREATEST:
            raise ValueError(f"{where} must be at most {GREATEST:g}, got {value}")
        return int(value) if kind == "int" else float(value)

    def check_together(self) -> None:
        """Raise ValueError for values that do not go together."""

    def changed(self: T, changes: Mapping[str, Any]) -> T:
        """Return the settings with some of them changed by name; ValueError for an unknown name says which exist."""
        known = [field.name for field in fields(self)]  # type: ignore[arg-type]
        for name in changes:
            if name not in known:
                raise ValueError(f"unknown name {name!r} in {type(self).__name__}; known: {', '.join(known)}")
        return replace(self, **changes)  # type: ignore[type-var]

    def rows(self) -> Iterator[tuple[str, Any, str, str]]:
        """Yield name, value, what is allowed, and the note beside each field in its source: unit and source."""
        notes = notes_of(type(self))
        for field in fields(self):  # type: ignore[arg-type]
            kinds = {"bool": "True, False", "int": "whole, 0 or more"}
            allowed = ", ".join(self.NAMES.get(field.name, ())) or kinds.get(str(field.type), "0 or more")
            if field.name in self.SIGNED:
                allowed = "any number"
            yield field.name, getattr(self, field.name), allowed, notes.get(field.name, "")

    def record(self) -> np.ndarray:
        """Return the (1,) record for compiled code: f8 for numbers, i8 for whole numbers, switches and codes."""
        found = np.zeros(1, record_type(type(self)))
        for field in fields(self):  # type: ignore[arg-type]
            value = getattr(self, field.name)
            found[field.name] = self.NAMES[field.name][value] if field.name in self.NAMES else value
        return found


def within(settings: Options, low: float, high: float, names: tuple[str, ...]) -> None:
    """Raise ValueError for each of some settings that does not lie between two bounds, both allowed."""
    for name in names:
        value = getattr(settings, name)
        if not low <= value <= high:
            allowed = f"{low:g} or more" if high == inf else f"{low:g} to {high:g}"
            raise ValueError(f"{type(settings).__name__}.{name} must be {allowed}, got {value}")


def notes_of(kind: type[Options]) -> dict[str, str]:
    """Return the comment beside each field of a settings class, or else beside the field that it inherits."""
    notes: dict[str, str] = {}
    for parent in reversed(kind.__mro__[: kind.__mro__.index(Options)]):
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
