"""The settings of `soccer play`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from soccer_env.guards.checking import Range
from soccer_env.train.evaluate.play_settings import PlaySettings

SLOWEST, FASTEST = 1 / 16, 4.0  # [1] times real time, that a person can play at


@dataclass(frozen=True)
class PersonSettings(PlaySettings):
    """Play in a match or a drill yourself, by keyboard or gamepad, in a window (needs pygame-ce).

    W A S D or the arrows drive, Q and E turn, space kicks, Tab takes the next robot, H shows all keys, Escape quits.
    The other robots of your team are played by the team that --home (or --away) names.
    """

    BOUNDS = {"speed": Range(SLOWEST, FASTEST)}

    person: str = "home"
    """Who you are: home or away, a whole team of which you steer one robot after another; or one robot, as home_1."""
    view: Literal["truth", "belief"] = "truth"
    """What you see: the truth, or only what your robot believes."""
    drive: Literal["robot", "pitch"] = "robot"
    """What the keys of driving mean: ahead and left of the robot, as its commands do; or directions on the pitch as you
    see it, into which the robot turns by itself."""
    out: Path | None = None
    """Replay file to write; leave out to keep none."""
    speed: float = 1.0
    """Speed at the start as a multiple of real time; keys change it."""
    width: int = 960
    """Width of the picture [pixels]."""
