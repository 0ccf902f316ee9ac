"""The settings of `soccer record`, `replay` and `export`, and of a match that is played."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import tyro

from soccer_env.guards.checking import FROM_ZERO, Range
from soccer_env.render.frame import LEAST_WIDTH, MOST_WIDTH
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.train.written_settings import CommandSettings, split_players


@dataclass(frozen=True)
class PlaySettings(CommandSettings):
    """A match or a drill between two teams."""

    league: str = "legged-2001"
    """League to play in; `soccer list leagues` names them."""
    scene: str = "kick-off"
    """How it begins; `soccer list scenes` names them. A drill ends as it is decided, or when its time is up."""
    episode: Literal["match", "goal", "drill"] | None = None
    """What ends it: the clock of a match, its first goal, or the test of a drill; None for that of the
    scene, if it is a drill."""
    home: str | None = None
    """The team that plays at home: a name of `soccer list teams`, or NAME@STRENGTH; None for chaser, or
    the one that the scene is meant for."""
    away: str | None = None
    """The team that plays away, in the same way."""
    minutes: float | None = None
    """Minutes of play, both halves together; None for 1. A drill has a limit of its own."""
    players: int | str | None = None
    """Players a side, 1 to 11; 3v5 gives home 3 and away 5; None for the league's own number, or the drill's."""
    seed: int = 0
    """Seed of the match, 0 or more."""
    rules: str | None = None
    """Which rules are called: league, simple or none; league:pushing=False,holding_time=5 changes one by name. None for
    the league's, or those of the drill."""
    placement: Literal["instant", "drive"] = "instant"
    """How robots reach their places at a restart."""
    senses: Literal["sensors", "ideal"] = "sensors"
    """What fills the teams' beliefs: their sensors, or the truth."""
    pose: Literal["particles", "percept"] = "particles"
    """How robots that use their sensors know where they are: a particle filter, or a noisy pose that is given."""

    def __post_init__(self) -> None:
        split_players(self.players, 1)
        super().__post_init__()


@dataclass(frozen=True)
class RecordSettings(PlaySettings):
    """Play a match or a drill and write it to a replay file."""

    out: Path = Path("match.replay")
    """The file to write."""


@dataclass(frozen=True)
class ReplaySettings(CommandSettings):
    """Play a replay file again and check every step."""

    file: tyro.conf.Positional[Path]
    """The file; nothing in it is executed."""
    verify: bool = False
    """Prove the hash of every step: what this command does anyway."""


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
