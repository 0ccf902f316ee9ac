"""Observations written by users: any shape, any bounds, dicts, and different observations for the two teams.

form     Part, or a dict of forms: the observation of one robot
Sides    the observations of home and of away
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.guards.checking import check_names, raise_not_allowed, short_repr

BUILT_IN = ("truth", "percepts", "belief")
OBJECTS = (
    "an object with `names`, `entries` or `space` to call with a match, such as WholeTruth(), "
    "or {'home': ..., 'away': ...}"
)
WHAT = f"a name, {OBJECTS}"


@dataclass(frozen=True)
class SideObservations:
    """The kinds of observation of home and of away: built-in names, or a user's own objects."""

    home: Any
    away: Any


@dataclass(frozen=True)
class ArrayForm:
    """The shape, bounds and dtype of an array in a robot's observation."""

    shape: tuple[int, ...]
    low: np.ndarray
    high: np.ndarray
    dtype: np.dtype

    def limits(self, at: tuple[int, ...]) -> str:
        """Return in words the allowed range of the number at an index."""
        low, high = (np.broadcast_to(bound, self.shape)[at] for bound in (self.low, self.high))
        return f"numbers in [{low:g}, {high:g}]" if np.isfinite([low, high]).any() else "finite numbers"


Form = ArrayForm | dict[str, Any]  # whose values are forms


def check_observe(observe: Any) -> Any:
    """Return the argument `observe`, checked; a mapping becomes SideObservations, anything wrong a ValueError."""
    if isinstance(observe, Mapping):
        check_names("side of observe", observe, ("home", "away"))
        home, away = (check_observe(observe.get(side, "truth")) for side in ("home", "away"))
        if isinstance(home, SideObservations) or isinstance(away, SideObservations):
            raise_not_allowed("observe", WHAT, observe)
        return home if isinstance(home, str) and home == away else SideObservations(home, away)
    if isinstance(observe, (str, SideObservations)):
        if isinstance(observe, str) and observe not in BUILT_IN:
            raise_not_allowed("observe", f"one of {', '.join(BUILT_IN)}, {OBJECTS}", observe)
        return observe
    if not callable(observe) or not any(hasattr(observe, name) for name in ("names", "entries", "space")):
        raise_not_allowed("observe", WHAT, observe)
    if hasattr(observe, "space"):
        form_of_space(observe.space, "space of observe")
    return observe


def observation_form(observe: Any, numbers: int) -> Form:
    """Return the form of one robot's observation: that of a user's `space`, else a vector of `numbers` entries."""
    if not isinstance(observe, str) and hasattr(observe, "space"):
        return form_of_space(observe.space, "space of observe")
    low, high = (np.asarray(getattr(observe, name, usual), float) for name, usual in (("low", -1.0), ("high", 1.0)))
    for name, bound in (("low", low), ("high", high)):
        if bound.shape not in ((), (numbers,)) or np.isnan(bound).any():
            raise ValueError(
                f"{name} of observe must be a number or {numbers} of them, got {short_repr(bound.tolist())}"
            )
    if not (low < high).all():
        raise ValueError(
            f"low of observe must be below high, got {short_repr(low.tolist())} and {short_repr(high.tolist())}"
        )
    return ArrayForm((numbers,), low, high, np.dtype(np.float32))


def form_of_space(space: Any, what: str) -> Form:
    """Return the form of a gymnasium space; ValueError unless it is a Box or a Dict of Boxes."""
    if isinstance(getattr(space, "spaces", None), Mapping) and space.spaces:
        return {name: form_of_space(part, f"{what}[{name!r}]") for name, part in space.spaces.items()}
    if not all(hasattr(space, name) for name in ("low", "high", "shape", "dtype")):
        raise_not_allowed(what, "a gymnasium Box, or a Dict of them", space)
    return ArrayForm(tuple(space.shape), np.asarray(space.low), np.asarray(space.high), np.dtype(space.dtype))


def space_from_form(form: Form) -> Any:
    """Return a new gymnasium space for one robot's observation."""
    from gymnasium import spaces

    if isinstance(form, dict):
        return spaces.Dict({name: space_from_form(part) for name, part in form.items()})
    low, high = (np.broadcast_to(bound, form.shape).astype(form.dtype) for bound in (form.low, form.high))
    return spaces.Box(low, high, form.shape, form.dtype.type)


def form_size(form: Form) -> int:
    """Return how many numbers one robot observes."""
    return sum(map(form_size, form.values())) if isinstance(form, dict) else math.prod(form.shape)


def zero_observations(form: Form, matches: int, robots: int) -> Any:
    """Return observations of M matches, all zero: an array (M, R, ...) or a dict of such arrays."""
    if isinstance(form, dict):
        return {name: zero_observations(part, matches, robots) for name, part in form.items()}
    return np.zeros((matches, robots, *form.shape), form.dtype)


def index_arrays(seen: Any, at: Any) -> Any:
    """Index an array, or each array of a dict, with the index `at`."""
    return {name: index_arrays(part, at) for name, part in seen.items()} if isinstance(seen, dict) else seen[at]


def copy_arrays(seen: Any) -> Any:
    """Return a copy of an array, or of each array of a dict."""
    return {name: copy_arrays(part) for name, part in seen.items()} if isinstance(seen, dict) else seen.copy()


def fill(form: Form, into: Any, values: Any, what: str, agents: list[str], rows: slice) -> None:
    """Copy a user's `values` for the robots `rows` into the arrays `into`; ValueError names the robot and the value."""
    if isinstance(form, dict):
        if not isinstance(values, Mapping) or set(values) != set(form):
            got = f"the keys {', '.join(map(str, values))}" if isinstance(values, Mapping) else short_repr(values)
            raise ValueError(f"{what} must return a dict with the keys {', '.join(form)}, got {got}")
        for name, part in form.items():
            fill(part, into[name], values[name], f"{what}[{name!r}]", agents, rows)
        return
    numbers = convert_to_numbers(values, into.shape, what, agents)[:, rows]
    check_bounds(form, numbers, what, agents[rows])
    into[:, rows] = numbers


def check_bounds(part: ArrayForm, numbers: np.ndarray, what: str, agents: list[str]) -> None:
    """Raise ValueError for the first number (M, R, ...) that is not finite or out of bounds."""
    wrong = ~((numbers >= part.low) & (numbers <= part.high) & np.isfinite(numbers))
    if wrong.any():
        at = tuple(int(i) for i in np.argwhere(wrong)[0])
        got = f"{numbers[at]} at {at}: {agents[at[1]]} of match {at[0]}"
        raise ValueError(f"{what} must return {part.limits(at[2:])}, got {got}")


def convert_to_numbers(values: Any, shape: tuple[int, ...], what: str, agents: list[str]) -> np.ndarray:
    """Convert values to an array of `shape` (M, R, ...); a single number fills it; ValueError names the robots."""
    try:
        numbers = np.asarray(values)
    except ValueError:
        numbers = np.asarray(None)
    if numbers.dtype.kind not in "fiub" or numbers.shape not in ((), shape):
        got = f"shape {numbers.shape}" if numbers.dtype.kind in "fiub" else short_repr(values)
        raise ValueError(f"{what} must return numbers of shape {shape}, got {got}; by match and by {', '.join(agents)}")
    return np.broadcast_to(numbers, shape)
