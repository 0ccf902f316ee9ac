"""Matches recorded and exported as the commands under the pictures do it: `soccer record`, then `soccer export`."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

from soccer_env.train.evaluate.exporting import export
from soccer_env.train.evaluate.play_settings import ExportSettings, RecordSettings
from soccer_env.train.evaluate.recording import record


class Moment(NamedTuple):
    """A picture or film: its file, what is recorded, and what is shown of it."""

    name: str
    recorded: dict[str, Any]
    shown: dict[str, Any]


MOMENTS = (
    Moment(
        "field.png",
        {"league": "legged-2001", "home": "sacks-2001", "away": "chaser", "minutes": 0.5, "seed": 3},
        {"start": 12.0, "width": 960, "robot": "home_1", "belief": True, "field": True, "path": True, "roles": True},
    ),
    Moment(
        "middle-size.gif",
        {"league": "middle-size-2006", "home": "heinemann-2006", "away": "weigel-2001", "minutes": 1.0, "seed": 3},
        {"start": 14.0, "seconds": 12.0, "speed": 2.0, "width": 480, "path": True, "trail": True},
    ),
)


def write_moments(out: Path) -> None:
    """Write every picture and film into a folder, over those that are there."""
    with TemporaryDirectory() as folder:
        for moment in MOMENTS:
            file = Path(folder, f"{moment.name}.replay")
            record(RecordSettings(**moment.recorded, out=file))
            export(ExportSettings(file=file, out=out / moment.name, anew=True, **moment.shown))
