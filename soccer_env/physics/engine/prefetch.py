"""Fetch the memory of a Space's next step into the processor's cache, while the match before it is stepped.

A control step of 3 v 3 touches 250 to 400 cache lines of a Space, scattered over 360 KiB, and Chipmunk follows pointers
from one line to the next. In a batch of some hundred matches a Space has left the cache when its turn comes again, and
waiting for one line after the other takes longer than the physics. So each match keeps a list of the spans of memory
that its steps touch, and all spans are requested at once, ahead of the match's turn.

Fetching is a hint to the processor: it changes no number, and an outdated span only costs time. Spans are noted after
control steps 1, 2, 4, 8, ... of a Space, whose memory grows but does not move.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from soccer_env.compiled import compiled, config
from soccer_env.compiling.numba_parts import cgutils
from soccer_env.physics.engine import pools
from soccer_env.physics.engine.memory import MOTOR_RATE, address_at, count_at, record_reader
from soccer_env.physics.solver.records import SOLVER, STANCE

LINE = 64  # [B] a cache line
MOST_SPANS = 254  # of a match: enough for 11 v 11; further spans are dropped

SPAN = np.dtype([("at", "i8"), ("lines", "i8")])  # address, a multiple of LINE; number of cache lines
SPANS = np.dtype([("steps", "i8"), ("count", "i8"), ("span", SPAN, (MOST_SPANS,))])  # control steps, spans in use
spans_at: Any = record_reader(SPANS)

SOLVER_SIZE, STANCE_SIZE = SOLVER.itemsize, STANCE.itemsize
SOLVER_STANCES = int(SOLVER.fields["stances"][1])  # type: ignore[index]
FEWEST_MATCHES = 96  # of a batch that gains by fetching; the Spaces of fewer stay in the cache, measured
USUAL_ARBITERS = 8  # in use at the same time in 3 v 3


def _prefetch(typing_context: Any, address: Any) -> Any:
    def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        place = builder.inttoptr(arguments[0], cgutils.voidptr_t)
        number = ir.IntType(32)
        kind = ir.FunctionType(ir.VoidType(), [place.type, number, number, number])
        function = cgutils.get_or_insert_function(builder.module, kind, "llvm.prefetch.p0")
        builder.call(function, [place, number(0), number(2), number(1)])  # read, second-level cache, data
        return context.get_dummy_value()

    return types.void(types.uintp), build


_fetch_line: Any = (lambda address: None) if config.DISABLE_JIT else intrinsic(_prefetch)


@compiled
def prefetch_spans(spans):
    """Fetch all spans of a match into the cache."""
    for i in range(spans.count):
        at = spans.span[i].at
        for line in range(spans.span[i].lines):
            _fetch_line(at + LINE * line)


@compiled
def prefetch_row(array, m, size):
    """Fetch the first `size` bytes of row m of an array into the cache."""
    at = np.int64(array.ctypes.data) + m * array.strides[0]
    for byte in range(0, size, LINE):
        _fetch_line(at + byte)


@compiled
def signed_pointer(at):
    """Return the pointer at an address as a signed number: numba adds unsigned and signed numbers as floats."""
    return np.int64(address_at(at))


@compiled
def count_space_step(spans, space):
    """Count a control step of a Space, and after step 1, 2, 4, 8, ... rebuild the list of its spans."""
    spans.steps += 1
    if spans.steps & (spans.steps - 1) == 0:
        list_space_spans(spans, space)


@compiled
def list_space_spans(spans, space):
    """List the spans of memory that the steps of a Space touch."""
    spans.count = 0
    add_span(spans, space, pools.SPACE_SIZE)
    add_item_spans(spans, signed_pointer(space + pools.SPACE_BODIES), pools.BODY_SIZE)
    add_solver_spans(
        spans, signed_pointer(space + pools.SPACE_CONSTRAINTS), count_at(signed_pointer(space + pools.SPACE_BODIES)) - 1
    )
    shapes = add_shape_spans(spans, signed_pointer(space + pools.SPACE_DYNAMIC))
    add_node_spans(spans, signed_pointer(space + pools.SPACE_DYNAMIC), shapes)
    static = signed_pointer(space + pools.SPACE_STATIC)
    add_node_spans(spans, static, count_at(signed_pointer(static + pools.TREE_LEAVES)))
    add_contact_spans(spans, signed_pointer(space + pools.SPACE_CONTACTS))
    add_item_spans(spans, signed_pointer(space + pools.SPACE_ARBITERS), pools.ARBITER_SIZE)
    add_hash_set_spans(spans, signed_pointer(space + pools.SPACE_CACHED), USUAL_ARBITERS)
    add_free_arbiter_spans(spans, signed_pointer(space + pools.SPACE_POOLED))


@compiled
def add_solver_spans(spans, constraints, robots):
    """Add the constraint of our part of the solver, if there is one, and its SOLVER and STANCE records to the spans."""
    add_item_spans(spans, constraints, pools.CONSTRAINT_SIZE)
    if count_at(constraints) == 1:
        constraint = signed_pointer(signed_pointer(constraints + pools.ARRAY_ITEMS))
        solver = signed_pointer(constraint + MOTOR_RATE)
        add_span(spans, solver, SOLVER_SIZE)
        add_span(spans, signed_pointer(solver + SOLVER_STANCES), robots * STANCE_SIZE)


@compiled
def add_span(spans, at, size):
    """Add `size` bytes at an address to the last span if they adjoin it, else as a new span."""
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
def add_item_spans(spans, array, size):
    """Add a cpArray of addresses, and `size` bytes at each address, to the spans."""
    items, count = signed_pointer(array + pools.ARRAY_ITEMS), count_at(array)
    add_span(spans, array, pools.ARRAY_SIZE)
    add_span(spans, items, max(8 * count, 8))
    for i in range(count):
        add_span(spans, signed_pointer(items + 8 * i), size)


@compiled
def add_shape_spans(spans, tree):
    """Add the shapes of a tree, and the hash set of its leaves, to the spans; return the number of shapes."""
    leaves = signed_pointer(tree + pools.TREE_LEAVES)
    table, count = signed_pointer(leaves + pools.SET_TABLE), 0
    for i in range(count_at(leaves + pools.SET_ROOM)):
        place = signed_pointer(table + 8 * i)
        while place != 0:
            shape = signed_pointer(signed_pointer(place))
            kind = count_at(signed_pointer(shape))
            add_span(spans, shape, pools.SHAPE_SIZES[kind])
            if kind == pools.POLYGON:
                add_span(
                    spans,
                    signed_pointer(shape + pools.POLYGON_PLANES),
                    2 * pools.PLANE_SIZE * count_at(shape + pools.POLYGON_COUNT),
                )
            count += 1
            place = signed_pointer(place + pools.BIN_NEXT)
    add_hash_set_spans(spans, leaves, count)
    return count


@compiled
def add_node_spans(spans, tree, leaves):
    """Add a tree with its nodes (its first pool) and its pairs of neighbours (the other pools) to the spans."""
    add_span(spans, tree, pools.TREE_SIZE)
    buffers = signed_pointer(tree + pools.TREE_BUFFERS)
    for i in range(count_at(buffers)):
        used = 2 * leaves if i == 0 else leaves
        add_pool_spans(
            spans, signed_pointer(signed_pointer(buffers + pools.ARRAY_ITEMS) + 8 * i), used * pools.NODE_SIZE
        )


@compiled
def add_hash_set_spans(spans, hash_set, items):
    """Add the memory of a hash set, and of the bins of `items` items, to the spans that are prefetched."""
    add_span(spans, hash_set, pools.SET_SIZE)
    add_span(spans, signed_pointer(hash_set + pools.SET_TABLE), 8 * count_at(hash_set + pools.SET_ROOM))
    buffers = signed_pointer(hash_set + pools.SET_BUFFERS)
    for i in range(count_at(buffers)):
        add_pool_spans(
            spans, signed_pointer(signed_pointer(buffers + pools.ARRAY_ITEMS) + 8 * i), items * pools.BIN_SIZE
        )


@compiled
def add_pool_spans(spans, buffer, used):
    """Add the head of a pool's buffer, and the last `used` bytes of the buffer, to the spans."""
    add_span(spans, buffer, LINE)
    add_span(spans, buffer + pools.BUFFER_SIZE - used, used)


