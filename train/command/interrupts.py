"""Resend a Ctrl-C that Python has swallowed."""

import contextlib
import signal
import sys
import threading
from collections.abc import Iterator
from typing import Any

AGAIN = 0.05  # [s] after which a swallowed Ctrl-C is sent again


@contextlib.contextmanager
def repeat_swallowed_interrupts() -> Iterator[None]:
    """Resend Ctrl-C if Python swallows it, as in a destructor or a weak reference's callback."""
    timers: list[threading.Timer] = []
    usual = sys.unraisablehook

    def hook(unraisable: Any) -> None:
        if issubclass(unraisable.exc_type, KeyboardInterrupt):
            timers.append(threading.Timer(AGAIN, signal.raise_signal, (signal.SIGINT,)))
            timers[-1].start()
        else:
            usual(unraisable)

    sys.unraisablehook = hook
    try:
        yield
    finally:
        sys.unraisablehook = usual
        for timer in timers:
            timer.cancel()
