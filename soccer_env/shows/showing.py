"""A replay as one picture, as a film, as a page for the browser."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.guards.checking import check_names
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.replay import Replay
from soccer_env.shows.browser import write_page
from soccer_env.shows.film import film_frames, make_film
from soccer_env.shows.film_settings import FilmSettings


def video(replay: Replay, path: str | Path, *, anew: bool = False, **settings: Any) -> Path:
    """Write the first match of a replay as a film, MP4 or GIF by the path's ending; return the path.

    settings: fps, speed, width, height, start, seconds and overlays, as in `film_settings.FilmSettings`. ValueError for
    a wrong setting, for an existing file (unless `anew`), and if the play differs; ImportError if the extra `video` is
    missing. Needs no display.
    """
    check_names("setting", settings, [item.name for item in fields(FilmSettings)], TypeError)
    return make_film(replay, path, FilmSettings(**settings), anew)


def frame(
    replay: Replay, seconds: float = 0.0, *, width: int = 960, height: int | None = None, **overlays: Any
) -> np.ndarray:
    """Return a picture (H, W, 3) uint8 of the first match of a replay, some seconds after the recording began.

    height: as in `film_settings.FilmSettings`. overlays: as in `render.overlays.flags.OverlayFlags`: belief=True,
    robot="home_1" and so on. ValueError for an unknown overlay, for a time outside the replay, and if the play differs.
    """
    check_names("overlay", overlays, [item.name for item in fields(OverlayFlags)], TypeError)
    settings = FilmSettings(start=seconds, width=width, height=height, **overlays)
    return next(film_frames(replay, settings, ".png")[1])


def html(replay: Replay, path: str | Path, *, anew: bool = False, **overlays: Any) -> Path:
    """Write the first match of a replay as one page for any browser, without network; return the path.

    overlays: shown when the page opens, as in `frame`. ValueError for an unknown overlay, for an existing file
    (unless `anew`), and if the play differs.
    """
    check_names("overlay", overlays, [item.name for item in fields(OverlayFlags)], TypeError)
    return write_page(replay, path, anew, flags=OverlayFlags(**overlays) if overlays else None)
