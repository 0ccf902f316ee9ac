"""A picture of a match, drawn from its records alone."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, isfinite

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.render import colours
from soccer_env.render.canvas import Canvas, Point, new_surface, packed_surface, require_pygame
from soccer_env.render.colours import TEAM_NAMES
from soccer_env.render.header import Header, bar_height, header_contents
from soccer_env.render.overlays import Overlay
from soccer_env.render.pitch import Ground
from soccer_env.render.robots import Figure, PlayerDrawer, figures_of
from soccer_env.render.view import View, view_of

LEAST_WIDTH, MOST_WIDTH = 240, 2560  # [px]


class Picture:
    """Draws frames of one size for one league, without a display; many Pictures may exist side by side.

    `width` is 240 to 2560 pixels; the height follows from the pitch and is even. `draw` redraws only the changed parts,
    but a frame depends on the arguments of its own call alone.
    """

    def __init__(self, league: League | str, width: int = 960) -> None:
        if isinstance(width, bool) or not isinstance(width, (int, np.integer)):
            raise ValueError(f"width must be a whole number of pixels, got {width!r}")
        if not LEAST_WIDTH <= width <= MOST_WIDTH:
            raise ValueError(f"width must be {LEAST_WIDTH} to {MOST_WIDTH} pixels, got {width}")
        require_pygame()
        self.league = find_league(league)
        self.width = int(width)
        self.view, pitch_height = view_of(self.league.pitch, self.width)
        self.header_height = bar_height(self.width)
        self.height = self.header_height + pitch_height
        self._screen = new_surface(self.width, self.height)
        self._packed = packed_surface(self.width, self.height)
        self._canvas = Canvas(self._screen.subsurface((0, self.header_height, self.width, pitch_height)))
        self._header = Header(Canvas(self._screen.subsurface((0, 0, self.width, self.header_height))), self.league)
        self._ground = Ground(self.league.pitch, self.view, self._canvas)
        self._ground.draw()
        self._players = PlayerDrawer(self.league, self.view, self._canvas)

    def pixel(self, x: float, y: float) -> Point:
        """Return column and row of a point of the field frame [m] in the frames."""
        column, row = self.view.pixel(x, y)
        return column, row + self.header_height

    def draw(
        self, match: np.void, ball: np.void, robots: np.ndarray, *, title: tuple[str, str] | None = None,
        overlays: Sequence[Overlay] = (),
    ) -> np.ndarray:  # fmt: skip
        """Return a new frame, (height, width, 3) uint8, of one match record, its ball and its robots (R,).

        `title` names home and away. ValueError for records of other shapes or a pose that is not finite.
        """
        check_records(match, ball, robots)
        home, away = (name.upper() for name in TEAM_NAMES) if title is None else (one_line(name) for name in title)
        self._header.draw(header_contents(match, robots, (home, away), self.league))
        self._canvas.clean()
        self._ground.draw_directions(float(match["home_direction"]))
        figures = figures_of(robots, self.league, float(match["handedness"]))
        self._draw_play(self.view, self._players, figures, ball, overlays)
        return self._pixels()

    def _draw_play(
        self, view: View, players: PlayerDrawer, figures: list[Figure], ball: np.void, overlays: Sequence[Overlay]
    ) -> None:
        """Draw robots and ball, and the overlays under and over them."""
        for overlay in overlays:
            if overlay.under:
                overlay.draw_on(self._canvas, view)
        players.draw_robots(figures)
        draw_bench(figures, view, self._canvas)
        players.draw_ball(*(float(ball[name]) for name in ("x", "y", "vx", "vy")))
        for overlay in overlays:
            if not overlay.under:
                overlay.draw_on(self._canvas, view)
        self._canvas.shrink()

    def _pixels(self) -> np.ndarray:
        self._packed.blit(self._screen, (0, 0))
        return np.asarray(self._packed.get_view("3")).transpose(1, 0, 2).copy()


def one_line(name: object) -> str:
    """Return a name as one line without control characters, so that a font can draw it."""
    return " ".join("".join(letter if letter.isprintable() else " " for letter in str(name)).split())


def check_records(match: np.void, ball: np.void, robots: np.ndarray) -> None:
    """Raise ValueError unless these are one match, one ball with finite coordinates, and a row of robots."""
    for name, record, dimensions in (("match", match, 0), ("ball", ball, 0), ("robots", robots, 1)):
        if np.ndim(record) != dimensions:
            expected = "one record" if dimensions == 0 else "records of shape (R,)"
            raise ValueError(f"{name} must be {expected}, got shape {np.shape(record)}")
    for name in ("x", "y", "vx", "vy"):
        if not isfinite(ball[name]):
            raise ValueError(f"ball has {name} = {ball[name]}, a picture needs finite numbers")


def draw_bench(figures: list[Figure], view: View, canvas: Canvas) -> None:
    """Draw inactive robots as grey discs below the field: home left, away right."""
    radius = 0.34 * view.margin
    y = canvas.height - 0.46 * view.margin
    for team in (0, 1):
        resting = [figure for figure in figures if figure.team == team and not figure.active]
        x = 0.5 * radius + team * canvas.width / 2
        if resting:
            x += canvas.text("off:", (x, y), 1.4 * radius, colours.DIM, "left") + 1.6 * radius
        for figure in resting:
            canvas.disc((x, y), radius, colours.TEAMS_LIGHT[team])
            canvas.disc((x, y), radius - 1.5, colours.GREY)
            canvas.text(str(figure.number), (x, y), 1.5 * radius, colours.WHITE)
            if figure.penalty > 0.0:
                words = f"{ceil(figure.penalty)} s"
                x += canvas.text(words, (x + 1.3 * radius, y), 1.4 * radius, colours.DIM, "left") + 0.6 * radius
            x += 2.5 * radius
