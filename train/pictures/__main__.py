"""Make the pictures of the pages: see the package's docstring."""

from __future__ import annotations

import tyro

from soccer_env.render import save_png
from soccer_env.train.pictures import rules_legged, rules_middle_size
from soccer_env.train.pictures.animation import frames_of, write_gif
from soccer_env.train.pictures.belief import belief_picture
from soccer_env.train.pictures.frames import frames_picture
from soccer_env.train.pictures.moments import write_moments
from soccer_env.train.pictures.rules import rules_sheet
from soccer_env.train.pictures.settings import PictureSettings


def make_pictures(settings: PictureSettings) -> None:
    """Write match.gif, belief.png, frames.png, the sheets of rules and recorded moments into the folder."""
    settings.out.mkdir(parents=True, exist_ok=True)
    write_gif(frames_of(settings), settings.out / "match.gif", settings.frame_time, settings.last_time)
    save_png(belief_picture(settings), settings.out / "belief.png")
    save_png(frames_picture(settings), settings.out / "frames.png")
    save_png(rules_sheet(rules_legged.RULINGS, settings.ruling_width), settings.out / "rules-legged.png")
    save_png(rules_sheet(rules_middle_size.RULINGS, settings.ruling_width), settings.out / "rules-middle-size.png")
    write_moments(settings.out)


if __name__ == "__main__":
    make_pictures(tyro.cli(PictureSettings))
