"""The strip under a picture: a legend, or lines of words."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from soccer_env.render.canvas import Canvas, new_surface
from soccer_env.render.colours import DIM, PANEL, WHITE, Colour

LETTERS = 0.026  # of the width: they are legible in a picture shown 480 px wide
ROW = 0.042  # of the width
WORDS = 0.043  # of the width, letters of `add_words`


class Entry(NamedTuple):
    """An entry of a legend: a colour of the picture, and its meaning."""

    colour: Colour
    words: str


def add_legend(frame: np.ndarray, entries: Sequence[Entry], columns: int = 2) -> np.ndarray:
    """Return a frame (H, W, 3) uint8 with a strip under it that explains its colours."""
    width = frame.shape[1]
    row = ROW * width
    canvas = strip(width, row * (-(-len(entries) // columns)) + 0.4 * row)
    for index, entry in enumerate(entries):
        left = width * (0.02 + index % columns / columns)
        middle = row * (0.7 + index // columns)
        canvas.disc((left + 0.55 * row, middle), 0.3 * row, entry.colour)
        canvas.text(
            entry.words, (left + 1.35 * row, middle), LETTERS * width, WHITE, "left", width * (1.0 / columns - 0.07)
        )
    return add_strip(frame, canvas)


def add_words(frame: np.ndarray, lines: Sequence[str], room: int) -> np.ndarray:
    """Return a frame (H, W, 3) uint8 with a strip under it that has room for lines of words, the first a title."""
    width = frame.shape[1]
    size = WORDS * width
    canvas = strip(width, 1.5 * size * room + 0.5 * size)
    for index, line in enumerate(lines):
        left, middle = 0.02 * width, size * (1.0 + 1.5 * index)
        canvas.text(line, (left, middle), size, WHITE if index == 0 else DIM, "left", 0.97 * width)
    return add_strip(frame, canvas)


def strip(width: int, height: float) -> Canvas:
    """Return an empty strip of a picture, of an even height [px]."""
    canvas = Canvas(new_surface(width, 2 * round(height / 2)))
    canvas.fill(PANEL)
    return canvas


def add_strip(frame: np.ndarray, canvas: Canvas) -> np.ndarray:
    """Return a frame (H, W, 3) uint8 with the strip under it."""
    import pygame

    canvas.shrink()
    pixels = np.frombuffer(pygame.image.tobytes(canvas.small, "RGB"), np.uint8)
    return np.concatenate([frame, pixels.reshape(-1, frame.shape[1], 3)])
