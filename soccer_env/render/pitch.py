"""The field as a background: carpet, lines, boards, goals, and which way each team attacks."""

from __future__ import annotations

from soccer_env.leagues.league import Pitch
from soccer_env.render import colours
from soccer_env.render.canvas import Canvas, Point
from soccer_env.render.colours import Colour
from soccer_env.render.view import View

STRIPES = 13  # of the carpet along the field; odd, so that both halves look alike
CORNER_ARC = 0.5  # [m] Paderborn 2005 field
PENALTY_MARK = 2.0  # [m] from the goal line, Paderborn 2005 field; drawn only on long fields
BOARD = 0.05  # [m] thickness of boards, for the eye
NET = 0.03  # [m] thickness of a goal's walls, for the eye
LEAST_LINE = 1.5  # [px]


class Ground:
    """Draws the background, and the two lines of text above the field."""

    def __init__(self, pitch: Pitch, view: View, canvas: Canvas) -> None:
        self.pitch = pitch
        self.view = view
        self.canvas = canvas
        self.line = max(pitch.line * view.scale, LEAST_LINE)

    def draw(self) -> None:
        """Draw the whole background and keep it."""
        self.canvas.fill(colours.FLOOR)
        self._draw_carpet()
        self._draw_lines()
        self._draw_boards()
        for side in (-1.0, 1.0):
            self._draw_goal(side)
        self.canvas.keep()

    def draw_directions(self, home_direction: float) -> None:
        """Write each team's direction of attack above the half that the team defends."""
        home = -1.0 if home_direction < 0.0 else 1.0
        free = self.view.margin - BOARD * self.view.scale  # [px] above the board
        for team, direction in ((0, home), (1, -home)):
            x, y = self.view.pixel(-direction * self.pitch.length / 4, 0.0)[0], 0.5 * free
            size, colour = min(0.62 * self.view.margin, free), colours.TEAMS_LIGHT[team]
            wide = self.canvas.text(f"{colours.TEAM_NAMES[team]} attacks", (x, y), size, colour)
            for index in range(3):
                start = x + direction * (wide / 2 + size * (0.5 + 0.55 * index))
                self.canvas.polygon(chevron((start, y), direction * size * 0.5), colour)

    def _box(self, left: float, bottom: float, right: float, top: float, colour: Colour, rounding: float = 0.0) -> None:
        """Fill a rectangle given in the field frame [m]."""
        (x, y), (end_x, end_y) = self.view.pixel(left, top), self.view.pixel(right, bottom)
        self.canvas.box(x, y, end_x - x, end_y - y, colour, rounding)

    def _draw_carpet(self) -> None:
        half_x, half_y = self.pitch.length / 2, self.pitch.width / 2
        end, side = half_x + self.pitch.band_end, half_y + self.pitch.band_side
        self._box(-end, -side, end, side, colours.BAND)
        stripe = self.pitch.length / STRIPES
        for index in range(STRIPES):
            colour = (colours.CARPET, colours.CARPET_LIGHT)[index % 2]
            self._box(-half_x + index * stripe, -half_y, -half_x + (index + 1) * stripe, half_y, colour)

    def _draw_boards(self) -> None:
        """Draw the boards: on the lines of a walled field, else around the band."""
        colour = colours.BOARD if self.pitch.walled else colours.BOARD_EDGE
        x, y = self.pitch.length / 2 + self.pitch.band_end, self.pitch.width / 2 + self.pitch.band_side
        out_x, out_y = x + BOARD, y + BOARD
        self._box(-out_x, y, out_x, out_y, colour)
        self._box(-out_x, -out_y, out_x, -y, colour)
        self._box(-out_x, -out_y, -x, out_y, colour)
        self._box(x, -out_y, out_x, out_y, colour)
        if self.pitch.ramp > 0.0:
            foot, mouth = self.pitch.ramp, self.pitch.goal_width / 2
            for bottom, top in ((y - foot, y), (-y, foot - y)):
                self._box(-x, bottom, x, top, colours.BOARD_FOOT)
            for left, right in ((x - foot, x), (-x, foot - x)):
                self._box(left, mouth, right, y, colours.BOARD_FOOT)
                self._box(left, -y, right, -mouth, colours.BOARD_FOOT)

    def _draw_lines(self) -> None:
        pitch = self.pitch
        half_x, half_y = pitch.length / 2, pitch.width / 2
        if not pitch.walled:
            self._frame(-half_x, -half_y, half_x, half_y)
            self._draw_corner_arcs()
        self._line(0.0, -half_y, 0.0, half_y)
        self.canvas.ring(self.view.pixel(0.0, 0.0), pitch.circle * self.view.scale, self.line, colours.LINE)
        self.canvas.disc(self.view.pixel(0.0, 0.0), 1.6 * self.line, colours.LINE)
        for side in (-1.0, 1.0):
            areas = (pitch.penalty_depth, pitch.penalty_width), (pitch.goal_area_depth, pitch.goal_area_width)
            for depth, width in areas:
                if depth > 0.0 and width > 0.0:
                    inner, outer = side * (half_x - depth), side * half_x
                    self._frame(min(inner, outer), -width / 2, max(inner, outer), width / 2)
            if not pitch.walled and pitch.penalty_depth > 0.0 and half_x > 2.0 * PENALTY_MARK:
                self.canvas.disc(self.view.pixel(side * (half_x - PENALTY_MARK), 0.0), 1.3 * self.line, colours.LINE)

    def _frame(self, left: float, bottom: float, right: float, top: float) -> None:
        corners = [(left, bottom), (right, bottom), (right, top), (left, top)]
        for (x, y), (end_x, end_y) in zip(corners, corners[1:] + corners[:1]):
            self._line(x, y, end_x, end_y)

    def _line(self, x: float, y: float, end_x: float, end_y: float) -> None:
        """Draw a line along an axis; its ends are square."""
        left, top = self.view.pixel(min(x, end_x), max(y, end_y))
        right, bottom = self.view.pixel(max(x, end_x), min(y, end_y))
        half = self.line / 2
        self.canvas.box(left - half, top - half, right - left + 2 * half, bottom - top + 2 * half, colours.LINE)

    def _draw_corner_arcs(self) -> None:
        half_x, half_y = self.pitch.length / 2, self.pitch.width / 2
        radius = min(CORNER_ARC, self.pitch.width / 10) * self.view.scale
        for upper, across in ((1.0, "bottom"), (-1.0, "top")):
            for side, along in ((1.0, "left"), (-1.0, "right")):
                centre = self.view.pixel(side * half_x, upper * half_y)
                self.canvas.ring(centre, radius, self.line, colours.LINE, f"{across} {along}")

    def _draw_goal(self, side: float) -> None:
        """Draw the goal at -x or +x in its own colour, which does not change at half-time."""
        pitch, end = self.pitch, side > 0.0
        near = side * pitch.length / 2
        far = side * (pitch.length / 2 + pitch.goal_depth)
        half = pitch.goal_width / 2
        wall, line = max(NET, 3.0 / self.view.scale), 0.0 if pitch.walled else self.line / 2 / self.view.scale
        back = far + side * wall
        mouth = near + side * line
        self._box(min(mouth, back), -half - wall, max(mouth, back), half + wall, colours.GOALS[end])
        self._box(min(mouth, far), -half, max(mouth, far), half, colours.GOALS_FLOOR[end])
        if pitch.walled:  # the goal line, elsewhere part of the field's frame
            self._line(near, -half, near, half)
        for upper in (-half, half):
            place = self.view.pixel(near, upper)
            radius = max(pitch.post_radius * self.view.scale, 3.0)
            self.canvas.disc(place, radius + 1.0, colours.INK)
            self.canvas.disc(place, radius, colours.GOALS[end])


def chevron(back: Point, length: float) -> list[Point]:
    """Return an arrow head that starts at a place and points right, or left if the length is negative."""
    (x, y), high = back, abs(length) * 0.75
    near, tip, notch = x + 0.4 * length, x + length, x + 0.6 * length
    return [(x, y - high), (near, y - high), (tip, y), (near, y + high), (x, y + high), (notch, y)]
