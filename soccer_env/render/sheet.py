"""Frames as PNG, on disk or in memory, and several frames in one picture."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from os import PathLike, fspath
from pathlib import Path

import numpy as np

from soccer_env.guards.whole_files import write_atomically
from soccer_env.render.canvas import require_pygame
from soccer_env.render.colours import PANEL


def check_frame(frame: np.ndarray) -> None:
    """Raise ValueError unless the frame is an (H, W, 3) array of uint8."""
    shape, kind = np.shape(frame), getattr(frame, "dtype", type(frame).__name__)
    if kind != np.uint8 or len(shape) != 3 or shape[2] != 3 or 0 in shape:
        raise ValueError(f"a frame must be uint8 of shape (H, W, 3), got {kind} of shape {shape}")


def save_png(frame: np.ndarray, path: str | PathLike[str]) -> None:
    """Write a frame to a PNG file, whole or not at all."""
    content = png_of_frame(frame)
    if not fspath(path).lower().endswith(".png"):
        raise ValueError(f"the path of a picture must end with .png, got {fspath(path)!r}")
    write_atomically(Path(path), content)


def png_of_frame(frame: np.ndarray) -> bytes:
    """Return a frame as the bytes of a PNG file."""
    require_pygame()
    import pygame

    check_frame(frame)
    held, size = BytesIO(), (frame.shape[1], frame.shape[0])
    pygame.image.save(pygame.image.frombuffer(np.ascontiguousarray(frame).tobytes(), size, "RGB"), held, "frame.png")
    return held.getvalue()


def contact_sheet(frames: Sequence[np.ndarray], columns: int = 3, gap: int = 8) -> np.ndarray:
    """Return one picture of many frames of equal size, row by row, (H, W, 3) uint8, `gap` pixels apart."""
    if not len(frames):
        raise ValueError("a contact sheet needs at least one frame, got none")
    if columns < 1 or gap < 0:
        raise ValueError(f"columns must be at least 1 and gap at least 0, got {columns} and {gap}")
    for frame in frames:
        check_frame(frame)
        if frame.shape != frames[0].shape:
            raise ValueError(f"frames of a contact sheet must have one size, got {frames[0].shape} and {frame.shape}")
    high, wide = frames[0].shape[0] + gap, frames[0].shape[1] + gap
    columns = min(columns, len(frames))
    rows = -(-len(frames) // columns)
    sheet = np.full((rows * high + gap, columns * wide + gap, 3), PANEL, np.uint8)
    for index, frame in enumerate(frames):
        top, left = gap + index // columns * high, gap + index % columns * wide
        sheet[top : top + frame.shape[0], left : left + frame.shape[1]] = frame
    return sheet
