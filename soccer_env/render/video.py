"""Frames as a film: MP4 by the ffmpeg of imageio-ffmpeg, GIF by pillow.

A film appears under its name when it is finished; an error or an interrupt leaves no file.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.guards.whole_files import atomic_file
from soccer_env.render import colours
from soccer_env.render.sheet import check_frame

KINDS = (".mp4", ".gif")
HOW = 'pip install "soccer_env[video]"'
MOST_GIF_FRAMES = 1500  # a GIF keeps all its frames in memory, and browsers do the same
GIF_TICK = 100.0  # [1/s] a GIF counts hundredths of a second
GIF_COLOURS = 256
SWATCH = 8  # [px] side of a patch of colour for the choice of the palette
ENCODER = ("-preset", "veryfast", "-crf", "25", "-movflags", "+faststart")  # small, and fast on one core


def video_kind(path: str | os.PathLike[str]) -> str:
    """Return the ending of a film's path; ValueError for a wrong ending, ImportError if its writer is missing."""
    kind = Path(path).suffix.lower()
    if kind not in KINDS:
        raise ValueError(f"the path of a film must end with {' or '.join(KINDS)}, got {str(path)!r}")
    import_video_module(
        "imageio_ffmpeg" if kind == ".mp4" else "PIL.Image", "imageio-ffmpeg" if kind == ".mp4" else "pillow", kind
    )
    return kind


def import_video_module(module: str, name: str, kind: str) -> Any:
    """Return a module of the extra `video`; ImportError says how to install it."""
    try:
        return import_module(module)
    except ImportError as error:
        raise ImportError(f"a film ending with {kind} needs {name}, which is not installed: {HOW}") from error


def gif_rate(fps: float) -> float:
    """Return the rate nearest to `fps` at which a GIF can show frames [1/s]."""
    return GIF_TICK / max(2, round(GIF_TICK / fps))


def write_video(path: str | os.PathLike[str], frames: Iterator[np.ndarray], fps: float, count: int) -> Path:
    """Write `count` frames (H, W, 3) uint8 of one size as an MP4 or GIF, by the path's ending; return the path.

    An odd row or column at the end of a frame is left out of an MP4.
    """
    kind, target = video_kind(path), Path(path)
    if kind == ".gif" and count > MOST_GIF_FRAMES:
        raise ValueError(f"a GIF holds at most {MOST_GIF_FRAMES} frames, this one would have {count}: write an MP4")
    with atomic_file(target, kind) as aside:
        (write_mp4 if kind == ".mp4" else write_gif)(aside, frames, fps)
    return target


def write_mp4(path: Path, frames: Iterator[np.ndarray], fps: float) -> None:
    """Write an MP4 that browsers play: H.264, 4:2:0."""
    ffmpeg = import_video_module("imageio_ffmpeg", "imageio-ffmpeg", ".mp4")
    writer = None
    try:
        for frame in frames:
            check_frame(frame)
            rows, columns = frame.shape[0] // 2 * 2, frame.shape[1] // 2 * 2
            if writer is None:
                settings = {"quality": None, "macro_block_size": 2, "output_params": list(ENCODER)}
                writer = ffmpeg.write_frames(str(path), (columns, rows), fps=fps, ffmpeg_log_level="error", **settings)
                writer.send(None)
            writer.send(np.ascontiguousarray(frame[:rows, :columns]))
    finally:
        if writer is not None:
            writer.close()


def write_gif(path: Path, frames: Iterator[np.ndarray], fps: float) -> None:
    """Write a GIF that repeats for ever, with one palette for all frames."""
    image = import_video_module("PIL.Image", "pillow", ".gif")
    first = next(frames)
    check_frame(first)
    palette = image.fromarray(np.concatenate([first, swatches(first.shape[1])])).quantize(GIF_COLOURS)

    def reduced(frame: np.ndarray) -> Any:
        return image.fromarray(frame).quantize(palette=palette, dither=image.Dither.NONE)

    others = (reduced(frame) for frame in frames)
    duration = round(1000.0 / gif_rate(fps))
    reduced(first).save(path, save_all=True, append_images=others, duration=duration, loop=0, optimize=False)


def swatches(width: int) -> np.ndarray:
    """Return patches of all colours of pictures, in rows of `width` pixels: the first frame lacks some colours."""
    palette: list[tuple[int, int, int]] = []
    for value in vars(colours).values():
        if isinstance(value, tuple) and len(value) == 3 and isinstance(value[0], int):
            palette.append(value)
        elif isinstance(value, tuple) and isinstance(value[0], tuple):
            palette.extend(value)
    row = np.repeat(np.array(palette, np.uint8), SWATCH, axis=0)
    pieces = [np.resize(row[start : start + width], (width, 3)) for start in range(0, len(row), width)]
    return np.repeat(np.stack(pieces), SWATCH, axis=0)
