"""Say while functions are compiled that it takes a while, and how many are left."""

import functools
import os
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

from soccer_env.compiling.numba_parts import Dispatcher
from soccer_env.compiling.sources import PACKAGE

EVERY = 20.0  # [s] between two lines of progress, at least


class CompileProgress:
    """The progress of compiling in this process: number of compiled functions, and times of messages."""

    functions = 0  # compiled versions of functions, without those from disk
    began = said = float("inf")  # [s] time of the announcement, and of the last line of progress

    def __init__(self) -> None:
        self.asked: set[Callable[..., Any]] = set()  # functions that were not on disk, and all that they call
        self.expected: frozenset[Any] = frozenset()  # compiled functions that they call

    def count(self) -> None:
        """Count a compiled function, and sometimes print the progress."""
        self.functions += 1
        now = time.monotonic()
        if now - self.said >= EVERY:
            self.said = now
            left = sum(not one.overloads for one in self.expected)
            words = f"{self.functions} of {self.functions + left} functions in {now - self.began:.0f} s"
            print(f"{PACKAGE}: compiling {words} ...", file=sys.stderr, flush=True)

    def expect(self, function: Callable[..., Any]) -> None:
        """Expect that the functions that a function calls will be compiled as well."""
        if function not in self.asked:
            called = called_functions(function)
            self.asked |= {function, *(one.py_func for one in called)}
            self.expected |= called


COMPILED = CompileProgress()


@functools.cache
def announce(folders: tuple[Path, ...]) -> None:
    """Print once per process that compiling takes a while, and whether the cache's folders hold other code."""
    if os.environ.get("SOCCER_ENV_QUIET", "0") not in ("", "0"):
        return
    filled = any(folder.is_dir() and any(folder.iterdir()) for folder in folders)
    what = "what is new" if filled else "kernels (once, about a minute)"
    COMPILED.said = COMPILED.began = time.monotonic()
    print(f"{PACKAGE}: compiling {what} ...", file=sys.stderr, flush=True)


def called_functions(function: Callable[..., Any]) -> frozenset[Any]:
    """Return every compiled function that a function's code names, and that those name in turn."""
    found: set[Any] = set()
    waiting = [function]
    while waiting:
        for value in named_values(waiting.pop()):
            if isinstance(value, Dispatcher) and value not in found:
                found.add(value)
                waiting.append(value.py_func)
    return frozenset(found)


def named_values(function: Callable[..., Any]) -> Iterator[Any]:
    """Yield the values of all global and enclosing names in a function's code, and of the modules' attributes."""
    names, variables = set(code_names(function.__code__)), function.__globals__
    values = [variables[name] for name in names if name in variables]
    values += [cell.cell_contents for cell in function.__closure__ or ()]
    for value in values:
        if isinstance(value, ModuleType):
            yield from (vars(value)[name] for name in names if name in vars(value))
        elif isinstance(value, tuple):
            yield from value
        else:
            yield value


def code_names(code: CodeType) -> Iterator[str]:
    """Yield the global names and attributes of a code object and of the functions inside it."""
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from code_names(constant)
