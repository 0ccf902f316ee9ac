"""Attention over other players, before the layers of policies of kind "attention".

    q      = Q fixed                                 (width,)  fixed: the entries that belong to no slot
    e_s    = activation(W slot_s + b)                (width,)  of each slot s in use; all slots share W and b
    a_s    = exp(q . e_s) / sum_s exp(q . e_s)                 [Vaswani et al. 2017, 3.2.1]
    pooled = sum_s a_s e_s                           (width,)  zeros if no slot is in use

Team-mates have one Q, W and b, opponents another; both pooled vectors follow the fixed entries in the input of the
first layer. So the order of slots does not matter, nor do the entries of empty slots. Unlike the paper there is one
head and no division by sqrt(width): Q learns its own scale.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import exp, tanh

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.observations.entry import OPPONENT, TEAMMATE, Entry

PLAYERS = (TEAMMATE, OPPONENT)  # groups of entries
TENSORS = tuple(f"{kind}.{part}" for kind in PLAYERS for part in ("weight", "bias", "query"))  # W, b, Q
NARROWEST = 8  # least width, beside a small hidden layer
SHARE = 4  # [1] how many times as wide the first hidden layer is
FIXED = 0  # places in the shape; slots and entries have two numbers each, one for each kind of player
WIDTH = 1
SLOTS = 2
ENTRIES = 4
SHAPE = 6  # numbers of the shape
MAX_UNITS = 1024
MAX_ACTIVITY = 1e37  # largest value of a unit; float32 ends at 3.4e38


@dataclass(frozen=True)
class Layout:
    """The number of entries in each part of an observation; slots of other players come last, team-mates first."""

    fixed: int  # entries that belong to no slot
    slots: tuple[int, int]  # of team-mates and opponents
    entries: tuple[int, int]  # of a slot of each

    def shapes(self, width: int) -> tuple[tuple[int, ...], ...]:
        """Return the shape of each attention tensor (TENSORS) for attention of this width."""
        return tuple(shape for size in self.entries for shape in ((width, size), (width,), (width, self.fixed)))

    def features(self, width: int) -> int:
        """Return the number of inputs to the first layer after attention of this width."""
        return self.fixed + len(PLAYERS) * width


def layout_of(inputs: Sequence[Entry]) -> Layout:
    """Return the layout of an observation; ValueError unless it ends in slots for team-mates, then for opponents.

    The slots of a kind are alike, and each begins with the entry that says whether it is in use.
    """
    fixed = sum(entry.group not in PLAYERS for entry in inputs)
    slots, sizes = [], []
    rest: list[tuple[str, int, Entry]] = []
    for kind in PLAYERS:
        own = [entry for entry in inputs if entry.group == kind]
        first = [_without_name_and_slot(entry) for entry in own if entry.slot == 0]
        slots.append(len({entry.slot for entry in own}))
        sizes.append(len(first))
        if first and first[0].present and len(own) == slots[-1] * len(first):
            rest += [(kind, slot, entry) for slot in range(slots[-1]) for entry in first]
    if (
        not fixed
        or not all(slots)
        or [(entry.group, entry.slot, _without_name_and_slot(entry)) for entry in inputs[fixed:]] != rest
    ):
        raise ValueError(
            "kind 'attention' needs inputs that end in slots for other players, of group 'teammate', then 'opponent', "
            "each beginning with its `present` entry, as observations of truth and belief do"
        )
    return Layout(fixed, (slots[0], slots[1]), (sizes[0], sizes[1]))


def _without_name_and_slot(entry: Entry) -> Entry:
    """Return an entry without its name and slot, so that the same entry of all slots compares equal."""
    return replace(entry, name="", slot=None)


def attention_width(hidden: Sequence[int]) -> int:
    """Return the width of attention in a network with these hidden layers."""
    return max(NARROWEST, hidden[0] // SHARE)


def shape_numbers(layout: Layout, width: int) -> tuple[int, ...]:
    """Return the SHAPE numbers that tell `attend` the layout of observations and the width of attention."""
    return (layout.fixed, width, *layout.slots, *layout.entries)


def flatten_tensors(tensors: Sequence[np.ndarray]) -> list[np.ndarray]:
    """Return the attention tensors in the order that `attend` reads: column by column, team-mates first."""
    parts: list[np.ndarray] = []
    for first in range(0, len(tensors), 3):
        weight, bias, query = tensors[first : first + 3]
        parts += [query.T.ravel(), weight.T.ravel(), bias]
    return [part.astype(np.float64) for part in parts]


def check_array(what: str, array: object) -> None:
    """Raise ValueError unless `array` is an array of float32."""
    if not isinstance(array, np.ndarray) or array.dtype != np.float32:
        kind = array.dtype if isinstance(array, np.ndarray) else type(array).__name__
        raise ValueError(f"{what} must be an array of float32, got {kind}")


def check_tensors(names: Sequence[str], arrays: Sequence[np.ndarray], shapes: Sequence[tuple[int, ...]]) -> None:
    """Raise ValueError unless all arrays are finite and of the given shapes."""
    for name, array, shape in zip(names, arrays, shapes, strict=True):
        if array.shape != shape:
            raise ValueError(f"{name} must have the shape {shape}, got {array.shape}")
        if not np.isfinite(array).all():
            raise ValueError(f"{name} must be finite, it holds NaN or infinity")


def check_below_limit(what: str, reached: float) -> None:
    """Raise ValueError unless the largest value that units can reach stays below the limit."""
    if not reached < MAX_ACTIVITY:
        raise ValueError(f"{what} must stay below {MAX_ACTIVITY:g}, its units could reach {reached:g}")


def check_attention(kind: str, attention: object, inputs: Sequence[Entry]) -> int:
    """Return the number of inputs to the first layer; ValueError unless attention fits kind and inputs."""
    if not isinstance(attention, tuple) or len(attention) != (len(TENSORS) if kind == "attention" else 0):
        size = f"{len(attention)} arrays" if isinstance(attention, tuple) else type(attention).__name__
        wanted = f"of {', '.join(TENSORS)}" if kind == "attention" else "without arrays"
        raise ValueError(f"attention of kind {kind!r} must be a tuple {wanted}, got {size}")
    if kind == "slots":
        return len(inputs)
    layout = layout_of(inputs)
    for name, array in zip(TENSORS, attention, strict=True):
        check_array(name, array)
    width = len(attention[1]) if attention[1].ndim == 1 else 0
    if not 1 <= width <= MAX_UNITS:
        raise ValueError(f"{TENSORS[1]} must have the shape (1 to {MAX_UNITS},), got {attention[1].shape}")
    check_tensors(TENSORS, attention, layout.shapes(width))
    return layout.features(width)


def check_attention_overflow(attention: tuple[np.ndarray, ...], activation: str, entering: float) -> float:
    """Return the largest possible input to the first layer; ValueError if attention could overflow."""
    largest = entering
    for first in range(0, len(attention), 3):
        weight, bias, query = (np.abs(array.astype(np.float64)) for array in attention[first : first + 3])
        encoded = weight.sum(axis=1) * entering + bias
        bounded = np.minimum(encoded, 1.0) if activation == "tanh" else encoded
        for name, reached in (
            (TENSORS[first], encoded.max()),
            (TENSORS[first + 2], query.sum(axis=1) @ bounded * entering),
        ):
            check_below_limit(name, reached)
        largest = max(largest, float(bounded.max()))
    return largest


@compiled
def observation_size(numbers, shape):
    """Return the number of entries of an observation; its layout's numbers begin at index `shape`."""
    count = numbers[shape + FIXED]
    for kind in range(2):
        count += numbers[shape + SLOTS + kind] * numbers[shape + ENTRIES + kind]
    return int(count)


