"""Make the pictures of the pages: see the package's docstring."""

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import tyro

from soccer_env.render import save_png
from soccer_env.train.evaluate.exporting import export
from soccer_env.train.evaluate.play_settings import ExportSettings, RecordSettings
from soccer_env.train.evaluate.recording import record
from soccer_env.train.pages.pictures import rules_legged, rules_middle_size
from soccer_env.train.pages.pictures.belief import belief_picture
from soccer_env.train.pages.pictures.frames import frames_picture
from soccer_env.train.pages.pictures.rules import rules_sheet
from soccer_env.train.pages.pictures.settings import PictureSettings


def make_pictures(settings: PictureSettings) -> None:
    """Write belief.png, frames.png, the sheets of rules and the recorded moments into the folder."""
    settings.out.mkdir(parents=True, exist_ok=True)
    save_png(belief_picture(settings), settings.out / "belief.png")
    save_png(frames_picture(settings), settings.out / "frames.png")
    save_png(rules_sheet(rules_legged.RULINGS, settings.ruling_width), settings.out / "rules-legged.png")
    save_png(rules_sheet(rules_middle_size.RULINGS, settings.ruling_width), settings.out / "rules-middle-size.png")
    write_moments(settings.out)


class Moment(NamedTuple):
    """A picture or film: its file, what is recorded, and what is shown of it."""

    name: str
    recorded: dict[str, Any]
    shown: dict[str, Any]


MOMENTS = (
    Moment(
        "match.gif",
        {"home": "chaser", "away": "sacks-2001", "seed": 78, "minutes": 20.0, "episode": "goal"},
        {"width": 720, "speed": 4.0},
    ),
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


if __name__ == "__main__":
    make_pictures(tyro.cli(PictureSettings))
