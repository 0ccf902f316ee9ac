"""A sheet with the drills of each league: a start of each, its name and what it is.

python -m soccer_env.train.pages.pictures.drills
"""

from pathlib import Path
from textwrap import wrap

import numpy as np

from soccer_env.match import Match
from soccer_env.render import Picture, contact_sheet, save_png
from soccer_env.scenes import Scene
from soccer_env.train.casting import sizes_of
from soccer_env.train.evaluate.drills import drills_of
from soccer_env.train.pages.pictures.legend import add_words
from soccer_env.train.pages.pictures.settings import FOLDER

LEAGUES = {"drills-legged.png": "legged-2001", "drills-middle-size.png": "middle-size-2006"}
COLUMNS, WIDTH = 4, 300  # [px] of a drill
LINE, LINES = 60, 3  # letters in a line of words; lines under each picture
SEED = 4


def drill_frame(league: str, scene: Scene) -> np.ndarray:
    """Return the drawing of a drill's start, (H, W, 3) uint8, over its name and description."""
    home, away = sizes_of(scene)
    match = Match(league, home=home, away=away, scene=scene, seed=SEED)
    picture = Picture(match.league, WIDTH)
    frame = picture.draw(match.matches[0], match.balls[0], match.robots[0])[picture.header_height :]
    return add_words(frame, [scene.name, *wrap(scene.description, LINE)], LINES)


def write_drills(out: Path = FOLDER) -> None:
    """Write the sheet of each league into a folder."""
    for name, league in LEAGUES.items():
        save_png(contact_sheet([drill_frame(league, scene) for scene in drills_of(league)], COLUMNS), out / name)


if __name__ == "__main__":
    write_drills()
