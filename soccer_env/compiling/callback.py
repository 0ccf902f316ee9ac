"""Compiled callbacks: functions of this package that C code calls by address.

`@callback("void", "address", "float64")` compiles a function at its first use; C gets `function.address`. The function
runs without the interpreter lock, and must not raise, since no caller could catch the error.
"""

from __future__ import annotations

import ctypes
import functools
import threading
from collections.abc import Callable
from typing import Any

from numba import types

from soccer_env.compiled import compiled, config
from soccer_env.compiling.cache import SourceCache
from soccer_env.compiling.numba_parts import Callback as CFunc
from soccer_env.compiling.stops import stoppable
from soccer_env.guards.turns import with_signals_held

TYPES = {"void": types.void, "address": types.uintp, "float64": types.float64}
C_TYPES: dict[str, Any] = {"void": None, "address": ctypes.c_size_t, "float64": ctypes.c_double}
OPTIONS = {"error_model": "numpy", "fastmath": False, "boundscheck": False}

_lock = threading.Lock()


class Callback:
    """A function that C may call; `address` compiles it, or loads it from the cache on disk."""

    def __init__(self, function: Callable[..., Any], result: str, arguments: tuple[str, ...]) -> None:
        self._function, self._result, self._arguments = function, result, arguments
        self._made: Any = None
        functools.update_wrapper(self, function)

    def __call__(self, *arguments: Any) -> Any:
        """Call the function as plain Python does, for tests."""
        return compiled(self._function)(*arguments)

    @property
    @with_signals_held
    def address(self) -> int:
        """Return the address of the machine code, or with NUMBA_DISABLE_JIT=1 of a stub that calls Python."""
        with stoppable(), _lock:
            return self._address

    @functools.cached_property
    def _address(self) -> int:
        if config.DISABLE_JIT:
            return self._stub()
        signature = TYPES[self._result](*(TYPES[name] for name in self._arguments))
        made: Any = CFunc(self._function, (signature.args, signature.return_type), locals={}, options=OPTIONS)
        made._cache = SourceCache(self._function)  # what enable_caching does with numba's own
        made.compile()
        self._made = made  # keeps the machine code alive
        return int(made.address)

    def _stub(self) -> int:
        kind = ctypes.CFUNCTYPE(C_TYPES[self._result], *(C_TYPES[name] for name in self._arguments))
        self._made = kind(compiled(self._function))
        return int(ctypes.cast(self._made, ctypes.c_void_p).value or 0)


def callback(result: str, *arguments: str) -> Callable[[Callable[..., Any]], Callback]:
    """Return a decorator for a function that C calls; types are "void", "address" and "float64"."""
    return lambda function: Callback(function, result, arguments)
