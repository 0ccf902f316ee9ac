"""Arrays that a kernel borrows: numba then counts no references to them.

An array of numba is counted wherever it is handed to a function that is not inlined, and so is
every view of a row: two atomic additions a call, each as long as ten others. A step of a match
makes hundreds of such calls; they took a fifth of its time. A borrowed array is the same one
without an owner, so that nothing is counted. Somebody else has to keep it: the caller of a kernel
keeps its arguments, and `keep` holds on to an array that the kernel itself has made.
"""

from typing import Any

from numba import types
from numba.extending import intrinsic, overload

from soccer_env.compiled import compiled
from soccer_env.compiling.numba_parts import cgutils


def borrowed(given):
    """Return an array, or a tuple of arrays and numbers, without owners, inside a compiled function."""
    return given


@compiled
def keep(given):
    """Keep an array, or a tuple of them, that was borrowed up to here."""


@overload(borrowed)
def _compiled_borrowed(given):
    return lambda given: _without_owner(given)


def _type_without_owner(typing_context, given):
    return given(given), _build_without_owner


def _build_without_owner(context, builder, signature, arguments):
    return _strip(context, builder, signature.return_type, arguments[0])


def _strip(context, builder, kind, value):
    """Return a value of a type with the owners of all arrays in it left out."""
    if isinstance(kind, types.BaseTuple):
        kinds: Any = kind  # mypy does not know that it can be gone through
        parts = zip(kinds, cgutils.unpack_tuple(builder, value, len(kind)), strict=True)
        stripped = [_strip(context, builder, *part) for part in parts]
        return context.make_tuple(builder, kind, stripped)
    if not isinstance(kind, types.Array):
        return value
    array = context.make_array(kind)(context, builder, value)
    array.meminfo = cgutils.get_null_value(array.meminfo.type)
    array.parent = cgutils.get_null_value(array.parent.type)
    return array._getvalue()


_without_owner: Any = intrinsic(_type_without_owner)
