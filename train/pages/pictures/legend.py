"""The legend under a picture."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from soccer_env.render.canvas import Canvas, new_surface
from soccer_env.render.colours import PANEL, WHITE, Colour

LETTERS = 0.026  # of the width: they are legible in a picture shown 480 px wide
ROW = 0.042  # of the width


class Entry(NamedTuple):
    """An entry of a legend: a colour of the picture, and its meaning."""

    colour: Colour
    words: str


def add_legend(frame: np.ndarray, entries: Sequence[Entry], columns: int = 2) -> np.ndarray:
    """Return a frame (H, W, 3) uint8 with a strip under it that explains its colours."""
    import pygame

    width = frame.shape[1]
    row = ROW * width
    height = 2 * round((row * (-(-len(entries) // columns)) + 0.4 * row) / 2)
    surface = new_surface(width, height)
    canvas = Canvas(surface)
    canvas.fill(PANEL)
    for index, entry in enumerate(entries):
        left = width * (0.02 + index % columns / columns)
        middle = row * (0.7 + index // columns)
        canvas.disc((left + 0.55 * row, middle), 0.3 * row, entry.colour)
        canvas.text(
            entry.words, (left + 1.35 * row, middle), LETTERS * width, WHITE, "left", width * (1.0 / columns - 0.07)
        )
    canvas.shrink()
    pixels = np.frombuffer(pygame.image.tobytes(surface, "RGB"), np.uint8).reshape(height, width, 3)
    return np.concatenate([frame, pixels])
