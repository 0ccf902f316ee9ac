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
    """Make a film, a page for the browser, data or pictures of a replay.

    .mp4, .gif   a film
    .html        a page for the browser
    .csv, .parquet   tidy tables: a row for each frame and object, and NAME_events with a row for each event
    .cdf         the Common Data Format: a folder of JSON and JSON lines
    .xml         tracking data of the German league (DFL, Sportec), which kloppy reads
    .png         one picture of the match

    With --maps, .png, .svg and .pdf show heat maps, pass networks and shot maps, also of a result.json.
    """

    BOUNDS = {
        "fps": Range(0.0, 100.0, above=True),
        "speed": Range(0.0, 100.0, above=True),
        "width": Range(LEAST_WIDTH, MOST_WIDTH),
        "start": FROM_ZERO,
        "seconds": Range(0.0, above=True),
    }

    file: tyro.conf.Positional[Path]
    """The replay file, nothing in it is executed, or a folder of them; for maps also a result.json."""
    out: Path = Path("match.html")
    """The file to write; its ending says what it is. Of a folder all but tables are one file a match, NAME_MATCH."""
    maps: bool = False
    """Draw heat maps, pass networks and shot maps, into .png, .svg or .pdf."""
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
