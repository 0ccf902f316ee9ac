"""The settings of `soccer export`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import tyro

from soccer_env.checking import FROM_ZERO, Range
from soccer_env.render.frame import LEAST_WIDTH, MOST_WIDTH
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.train.written_settings import CommandSettings


@dataclass(frozen=True)
class ExportSettings(OverlayFlags, CommandSettings):
    """Make a film (.mp4, .gif), a picture (.png) or a page for the browser (.html) of a replay file."""

    BOUNDS = {
        "fps": Range(0.0, 100.0, above=True),
        "speed": Range(0.0, 100.0, above=True),
        "width": Range(LEAST_WIDTH, MOST_WIDTH),
        "start": FROM_ZERO,
        "seconds": Range(0.0, above=True),
    }

    file: tyro.conf.Positional[Path]
    """The replay file; nothing in it is executed."""
    out: Path = Path("match.html")
    """The file to write; its ending says what it is: .html, .mp4, .gif or .png."""
    anew: bool = False
    """Write over a file that exists."""
    fps: float | None = None
    """Frames a second of a film; None for 25 in an MP4 and 12.5 in a GIF, or each control step if there are fewer."""
    speed: float = 1.0
    """How many times as fast as real time a film is."""
    width: int = 640
    """Width of a film or a picture [pixels]."""
    start: float = 0.0
    """Where a film begins, or what a picture shows [s since the recording began]."""
    seconds: float | None = None
    """How much of the match a film shows [s]; None for all that follows."""