@compiled
def add_contact_spans(spans, newest):
    """Add the heads of the buffers of contacts, which Chipmunk uses in turn, to the spans."""
    place = newest
    while place != 0:
        add_span(spans, place, pools.CONTACTS_SIZE)
        place = signed_pointer(place + pools.CONTACTS_NEXT)
        if place == newest:
            break


@compiled
def add_free_arbiter_spans(spans, array):
    """Add the free arbiters that Chipmunk takes next, and the top of the stack of their addresses, to the spans.
    The lowest address on the stack is that of the arbiters' buffer.
    """
    items, count = signed_pointer(array + pools.ARRAY_ITEMS), count_at(array)
    add_span(spans, array, pools.ARRAY_SIZE)
    if count > USUAL_ARBITERS:
        add_span(spans, items + 8 * (count - USUAL_ARBITERS), 8 * USUAL_ARBITERS)
        used = USUAL_ARBITERS * pools.ARBITER_SIZE
        add_span(spans, signed_pointer(items) + pools.BUFFER_SIZE - used, used)


# For the class that owns the Spaces


def is_prefetch_useful(matches: int) -> bool:
    """Tell whether a batch of `matches` matches gains from prefetching, and this pymunk has the expected structs."""
    return matches >= FEWEST_MATCHES and pools.layout_fits()
