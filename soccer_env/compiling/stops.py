"""The points at which a signal may end compiling: between two passes of the compiler, nowhere else.

An interrupt inside numba or llvmlite is lost in a destructor, or leaves the function marked as being compiled, and
numba then refuses it as a recursion. So signals wait while a function is compiled, and are delivered between two passes
of the compiler. LLVM's passes over a whole module take long: they run in another thread, which runs to its end even if
a signal ends the compiling.
"""

from __future__ import annotations

import contextlib
import gc
import os
import threading
import traceback
from collections.abc import Callable, Iterator
from typing import Any

from soccer_env.compiling.numba_parts import Listener, numba_lock, register
from soccer_env.guards.interrupts import are_signals_held, deliver_waiting_signals

LOOK = 0.02  # [s] between two checks for signals while another thread works
PASS = "numba:run_pass"  # numba's event before and after each pass


class CompilingState(threading.local):
    """The state of compiling in this thread."""

    depth = 0  # nested functions of ours that are being compiled
    stoppable = False


compiling = CompilingState()
_left: list[threading.Thread] = []  # threads that free the results of ended compiling


class _StopError(BaseException):
    """Carries the error of a signal through the compiler, which would handle an ordinary error itself."""

    def __init__(self, error: BaseException) -> None:
        super().__init__()
        self.error = error
        self.worker: threading.Thread | None = None  # still at work


class _PassListener(Listener):  # type: ignore[misc]
    def on_start(self, event: Any) -> None:
        stop_here()

    def on_end(self, event: Any) -> None:
        """Do nothing: numba also calls this after a pass that failed."""


register(PASS, _PassListener())


@contextlib.contextmanager
def stoppable() -> Iterator[None]:
    """Compile inside a `with` while signals wait; an error of `stop_here` is raised at the end of the outermost."""
    if compiling.stoppable:
        yield
        return
    compiling.stoppable = True
    try:
        with _compiler_lock():
            yield
    except _StopError as stop:
        _free_in_thread(stop)
        error = stop.error
    else:
        return
    finally:
        compiling.stoppable = False
    context = error.__context__
    try:
        raise error
    finally:
        error.__context__ = context  # without the frames of the compiler


@contextlib.contextmanager
def _compiler_lock() -> Iterator[None]:
    """Take the lock of numba's compiler, and wait for LLVM in other threads; meanwhile signals are delivered."""
    while _left and any(one.is_alive() for one in _left):
        _left[-1].join(LOOK)
        stop_here()
    while not numba_lock._lock.acquire(timeout=LOOK):
        stop_here()
    try:
        yield
    finally:
        numba_lock._lock.release()


def stop_here() -> None:
    """Deliver the signals that have waited while this thread compiles."""
    if not compiling.stoppable:
        return
    depth, compiling.depth, compiling.stoppable = compiling.depth, 0, False  # a handler may compile
    try:
        deliver_waiting_signals()
    except BaseException as error:
        raise _StopError(error) from None
    finally:
        compiling.depth, compiling.stoppable = depth, True


def run_stoppably(work: Callable[[], None]) -> None:
    """Do long work of LLVM, in another thread if signals wait, so that a signal can end the waiting."""
    if not (compiling.stoppable and are_signals_held()):
        work()
        return
    raised: list[BaseException] = []

    def run() -> None:
        try:
            work()
        except BaseException as error:
            raised.append(error)

    worker = threading.Thread(target=run)
    worker.start()
    try:
        while worker.is_alive():
            worker.join(LOOK)
            stop_here()
    except _StopError as stop:
        stop.worker = worker
        raise
    if raised:
        raise raised[0]


def _free_in_thread(stop: _StopError) -> None:
    """Free the objects of LLVM in another thread: this thread would wait for LLVM and swallow the next interrupt."""

    def clear() -> None:
        if stop.worker is not None:
            stop.worker.join()
        traceback.clear_frames(stop.__traceback__)
        gc.collect()

    thread = threading.Thread(target=clear)
    thread.start()
    _left[:] = [*(one for one in _left if one.is_alive()), thread]


def _join_lock_holders() -> None:
    """Wait for threads that hold LLVM's lock, which would stay locked in a forked process."""
    while _left:
        _left.pop().join()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_join_lock_holders)
