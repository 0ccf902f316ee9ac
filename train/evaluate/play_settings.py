"""The settings of `soccer record`, `replay` and `export`, and of any command that plays a match."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import tyro

from soccer_env.shows.film_settings import FilmSettings
from soccer_env.train.written_settings import CommandSettings, split_players


@dataclass(frozen=True)
class PlaySettings(CommandSettings):
    """A match or a drill between two teams."""

    league: str = "legged-2001"
    """League to play in; `soccer list leagues` names them."""
    scene: str = "kick-off"
    """How the match begins; `soccer list scenes` names all scenes. A drill ends by its own test or time limit."""
    episode: Literal["match", "goal", "drill"] | None = None
    """When the match ends: by the clock, at the first goal, or by the test of a drill; leave out for the scene's
    default."""
    home: str | None = None
    """Home team: a name of `soccer list teams`, NAME@STRENGTH or a policy file; leave out for chaser, or the team that
    the scene is meant for."""
    away: str | None = None
    """Away team, written like --home."""
    minutes: float | None = None
    """Minutes of play, both halves together; leave out for 1. A drill has its own time limit."""
    players: int | str | None = None
    """Players a side, 1 to 11; 3v5 gives home 3 and away 5; leave out for the league's own number, or the drill's."""
    seed: int = 0
    """Seed of the match, 0 or more."""
    rules: str | None = None
    """Rule set: league, simple or none; league:pushing=False,holding_time=5 changes single rules. Leave out for the
    league's rules, or the drill's."""
    placement: Literal["instant", "drive"] = "instant"
    """How robots reach their places at a restart."""
    senses: Literal["sensors", "ideal"] = "sensors"
    """What fills the teams' beliefs: their sensors, or the truth."""
    pose: Literal["particles", "percept"] = "particles"
    """How robots with sensors know where they are: by a particle filter, or by a given noisy pose (percept)."""

    def __post_init__(self) -> None:
        split_players(self.players, 1)
        super().__post_init__()


@dataclass(frozen=True)
class RecordSettings(PlaySettings):
    """Play a match or a drill and write it to a replay file."""

    out: Path = Path("match.replay")
    """Replay file to write."""


@dataclass(frozen=True)
class ReplaySettings(CommandSettings):
    """Play a replay file again and check every step."""

    file: tyro.conf.Positional[Path]
    """Replay file; it holds no code."""
    verify: bool = False
    """Check the hash of every step; the command always does this."""


@dataclass(frozen=True)
class ExportSettings(FilmSettings, CommandSettings):
    """Make a film, a browser page, data or pictures from a replay.

    .mp4, .gif   a film
    .html        a page for the browser (the default, named after the replay)
    .csv, .parquet   tidy tables: a row for each frame and object, and NAME_events with a row for each event
    .cdf         the Common Data Format: a folder of JSON and JSON lines
    .png         one picture of the match

    With --maps, .png, .svg and .pdf show heat maps, pass networks and shot maps, also from a result.json.
    With --beliefs, tables have NAME_beliefs as well, and .png and .svg show errors against range and age.
    """

    file: tyro.conf.Positional[Path]
    """Replay file, or a folder of replays; with --maps also a result.json. A replay holds no code."""
    out: Path | None = None
    """File to write; its ending chooses the format. Leave out for a page named after the replay. From a folder of
    replays, one file per match, NAME_MATCH; but tables hold all matches in one file."""
    maps: bool = False
    """Draw heat maps, pass networks and shot maps: .png, .svg or .pdf."""
    beliefs: bool = False
    """Write what robots believed, beside the truth: tables, .png or .svg."""
    anew: bool = False
    """Overwrite an existing file."""

    @property
    def target(self) -> Path:
        """Return the file to write: `out`, or by default a page (of maps or beliefs a picture) named as the replay."""
        return self.out or Path(self.file.resolve().stem + (".png" if self.maps or self.beliefs else ".html"))

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.maps and self.beliefs:
            raise ValueError("give maps or beliefs, not both")
