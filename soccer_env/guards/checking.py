"""Check settings, numbers and names, with error messages of one form.

    <setting> must be <allowed values>, got <value>
    unknown <kind> <name>, did you mean <similar name>? known: <all names>

A settings record is a frozen dataclass that inherits from `CheckedFields`: its annotations and a few tables beside them
give the allowed values of each field.
"""

import operator
import sys
from collections.abc import Iterable, Mapping
from dataclasses import Field, fields
from functools import cache
from math import inf
from pathlib import Path
from reprlib import Repr
from types import NoneType, UnionType
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, NoReturn, Union, get_args, get_origin

import numpy as np

from soccer_env.guards.names import unknown

BRIEF = Repr()
BRIEF.maxstring = BRIEF.maxother = 80
BELOW = {"at most": (operator.le, "at least"), "less than": (operator.lt, "more than")}  # comparison, inverse words


class Range(NamedTuple):
    """A range of allowed finite numbers."""

    low: float = -inf
    high: float = inf
    above: bool = False  # True: without the lower end itself
    below: bool = False  # True: without the upper end itself

    def holds(self, value: float) -> bool:
        """Tell whether a number lies in the range."""
        value = value.item() if isinstance(value, np.generic) else value  # float32 has no room for the bounds
        high_enough = value > self.low if self.above else value >= self.low
        low_enough = value < self.high if self.below else value <= self.high
        return high_enough and low_enough and abs(value) <= sys.float_info.max

    def text(self, whole: bool = False) -> str:
        """Return the range in words."""
        if abs(self.low) < inf and self.high < inf and not (self.above or self.below):
            ends = (f"{bound:.0f}" if bound == round(bound) else f"{bound:g}" for bound in (self.low, self.high))
            return " to ".join(ends)
        low = f"{'above' if self.above else 'of at least'} {self.low:g}" if self.low > -inf else ""
        high = f"{'below' if self.below else 'at most'} {self.high:g}" if self.high < inf else ""
        bounds = " and ".join(filter(None, (low, high)))
        return f"a {'whole ' if whole else ''}number {bounds}".strip()


ANY = Range()
ABOVE_ZERO = Range(0.0, above=True)
FROM_ZERO = Range(0.0)
SHARE = Range(0.0, 1.0)


def allowed_in_words(allowed: Range, whole: bool, value: Any) -> str:
    """Return the allowed numbers in words; "a whole number, ..." if the value is in range or not a number at all."""
    text = allowed.text(whole)
    not_whole = whole and not text.startswith("a ") and (not is_number(value) or allowed.holds(value))
    return f"a whole number, {text}" if not_whole else text


def raise_not_allowed(what: str, allowed: str, value: Any) -> NoReturn:
    """Raise ValueError for a value that is not allowed, with the allowed values in words."""
    raise ValueError(f"{what} must be {allowed}, got {short_repr(value)}")


def short_repr(value: object) -> str:
    """Return the representation of a value as one short line, safe for values from untrusted files."""
    return BRIEF.repr(value)


def check_names(
    what: str, given: Iterable[Any], known: Iterable[str], error: type[Exception] = ValueError, more: str = ""
) -> None:
    """Raise an error for the first unknown name in `given`, with the known names and the most similar name."""
    known = list(known)
    for name in given:
        if not isinstance(name, str) or name not in known:
            raise error(unknown(what, name, known, more=more))


def check_choice(what: str, value: Any, choices: Iterable[Any]) -> Any:
    """Return the value if it is one of the choices; otherwise ValueError lists the choices."""
    choices = list(choices)
    if not any(isinstance(value, type(choice)) and value == choice for choice in choices):
        raise_not_allowed(what, f"one of {', '.join(map(str, choices))}", value)
    return value


def check_whole_number(what: str, value: Any, low: float = -inf, high: float = inf) -> int:
    """Return the value if it is a whole number in a range; otherwise ValueError names value and range."""
    allowed = Range(low, high)
    if not (is_number(value, whole=True) and allowed.holds(value)):
        raise_not_allowed(what, allowed_in_words(allowed, True, value), value)
    return int(value)


def check_finite_number(what: str, value: Any, allowed: Range = ANY) -> float:
    """Return the value if it is a finite number in a range; otherwise ValueError names value and range."""
    if not (is_number(value) and allowed.holds(value)):
        raise_not_allowed(what, allowed.text(), value)
    return float(value)


def is_number(value: Any, whole: bool = False) -> bool:
    """Tell whether a value is a number of Python or numpy, but not a bool; `whole`: whether it is a whole number."""
    if isinstance(value, (int, np.integer)):
        return not isinstance(value, bool)
    return not whole and isinstance(value, (float, np.floating))


