"""Arrays without reference counts, for speed: numba does not count references to the arrays that a kernel borrows.

numba counts a reference for each array, and each view of a row, that is passed to a function that is not inlined: two
atomic additions a call, each as slow as ten plain ones. A step of a match makes hundreds of such calls, which took a
fifth of its time. A borrowed array has no owner, so nothing is counted, and another reference must keep it alive: the
caller of a kernel keeps the arguments, and `keep_alive` keeps an array that the kernel itself has made.
"""

from typing import Any

from numba import types
from numba.extending import intrinsic, overload

from soccer_env.compiled import compiled
from soccer_env.compiling.numba_parts import cgutils


def borrow_arrays(given):
    """Return an array, or a tuple of arrays and numbers, without reference counts; for compiled functions only."""
    return given


@compiled
def keep_alive(given):
    """Keep an array, or a tuple of arrays, alive up to this call, while the array is borrowed elsewhere."""


@overload(borrow_arrays)
def _compiled_borrow_arrays(given):
    return lambda given: _without_owner(given)


def _type_without_owner(typing_context, given):
    return given(given), _build_without_owner


def _build_without_owner(context, builder, signature, arguments):
    return _strip_owners(context, builder, signature.return_type, arguments[0])


def _strip_owners(context, builder, kind, value):
    """Return the LLVM value of a numba type without the owners of its arrays, so that no references are counted."""
    if isinstance(kind, types.BaseTuple):
        kinds: Any = kind  # mypy does not know that it can be gone through
        parts = zip(kinds, cgutils.unpack_tuple(builder, value, len(kind)), strict=True)
        stripped = [_strip_owners(context, builder, *part) for part in parts]
        return context.make_tuple(builder, kind, stripped)
    if not isinstance(kind, types.Array):
        return value
    array = context.make_array(kind)(context, builder, value)
    array.meminfo = cgutils.get_null_value(array.meminfo.type)
    array.parent = cgutils.get_null_value(array.parent.type)
    return array._getvalue()


_without_owner: Any = intrinsic(_type_without_owner)
