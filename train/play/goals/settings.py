"""The settings of a look at goals."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from soccer_env.checking import Range
from soccer_env.train.play.settings import PlaySettings


@dataclass(frozen=True)
class GoalSettings(PlaySettings):
    """Play matches until enough goals have fallen, say how they fell, and draw the seconds before them."""

    BOUNDS = {
        "matches": Range(1),
        "minutes": Range(0.0, 10_000.0, above=True, below=True),
        "goals": Range(1),
        "sheets": Range(0),
    }

    goals: int = 40
    """Goals to classify, in order of the matches; a match is always played to its end."""
    sheets: int = 10
    """Goals to draw, the first of them, a sheet each (needs pygame-ce); 0 for none."""
    matches: int = 512
    """Matches to play at most, each from a seed of its own."""
    out: Path = Path("runs/goals")
    """Folder for goals.jsonl, a line for each goal, and for the sheets."""
