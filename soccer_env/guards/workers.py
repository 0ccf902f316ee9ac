"""Threads that share the parts of a task.

`map` returns after all parts have ended, because parts work on records and Spaces that the caller may change next. The
threads start with the first task of a process, so that a forked process has its own threads.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from typing import Any, TypeVar

from soccer_env.guards.interrupts import SignalsHeld

T = TypeVar("T")


class Workers:
    """A pool of up to `threads` threads; with one thread all work runs in the calling thread."""

    def __init__(self, threads: int) -> None:
        self.threads = threads
        self._executor: ThreadPoolExecutor | None = None
        self._process = 0  # id of the process that started the threads

    def map(self, function: Callable[..., T], *parts: Iterable[Any]) -> list[T]:
        """Return function(*part) for all parts, in order; errors are raised after all parts have ended."""
        if self.threads == 1:
            return [function(*part) for part in zip(*parts, strict=True)]
        if self._executor is None or self._process != os.getpid():
            self._executor, self._process = ThreadPoolExecutor(self.threads), os.getpid()
        submit = self._executor.submit
        try:
            jobs = [submit(function, *part) for part in zip(*parts, strict=True)]
            return [job.result() for job in jobs]
        except BaseException:  # Ctrl-C too: parts may run whose job was not stored
            self.shutdown()
            raise

    def shutdown(self) -> None:
        """Wait for running parts and end the threads; the next `map` starts new threads."""
        with SignalsHeld():
            executor, self._executor = self._executor, None
            if executor is not None and self._process == os.getpid():
                executor.shutdown(wait=True)
