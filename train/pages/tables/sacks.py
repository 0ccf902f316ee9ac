"""The README of the team sacks-2001: the paper's claims beside the measurements, and the paper's own numbers.

`python -m soccer_env.train.pages.tables.sacks [run FOLDER ... | write]`: see `paper_page.py`.
"""

import sys
from math import pi
from pathlib import Path
from textwrap import wrap

from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.guards.checking import is_number
from soccer_env.train.evaluate.report import plain_number
from soccer_env.train.pages.tables.paper_page import PaperPage
from soccer_env.train.papers.claim import SACKS
from soccer_env.train.papers.results import FOLDERS

WIDTH = 118  # of a line of text


def constants_text() -> str:
    """Return a paragraph on the settings that are constants of the paper, and the number of assumed settings."""
    rows = list(SacksSettings().rows())
    assumed = [name for name, _, _, note in rows if "assumed" in note or "ours" in note]
    numbers = [row for row in rows if is_number(row[1]) and row[0] != "strength" and row[0] not in assumed]
    words = ", ".join(f"`{name}` {setting_in_words(value, note)}" for name, value, _, note in numbers)
    rest = len(rows) - len(numbers) - len(assumed) - 1
    text = (
        f"Of {len(rows)} settings, {len(numbers)} are numbers of the paper: {words}. {rest} are rules of the paper "
        f"that can be switched off, or what it leaves to the future; one is the strength. {len(assumed)} are assumed "
        "or ours."
    )
    return "\n".join(wrap(text, WIDTH))


def setting_in_words(value: float, note: str) -> str:
    """Return a setting's value with its unit, with which its note begins, an angle also in degrees."""
    number, unit = plain_number(float(value), 3), note[1:].partition("] ")[0] if note.startswith("[") else ""
    if unit == "rad":
        return f"{number} rad ({value * 180.0 / pi:.0f} degrees)"
    return f"{number} {unit}" if unit not in ("", "1") else number


PAGE = PaperPage(
    folder=FOLDERS[SACKS],
    paper=SACKS,
    pictures={"S06": 1, "S29": 1, "S35": 1, "S47": 1, "S63": 1},
    run=Path("runs/claims"),
    tables={"constants": constants_text},
    both_papers=True,
)


if __name__ == "__main__":
    sys.exit(PAGE.main(sys.argv[1:]))
