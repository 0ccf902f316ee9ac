"""The settings of `soccer watch`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import tyro

from soccer_env.guards.checking import FROM_ZERO
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.train.evaluate.play_settings import PlaySettings


@dataclass(frozen=True)
class WatchSettings(OverlayFlags, PlaySettings):
    """Show a match in a window (needs pygame-ce): a replay FILE, or a new match with the given options.

    Space pauses, comma and full stop step, left and right jump 5 s, up and down change the speed, Home returns to the
    start, H shows all keys (each overlay has one), Escape quits.
    """

    BOUNDS = {"start": FROM_ZERO}
    BASIC = "infrared"  # the last option that --help shows

    file: tyro.conf.Positional[Path | None] = None
    """Replay file to show; leave out to play a new match."""
    width: int = 960
    """Width of the picture [pixels]."""
    start: float = 0.0
    """Time at which to start [s from the kick-off, or from the start of the recording]."""
    speed: float = 1.0
    """Speed as a multiple of real time, above 0."""
    follow: Literal["", "robot", "ball"] = ""
    """Zoom in on the robot of --robot, or on the ball, and follow it; "" shows the whole pitch."""
