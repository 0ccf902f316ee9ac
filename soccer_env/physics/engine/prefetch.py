"""Fetch what a Space's next step touches into the processor's cache, while the match before it is played.

A control step of 3 v 3 touches 250 to 400 cache lines of a Space, scattered over 360 KiB, and Chipmunk finds each by an
address in another. In a batch of some hundred matches none of them is still in the cache when a match's turn comes
again, and to wait for one after the other takes longer than the physics itself. So each match keeps a list of spans of
memory that its steps touch, and all of them are asked for at once, ahead of its turn.

Fetching is a hint to the processor: it changes no number, and a span that is out of date costs time and nothing else.
Spans are noted after control steps 1, 2, 4, 8, ... of a Space: its memory grows, and stays where it is.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from soccer_env.compiled import compiled, config
from soccer_env.compiling.numba_parts import cgutils
from soccer_env.physics.engine.memory import MOTOR_RATE, address_at, count_at, record_reader
from soccer_env.physics.engine.pools import (
    ARBITER_SIZE,
    ARRAY_ITEMS,
    ARRAY_SIZE,
    BIN_NEXT,
    BIN_SIZE,
    BODY_SIZE,
    BUFFER_SIZE,
    CONSTRAINT_SIZE,
    CONTACTS_NEXT,
    CONTACTS_SIZE,
    NODE_SIZE,
    PLANE_SIZE,
    POLYGON,
    POLYGON_COUNT,
    POLYGON_PLANES,
    SET_BUFFERS,
    SET_ROOM,
    SET_SIZE,
    SET_TABLE,
    SHAPE_SIZES,
    SPACE_ARBITERS,
    SPACE_BODIES,
    SPACE_CACHED,
    SPACE_CONSTRAINTS,
    SPACE_CONTACTS,
    SPACE_DYNAMIC,
    SPACE_POOLED,
    SPACE_SIZE,
    SPACE_STATIC,
    TREE_BUFFERS,
    TREE_LEAVES,
    TREE_SIZE,
    layout_fits,
)
from soccer_env.physics.solver.records import SOLVER, STANCE

LINE = 64  # [B] a cache line
MOST_SPANS = 254  # of a match; enough for 11 v 11, and more would not be noted

SPAN = np.dtype(
    [
        ("at", "i8"),  # address, a multiple of LINE
        ("lines", "i8"),  # how many
    ]
)
SPANS = np.dtype(
    [
        ("steps", "i8"),  # control steps of this Space
        ("count", "i8"),  # spans that are noted
        ("span", SPAN, (MOST_SPANS,)),
    ]
)
spans_at: Any = record_reader(SPANS)

SOLVER_SIZE, STANCE_SIZE = SOLVER.itemsize, STANCE.itemsize
SOLVER_STANCES = int(SOLVER.fields["stances"][1])  # type: ignore[index]
FEWEST_MATCHES = 96  # of a batch that gains by it; the Spaces of fewer stay in the cache by themselves, measured
USUAL_ARBITERS = 8  # in use at the same time, of 3 v 3


def _prefetch(typing_context: Any, address: Any) -> Any:
    def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        place = builder.inttoptr(arguments[0], cgutils.voidptr_t)
        number = ir.IntType(32)
        kind = ir.FunctionType(ir.VoidType(), [place.type, number, number, number])
        function = cgutils.get_or_insert_function(builder.module, kind, "llvm.prefetch.p0")
        builder.call(
            function, [place, number(0), number(2), number(1)]
        )  # for reading, into the second-level cache, data
        return context.get_dummy_value()

    return types.void(types.uintp), build


_fetch_line: Any = (lambda address: None) if config.DISABLE_JIT else intrinsic(_prefetch)


@compiled
def fetch_spans(spans):
    """Fetch all spans of a match into the cache."""
    for i in range(spans.count):
        at = spans.span[i].at
        for line in range(spans.span[i].lines):
            _fetch_line(at + LINE * line)


@compiled
def fetch_row(array, m, size):
    """Fetch so many bytes [1] of row m of an array into the cache, from its start."""
    at = np.int64(array.ctypes.data) + m * array.strides[0]
    for byte in range(0, size, LINE):
        _fetch_line(at + byte)


@compiled
def pointer(at):
    """Return the address that lies at an address, as a signed number: sums of unsigned and signed ones are floats."""
    return np.int64(address_at(at))


@compiled
def note_step(spans, space):
    """Count a control step of a Space, and note anew what it touches if it is step 1, 2, 4, 8, ..."""
    spans.steps += 1
    if spans.steps & (spans.steps - 1) == 0:
        note_space(spans, space)


@compiled
def note_space(spans, space):
    """Note what a Space's steps touch."""
    spans.count = 0
    add(spans, space, SPACE_SIZE)
    note_items(spans, pointer(space + SPACE_BODIES), BODY_SIZE)
    note_solver(spans, pointer(space + SPACE_CONSTRAINTS), count_at(pointer(space + SPACE_BODIES)) - 1)
    shapes = note_shapes(spans, pointer(space + SPACE_DYNAMIC))
    note_nodes(spans, pointer(space + SPACE_DYNAMIC), shapes)
    static = pointer(space + SPACE_STATIC)
    note_nodes(spans, static, count_at(pointer(static + TREE_LEAVES)))
    note_contacts(spans, pointer(space + SPACE_CONTACTS))
    note_items(spans, pointer(space + SPACE_ARBITERS), ARBITER_SIZE)
    note_set(spans, pointer(space + SPACE_CACHED), USUAL_ARBITERS)
    note_pooled(spans, pointer(space + SPACE_POOLED))


