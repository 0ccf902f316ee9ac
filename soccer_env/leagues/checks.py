"""Checks of the settings that a league is made of: every number is one, finite, and passes its test."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import fields
from math import isfinite
from typing import Any

import numpy as np

NUMBERS = {"int": "a whole number", "float": "a number"}  # annotations of fields that hold one
PYTHON_ONLY = {"kernels": False}  # metadata of a field that no compiled kernel reads: it is not among the constants
FAMILY = re.compile(r"[a-z0-9][a-z0-9-]{0,63}")


def check(record: object, **tests: Callable[[float], bool]) -> None:
    """Raise ValueError for each number of a settings record that is none, is not finite or fails its test."""
    where = type(record).__name__
    for field in fields(record):  # type: ignore[arg-type]
        value, kind = getattr(record, field.name), str(field.type)
        if kind not in NUMBERS:
            continue
        if not is_number(value, kind):
            raise ValueError(f"{where}.{field.name} must be {NUMBERS[kind]}, got {value!r}")
        if not isfinite(value):
            raise ValueError(f"{where}.{field.name} must be finite, got {value}")
        if isinstance(value, np.generic):  # so that settings compare and are written as Python's own numbers
            object.__setattr__(record, field.name, value.item())
        test = tests.get(field.name, not_negative)
        if not test(value):
            raise ValueError(f"{where}.{field.name} must be {test.__name__.replace('_', ' ')}, got {value}")


def is_number(value: Any, kind: str) -> bool:
    """Tell whether a value is a number, Python's or numpy's, and a whole one if the kind is "int"."""
    whole = isinstance(value, (int, np.integer)) and not isinstance(value, bool)
    return whole or (kind == "float" and isinstance(value, (float, np.floating)))


def check_family(where: str, family: object) -> None:
    """Raise ValueError unless the name of a family of leagues is a short plain word."""
    if not isinstance(family, str) or not FAMILY.fullmatch(family):
        raise ValueError(f"{where} must be 1 to 64 lower-case letters, digits and -, got {family!r}")


def not_negative(value: float) -> bool:
    """Tell whether a number is zero or more."""
    return value >= 0.0


def positive(value: float) -> bool:
    """Tell whether a number is above zero."""
    return value > 0.0


def between_0_and_1(value: float) -> bool:
    """Tell whether a number is a fraction."""
    return 0.0 <= value <= 1.0


def any_number(value: float) -> bool:
    """Accept every finite number."""
    return True


def is_convex(corners: tuple[tuple[float, float], ...]) -> bool:
    """Tell whether finite corners run counter-clockwise round a convex hull."""
    points = np.asarray(corners, float)
    edges = np.roll(points, -1, axis=0) - points
    after = np.roll(edges, -1, axis=0)
    left_turns = edges[:, 0] * after[:, 1] - edges[:, 1] * after[:, 0] > 0.0
    return len(points) >= 3 and bool(np.isfinite(points).all() and left_turns.all())