class CheckedFields:
    """A base class for frozen dataclasses that check the values of their fields.

    bool, int, float, str, Path, Literal, None and their unions are checked by annotation; fields of other types may
    hold anything. Tables add to the tables of parent classes; `bounds` in a field's metadata replaces BOUNDS.
    """

    NAMES: ClassVar[Mapping[str, Iterable[str]]] = {}  # the allowed names of a field
    BOUNDS: ClassVar[Mapping[str, tuple[Any, ...]]] = {}  # of numbers: Range, or (least, greatest); else NUMBER
    NUMBER: ClassVar[Range] = ANY
    ORDER: ClassVar[tuple[tuple[str, str, str], ...]] = ()  # (one field, "at most" or "less than", another)
    EVEN: ClassVar[Mapping[str, str]] = {}  # fields that must be even whole numbers, and why
    TITLED: ClassVar[bool] = True  # messages name the class before the field

    def __post_init__(self) -> None:
        # mypy takes the hash of the class for that of its instances.
        for name, kinds in kinds_of_fields(type(self)).items():  # type: ignore[arg-type]
            object.__setattr__(self, name, self._checked(name, kinds, getattr(self, name)))
        for one, relation, other in self.ORDER:
            value, bound = getattr(self, one), getattr(self, other)
            if not BELOW[relation][0](value, bound):
                raise_not_allowed(self.where(one), f"{relation} {other} {bound}", value)

    @classmethod
    def where(cls, name: str) -> str:
        """Return the name of a field as error messages show it."""
        return f"{cls.__name__}.{name}" if cls.TITLED else name

    def _checked(self, name: str, kinds: tuple[Any, ...], value: Any) -> Any:
        """Return a field's value, converted to a plain Python type; ValueError names the allowed values."""
        if name in self.NAMES:
            return check_choice(self.where(name), value, self.NAMES[name])
        for kind in kinds:
            fits, checked = convert_to_kind(kind, value, self.bounds(name))
            if fits:
                if name in self.EVEN and value is not None and value % 2 != 0:
                    raise_not_allowed(self.where(name), f"an even whole number, {self.EVEN[name]}", value)
                return checked
        raise_not_allowed(self.where(name), self._words(name, kinds, value), value)

    @classmethod
    def bounds(cls, name: str) -> Range:
        """Return the range of numbers that a field may hold."""
        metadata = cls.__dataclass_fields__[name].metadata  # type: ignore[attr-defined]
        tables = (kind.BOUNDS[name] for kind in cls.__mro__ if issubclass(kind, CheckedFields) and name in kind.BOUNDS)
        return Range(*metadata["bounds"]) if "bounds" in metadata else Range(*next(tables, cls.NUMBER))

    @classmethod
    def _words(cls, name: str, kinds: tuple[Any, ...], value: Any) -> str:
        """Return the allowed values of a field in words, leaving out None."""
        words = {bool: "True or False", str: "a text", Path: "a path"}
        numbers = allowed_in_words(cls.bounds(name), float not in kinds, value)
        words |= dict.fromkeys((int, float), numbers)
        choices = [str(choice) for kind in kinds for choice in get_args(kind)]
        options = [f"one of {', '.join(choices)}"] if len(choices) > 1 else choices
        return " or ".join(dict.fromkeys([*(words[kind] for kind in kinds if kind in words), *options]))


def convert_to_kind(kind: Any, value: Any, bounds: Range) -> tuple[bool, Any]:
    """Return whether a value is of a kind and within bounds, and the value converted to a plain Python type."""
    if get_origin(kind) is Literal:
        return any(isinstance(value, type(choice)) and value == choice for choice in get_args(kind)), value
    if kind is bool:
        return isinstance(value, (bool, np.bool_)), bool(value) if isinstance(value, np.bool_) else value
    if kind in (int, float):
        fits = is_number(value, whole=kind is int) and bounds.holds(value)
        return fits, kind(value) if fits else value
    if kind is Path:
        return isinstance(value, (str, Path)), Path(value) if isinstance(value, str) else value
    return isinstance(value, kind), value


@cache
def kinds_of_fields(record: type) -> dict[str, tuple[Any, ...]]:
    """Return, for each field of a settings class that can be checked, its allowed kinds of values."""
    annotations: dict[str, Any] = {}
    for parent in reversed(record.__mro__):
        names = vars(sys.modules[parent.__module__])
        annotations |= {
            name: evaluate_annotation(kind, names) for name, kind in parent.__dict__.get("__annotations__", {}).items()
        }
    kinds_by_field = {field.name: union_members(annotations[field.name]) for field in fields(record)}
    return {name: kinds for name, kinds in kinds_by_field.items() if all(map(can_be_checked, kinds))}


def evaluate_annotation(annotation: Any, names: dict[str, Any]) -> Any:
    """Return the type that an annotation names; Any if only type checkers import that type."""
    try:
        return eval(annotation, names) if isinstance(annotation, str) else annotation
    except NameError:
        return Any


def union_members(kind: Any) -> tuple[Any, ...]:
    """Return the members of a union type; for any other type a tuple of that type alone."""
    if get_origin(kind) is Annotated:
        kind = get_args(kind)[0]
    return get_args(kind) if get_origin(kind) in (Union, UnionType) else (kind,)


def field_type_name(field: Field[Any]) -> str:
    """Return the name of a field's type, such as "float", from an annotation that is a string or a type."""
    return field.type if isinstance(field.type, str) else field.type.__name__


def can_be_checked(kind: Any) -> bool:
    """Tell whether values of a kind can be checked at run time."""
    return get_origin(kind) is Literal or kind in (bool, int, float, str, Path, NoneType)
