"""The settings of `soccer watch`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import tyro

from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.train.evaluate.play_settings import PlaySettings


@dataclass(frozen=True)
class WatchSettings(OverlayFlags, PlaySettings):
    """Show a match in a window (needs pygame-ce): a replay FILE, or one that is played now as the options say.

    Space pauses, comma and full stop step, left and right go 5 s, up and down change the speed, Home goes to the
    start, H shows all keys (overlays have one each), Escape ends.
    """

    file: tyro.conf.Positional[Path | None] = None
    """A replay file to show; None: a match is played."""
    width: int = 960
    """Width of the picture [pixels]."""
    speed: float = 1.0
    """How many times as fast as real time, above 0."""
    follow: Literal["", "robot", "ball"] = ""
    """Whom the picture goes near to and follows: the robot that is looked into, or the ball."""
