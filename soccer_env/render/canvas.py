"""A surface that is drawn larger and then shrunk, so that edges are smooth."""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from math import hypot
from typing import TYPE_CHECKING

import numpy as np

from soccer_env.render.colours import WHITE, Colour

if TYPE_CHECKING:
    import pygame

FACTOR = 2  # of the enlargement
RED_FIRST = (0xFF, 0xFF00, 0xFF0000, 0) if sys.byteorder == "little" else (0xFF0000, 0xFF00, 0xFF, 0)
PIECE = 8  # lines of a path that are shrunk as one
LETTERS_KEPT = 1024  # rendered words in memory
LEAST_SHRINK = 0.5  # [1] letters are not made smaller than this, to fit
FAR = 100_000.0  # [px] limit of coordinates: SDL counts in 32-bit integers

Point = tuple[float, float]


def require_pygame() -> None:
    """Import pygame-ce without its greeting; ImportError says how to install it."""
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    how = 'pip install "soccer_env[render]"'
    try:
        module = importlib.import_module("pygame")
    except ImportError as error:
        raise ImportError(f"pictures need pygame-ce, which is not installed: {how}") from error
    if not getattr(module, "IS_CE", False):
        raise ImportError(f"pictures need pygame-ce, but the older pygame is installed: pip uninstall pygame; {how}")


def new_surface(width: int, height: int, glass: bool = False) -> pygame.Surface:
    """Return a surface of 32 bits a pixel on any display; `glass` adds an alpha channel."""
    import pygame

    return pygame.Surface((width, height), pygame.SRCALPHA if glass else 0, 32)


def packed_surface(width: int, height: int) -> pygame.Surface:
    """Return a surface of three bytes a pixel, red first: a blit onto it is the fastest way to an array."""
    import pygame

    return pygame.Surface((width, height), 0, 24, masks=RED_FIRST)


class TextSurfaces:
    """Words as surfaces, in the font of pygame, so that pictures agree between machines."""

    def __init__(self) -> None:
        self._fonts: dict[int, pygame.font.Font] = {}
        self._words: dict[tuple[str, int, Colour], pygame.Surface] = {}

    def word(self, text: str, size: int, colour: Colour) -> pygame.Surface:
        """Return the text as a surface with alpha, `size` pixels high."""
        import pygame

        key = (text, size, colour)
        if key not in self._words:
            if len(self._words) >= LETTERS_KEPT:
                self._words.clear()
            try:
                self._words[key] = self._font(size).render(text, True, colour)
            except pygame.error:  # someone called pygame.quit(), which ends all fonts
                self._fonts.clear()
                self._words[key] = self._font(size).render(text, True, colour)
        return self._words[key]

    def _font(self, size: int) -> pygame.font.Font:
        import pygame

        if size not in self._fonts:
            pygame.font.init()
            self._fonts[size] = pygame.font.Font(None, size)
        return self._fonts[size]


