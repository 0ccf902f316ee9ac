"""What a replay shows: frames, films, pages, data, and what robots thought."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from soccer_env.checking import check_names
from soccer_env.thoughts.thoughts import Notes

if TYPE_CHECKING:
    from soccer_env.replay.replay_file import Replay


class Pictured:
    """What a replay can be looked at by, and taken out as."""

    commands: np.ndarray
    thoughts: dict[str, np.ndarray]

    def notes(self) -> Notes | None:
        """Return what robots thought, None where that was not recorded; ValueError if it is damaged."""
        if not self.thoughts:
            return None
        try:
            return Notes(self.thoughts, self.commands.shape[2])
        except (KeyError, TypeError, RecursionError, OverflowError) as error:
            raise ValueError(f"the thoughts of this replay are damaged: {error!r}") from error

    def video(self: Replay, path: str | Path, *, anew: bool = False, **settings: Any) -> Path:  # type: ignore[misc]
        """Write the first match as a film, MP4 or GIF by the path's ending; return the path. No display is needed.

        settings: fps, speed, width, start, seconds and overlays, as in `film.FilmSettings`. ValueError for a wrong one,
        for a file that exists (unless `anew`), and where the play differs; ImportError if the extra `video` is missing.
        """
        from soccer_env.replay.film import FilmSettings, make_film

        check_names("setting", settings, [item.name for item in fields(FilmSettings)], TypeError)
        return make_film(self, path, FilmSettings(**settings), anew)

    def frame(self: Replay, seconds: float = 0.0, *, width: int = 960, **overlays: Any) -> np.ndarray:  # type: ignore[misc]
        """Return the first match at a time since the recording began as a picture, (H, W, 3) uint8.

        overlays: as in `render.overlays.flags.OverlayFlags`: belief=True, robot="home_1" and so on. ValueError for a
        wrong one, for a time that is not in the replay, and where the play differs.
        """
        from soccer_env.render.overlays.flags import OverlayFlags
        from soccer_env.replay.film import FilmSettings, film_frames

        check_names("overlay", overlays, [item.name for item in fields(OverlayFlags)], TypeError)
        return next(film_frames(self, FilmSettings(start=seconds, width=width, **overlays), ".png")[1])

    def html(self: Replay, path: str | Path, *, anew: bool = False, **overlays: Any) -> Path:  # type: ignore[misc]
        """Write the first match as one page for any browser, no network needed; return the path.

        overlays: what the page shows at first, as in `frame`. ValueError for a wrong one, for a file that exists
        (unless `anew`), and where the play differs.
        """
        from soccer_env.render.overlays.flags import OverlayFlags
        from soccer_env.replay.browser import write_page

        check_names("overlay", overlays, [item.name for item in fields(OverlayFlags)], TypeError)
        return write_page(self, path, anew, flags=OverlayFlags(**overlays) if overlays else None)

    def to_kloppy(self: Replay) -> Any:  # type: ignore[misc]
        """Return the first match as a kloppy TrackingDataset in metres; ImportError if the extra `data` is missing."""
        from soccer_env.data_out.collect import collect
        from soccer_env.data_out.kloppy_data import require_kloppy, tracking_dataset

        require_kloppy()
        return tracking_dataset(collect(self))

    def to_kloppy_events(self: Replay) -> Any:  # type: ignore[misc]
        """Return the first match as a kloppy EventDataset: passes, shots, interceptions, saves, fouls, calls."""
        from soccer_env.data_out.collect import collect
        from soccer_env.data_out.kloppy_data import event_dataset, require_kloppy

        require_kloppy()
        return event_dataset(collect(self))
