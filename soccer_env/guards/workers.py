"""Threads that share out the parts of a task.

Nobody returns while a part still runs: parts work on records and Spaces that the caller may change next. The threads
begin with the first task of a process, so that a process that was forked has its own.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from typing import Any, TypeVar

from soccer_env.guards.interrupts import HeldBack

T = TypeVar("T")


class Workers:
    """Up to `threads` threads; with one, the caller's own does everything."""

    def __init__(self, threads: int) -> None:
        self.threads = threads
        self._executor: ThreadPoolExecutor | None = None
        self._process = 0  # whose threads these are

    def map(self, function: Callable[..., T], *parts: Iterable[Any]) -> list[T]:
        """Return function(*part) of all parts, in order; what one of them raises comes once the others are done."""
        if self.threads == 1:
            return [function(*part) for part in zip(*parts, strict=True)]
        executor = self._started()
        try:
            jobs = [executor.submit(function, *part) for part in zip(*parts, strict=True)]
            return [job.result() for job in jobs]
        except BaseException:  # Ctrl-C too: parts may run that no job here stands for
            self.shutdown()
            raise

    def shutdown(self) -> None:
        """Wait for what runs, and end the threads; the next task begins new ones."""
        with HeldBack():
            executor, self._executor = self._executor, None
            if executor is not None and self._process == os.getpid():
                executor.shutdown(wait=True)

    def _started(self) -> ThreadPoolExecutor:
        """Return threads of this process."""
        if self._executor is None or self._process != os.getpid():
            self._executor, self._process = ThreadPoolExecutor(self.threads), os.getpid()
        return self._executor
