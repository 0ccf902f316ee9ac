"""Make machine code of a compiled function once, with all that it calls, and not of each of the called ones before.

numba makes machine code of every function that a compiled one calls, though it is called from Python by nobody: of the
time that it takes to compile a match, that is a third. Here a function that is compiled because another one calls it
stays LLVM's intermediate code, optimised. Should Python call it later, it is compiled again, as one that Python calls.
(Optimising only the outermost saves another tenth of the time, and steps of matches become slower by as much.)
"""

from __future__ import annotations

import contextlib
import gc
import threading
from collections.abc import Iterator
from typing import Any

from llvmlite import binding
from numba.core import compiler, sigutils
from numba.core.codegen import JITCodeLibrary
from numba.core.registry import CPUDispatcher

from soccer_env.guards.interrupts import hold, is_held

INNER = "inner"  # kind of a library in the cache
OBJECTS = 50_000  # that are made while compiling between two looks for garbage

Library: Any = JITCodeLibrary
Dispatcher: Any = CPUDispatcher
Pipeline: Any = compiler.Compiler
normalized: Any = sigutils.normalize_signature


class _Compiling(threading.local):
    """Count the functions of ours that are being compiled on this thread, each for the sake of the one before."""

    depth = 0


_compiling = _Compiling()


def for_another() -> bool:
    """Tell whether a function is being compiled because another one calls it."""
    return _compiling.depth > 1


class InnerLibrary(Library):  # type: ignore[misc]
    """The code of a function that only compiled ones call: ready to be linked, not to be run."""

    @classmethod
    def of_bitcode(cls, codegen: Any, name: str, bitcode: bytes) -> InnerLibrary:
        """Return the library that `serialize_using_object_code` described."""
        library = cls(codegen, name)
        library._final_module = binding.parse_bitcode(bitcode)
        library._finalize_final_module()
        return library

    @property
    def codegen(self) -> Any:
        """Whoever gives the environment of the function to the engine is to find nothing: see `set_env`."""
        return self

    def set_env(self, name: str, environment: Any) -> None:
        """Do nothing: what this code reads is set as it runs inside another function."""

    def get_pointer_to_function(self, name: str) -> int:
        """Return 0, as there is no machine code."""
        return 0

    def serialize_using_object_code(self) -> tuple[str, str, bytes]:
        """Return the library as the cache keeps it."""
        return self.name, INNER, self._get_module_for_linking().as_bitcode()

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()
        self._finalized = True


class InnerTarget:
    """Stands in for the target of a compile result that is read from the cache, and rebuilds its library as inner."""

    def __init__(self, context: Any) -> None:
        self.context, self.typing_context = context, context.typing_context
        self.get_executable = context.get_executable

    def codegen(self) -> Any:
        """Return what unpacks libraries."""
        return self

    def unserialize_library(self, state: tuple[str, str, bytes]) -> InnerLibrary:
        """Return the library of a cached state."""
        name, _, bitcode = state
        return InnerLibrary.of_bitcode(self.context.codegen(), name, bitcode)


class KernelCompiler(Pipeline):  # type: ignore[misc]
    """numba's compiler, which leaves the code of inner functions as it is."""

    def define_pipelines(self) -> Any:
        """Return numba's own."""
        if for_another():
            self.state.flags.no_cpython_wrapper = True
            self.state.library = InnerLibrary(self.state.targetctx.codegen(), self.state.func_id.func_qualname)
        return super().define_pipelines()


class Kernel(Dispatcher):  # type: ignore[misc]
    """A function that compiles itself for the types that it is called with."""

    def compile(self, sig: Any) -> Any:
        """Compile for a signature, for whoever asks: Python, or the compiler for the sake of another function."""
        _compiling.depth += 1
        held = is_held()
        try:
            return super().compile(sig) if for_another() else self._compile_for_python(sig)
        finally:
            _compiling.depth -= 1
            if held:  # the cache has let go, if there was something to compile
                hold()

    def _compile_for_python(self, sig: Any) -> Any:
        arguments = tuple(normalized(sig)[0])
        if is_inner(self.overloads.get(arguments)):
            del self.overloads[arguments]
        with few_collections():
            entry = super().compile(sig)
        set_environments(self.overloads[arguments])
        return entry

    def add_overload(self, cres: Any) -> None:
        """Take a compile result; one without machine code is for other compiled functions alone."""
        if is_inner(cres):
            self.overloads[tuple(cres.signature.args)] = cres
        else:
            super().add_overload(cres)


@contextlib.contextmanager
def few_collections() -> Iterator[None]:
    """Let Python look for garbage less often: the compiler makes many objects that live on, and little garbage."""
    often = gc.get_threshold()
    gc.set_threshold(max(OBJECTS, often[0]), *often[1:])
    try:
        yield
    finally:
        gc.set_threshold(*often)


def is_inner(result: Any) -> bool:
    """Tell whether a compile result has no machine code."""
    return result is not None and isinstance(result.library, InnerLibrary)


def set_environments(result: Any) -> None:
    """Give the environments of all functions inside a compiled one to the engine, as numba does after loading it."""
    for environment in result._find_referenced_environments():
        result.library.codegen.set_env(environment.env_name, environment)
