"""The settings of a film, which `soccer export` has as options."""

from __future__ import annotations

from dataclasses import dataclass

from soccer_env.guards.checking import ABOVE_ZERO, FROM_ZERO, Range
from soccer_env.render.frame import LEAST_WIDTH, MOST_WIDTH
from soccer_env.render.overlays.flags import OverlayFlags


@dataclass(frozen=True, kw_only=True)
class FilmSettings(OverlayFlags):
    """How a film shows a replay, with its overlays."""

    BOUNDS = {
        "fps": Range(0.0, 100.0, above=True), "speed": Range(0.0, 100.0, above=True),
        "width": (LEAST_WIDTH, MOST_WIDTH), "height": (LEAST_WIDTH, MOST_WIDTH),
        "start": FROM_ZERO, "seconds": ABOVE_ZERO,
    }  # fmt: skip

    fps: float | None = None
    """Frames per second of a film; leave out for 25, of a GIF 12.5, or the control rate if lower."""
    speed: float = 1.0
    """Speed of a film, as a multiple of real time."""
    width: int = 640
    """Width of a film or picture [pixels]."""
    height: int | None = None
    """Height of a film or picture [pixels], with bars; leave out for that of the pitch."""
    start: float = 0.0
    """Time at which a film begins, or that a picture shows [s from the start of the recording]."""
    seconds: float | None = None
    """Length of play that a film shows [s]; leave out for the rest of the match."""
