"""The legend under a picture."""

from collections.abc import Sequence
from math import atan2, cos, sin
from typing import NamedTuple

import numpy as np

from soccer_env.render.canvas import Canvas, new_surface
from soccer_env.render.colours import FLOOR, PANEL, WHITE, Colour

LETTERS = 0.026  # of the width: they are legible in a picture shown 480 px wide
ROW = 0.042  # of the width


class Entry(NamedTuple):
    """An entry of a legend: a sign, as in the picture, and its meaning."""

    sign: str  # "ring", "box", "axes", "polar" or "area"
    colour: Colour
    words: str


def add_legend(frame: np.ndarray, entries: Sequence[Entry], columns: int = 2) -> np.ndarray:
    """Return a frame (H, W, 3) uint8 with a strip under it that explains its signs."""
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
        draw_sign(canvas, entry, left + 0.55 * row, middle, 0.3 * row)
        canvas.text(
            entry.words, (left + 1.35 * row, middle), LETTERS * width, WHITE, "left", width * (1.0 / columns - 0.07)
        )
    canvas.shrink()
    pixels = np.frombuffer(pygame.image.tobytes(surface, "RGB"), np.uint8).reshape(height, width, 3)
    return np.concatenate([frame, pixels])


def draw_sign(canvas: Canvas, entry: Entry, x: float, y: float, radius: float) -> None:
    """Draw a sign with its middle at (x, y) [px]."""
    line = max(2.0, radius / 4)
    if entry.sign == "ring":
        canvas.ring((x, y), radius, line, entry.colour)
    elif entry.sign == "box":
        corners = [(x - 1.3 * radius, y - radius), (x + 1.3 * radius, y - radius)]
        corners += [(x + 1.3 * radius, y + radius), (x - 1.3 * radius, y + radius)]
        for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
            canvas.stroke(start, end, line, entry.colour)
    elif entry.sign == "axes":
        corner = (x - 0.8 * radius, y + 0.8 * radius)
        for end in ((x + 1.3 * radius, y + 0.8 * radius), (x - 0.8 * radius, y - 1.2 * radius)):
            canvas.stroke(corner, end, line, entry.colour)
    elif entry.sign == "polar":
        robot = (x - radius, y + radius)
        canvas.stroke(robot, (robot[0] + 1.5 * radius, robot[1] - 2.2 * radius), line, entry.colour)
        angles = np.linspace(0.0, atan2(2.2, 1.5), 12)
        arc = [(robot[0] + 1.9 * radius * cos(angle), robot[1] - 1.9 * radius * sin(angle)) for angle in angles]
        for start, end in zip(arc[:-1], arc[1:], strict=True):
            canvas.stroke(start, end, line, entry.colour)
    elif entry.sign == "area":
        canvas.box(x - 1.3 * radius, y - radius, 2.6 * radius, 2 * radius, FLOOR)
        corners = [(x - 1.3 * radius, y), (x + 1.3 * radius, y - radius), (x + 1.3 * radius, y + radius)]
        canvas.polygon(corners, entry.colour)
