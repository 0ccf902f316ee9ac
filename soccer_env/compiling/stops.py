"""Where a signal may end compiling: between two steps of the compiler, nowhere else.

An interrupt that raises anywhere in numba or llvmlite is lost in a destructor, or leaves numba in the belief that it
still compiles a function, which it then refuses as a recursion. So signals wait while something is compiled, and come
between two passes of the compiler. Only LLVM's passes over a whole module take longer than a moment: they run in a
thread of their own, which is left to its end if what a signal raises ends the compiling.
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
from soccer_env.guards.interrupts import is_held, let_come

LOOK = 0.02  # [s] between two looks whether a signal has come, while another thread works
PASS = "numba:run_pass"  # numba's event before and after each pass


class Compiling(threading.local):
    """What this thread compiles."""

    depth = 0  # functions of ours, each for the sake of the one before
    stoppable = False


compiling = Compiling()
_left: list[threading.Thread] = []  # that clear away what nobody waits for any more


class _StopError(BaseException):
    """Carries what a signal raised through the compiler, which would take an ordinary error for one of its own."""

    def __init__(self, error: BaseException) -> None:
        super().__init__()
        self.error = error
        self.worker: threading.Thread | None = None  # that is still at work


class _Passes(Listener):  # type: ignore[misc]
    def on_start(self, event: Any) -> None:
        stop_here()

    def on_end(self, event: Any) -> None:
        """Do nothing: it is told of passes that have failed, too."""


register(PASS, _Passes())


@contextlib.contextmanager
def stoppable() -> Iterator[None]:
    """Compile in a `with`, while signals wait; what one raises at `stop_here` is raised at the end of the outermost."""
    if compiling.stoppable:
        yield
        return
    compiling.stoppable = True
    try:
        with _alone():
            yield
    except _StopError as stop:
        _clear_away(stop)
        error = stop.error
    else:
        return
    finally:
        compiling.stoppable = False
    context = error.__context__
    try:
        raise error
    finally:
        error.__context__ = context  # not the way through the compiler


@contextlib.contextmanager
def _alone() -> Iterator[None]:
    """Take the lock of numba's compiler; signals may come while another thread has it."""
    while not numba_lock._lock.acquire(timeout=LOOK):
        stop_here()
    try:
        yield
    finally:
        numba_lock._lock.release()


def stop_here() -> None:
    """Let those signals come that have waited while this thread compiles."""
    if not compiling.stoppable:
        return
    depth, compiling.depth, compiling.stoppable = compiling.depth, 0, False  # a handler may compile
    try:
        let_come()
    except BaseException as error:
        raise _StopError(error) from None
    finally:
        compiling.depth, compiling.stoppable = depth, True


def beside(work: Callable[[], None]) -> None:
    """Do work of LLVM that takes long, in another thread if signals wait: so they may come, and end the waiting."""
    if not (compiling.stoppable and is_held()):
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


def _clear_away(stop: _StopError) -> None:
    """Let another thread destroy what LLVM has made: here that would swallow the next interrupt, and wait for LLVM."""

    def clear() -> None:
        if stop.worker is not None:
            stop.worker.join()
        traceback.clear_frames(stop.__traceback__)
        gc.collect()

    thread = threading.Thread(target=clear)
    thread.start()
    _left[:] = [*(one for one in _left if one.is_alive()), thread]


def _end_what_is_left() -> None:
    """Wait for threads that hold LLVM's lock: in a forked process it would be held for ever."""
    while _left:
        _left.pop().join()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_end_what_is_left)
