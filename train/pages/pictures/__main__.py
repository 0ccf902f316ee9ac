"""Make the pictures of the pages: see the package's docstring."""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from soccer_env import Match
from soccer_env.render import Picture, contact_sheet, save_png
from soccer_env.render.frame import LEAST_WIDTH
from soccer_env.train.evaluate.exporting import export
from soccer_env.train.evaluate.play_settings import ExportSettings, RecordSettings
from soccer_env.train.evaluate.recording import record
from soccer_env.train.pages.pictures import rules_legged, rules_middle_size
from soccer_env.train.pages.pictures.belief import belief_picture
from soccer_env.train.pages.pictures.drills import write_drills
from soccer_env.train.pages.pictures.frames import frames_picture
from soccer_env.train.pages.pictures.play import play_picture
from soccer_env.train.pages.pictures.rules import rules_sheet, ruling_frame
from soccer_env.train.pages.pictures.settings import FOLDER, MOMENTS, RULING_WIDTH, WIDTH


def make_pictures(out: Path = FOLDER) -> None:
    """Write the pictures of beliefs, frames and play, the sheets of rules and drills, and the recorded moments."""
    save_png(belief_picture(), out / "belief.png")
    save_png(frames_picture(), out / "frames.png")
    save_png(play_picture(), out / "play.png")
    save_png(rules_sheet(rules_legged.RULINGS, RULING_WIDTH), out / "rules-legged.png")
    save_png(rules_sheet(rules_middle_size.RULINGS, RULING_WIDTH), out / "rules-middle-size.png")
    save_png(ruling_frame(rules_legged.RULINGS[0], WIDTH), out / "ruling.png")
    save_png(many_matches(), out / "many.png")
    write_drills(out)
    with TemporaryDirectory() as folder:
        for moment in MOMENTS:
            file = Path(folder, f"{moment.name}.replay")
            record(RecordSettings(**moment.recorded, out=file))
            export(ExportSettings(file=file, out=out / moment.name, anew=True, **moment.shown))


def many_matches() -> np.ndarray:
    """Return one picture, (H, W, 3) uint8, of twelve matches of a batch."""
    match = Match(matches=12, seed=1, controllers={"home": "chaser", "away": "chaser"}, home=1, away=1)
    for _ in range(160):
        match.step()
    picture = Picture(match.league, LEAST_WIDTH)
    frames = [picture.draw(*each)[picture.header_height :] for each in zip(match.matches, match.balls, match.robots)]
    return contact_sheet(frames, 4)


if __name__ == "__main__":
    make_pictures()
