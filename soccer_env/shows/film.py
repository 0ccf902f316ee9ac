"""A replay as a film: the control steps that are drawn, and the times at which they are shown."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.render.colours import PANEL
from soccer_env.render.frame import LEAST_WIDTH, Picture
from soccer_env.render.header import bar_height
from soccer_env.render.overlays.flags import select_flags
from soccer_env.render.overlays.layers import make_overlays
from soccer_env.render.overlays.onlooker import ReplaySnapshots, new_past_queue
from soccer_env.render.video import gif_rate, video_kind, write_video
from soccer_env.render.view import view_of
from soccer_env.shows.film_settings import FilmSettings

if TYPE_CHECKING:
    from soccer_env.replay.replay_file import Replay

SMOOTH = {".mp4": 25.0, ".gif": 12.5, ".png": 25.0}  # [1/s] frames, unless there are fewer control steps


def drawn_steps(settings: FilmSettings, kind: str, rate: int, steps: int) -> tuple[np.ndarray, float]:
    """Return the control step (N,) that each frame shows, in ascending order, and the frame rate [1/s]."""
    fps = min(SMOOTH[kind], rate * settings.speed) if settings.fps is None else settings.fps
    fps = gif_rate(fps) if kind == ".gif" else fps
    length = steps / rate
    if settings.start > length:
        raise ValueError(f"start must be at most {length:g}, the length of the replay in seconds, got {settings.start}")
    last = length if settings.seconds is None else min(length, settings.start + settings.seconds)
    count = int((last - settings.start) * fps / settings.speed + 1e-6) + 1
    times = settings.start + np.arange(count) * settings.speed / fps
    return np.minimum(np.rint(times * rate).astype(np.int64), steps), fps


def make_film(
    replay: Replay, path: str | os.PathLike[str], settings: FilmSettings, anew: bool = False,
    note: Callable[[int], None] | None = None,
) -> Path:  # fmt: skip
    """Write the first match of a replay as a film; `note` is called after each frame. See `showing.video`."""
    kind = video_kind(path)
    check_overwrite(path, anew)
    count, frames, fps = film_frames(replay, settings, kind, note)
    return write_video(path, frames, fps, count)


def film_frames(
    replay: Replay, settings: FilmSettings, kind: str, note: Callable[[int], None] | None = None
) -> tuple[int, Iterator[np.ndarray], float]:
    """Return the number of frames of a film, the frames (H, W, 3) uint8, and their rate [1/s]."""
    flags = select_flags(settings)
    reel = ReplaySnapshots(replay, flags.any)
    league = reel.cast.league
    steps, fps = drawn_steps(settings, kind, league.control_rate, len(replay))
    picture = Picture(league, widest_picture(league, settings.width, settings.height))
    reel.cast.selected_row(flags, reel.first)

    def frames() -> Iterator[np.ndarray]:
        shots, past, at = reel.shots(), new_past_queue(reel.cast), -1
        frame = np.zeros(0)
        for step in steps.tolist():
            if step > at:
                for shot in islice(shots, step - at):
                    past.append(shot)
                at = step
                overlays = make_overlays(flags, reel.cast, past[-1], list(past)[:-1], picture.width)
                drawn = picture.draw(*past[-1][:3], title=replay.teams, overlays=overlays)
                high, wide = drawn.shape[:2]
                frame = np.full((settings.height or high, settings.width, 3), PANEL, np.uint8)
                top, left = (len(frame) - high) // 2, (settings.width - wide) // 2
                frame[top : top + high, left : left + wide] = drawn
            yield frame
            if note is not None:
                note(1)

    return len(steps), frames(), fps


def widest_picture(league: League, width: int, height: int | None) -> int:
    """Return the width [px] of the largest picture that fits into a width and a height; ValueError if none does."""
    for wide in range(width, LEAST_WIDTH - 1, -1):
        if height is None or bar_height(wide) + view_of(league.pitch, wide)[1] <= height:
            return wide
    raise ValueError(f"a picture of {league.name} does not fit into a height of {height} pixels")


def check_overwrite(path: str | os.PathLike[str], anew: bool) -> None:
    """Raise ValueError if the path is a folder, or a file that must not be overwritten."""
    if Path(path).is_dir():
        raise ValueError(f"{os.fspath(path)} is a folder, not the file to write")
    if Path(path).exists() and not anew:
        raise ValueError(f"{os.fspath(path)} exists already; give another path or anew=True")
