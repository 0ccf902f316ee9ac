"""Flat settings of named numbers and switches: checked, changed by name, and turned into a record for compiled code."""

import inspect
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any, ClassVar, TypeVar

import numpy as np

from soccer_env.guards.checking import BELOW, CheckedFields, Range, field_type_name
from soccer_env.guards.names import unknown

GREATEST = 1e6  # no number of sensors or memory is larger
SIGNED = (-GREATEST, GREATEST)

T = TypeVar("T", bound="Options")


class Options(CheckedFields):
    """A frozen dataclass whose fields are numbers, switches (bool), or names from a list; see class attributes.

    The same tables check and list the allowed values; BOUNDS of a class add to its parents'.
    """

    NAMES: ClassVar[Mapping[str, Mapping[str, int]]] = {}  # the names that a field may take, and their codes
    DERIVED: ClassVar[Mapping[str, Callable[[Any], float]]] = {}  # numbers that follow from the fields: f(settings)
    NUMBER = Range(0.0, GREATEST)

    @classmethod
    def allowed(cls, name: str, kind: str) -> str:
        """Return a text that states the allowed values of the field `name`."""
        if name in cls.NAMES:
            return ", ".join(cls.NAMES[name])
        if kind == "bool":
            return "True, False"
        words = ["whole"] if kind == "int" else []
        words += [cls.bounds(name).text(), *(["even"] if name in cls.EVEN else [])]
        words += [f"{relation} {other}" for one, relation, other in cls.ORDER if one == name]
        words += [f"{BELOW[relation][1]} {one}" for one, relation, other in cls.ORDER if other == name]
        return ", ".join(words)

    def changed(self: T, changes: Mapping[str, Any]) -> T:
        """Return a copy of the settings with some values changed; ValueError for an unknown name lists the names."""
        known = [field.name for field in fields(self)]  # type: ignore[arg-type]
        for name in changes:
            if name not in known:
                listed = "settings" if type(self).__name__.endswith("Settings") else "sensors"
                raise ValueError(unknown("name", name, known, where=type(self).__name__, listed=listed))
        return replace(self, **changes)  # type: ignore[type-var]

    def rows(self) -> Iterator[tuple[str, Any, str, str]]:
        """Yield name, value, allowed values and source comment of each field; inherited fields last."""
        notes, parents = field_comments(type(self)), type(self).__mro__
        parents = parents[1 : parents.index(Options)]
        inherited = {field.name for kind in parents for field in fields(kind)}
        for field in sorted(fields(self), key=lambda field: field.name in inherited):  # type: ignore[arg-type]
            allowed = self.allowed(field.name, field_type_name(field))
            yield field.name, getattr(self, field.name), allowed, notes.get(field.name, "")

    def record(self) -> np.ndarray:
        """Return the (1,) record for compiled code: f8 for numbers, i8 for whole numbers, switches and codes.

        The derived numbers follow, computed once.
        """
        record = np.zeros(1, record_type(type(self)))
        for field in fields(self):  # type: ignore[arg-type]
            value = getattr(self, field.name)
            record[field.name] = self.NAMES[field.name][value] if field.name in self.NAMES else value
        for name, follows in self.DERIVED.items():
            record[name] = follows(self)
        return record


def field_comments(kind: type) -> dict[str, str]:
    """Return the comment beside each field of a settings class, inherited fields included."""
    notes: dict[str, str] = {}
    for parent in reversed(kind.__mro__):
        notes |= own_field_comments(parent) if is_dataclass(parent) else {}
    return notes


def own_field_comments(kind: type) -> dict[str, str]:
    """Return the comment beside each field that a settings class declares itself."""
    matches = (re.match(r"    (\w+): \w+(?: = .*?)?  # (.*)", line) for line in inspect.getsource(kind).splitlines())
    return {match[1]: match[2] for match in matches if match}


def record_type(kind: type[Options]) -> np.dtype:
    """Return the record dtype of a settings class; always the identical object, so that kernels are compiled once."""
    if kind not in RECORD_TYPES:
        columns = [(field.name, "f8" if field_type_name(field) == "float" else "i8") for field in fields(kind)]  # type: ignore[arg-type]
        RECORD_TYPES[kind] = np.dtype(columns + [(name, "f8") for name in kind.DERIVED])
    return RECORD_TYPES[kind]


RECORD_TYPES: dict[type[Options], np.dtype] = {}
