"""What the page of sacks-2001 says of its settings: which are the paper's own numbers, and how many are assumed."""

from math import pi
from textwrap import wrap
from typing import Any

from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.train.evaluate.report import plain

WIDTH = 118  # of a line of text


def constants_text() -> str:
    """Return in a paragraph which settings are constants of the paper, and how many are assumed."""
    rows = list(SacksSettings().rows())
    assumed = [name for name, _, _, note in rows if "assumed" in note or "ours" in note]
    numbers = [row for row in rows if is_number(row[1]) and row[0] != "strength" and row[0] not in assumed]
    words = ", ".join(f"`{name}` {shown(value, unit_of(note))}" for name, value, _, note in numbers)
    rest = len(rows) - len(numbers) - len(assumed) - 1
    text = (
        f"Of {len(rows)} settings, {len(numbers)} are numbers of the paper: {words}. {rest} are rules of the paper "
        f"that can be switched off, or what it leaves to the future; one is the strength. {len(assumed)} are assumed "
        "or ours."
    )
    return "\n".join(wrap(text, WIDTH))


def is_number(value: Any) -> bool:
    """Tell whether a setting is a number, not a switch or a choice."""
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def unit_of(note: str) -> str:
    """Return the unit at the head of a setting's note, as "[m"."""
    return note.partition("] ")[0] if note.startswith("[") else ""


def shown(value: Any, unit: str) -> str:
    """Return a setting's value with its unit; an angle in degrees too."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return str(value)
    number = plain(float(value), 3)
    if unit == "[rad":
        return f"{number} rad ({value * 180.0 / pi:.0f} degrees)"
    return f"{number} {unit[1:]}" if unit not in ("", "[1") else number
