"""Shapes in the field frame, to be drawn over a picture: points, paths, arrows, areas, labels."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, hypot, sin
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from soccer_env.render.canvas import Canvas
from soccer_env.render.colours import INK, Colour
from soccer_env.render.view import View

HEAD_LENGTH = 4.0  # of an arrow, in widths of its line


class Overlay(Protocol):
    """Anything that can draw itself; `under` puts it beneath the robots."""

    @property
    def under(self) -> bool:
        """Tell whether the overlay lies beneath robots and ball."""

    def draw_on(self, canvas: Canvas, view: View) -> None:
        """Draw the overlay onto the canvas through the view."""


def check_pairs(name: str, values: ArrayLike) -> list[tuple[float, float]]:
    """Return points or vectors as a list of pairs; ValueError unless they are finite and of shape (N, 2)."""
    array = np.asarray(values, dtype=float)
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f"{name} must have shape (N, 2), got {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} must be finite, got {array[~np.isfinite(array).all(axis=1)][0].tolist()}")
    return [(x, y) for x, y in array.tolist()]


@dataclass(frozen=True, eq=False)
class Points:
    """Dots with a dark rim, or open circles."""

    xy: ArrayLike  # (N, 2) [m] field frame
    colour: Colour
    radius: float = 4.0  # [px]
    hollow: bool = False
    under: bool = False

    def draw_on(self, canvas: Canvas, view: View) -> None:
        """Draw every dot."""
        for x, y in check_pairs("Points.xy", self.xy):
            place = view.pixel(x, y)
            if self.hollow:
                canvas.ring(place, self.radius, max(1.5, self.radius / 4), self.colour)
            else:
                canvas.disc(place, self.radius + 1.0, INK)
                canvas.disc(place, self.radius, self.colour)


@dataclass(frozen=True, eq=False)
class Polyline:
    """A path, closed if asked."""

    xy: ArrayLike  # (N, 2) [m] field frame
    colour: Colour
    width: float = 2.5  # [px]
    closed: bool = False
    under: bool = False

    def draw_on(self, canvas: Canvas, view: View) -> None:
        """Draw every segment of the path."""
        places = [view.pixel(x, y) for x, y in check_pairs("Polyline.xy", self.xy)]
        if self.closed and places:
            places.append(places[0])
        canvas.path(places, self.width, self.colour)


@dataclass(frozen=True, eq=False)
class Arrows:
    """Arrows, such as those of a force field."""

    tails: ArrayLike  # (N, 2) [m] field frame
    vectors: ArrayLike  # (N, 2) [m] from tail to tip, field frame
    colour: Colour
    width: float = 2.0  # [px]
    under: bool = False

    def draw_on(self, canvas: Canvas, view: View) -> None:
        """Draw every arrow; ValueError when tails and vectors differ in number."""
        tails, vectors = check_pairs("Arrows.tails", self.tails), check_pairs("Arrows.vectors", self.vectors)
        if len(tails) != len(vectors):
            raise ValueError(f"Arrows need a vector for each tail, got {len(vectors)} for {len(tails)} tails")
        for (x, y), (across, up) in zip(tails, vectors):
            self._draw_arrow(canvas, view.pixel(x, y), view.pixel(x + across, y + up))

    def _draw_arrow(self, canvas: Canvas, tail: tuple[float, float], tip: tuple[float, float]) -> None:
        length = hypot(tip[0] - tail[0], tip[1] - tail[1])
        if length < 1.0:
            return
        angle = atan2(tip[1] - tail[1], tip[0] - tail[0])
        head = min(HEAD_LENGTH * self.width, length)
        neck = (tip[0] - head * cos(angle), tip[1] - head * sin(angle))
        side = (-sin(angle) * head / 2, cos(angle) * head / 2)
        canvas.stroke(tail, neck, self.width, self.colour)
        canvas.polygon(
            [tip, (neck[0] + side[0], neck[1] + side[1]), (neck[0] - side[0], neck[1] - side[1])], self.colour
        )


@dataclass(frozen=True, eq=False)
class ArrowGrid:
    """Many arrows around their middles, such as those of a force field; colours show their strength."""

    middles: ArrayLike  # (N, 2) [m] field frame
    vectors: ArrayLike  # (N, 2) [m] from tail to tip, field frame
    shares: ArrayLike  # (N,) [1] from the weak colour to the strong one
    weak: Colour
    strong: Colour
    width: float = 2.0  # [px]
    under: bool = True

    def draw_on(self, canvas: Canvas, view: View) -> None:
        """Draw every arrow as one polygon."""
        middles, vectors = np.array(check_pairs("ArrowGrid.middles", self.middles)), np.asarray(self.vectors, float)
        half, thick = 0.5 * view.scale * vectors * (1.0, -1.0), 0.5 * self.width
        centres = np.array([view.pixel(x, y) for x, y in middles.tolist()])
        long = np.maximum(np.hypot(*half.T)[:, None], 1e-9)
        ahead = half / long
        aside, head = np.column_stack([-ahead[:, 1], ahead[:, 0]]), np.minimum(2.8 * self.width, 1.2 * long)
        tip, tail, neck = centres + half, centres - half, centres + half - head * ahead
        rims = [tail + thick * aside, neck + thick * aside, neck + 0.42 * head * aside, tip]
        rims += [neck - 0.42 * head * aside, neck - thick * aside, tail - thick * aside]
        tints = np.rint(
            np.array(self.weak) + np.outer(np.asarray(self.shares, float), np.subtract(self.strong, self.weak))
        )
        canvas.polygons(np.stack(rims, axis=1), tints.astype(int).tolist())


@dataclass(frozen=True, eq=False)
class Area:
    """A transparent region, such as the field of view of a camera."""

    xy: ArrayLike  # (N, 2) [m] field frame: its corners, of which at least three
    colour: Colour
    alpha: int = 60  # of 255
    under: bool = True

    def draw_on(self, canvas: Canvas, view: View) -> None:
        """Fill the region."""
        canvas.glass([view.pixel(x, y) for x, y in check_pairs("Area.xy", self.xy)], self.colour, self.alpha)


@dataclass(frozen=True, eq=False)
class Label:
    """Words beside a point, with a dark rim that keeps them legible on any ground."""

    xy: tuple[float, float]  # [m] field frame
    words: str
    colour: Colour
    size: float = 14.0  # [px]
    away: tuple[float, float] = (0.0, 0.0)  # [px] to the right and down, from the point to the words
    align: str = "centre"  # or "left" or "right": which part of the words stands there
    under: bool = False

    def draw_on(self, canvas: Canvas, view: View) -> None:
        """Write the words, unless their place lies outside the picture."""
        ((x, y),) = check_pairs("Label.xy", [self.xy])
        column, row = view.pixel(x, y)
        if not (0.0 <= column <= canvas.width and 0.0 <= row <= canvas.height):
            return
        column, row = column + self.away[0], row + self.away[1]
        rim = max(1.0, self.size / 14.0)
        for right, down in ((-rim, 0.0), (rim, 0.0), (0.0, -rim), (0.0, rim)):
            canvas.text(self.words, (column + right, row + down), self.size, INK, self.align)
        canvas.text(self.words, (column, row), self.size, self.colour, self.align)
