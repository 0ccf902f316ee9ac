"""Hold interrupts back while something is made or dropped that must not be left half done.

A signal with a handler in Python, such as Ctrl-C, raises between two instructions of the main thread, whatever runs
there. In the functions by which pymunk frees a Space it is swallowed, and half of the Space stays behind. Blocking
signals does not help: the system then hands them to another thread, and Python runs the handler in the main one.
"""

from __future__ import annotations

import _signal  # type: ignore[import-not-found]  # the functions of `signal` without its enumerations, which take ten times as long
import signal
import threading
from types import FrameType
from typing import Any

NAMES = ("INT", "TERM", "HUP", "QUIT", "ALRM", "VTALRM", "PROF", "USR1", "USR2", "CHLD", "CONT", "WINCH", "BREAK")
SIGNALS = tuple(int(getattr(signal, f"SIG{name}")) for name in NAMES if hasattr(signal, f"SIG{name}"))
SOON = 0.001  # [s] until signals come that a destructor has held back

_raw: Any = _signal


class HeldBack:
    """Let the signals that come in a `with` wait until its end; in other threads than the main one nothing can come.

    later: they come soon after the end, for a destructor, where Python would print and forget what they raise.
    """

    def __init__(self, later: bool = False) -> None:
        self.holds, self.later = False, later
        self._waiting: dict[int, _Waiting] = {}

    def __enter__(self) -> HeldBack:
        if threading.get_ident() != threading.main_thread().ident:
            return self
        handlers = {number: _raw.getsignal(number) for number in SIGNALS}
        self._waiting = {n: _Waiting(self, found) for n, found in handlers.items() if needs_holding(found)}
        self.holds = True
        try:
            for number, waiting in self._waiting.items():
                _raw.signal(number, waiting)
        except BaseException:  # one that was not yet held
            self._hand_back()
            raise
        return self

    def __exit__(self, *error: object) -> None:
        if self._waiting:
            self._hand_back()
            came = [number for number, waiting in self._waiting.items() if waiting.came]
            if came and self.later:
                threading.Timer(SOON, deliver, [came]).start()
            else:
                deliver(came)

    def _hand_back(self) -> None:
        """Install the handlers that were there; one that cannot be, as another raises, is called through ours."""
        try:
            for number, waiting in self._waiting.items():
                _raw.signal(number, waiting.handler)
        finally:
            self.holds = False


class _Waiting:
    """A handler that stands for another: it notes that the signal came, and after the `with` it calls the other."""

    def __init__(self, held: HeldBack, handler: Any) -> None:
        self.held, self.handler, self.came = held, handler, False

    def __call__(self, number: int, frame: FrameType | None) -> None:
        if self.held.holds:
            self.came = True
        else:
            self.handler(number, frame)


def needs_holding(handler: Any) -> bool:
    """Tell whether a signal's handler runs Python, and does not wait already."""
    return callable(handler) and not (isinstance(handler, _Waiting) and handler.held.holds)


def deliver(numbers: list[int]) -> None:
    """Send this process some signals; each comes, also when the handler of the one before raises."""
    if numbers:
        try:
            signal.raise_signal(numbers[0])
        finally:
            deliver(numbers[1:])