@compiled
def note_solver(spans, constraints, robots):
    """Note the constraint that is our part of the solver, if there is one, and the SOLVER record that it works on."""
    note_items(spans, constraints, CONSTRAINT_SIZE)
    if count_at(constraints) == 1:
        constraint = pointer(pointer(constraints + ARRAY_ITEMS))
        solver = pointer(constraint + MOTOR_RATE)
        add(spans, solver, SOLVER_SIZE)
        add(spans, pointer(solver + SOLVER_STANCES), robots * STANCE_SIZE)


@compiled
def add(spans, at, size):
    """Note `size` bytes from an address on: with the span before, if they go on where it ends, or one of their own."""
    if at == 0 or size <= 0:
        return
    first, end = at // LINE, (at + size - 1) // LINE + 1
    if spans.count > 0:
        span = spans.span[spans.count - 1]
        start = span.at // LINE
        if start <= first <= start + span.lines:
            span.lines = max(span.lines, end - start)
            return
    if spans.count < MOST_SPANS:
        span = spans.span[spans.count]
        span.at = first * LINE
        span.lines = end - first
        spans.count += 1


@compiled
def note_items(spans, array, size):
    """Note a cpArray of addresses, and the `size` bytes that each of them leads to."""
    items, count = pointer(array + ARRAY_ITEMS), count_at(array)
    add(spans, array, ARRAY_SIZE)
    add(spans, items, max(8 * count, 8))
    for i in range(count):
        add(spans, pointer(items + 8 * i), size)


@compiled
def note_shapes(spans, tree):
    """Note the shapes of a tree; return how many there are."""
    leaves = pointer(tree + TREE_LEAVES)
    table, found = pointer(leaves + SET_TABLE), 0
    for i in range(count_at(leaves + SET_ROOM)):
        place = pointer(table + 8 * i)
        while place != 0:
            shape = pointer(pointer(place))
            kind = count_at(pointer(shape))
            add(spans, shape, SHAPE_SIZES[kind])
            if kind == POLYGON:
                add(spans, pointer(shape + POLYGON_PLANES), 2 * PLANE_SIZE * count_at(shape + POLYGON_COUNT))
            found += 1
            place = pointer(place + BIN_NEXT)
    note_set(spans, leaves, found)
    return found


@compiled
def note_nodes(spans, tree, leaves):
    """Note the nodes of a tree, its first pool, and its pairs of neighbours, the others."""
    add(spans, tree, TREE_SIZE)
    buffers = pointer(tree + TREE_BUFFERS)
    for i in range(count_at(buffers)):
        used = 2 * leaves if i == 0 else leaves
        note_pool(spans, pointer(pointer(buffers + ARRAY_ITEMS) + 8 * i), used * NODE_SIZE)


@compiled
def note_set(spans, hash_set, items):
    """Note a hash set of a usual number of items."""
    add(spans, hash_set, SET_SIZE)
    add(spans, pointer(hash_set + SET_TABLE), 8 * count_at(hash_set + SET_ROOM))
    buffers = pointer(hash_set + SET_BUFFERS)
    for i in range(count_at(buffers)):
        note_pool(spans, pointer(pointer(buffers + ARRAY_ITEMS) + 8 * i), items * BIN_SIZE)


@compiled
def note_pool(spans, buffer, used):
    """Note the head of a pool's buffer, and so many bytes of its tail."""
    add(spans, buffer, LINE)
    add(spans, buffer + BUFFER_SIZE - used, used)


@compiled
def note_contacts(spans, newest):
    """Note the heads of the buffers of contacts, used in turn."""
    place = newest
    while place != 0:
        add(spans, place, CONTACTS_SIZE)
        place = pointer(place + CONTACTS_NEXT)
        if place == newest:
            break


@compiled
def note_pooled(spans, array):
    """Note the arbiters that are used next: the stack of their addresses, whose lowest is the buffer's own."""
    items, count = pointer(array + ARRAY_ITEMS), count_at(array)
    add(spans, array, ARRAY_SIZE)
    if count > USUAL_ARBITERS:
        add(spans, items + 8 * (count - USUAL_ARBITERS), 8 * USUAL_ARBITERS)
        used = USUAL_ARBITERS * ARBITER_SIZE
        add(spans, pointer(items) + BUFFER_SIZE - used, used)


# For the owner of the Spaces


def is_useful(matches: int) -> bool:
    """Say whether a batch of so many matches gains by it, and this pymunk is the one that this file is written for."""
    return matches >= FEWEST_MATCHES and layout_fits()
