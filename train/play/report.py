"""The figures of a measurement as a table for the terminal and as JSON."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from soccer_env.train.play.figures import Found
from soccer_env.train.play.measures import MEASURES, Play
from soccer_env.whole_files import write_whole

if TYPE_CHECKING:
    from rich.table import Table


def as_dict(play: Play) -> dict[str, Any]:
    """Return what the JSON file holds."""
    settings = {name: str(value) if isinstance(value, Path) else value for name, value in asdict(play.settings).items()}
    return {
        "settings": settings | {"placement": play.conditions.placement, "players": list(play.conditions.players)},
        "made_with": play.made_with,
        "goals": play.goals,
        "figures": [asdict(found) for found in play.figures],
        "definitions": {figure.name: one.definition for one in MEASURES for figure in one.figures},
    }


def write(play: Play, path: Path) -> None:
    """Write the JSON file."""
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, (json.dumps(as_dict(play), indent=1) + "\n").encode())


def read(path: Path) -> dict[str, Found]:
    """Return the figures that a JSON file holds, by name; ValueError if it holds none."""
    try:
        return {one["name"]: Found(**one) for one in json.loads(path.read_text(encoding="utf-8"))["figures"]}
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"before must be a file that a measurement of play has written, got {path}") from error


def screen_table(play: Play, before: Mapping[str, Found] | None = None) -> Table:
    """Return the figures as a table, beside those of an earlier measurement; those of nothing are left out."""
    from rich.table import Table

    settings, conditions = play.settings, play.conditions
    drawn = Table(
        title=f"{settings.home} against {settings.away}, {conditions.league.name}, "
        f"{conditions.players[0]}v{conditions.players[1]}, {settings.matches} x {settings.minutes:g} min, "
        f"seed {settings.seed}"
    )
    drawn.add_column("")
    for name in (*(("before", "95 % interval") if before else ()), "value", "95 % interval"):
        drawn.add_column(name, justify="right")
    drawn.add_column("")
    for found in play.figures:
        both = [*([before.get(found.name)] if before else []), found]
        if any(one is not None and one.value is not None for one in both):
            drawn.add_row(found.name, *(cell for one in both for cell in cells(one)), found.unit)
    return drawn


def cells(found: Found | None) -> tuple[str, str]:
    """Return value and interval in words; nothing of a figure that is not known."""
    if found is None or found.value is None:
        return "", ""
    return number(found.value), interval(found)


def interval(found: Found) -> str:
    """Return the interval in words, "" without one."""
    if found.low is None and found.high is None:
        return ""
    return f"{number(found.low)} to {number(found.high)}"


def number(value: float | None) -> str:
    """Return a number as short as it may be read; "?" for one that is not known."""
    if value is None:
        return "?"
    return f"{value:.1f}" if abs(value) >= 9.95 else f"{value:.2f}"
