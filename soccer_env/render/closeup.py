"""A picture that can zoom in and follow a robot or the ball."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.render.canvas import Canvas, Point, new_surface
from soccer_env.render.frame import Picture, check_records, one_line
from soccer_env.render.header import header_contents
from soccer_env.render.overlays.shapes import Overlay
from soccer_env.render.pitch import Ground
from soccer_env.render.robots import PlayerDrawer, figures_of
from soccer_env.render.view import View

ZOOM = 2.2  # [1] magnification


class Closeup(Picture):
    """A `Picture` that can also draw the part of the pitch around a point, magnified, in a frame of the same size."""

    def __init__(self, league: League | str, width: int = 960) -> None:
        super().__init__(league, width)
        high = self.height - self.header_height
        self._whole = Canvas(new_surface(round(ZOOM * self.width), round(ZOOM * high)))
        near = self.view
        self._near = View(ZOOM * near.scale, ZOOM * near.centre_x, ZOOM * near.centre_y, ZOOM * near.margin)
        Ground(self.league.pitch, self._near, self._whole).draw()
        self._near_players = PlayerDrawer(self.league, self._near, self._canvas)

    def draw_near(
        self, match: np.void, ball: np.void, robots: np.ndarray, around: Point, *, title: tuple[str, str],
        overlays: Sequence[Overlay] = (),
    ) -> np.ndarray:  # fmt: skip
        """Return a new frame, (height, width, 3) uint8, of the pitch around a point [m] of the field frame."""
        check_records(match, ball, robots)
        home, away = (one_line(name) for name in title)
        self._header.draw(header_contents(match, robots, (home, away), self.league))
        column, row = self._near.pixel(*around)
        left = self._clip_pixel(column - self._canvas.width / 2, self._whole.width - self._canvas.width)
        top = self._clip_pixel(row - self._canvas.height / 2, self._whole.height - self._canvas.height)
        self._canvas.cover(self._whole, left, top)
        view = replace(self._near, centre_x=self._near.centre_x - left, centre_y=self._near.centre_y - top)
        self._near_players.view = view
        figures = figures_of(robots, self.league, float(match["handedness"]))
        self._draw_play(view, self._near_players, figures, ball, overlays)
        return self._pixels()

    def _clip_pixel(self, place: float, most: float) -> float:
        """Round a coordinate [px] to whole pixels, clipped to 0 ... most."""
        return float(round(min(max(place, 0.0), most)))
