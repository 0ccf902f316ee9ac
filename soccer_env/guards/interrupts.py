"""Hold signals back while something is done that must be done or not done, never half.

A signal with a handler in Python, such as Ctrl-C, raises between two instructions of the main thread, whatever runs
there: a match would be left in the middle of a step. In the functions by which pymunk frees a Space it is swallowed,
and half of the Space stays behind. Blocking signals does not help: the system then hands them to another thread, and
Python runs the handler in the main one.

`HeldBack` is the usual way. `hold` and `release` are the same for a control step, which they cost a microsecond.
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

MOST = 1000  # signals that come while another is raised
NAMES = ("INT", "TERM", "HUP", "QUIT", "ALRM", "VTALRM", "PROF", "USR1", "USR2", "CHLD", "CONT", "WINCH", "BREAK")
SIGNALS = tuple(int(getattr(signal, f"SIG{name}")) for name in NAMES if hasattr(signal, f"SIG{name}"))
SOON = 0.001  # [s] between two looks whether a destructor that has held signals back has ended
Handlers = tuple[tuple[int, Any], ...]  # number of a signal, and what is called for it

_raw: Any = _signal
_get, _set = _raw.getsignal, _raw.signal


class _Held:
    """The signals of this process, whose handlers run in the main thread alone."""

    __slots__ = "arrived", "handlers", "holds", "main", "python_handlers", "stand_ins"

    def __init__(self) -> None:
        self.main = threading.main_thread().ident
        self.holds = False  # whether signals wait now
        self.arrived: tuple[int, ...] = ()
        self.handlers: tuple[Any, ...] = ()  # the handlers of all SIGNALS, as they were when signals last began to wait
        self.python_handlers: Handlers = ()  # those of them that run Python
        self.stand_ins: Handlers = ()  # what stands for them while signals wait

    def take(self, handlers: tuple[Any, ...]) -> None:
        """Take note of the handlers that are to be held back; one of ours that was left behind stands for its own."""
        known = [
            (n, one.handler if isinstance(one, _Waiting) else one) for n, one in zip(SIGNALS, handlers, strict=True)
        ]
        self.python_handlers = tuple((number, handler) for number, handler in known if callable(handler))
        self.stand_ins = tuple((number, _Waiting(handler)) for number, handler in self.python_handlers)
        self.handlers = handlers  # at the end: if this is interrupted, they are taken anew


_HELD = _Held()


class _Waiting:
    """A handler that stands for another: while signals wait it notes that one came, else it calls the other."""

    def __init__(self, handler: Any) -> None:
        self.handler = handler

    def __call__(self, number: int, frame: FrameType | None) -> None:
        if _HELD.holds:
            _HELD.arrived += (number,)
        else:
            self.handler(number, frame)


def hold() -> bool:
    """Let signals wait from now on; return whether they began to: whoever gets True has to call `release`.

    In other threads than the main one nothing can come.
    """
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
    except BaseException:  # one that was not yet held
        release()
        raise
    return True


def release(later: bool = False) -> None:
    """Let those signals come that have waited; later: once no destructor runs."""
    held = _HELD
    held.holds = False  # first of all, as whatever left it true would keep all signals away for ever
    try:
        for number, handler in held.python_handlers:
            _set(number, handler)
    except BaseException:  # of one that came through ours, before its own was back
        for number, handler in held.python_handlers:
            _set(number, handler)
        raise
    finally:
        if held.arrived:
            came, held.arrived = dict.fromkeys(held.arrived), ()
            if later:
                deliver_soon([*came])
            else:
                deliver([*came])


def let_go() -> None:
    """Let signals come, until `hold`, in the middle of what they wait for: a user's code begins."""
    if _HELD.holds and get_ident() == _HELD.main:
        release()


def let_come() -> None:
    """Let those signals come that have waited until now; the next ones wait again, also if one of these raises."""
    if not (_HELD.arrived and is_held()):
        return
    try:
        release()
        hold()
    except BaseException:
        hold_again()
        raise


def hold_again() -> None:
    """Let signals wait, whatever comes meanwhile: another one is being raised already."""
    for _ in range(MOST):
        with contextlib.suppress(BaseException):
            hold()
            return


def is_held() -> bool:
    """Tell whether signals wait in this thread."""
    return _HELD.holds and get_ident() == _HELD.main


class HeldBack:
    """Let the signals that come in a `with` wait until its end, or until that of an outer one.

    later: they come soon after the end, for a destructor, where Python would print and forget what they raise.
    """

    def __init__(self, later: bool = False) -> None:
        self.later = later

    def __enter__(self) -> HeldBack:
        self._began = hold()
        return self

    def __exit__(self, *error: object) -> None:
        if self._began:
            release(self.later)


def deliver(numbers: list[int]) -> None:
    """Send this process some signals; each comes, also when the handler of the one before raises."""
    if numbers:
        try:
            signal.raise_signal(numbers[0])
        finally:
            deliver(numbers[1:])


def deliver_soon(numbers: list[int]) -> None:
    """Send this process some signals from another thread, once the main one is in no destructor."""

    def wait() -> None:
        while _in_destructor():
            time.sleep(SOON)
        deliver(numbers)

    threading.Timer(SOON, wait).start()


def _in_destructor() -> bool:
    """Tell whether the main thread is in a destructor."""
    frame = sys._current_frames().get(_HELD.main or 0)
    while frame is not None and frame.f_code.co_name != "__del__":
        frame = frame.f_back
    return frame is not None


def _after_fork() -> None:
    """Take the thread that forked for the main one of the child, in which nothing waits."""
    _HELD.main = get_ident()
    if _HELD.holds:
        _HELD.arrived = ()
        release()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)
