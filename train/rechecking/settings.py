"""The settings of `soccer recheck`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import tyro

from soccer_env.checking import Range
from soccer_env.train.written_settings import CommandSettings

ALL = "all"  # pairs: every finished one


@dataclass(frozen=True)
class RecheckSettings(CommandSettings):
    """Play a random sample of an evaluation's finished pairs again and compare every line bit for bit.

    Ends with exit code 1 if a line differs, and names the pair, the match and the fields. No file is changed, and no
    code that the folder names is run: what is MODULE:NAME has to be said once more.
    """

    BOUNDS = {"pairs": Range(1)}

    folder: tyro.conf.Positional[Path]
    """The folder of an evaluation (`soccer evaluate --out`), finished or not."""
    pairs: int | Literal["all"] = 5
    """Pairs to play again, drawn at random from those that are finished; `all` for every one of them."""
    seed: int | None = None
    """Seed of that draw; None for one that nobody knows before, which is said."""
    threads: int = 1
    """Threads that share the matches."""
    home: str = ""
    """Where the first team is to be had now: another path of the same policy file, or the same MODULE:NAME."""
    away: str = ""
    """The same for the second team."""
    league: str = ""
    """The league, where it was MODULE:NAME."""
    scene: str = ""
    """The scene, where it was MODULE:NAME."""
    json: bool = False
    """Print what was found as JSON."""