@compiled
def attend(numbers, shape, start, smooth, scratch):
    """Append both pooled vectors to the fixed entries in scratch[2]; return the next unread index of `numbers`.

    scratch[0] and scratch[1] are working space; `smooth` is True for tanh.
    """
    fixed, width = int(numbers[shape + FIXED]), int(numbers[shape + WIDTH])
    at, first = start, fixed
    for kind in range(2):
        slots, entries = int(numbers[shape + SLOTS + kind]), int(numbers[shape + ENTRIES + kind])
        write_query(numbers, at, fixed, width, scratch)
        at += fixed * width
        pool_players(numbers, at, first, slots, entries, width, kind * width, smooth, scratch)
        at += (entries + 1) * width
        first += slots * entries
    for j in range(2 * width):
        scratch[2, fixed + j] = scratch[1, j]
    return at


@compiled
def write_query(numbers, at, fixed, width, scratch):
    """Write the query q = Q fixed into scratch[0]."""
    for j in range(width):
        scratch[0, j] = 0.0
    for i in range(fixed):
        value = scratch[2, i]
        for j in range(width):
            scratch[0, j] += value * numbers[at + i * width + j]


@compiled
def pool_players(numbers, at, first, slots, entries, width, to, smooth, scratch):
    """Write the pooled vector of team-mates or of opponents into scratch[1], starting at index `to`.

    The weights are relative to the largest so far, so that no exponential overflows.
    """
    top, total = 0.0, 0.0
    for j in range(width):
        scratch[1, to + j] = 0.0
    for slot in range(first, first + slots * entries, entries):
        if scratch[2, slot] > 0.0:
            encode(numbers, at, slot, entries, width, smooth, scratch)
            alike = 0.0
            for j in range(width):
                alike += scratch[0, j] * scratch[0, width + j]
            kept = exp(min(top - alike, 0.0)) if total > 0.0 else 0.0
            top = max(top, alike) if total > 0.0 else alike
            weight = exp(alike - top)
            total = kept * total + weight
            for j in range(width):
                scratch[1, to + j] = kept * scratch[1, to + j] + weight * scratch[0, width + j]
    if total > 0.0:
        for j in range(width):
            scratch[1, to + j] /= total


@compiled
def encode(numbers, at, slot, entries, width, smooth, scratch):
    """Write the encoding e of one slot into scratch[0], after the query q."""
    bias = at + entries * width
    for j in range(width):
        scratch[0, width + j] = numbers[bias + j]
    for i in range(entries):
        value = scratch[2, slot + i]
        for j in range(width):
            scratch[0, width + j] += value * numbers[at + i * width + j]
    for j in range(width):
        scratch[0, width + j] = tanh(scratch[0, width + j]) if smooth else max(scratch[0, width + j], 0.0)
