"""The decorators that compile the stages of a match.

They turn plain Python over record fields into machine code that runs without the interpreter lock. A function is
compiled at its first call, and its machine code is kept on disk (`compiling/`).

Environment variables: `SOCCER_ENV_CACHE` (folder of the cache), `SOCCER_ENV_QUIET=1` (say nothing while compiling),
`NUMBA_DISABLE_JIT=1` (run everything as ordinary Python, for a debugger or for coverage).

Constants that a function reads from its module must follow from source code alone: a value from a data file or from
the environment would be frozen into the machine code on disk.
"""

import functools
import os
import threading
from collections.abc import Callable
from typing import Any, TypeVar, cast

import numba
import numpy as np
from numba.extending import overload

from soccer_env.compiling.cache import SourceCache
from soccer_env.compiling.inner import Kernel, KernelCompiler

F = TypeVar("F", bound=Callable[..., Any])

config: Any = numba.config
OPTIONS = {"nopython": True, "nogil": True, "error_model": "numpy", "fastmath": False, "boundscheck": False}


def compiled(function: F) -> F:
    """Compile `function` for the types of its arguments, at its first call, and cache the result on disk.

    With NUMBA_DISABLE_JIT=1 the function stays Python, and gets structured arrays as recarrays. A function without a
    file (typed into an interpreter or a notebook) is compiled but not cached.
    """
    if config.DISABLE_JIT:
        return cast(F, _as_python(function))
    dispatcher: Any = Kernel(
        function, targetoptions={**OPTIONS, "no_cfunc_wrapper": True}, pipeline_class=KernelCompiler
    )
    if os.path.isfile(function.__code__.co_filename):
        dispatcher._cache = SourceCache(function)  # what Dispatcher.enable_caching does with numba's own
    return cast(F, dispatcher)


def inlined(function: F) -> F:
    """Compile `function` as `compiled` does, and inline it in its compiled callers.

    For a short function, or one with a single caller: passing an array copies at least seven numbers.
    """
    made: Any = compiled(function)
    if not config.DISABLE_JIT:
        made.targetoptions["forceinline"] = True
    return cast(F, made)


def scratch_records(count: int, dtype: Any) -> Any:
    """Return `count` zeroed scratch records for compiled functions; their fields are attributes in plain Python too."""
    return np.zeros(count, dtype).view(np.recarray)


@overload(scratch_records)
def _compiled_scratch_records(count, dtype):  # type: ignore[no-untyped-def]  # numba compares the signatures
    return lambda count, dtype: np.zeros(count, dtype)


class _Depth(threading.local):
    """The number of compiled functions on this thread's stack."""

    value = 0


_depth = _Depth()


def _as_python(function: Callable[..., Any]) -> Callable[..., Any]:
    """Wrap `function` so that records have attributes and integers overflow silently, as in compiled code."""

    @functools.wraps(function)
    def call(*arguments: Any, **named: Any) -> Any:
        if _depth.value:  # converted by the outermost call: parts of a recarray are recarrays and records
            return function(*arguments, **named)
        _depth.value += 1
        try:
            with np.errstate(all="ignore"):
                return function(
                    *map(view_with_attributes, arguments), **{k: view_with_attributes(v) for k, v in named.items()}
                )
        finally:
            _depth.value -= 1

    call.py_func = function  # type: ignore[attr-defined]  # the name that numba gives it
    return call


def view_with_attributes(value: Any) -> Any:
    """Return a structured array or record as a view whose fields are attributes, any other value unchanged."""
    if isinstance(value, np.ndarray):
        is_plain = value.dtype.names is not None and not isinstance(value, np.recarray)
        return value.view(np.recarray) if is_plain else value
    if isinstance(value, np.void):
        is_plain = value.dtype.names is not None and not isinstance(value, np.record)
        return value.view((np.record, value.dtype)) if is_plain else value
    if isinstance(value, tuple):
        parts = [view_with_attributes(part) for part in value]
        return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
    return value