class Canvas:
    """Draw in pixels of the small surface; only what was touched is shrunk and cleaned again.

    Coordinates, radii and widths are floats in pixels of `small`, y downwards.
    """

    def __init__(self, small: pygame.Surface) -> None:
        self.small = small
        self.width, self.height = small.get_size()
        self.large = new_surface(self.width * FACTOR, self.height * FACTOR)
        self.letters = TextSurfaces()
        self._background: pygame.Surface | None = None
        self._pane: pygame.Surface | None = None  # working surface of `glass`
        self._touched: list[pygame.Rect] = []
        self._stale: list[pygame.Rect] = []  # touched in the frame before

    @contextmanager
    def shrink_as_one(self) -> Iterator[None]:
        """Shrink all shapes drawn inside the `with` as one part, for shapes that lie near each other."""
        before = len(self._touched)
        yield
        if len(self._touched) > before + 1:
            self._touched[before:] = [self._touched[before].unionall(self._touched[before + 1 :])]

    def fill(self, colour: Colour) -> None:
        """Fill the whole canvas with a colour."""
        self._touched = [self.large.fill(colour)]

    def polygon(self, points: Sequence[Point], colour: Colour) -> None:
        """Fill a polygon."""
        import pygame

        self._touched.append(pygame.draw.polygon(self.large, colour, [enlarge(point) for point in points]))

    def disc(self, centre: Point, radius: float, colour: Colour) -> None:
        """Fill a disc."""
        import pygame

        self._touched.append(pygame.draw.circle(self.large, colour, enlarge(centre), radius * FACTOR))

    def ring(self, centre: Point, radius: float, width: float, colour: Colour, quarter: str = "") -> None:
        """Draw a circle whose line has its middle at the radius; `quarter`: draw only that one, such as "top left"."""
        import pygame

        outer, line = (radius + width / 2) * FACTOR, max(1, round(width * FACTOR))
        if not quarter:
            rect = pygame.draw.circle(self.large, colour, enlarge(centre), outer, line)
        else:
            flag = {f"draw_{quarter.replace(' ', '_')}": True}
            rect = pygame.draw.circle(self.large, colour, enlarge(centre), outer, line, **flag)
        self._touched.append(rect)

    def stroke(self, start: Point, end: Point, width: float, colour: Colour) -> None:
        """Draw a straight line with round ends."""
        self._bar(start, end, width, colour)
        for point in (start, end):
            self.disc(point, width / 2, colour)

    def _bar(self, start: Point, end: Point, width: float, colour: Colour) -> None:
        away = hypot(end[0] - start[0], end[1] - start[1])
        if away > 0.0 and max(map(abs, (*start, *end))) < FAR:
            x, y = (end[0] - start[0]) / away * width / 2, (end[1] - start[1]) / away * width / 2
            left = [(start[0] - y, start[1] + x), (end[0] - y, end[1] + x)]
            self.polygon([*left, (end[0] + y, end[1] - x), (start[0] + y, start[1] - x)], colour)

    def path(self, points: Sequence[Point], width: float, colour: Colour) -> None:
        """Draw straight lines from point to point with round joints and ends, like `stroke` but each joint once."""
        if len(points) < 2:
            return
        for at in range(0, len(points) - 1, PIECE):
            with self.shrink_as_one():
                piece = points[at : at + PIECE + 1]
                for start, end in zip(piece, piece[1:]):
                    self._bar(start, end, width, colour)
                for point in piece[at > 0 :]:
                    self.disc(point, width / 2, colour)

    def box(self, left: float, top: float, width: float, height: float, colour: Colour, rounding: float = 0.0) -> None:
        """Fill a rectangle, with round corners if asked."""
        import pygame

        rect = pygame.Rect(round(left * FACTOR), round(top * FACTOR), round(width * FACTOR), round(height * FACTOR))
        self._touched.append(pygame.draw.rect(self.large, colour, rect, border_radius=round(rounding * FACTOR)))

    def text(
        self, words: str, place: Point, size: float, colour: Colour, align: str = "centre", room: float = float("inf")
    ) -> float:
        """Write words with their middle, left or right end at a place, and return their width.

        Words wider than `room` [px] get smaller letters, down to half the size, and are then cut off.
        """
        letters = max(6, round(size * FACTOR))
        image = self.letters.word(words, letters, colour)
        least = max(6, int(letters * LEAST_SHRINK))
        while image.get_width() > room * FACTOR and letters > least:  # widths of letters are whole pixels: try again
            letters = max(least, min(letters - 1, int(letters * room * FACTOR / image.get_width())))
            image = self.letters.word(words, letters, colour)
        while image.get_width() > room * FACTOR and len(words) > 1:
            words = words[: max(1, min(len(words) - 2, int(len(words) * room * FACTOR / image.get_width())))]
            image = self.letters.word(f"{words}…", letters, colour)
        shift = {"left": 0.0, "centre": 0.5, "right": 1.0}[align]
        x, y = enlarge(place)
        self._touched.append(self.large.blit(image, (x - shift * image.get_width(), y - image.get_height() * 0.48)))
        return image.get_width() / FACTOR

    def word_width(self, words: str, size: float) -> float:
        """Return how wide words are at a size [px]."""
        return self.letters.word(words, max(6, round(size * FACTOR)), WHITE).get_width() / FACTOR

    def polygons(self, corners: np.ndarray, tints: Sequence[Colour]) -> None:
        """Fill N polygons of K corners (N, K, 2) that lie near each other, each in its colour."""
        import pygame

        large = (np.clip(corners, -FAR, FAR) * FACTOR).tolist()
        with self.shrink_as_one():
            self._touched += [
                pygame.draw.polygon(self.large, tint, shape) for shape, tint in zip(large, tints, strict=True)
            ]

    def stamp(self, image: pygame.Surface, centre: Point) -> None:
        """Draw an image, in pixels of the large surface, with its middle at a place, alpha blended."""
        x, y = enlarge(centre)
        self._touched.append(self.large.blit(image, (x - image.get_width() / 2, y - image.get_height() / 2)))

    def pane(self, left: float, top: float, wide: float, high: float, colour: Colour, alpha: int) -> None:
        """Fill a rectangle with a transparent colour; alpha from 0 to 255."""
        right, bottom = left + wide, top + high
        self.glass([(left, top), (right, top), (right, bottom), (left, bottom)], colour, alpha)

    def glass(self, points: Sequence[Point], colour: Colour, alpha: int) -> None:
        """Fill a polygon with a transparent colour; alpha from 0 to 255."""
        import pygame

        large = [enlarge(point) for point in points]
        left, top = (int(max(min(place), 0.0)) for place in zip(*large))
        right, bottom = (max(place) for place in zip(*large))
        wide = int(min(right, self.large.get_width()) - left) + 2
        high = int(min(bottom, self.large.get_height()) - top) + 2
        if wide <= 2 or high <= 2:
            return
        if self._pane is None:
            self._pane = new_surface(self.large.get_width() + 2, self.large.get_height() + 2, glass=True)
        area = self._pane.fill((0, 0, 0, 0), (0, 0, wide, high))
        pygame.draw.polygon(self._pane, (*colour, alpha), [(x - left, y - top) for x, y in large])
        self._touched.append(self.large.blit(self._pane, (left, top), area))

    def keep(self) -> None:
        """Make the present drawing the background."""
        self._background = self.large.copy()
        self._stale, self._touched = [], [self.large.get_rect()]
        self.shrink()

    def clean(self) -> None:
        """Restore the background wherever something was drawn."""
        if self._background is None:
            raise RuntimeError("a canvas is cleaned only after keep()")
        self._stale, self._touched = self._stale + self._touched, []  # the latter only after a drawing that failed
        for rect in self._stale:
            self.large.blit(self._background, rect, rect)

    def cover(self, other: Canvas, left: float, top: float) -> None:
        """Copy a part of another canvas, whose corner lies at (left, top) [px], as the ground of this one."""
        area = (round(left * FACTOR), round(top * FACTOR), *self.large.get_size())
        self.large.blit(other.large, (0, 0), area)
        self._touched = [self.large.get_rect()]

    def shrink(self) -> None:
        """Shrink every touched part onto the small surface."""
        import pygame

        touched = merge_rectangles(self._touched, self.large.get_rect())
        for rect in merge_rectangles(self._stale + touched, self.large.get_rect()):
            x, y, width, height = (side // FACTOR for side in rect)
            part = self.small.subsurface((x, y, width, height))
            pygame.transform.smoothscale(self.large.subsurface(rect), (width, height), part)
        self._stale, self._touched = touched, []


def enlarge(point: Point) -> Point:
    """Convert a place from pixels of the small surface to pixels of the large surface, clipped to the range of SDL."""
    x, y = point
    if -FAR < x < FAR and -FAR < y < FAR:
        return x * FACTOR, y * FACTOR
    return min(max(x, -FAR), FAR) * FACTOR, min(max(y, -FAR), FAR) * FACTOR


def merge_rectangles(rects: list[pygame.Rect], bounds: pygame.Rect) -> list[pygame.Rect]:
    """Return fewer rectangles that cover `rects`, cut to the bounds, on whole pixels of the small surface."""
    import pygame

    covering: list[pygame.Rect] = []
    for rect in rects:
        left, top = rect.left // FACTOR * FACTOR, rect.top // FACTOR * FACTOR
        right, bottom = -(-rect.right // FACTOR) * FACTOR, -(-rect.bottom // FACTOR) * FACTOR
        whole = pygame.Rect(left, top, right - left, bottom - top).clip(bounds)
        if whole.width == 0 or whole.height == 0:
            continue
        index = whole.collidelist(covering)
        if index < 0:
            covering.append(whole)
        else:
            covering[index].union_ip(whole)
    return covering
