"""Arrays that a kernel borrows are the same ones, and nobody counts references to them."""

from collections import namedtuple

import numpy as np
import pytest
from numba import types
from numba.core import cgutils
from numba.core.runtime import _nrt_python, rtsys
from numba.extending import intrinsic

from soccer_env.compiled import compiled, config
from soccer_env.compiling.borrowing import borrow_arrays, keep_alive

RECORD = np.dtype([("x", "f8"), ("n", "i8")])
Pair = namedtuple("Pair", ("records", "number"))

needs_compiler = pytest.mark.skipif(bool(config.DISABLE_JIT), reason="plain Python counts all references")


@compiled
def fill(given, add):
    """Write into records (M, R) and an array of a nested tuple, all borrowed."""
    pair, (numbers, _) = borrow_arrays(given)
    for m in range(pair.records.shape[0]):
        row = pair.records[m]
        for r in range(row.shape[0]):
            row[r].x += add + pair.number
    numbers[1:3] = pair.records.shape[1]


def test_what_is_written_to_a_borrowed_array_is_in_the_owners():
    records, numbers = np.zeros((3, 2), RECORD), np.zeros(4)
    fill((Pair(records[::2], 10), (numbers[::-1], 7.0)), 0.5)
    assert records["x"].tolist() == [[10.5, 10.5], [0.0, 0.0], [10.5, 10.5]]
    assert numbers.tolist() == [0.0, 2.0, 2.0, 0.0]


@compiled
def sum_of_own(count):
    """Return the sum of the squares below `count`, worked out in an array that the kernel makes and borrows."""
    own = np.empty(count), np.empty(1, np.int64)
    squares, _ = borrow_arrays(own)
    for i in range(count):
        squares[i] = i * i
    total = 0.0
    for i in range(count):
        total += squares[i]
    keep_alive(own)
    return total


@needs_compiler
def test_what_a_kernel_makes_and_borrows_is_freed_once():
    _nrt_python.memsys_enable_stats()
    try:
        sum_of_own(4)
        before = rtsys.get_allocation_stats()
        assert sum_of_own(1000) == 999 * 1000 * 1999 / 6
        after = rtsys.get_allocation_stats()
    finally:
        _nrt_python.memsys_disable_stats()
    assert after.alloc - before.alloc == after.free - before.free == 2


@intrinsic
def has_owner(typing_context, array):
    def build(context, builder, signature, arguments):
        return cgutils.is_not_null(builder, context.make_array(array)(context, builder, arguments[0]).meminfo)

    return types.boolean(array), build


@compiled
def has_owner_when_borrowed(records):
    """Tell of an array and of a row of it whether they have owners, first as it is given and then borrowed."""
    view = borrow_arrays(records)
    return has_owner(records), has_owner(records[0]), has_owner(view), has_owner(view[0])


@needs_compiler
def test_neither_a_borrowed_array_nor_a_row_of_it_is_counted():
    assert has_owner_when_borrowed(np.zeros((2, 3), RECORD)) == (True, True, False, False)
