"""The points at which a signal such as Ctrl-C may interrupt compiling: between two compiler passes, nowhere else.

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
    """An error that carries a signal's error through the compiler, which would catch an ordinary error itself."""

    def __init__(self, error: BaseException) -> None:
        super().__init__()
        self.error = error
        self.worker: threading.Thread | None = None  # still at work


class _PassListener(Listener):  # type: ignore[misc]
    def on_start(self, event: Any) -> None:
        stop_here()

    def on_end(self, event: Any) -> None:
        """Do nothing: numba calls this even after a pass that failed."""


register(PASS, _PassListener())


@contextlib.contextmanager
def stoppable() -> Iterator[None]:
    """Allow signals to interrupt compiling inside a `with`; the error is raised at the end of the outermost `with`."""
    if compiling.stoppable:
        yield
        return
    compiling.stoppable = True
    try:
        with _compiler_lock():
            yield
    except _StopError as stop:
        _free_llvm_in_thread(stop)
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
    """Take the lock of numba's compiler and wait for LLVM in other threads, while signals are still handled."""
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
    """Handle the signals that have arrived while this thread was compiling."""
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
    """Run a long LLVM task, in another thread if signals are held back, so that a signal can interrupt the waiting."""
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


def _free_llvm_in_thread(stop: _StopError) -> None:
    """Free LLVM objects in another thread: in this thread the wait for LLVM would swallow the next interrupt."""

    def clear() -> None:
        if stop.worker is not None:
            stop.worker.join()
        traceback.clear_frames(stop.__traceback__)
        gc.collect()

    thread = threading.Thread(target=clear)
    thread.start()
    _left[:] = [*(one for one in _left if one.is_alive()), thread]


def _join_lock_holders() -> None:
    """Wait for threads that hold LLVM's lock, because the lock would stay locked in a forked process."""
    while _left:
        _left.pop().join()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_join_lock_holders)
