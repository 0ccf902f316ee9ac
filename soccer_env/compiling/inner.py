"""Make machine code only for functions that Python calls; each contains the code of all functions that it calls.

numba also makes machine code of each called function, although Python never calls it; that takes a third of the time to
compile a match. Here a function that is compiled for another function stays optimised intermediate code of LLVM. If
Python calls it later, it is compiled again. (Optimising the outermost function alone saves another tenth of the time,
and makes steps of matches a tenth slower.)
"""

from __future__ import annotations

import contextlib
import gc
from collections.abc import Iterator
from typing import Any

from llvmlite import binding
from numba import types

from soccer_env.compiling.numba_parts import Kernel as Dispatcher
from soccer_env.compiling.numba_parts import Library, NumbaError, Pipeline, normalized
from soccer_env.compiling.stops import compiling, run_stoppably, stop_here, stoppable
from soccer_env.guards.turns import with_signals_held

INNER = "inner"  # kind of a library in the cache
OBJECTS = 50_000  # new objects between two garbage collections while compiling


def is_inner_compile() -> bool:
    """Tell whether numba is compiling a function only because another function calls it."""
    return compiling.depth > 1


class KernelLibrary(Library):  # type: ignore[misc]
    """The compiled code of one function of this package; signals such as Ctrl-C are handled during long LLVM work."""

    def _optimize_final_module(self) -> None:
        run_stoppably(super()._optimize_final_module)

    def _finalize_specific(self) -> None:
        self._codegen._scan_and_fix_unresolved_refs(self._final_module)
        run_stoppably(self._make_machine_code)

    def _make_machine_code(self) -> None:
        self._codegen._engine.finalize_object()


class InnerLibrary(KernelLibrary):
    """The code of a function that only compiled functions call: it can be linked into callers, but not run alone."""

    @classmethod
    def of_bitcode(cls, codegen: Any, name: str, bitcode: bytes) -> InnerLibrary:
        """Return the library rebuilt from the bitcode of `serialize_using_object_code`."""
        library = cls(codegen, name)
        library._final_module = binding.parse_bitcode(bitcode)
        library._finalize_final_module()
        return library

    @property
    def codegen(self) -> Any:
        """Return this library, whose `set_env` does nothing."""
        return self

    def set_env(self, name: str, environment: Any) -> None:
        """Do nothing: numba sets the environment of the outermost function, which contains this code."""

    def get_pointer_to_function(self, name: str) -> int:
        """Return 0, since an inner library has no machine code."""
        return 0

    def serialize_using_object_code(self) -> tuple[str, str, bytes]:
        """Return the library in the form that the cache stores: name, the marker INNER, and LLVM bitcode."""
        return self.name, INNER, self._get_module_for_linking().as_bitcode()

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()
        self._finalized = True


class InnerTarget:
    """A stand-in for numba's target context, which rebuilds cached libraries as inner libraries."""

    def __init__(self, context: Any) -> None:
        self.context, self.typing_context = context, context.typing_context
        self.get_executable = context.get_executable

    def codegen(self) -> Any:
        """Return this object, since it also unpacks libraries."""
        return self

    def unserialize_library(self, state: tuple[str, str, bytes]) -> InnerLibrary:
        """Return the library rebuilt from its cached form."""
        name, _, bitcode = state
        return InnerLibrary.of_bitcode(self.context.codegen(), name, bitcode)


class KernelCompiler(Pipeline):  # type: ignore[misc]
    """numba's compiler, changed to make no machine code for inner functions."""

    def define_pipelines(self) -> Any:
        """Choose the kind of library to make, and return numba's own pipelines."""
        kind = InnerLibrary if is_inner_compile() else KernelLibrary
        self.state.library = kind(self.state.targetctx.codegen(), self.state.func_id.func_qualname)
        if is_inner_compile():
            self.state.flags.no_cpython_wrapper = True
        else:
            self.state.library.enable_object_caching()
        return super().define_pipelines()


class Kernel(Dispatcher):  # type: ignore[misc]
    """A function that is compiled when called, once for each combination of argument types."""

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """Return the typed function for a call in compiled code: of numbers, whether or not the call's are constants.

        numba compiles another version for each constant that a call passes, such as a player's number or a flag; that
        takes a fifth of all compiling. LLVM still sees the constants where it puts the function into its caller.
        """
        plain = tuple(map(without_value, args)), {name: without_value(kind) for name, kind in kws.items()}
        try:
            return super().get_call_template(*plain)
        except NumbaError:
            if plain == (tuple(args), kws):
                raise
            return super().get_call_template(args, kws)  # such as the constant index of a tuple

    @with_signals_held
    def compile(self, sig: Any) -> Any:
        """Compile for an argument signature: to be called from Python, or inside another compiled function."""
        with stoppable():
            compiling.depth += 1
            try:
                if not is_inner_compile():
                    return self._compile_for_python(sig)
                made = super().compile(sig)
                stop_here()
                return made
            finally:
                compiling.depth -= 1

    def _compile_for_python(self, sig: Any) -> Any:
        arguments = tuple(normalized(sig)[0])
        if is_inner(self.overloads.get(arguments)):
            del self.overloads[arguments]
        with collect_garbage_rarely():
            entry = super().compile(sig)
        set_environments(self.overloads[arguments])
        return entry

    def add_overload(self, cres: Any) -> None:
        """Store a compile result, and keep Python from calling a result that has no machine code."""
        if is_inner(cres):
            self.overloads[tuple(cres.signature.args)] = cres
        else:
            super().add_overload(cres)


def without_value(kind: Any) -> Any:
    """Return the type of a constant number or truth value without its value, any other type unchanged."""
    unliteral: Any = types.unliteral
    return unliteral(kind) if isinstance(kind, (types.IntegerLiteral, types.BooleanLiteral)) else kind


@contextlib.contextmanager
def collect_garbage_rarely() -> Iterator[None]:
    """Make Python collect garbage less often in a `with`: the compiler makes many lasting objects, little garbage."""
    often = gc.get_threshold()
    gc.set_threshold(max(OBJECTS, often[0]), *often[1:])
    try:
        yield
    finally:
        gc.set_threshold(*often)


def is_inner(result: Any) -> bool:
    """Tell whether a compile result is that of an inner function, without machine code."""
    return result is not None and isinstance(result.library, InnerLibrary)


def set_environments(result: Any) -> None:
    """Register the environments of all functions inside a compiled function, as numba does after loading."""
    for environment in result._find_referenced_environments():
        result.library.codegen.set_env(environment.env_name, environment)
