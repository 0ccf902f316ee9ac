"""Places of the field frame in a picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import atan2, cos, pi, sin

from soccer_env.leagues.league import Pitch

CORNER_STEP = pi / 8  # [rad] between the points of a rounded corner

Point = tuple[float, float]


@dataclass(frozen=True)
class View:
    """The scale and position of a picture that looks straight down at a pitch; x of the field to the right, y up."""

    scale: float  # [px/m]
    centre_x: float  # [px] of the centre spot
    centre_y: float  # [px]
    margin: float  # [px] of floor around the field

    def pixel(self, x: float, y: float) -> Point:
        """Convert a point of the field frame [m] to pixels, counted to the right and down."""
        return self.centre_x + self.scale * x, self.centre_y - self.scale * y

    def pixels(self, points: Sequence[Point], x: float, y: float, heading: float) -> list[Point]:
        """Convert points of the frame of a robot with pose (x, y, heading) to pixels."""
        scale_x, scale_y = self.scale * cos(heading), self.scale * sin(heading)
        origin_x, origin_y = self.pixel(x, y)
        return [(origin_x + scale_x * u - scale_y * v, origin_y - scale_y * u - scale_x * v) for u, v in points]


def view_of(pitch: Pitch, width: int) -> tuple[View, int]:
    """Return the view that fits the pitch with its goals and bands into a width [px], and its height [px], even."""
    margin = 10.0 + 0.021 * width
    half_x = pitch.length / 2 + max(pitch.goal_depth, pitch.band_end)
    half_y = pitch.width / 2 + pitch.band_side
    scale = (width / 2 - margin) / half_x
    height = 2 * round(half_y * scale + margin)
    return View(scale, width / 2, height / 2, margin), height


def rounded_outline(corners: Sequence[Point], radius: float) -> list[Point]:
    """Return the outline around a convex polygon at a distance, both counter-clockwise; two corners give a capsule."""
    outline = []
    for index, (x, y) in enumerate(corners):
        before_x, before_y = corners[index - 1]
        after_x, after_y = corners[(index + 1) % len(corners)]
        first = atan2(before_x - x, y - before_y)  # normals of the edges that meet here
        last = atan2(x - after_x, after_y - y)
        sweep = (last - first) % (2.0 * pi)
        steps = max(1, round(sweep / CORNER_STEP))
        for step in range(steps + 1):
            angle = first + sweep * step / steps
            outline.append((x + radius * cos(angle), y + radius * sin(angle)))
    return outline
