"""The progress of long work: a bar on stderr, or a plain line at intervals where stderr is no terminal."""

from __future__ import annotations

import sys
import threading
import time
from typing import Any

EVERY = 15.0  # [s] between two plain lines, at least


class Progress:
    """A bar over an amount of work, or plain lines; use it as a context manager. Any thread may advance it."""

    def __init__(self, title: str, total: float) -> None:
        self._title = title
        self._total = total
        self._done = 0.0
        self._words = ""
        self._begun = self._said = time.monotonic()
        self._lock = threading.Lock()
        self._bar: Any = None
        if sys.stderr.isatty() and total > 0:
            from rich.console import Console
            from rich.progress import BarColumn, TaskProgressColumn, TextColumn, TimeRemainingColumn
            from rich.progress import Progress as Bar

            text, note = (TextColumn(part, markup=False) for part in ("{task.description}", "{task.fields[note]}"))
            columns = (text, BarColumn(), TaskProgressColumn(), note, TimeRemainingColumn())
            self._bar = Bar(*columns, console=Console(stderr=True), transient=True)
            self._task = self._bar.add_task(title, total=total, note="")

    def __enter__(self) -> Progress:
        if self._bar is not None:
            self._bar.start()
        return self

    def __exit__(self, *error: object) -> None:
        if self._bar is not None:
            self._bar.stop()

    def advance(self, amount: float) -> None:
        """Add `amount` to the work done, and update the bar."""
        with self._lock:
            self._done += amount
            if self._bar is not None:
                self._bar.advance(self._task, amount)
            else:
                self._say()

    def skip(self, amount: float) -> None:
        """Take work off the total that an earlier run has done."""
        with self._lock:
            self._total -= amount
            if self._bar is not None:
                self._bar.update(self._task, total=self._total)

    def rename(self, title: str) -> None:
        """Change the words before the bar."""
        with self._lock:
            self._title = title
            if self._bar is not None:
                self._bar.update(self._task, description=title)

    def note(self, text: str) -> None:
        """Show a few words beside the bar."""
        with self._lock:
            self._words = text
            if self._bar is not None:
                self._bar.update(self._task, note=text)
            else:
                self._say()

    def _say(self) -> None:
        """Print a line of progress, if the last line is at least EVERY seconds old."""
        now = time.monotonic()
        if self._total <= 0 or now - self._said < EVERY:
            return
        self._said = now
        words = f", {self._words}" if self._words else ""
        print(
            f"{self._title}: {100 * self._done / self._total:.0f} %{words}{self._left(now)}",
            file=sys.stderr,
            flush=True,
        )

    def _left(self, now: float) -> str:
        """Return the time that the rest takes at the pace so far, in words; "" before anything is done."""
        if not 0.0 < self._done < self._total:
            return ""
        left = (now - self._begun) * (self._total / self._done - 1.0)
        return f", {left / 60.0:.0f} min left" if left >= 60.0 else f", {left:.0f} s left"
