"""Hold back signals such as Ctrl-C during work that must not be interrupted halfway.

A signal with a handler in Python, such as Ctrl-C, raises between two instructions of the main thread and can leave a
match in the middle of a step. In the functions by which pymunk frees a Space the error is swallowed, and half of the
Space stays in memory. Blocking signals does not help: the system delivers them to another thread, and Python runs the
handler in the main thread.

`SignalsHeld` is the usual way. `hold_signals` and `release_signals` do the same for a control step and cost 1 us.
"""

from __future__ import annotations

import _signal  # type: ignore[import-not-found]  # the functions of `signal` without its enumerations, which take ten times as long
import contextlib
import os
import signal
import sys
import threading
import time
from threading import get_ident
from types import FrameType
from typing import Any

MOST = 1000  # attempts to hold signals again while others arrive
NAMES = ("INT", "TERM", "HUP", "QUIT", "ALRM", "VTALRM", "PROF", "USR1", "USR2", "CHLD", "CONT", "WINCH", "BREAK")
SIGNALS = tuple(int(getattr(signal, f"SIG{name}")) for name in NAMES if hasattr(signal, f"SIG{name}"))
SOON = 0.001  # [s] between two checks whether a destructor that held signals back has ended
Handlers = tuple[tuple[int, Any], ...]  # number and handler of each signal

_raw: Any = _signal
_get, _set = _raw.getsignal, _raw.signal


class _HeldSignals:
    """The state of held signals in this process, whose handlers Python runs only in the main thread."""

    __slots__ = "arrived", "handlers", "holds", "main", "python_handlers", "stand_ins"

    def __init__(self) -> None:
        self.main = threading.main_thread().ident
        self.holds = False  # whether signals wait now
        self.arrived: tuple[int, ...] = ()
        self.handlers: tuple[Any, ...] = ()  # of all SIGNALS, when signals last began to wait
        self.python_handlers: Handlers = ()  # the handlers among them that are Python functions
        self.stand_ins: Handlers = ()  # their replacements while signals wait

    def take(self, handlers: tuple[Any, ...]) -> None:
        """Store the present signal handlers, to be held back from now on."""
        originals = [handler.handler if isinstance(handler, _WaitingHandler) else handler for handler in handlers]
        known = zip(SIGNALS, originals, strict=True)
        self.python_handlers = tuple((number, handler) for number, handler in known if callable(handler))
        self.stand_ins = tuple((number, _WaitingHandler(handler)) for number, handler in self.python_handlers)
        self.handlers = handlers  # last of all: after an interrupt `hold_signals` calls `take` again


_HELD = _HeldSignals()


class _WaitingHandler:
    """A replacement for a signal handler: notes the signal while signals are held back, else calls the handler."""

    def __init__(self, handler: Any) -> None:
        self.handler = handler

    def __call__(self, number: int, frame: FrameType | None) -> None:
        if _HELD.holds:
            _HELD.arrived += (number,)
        else:
            self.handler(number, frame)


def hold_signals() -> bool:
    """Hold back signals in the main thread; return True if the caller must call `release_signals`."""
    held = _HELD
    if held.holds or get_ident() != held.main:
        return False
    handlers = tuple(map(_get, SIGNALS))
    if handlers != held.handlers:
        held.take(handlers)
    try:
        held.holds = True
        for number, handler in held.stand_ins:
            _set(number, handler)
    except BaseException:  # raised by a signal that was not yet held
        release_signals()
        raise
    return True


def release_signals(later: bool = False) -> None:
    """Stop holding back signals and deliver those that arrived; later: once no destructor is running."""
    held = _HELD
    held.holds = False  # first of all: if it stayed true, no signal would ever be delivered again
    try:
        for number, handler in held.python_handlers:
            _set(number, handler)
    except BaseException:  # raised through a stand-in whose handler was not yet restored
        for number, handler in held.python_handlers:
            _set(number, handler)
        raise
    finally:
        if held.arrived:
            came, held.arrived = dict.fromkeys(held.arrived), ()
            if later:
                send_signals_later([*came])
            else:
                send_signals([*came])


def resume_signals() -> None:
    """Stop holding back signals, until the next `hold_signals`, because a user's code begins."""
    if _HELD.holds and get_ident() == _HELD.main:
        release_signals()


def deliver_waiting_signals() -> None:
    """Deliver the signals that have arrived, and hold back later signals again, even if a handler raises."""
    if not (_HELD.arrived and are_signals_held()):
        return
    try:
        release_signals()
        hold_signals()
    except BaseException:
        hold_signals_again()
        raise


def hold_signals_again() -> None:
    """Hold back signals while an error is being raised; errors of signal handlers meanwhile are dropped."""
    for _ in range(MOST):
        with contextlib.suppress(BaseException):
            hold_signals()
            return


def are_signals_held() -> bool:
    """Tell whether signals are held back in this thread."""
    return _HELD.holds and get_ident() == _HELD.main


class SignalsHeld:
    """A context manager that holds back signals until the end of the outermost `with`.

    later: deliver them soon after, not inside a destructor, where Python would print and forget their errors.
    """

    def __init__(self, later: bool = False) -> None:
        self.later = later

    def __enter__(self) -> SignalsHeld:
        self._began = hold_signals()
        return self

    def __exit__(self, *error: object) -> None:
        if self._began:
            release_signals(self.later)


def send_signals(numbers: list[int]) -> None:
    """Send all given signals to this process, one after the other, even if a signal handler raises."""
    if numbers:
        try:
            signal.raise_signal(numbers[0])
        finally:
            send_signals(numbers[1:])


def send_signals_later(numbers: list[int]) -> None:
    """Send signals to this process from another thread, once the main thread is not in a destructor."""

    def wait() -> None:
        while _in_destructor():
            time.sleep(SOON)
        send_signals(numbers)

    threading.Timer(SOON, wait).start()


def _in_destructor() -> bool:
    """Tell whether the main thread is running a destructor (`__del__`)."""
    frame = sys._current_frames().get(_HELD.main or 0)
    while frame is not None and frame.f_code.co_name != "__del__":
        frame = frame.f_back
    return frame is not None


def _reset_after_fork() -> None:
    """In a forked process, record the present thread as the main thread, and drop the signals held back."""
    _HELD.main = get_ident()
    if _HELD.holds:
        _HELD.arrived = ()
        release_signals()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_reset_after_fork)
