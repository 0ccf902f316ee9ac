"""Print tables, JSON, and the files of a run."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.console import Console

WIDTH = 120  # columns of a table that does not go to a terminal


def console() -> Console:
    """Return the console for printing tables: the terminal, or one of fixed width."""
    from rich.console import Console

    return Console(width=None if sys.stdout.isatty() else WIDTH, markup=False)  # names of teams and files are no markup


def print_json(value: Any) -> None:
    """Print a value as JSON and nothing else on stdout, for other programs."""
    print(json.dumps(value, indent=2))


def print_written_files(folder: Path | None, *names: str) -> None:
    """Print the paths of those files `names` that exist in a folder."""
    if folder is not None:
        print(f"written: {', '.join(str(folder / name) for name in names if (folder / name).exists())}")


def print_kept_replays(folder: Path | None) -> None:
    """Print the number and size of the replays that a folder keeps."""
    from soccer_env.train.evaluate.replays import kept_in
    from soccer_env.train.evaluate.replays.keep import summary

    kept = kept_in(folder) if folder is not None else []
    if folder is not None and kept:
        print(f"kept: {folder / 'replays'}, {summary(kept)}")
