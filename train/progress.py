"""A progress bar on stderr, silent when that is no terminal."""

from __future__ import annotations

import sys
from typing import Any


class Progress:
    """A bar over an amount of work; use it as a context manager."""

    def __init__(self, title: str, total: float) -> None:
        self._bar: Any = None
        if sys.stderr.isatty() and total > 0:
            from rich.console import Console
            from rich.progress import BarColumn, TaskProgressColumn, TextColumn, TimeRemainingColumn
            from rich.progress import Progress as Bar

            text, note = TextColumn("{task.description}"), TextColumn("{task.fields[note]}")
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
        """Move the bar on by an amount of work."""
        if self._bar is not None:
            self._bar.advance(self._task, amount)

    def note(self, text: str) -> None:
        """Show a few words beside the bar."""
        if self._bar is not None:
            self._bar.update(self._task, note=text)
