"""Panels of a picture: words, key help, and the picture of a camera with its blobs."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from typing import TYPE_CHECKING

from soccer_env.render.canvas import Canvas
from soccer_env.render.colours import DIM, INK, WHITE
from soccer_env.render.overlays.belief import letter_height
from soccer_env.render.overlays.sight import blob_boxes, thing_colours
from soccer_env.render.view import View

if TYPE_CHECKING:
    from soccer_env.render.overlays.layers import LayerInput

GAP = 6.0  # [px] from the corner
SHADE = 175  # of 255


@dataclass(frozen=True, eq=False)
class TextPanel:
    """Lines at the lower edge of the pitch, on a dark plate."""

    lines: tuple[str, ...]
    unit: float
    above_bench: bool = False  # inactive robots are drawn below
    under: bool = False

    def draw_on(self, canvas: Canvas, view: View) -> None:
        """Write the lines, the last at the bottom."""
        size = letter_height(self.unit)
        room = canvas.width - 4.0 * GAP
        for at, line in enumerate(reversed(self.lines)):
            middle = canvas.height - (view.margin if self.above_bench else GAP) - (at + 0.5) * 1.15 * size
            wide = min(room, canvas.word_width(line, size)) + 2.0 * GAP
            canvas.pane(0.0, middle - 0.58 * size, wide, 1.16 * size, INK, SHADE)
            canvas.text(line, (GAP, middle), size, WHITE, "left", room)


@dataclass(frozen=True, eq=False)
class HelpPanel:
    """Lines in the middle of the picture, on a dark plate."""

    lines: tuple[str, ...]
    under: bool = False

    def draw_on(self, canvas: Canvas, view: View) -> None:
        """Write the lines, as large as they fit."""
        size = min(26.0, 0.82 * canvas.height / len(self.lines), 0.042 * canvas.width)
        wide = max(canvas.word_width(line, size) for line in self.lines) + 4.0 * GAP
        high = (1.2 * len(self.lines) + 0.6) * size
        left, top = (canvas.width - wide) / 2, (canvas.height - high) / 2
        canvas.pane(left, top, wide, high, INK, 225)
        for at, line in enumerate(self.lines):
            canvas.text(line, (left + 2.0 * GAP, top + (1.2 * at + 0.9) * size), size, WHITE, "left")


@dataclass(frozen=True, eq=False)
class CameraPicture:
    """The picture of the camera of one robot: a frame with a box for each blob, in the corner with the most room."""

    look: LayerInput
    under: bool = False

    def draw_on(self, canvas: Canvas, view: View) -> None:
        """Draw frame, blobs and a caption."""
        camera, thought = self.look.cast.camera, self.look.thought
        if camera is None or thought is None:
            return
        wide = 0.17 * canvas.width
        scale = wide / camera.width
        high = scale * camera.height
        left, top = self._corner(canvas, view, wide, high)
        canvas.pane(left, top, wide, high, INK, SHADE)
        robot = self.look.shot.robots[self.look.row]
        tints = thing_colours(int(robot["team"]), float(self.look.shot.match["home_direction"]))
        for name in ("landmarks", "own_goal", "opponent_goal", "teammates", "opponents", "ball"):
            for u_left, u_right, v_high, v_low in blob_boxes(thought.groups.get(name)):
                x, y = left + wide / 2 - scale * u_left, top + high / 2 - scale * v_high
                size = (max(2.0, scale * (u_left - u_right)), max(2.0, scale * (v_high - v_low)))
                x, y = max(left, x), max(top, y)
                size = min(size[0], left + wide - x), min(size[1], top + high - y)
                canvas.box(x, y, *size, tints[name])
        corners = [(left, top), (left + wide, top), (left + wide, top + high), (left, top + high)]
        for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
            canvas.stroke(start, end, 1.2, DIM)
        tall = 0.8 * letter_height(self.look.unit)
        canvas.pane(left, top, wide, 1.2 * tall, INK, SHADE)
        canvas.text(f"camera of {self.look.name}", (left + 3.0, top + 0.6 * tall), tall, WHITE, "left", wide - 6.0)

    def _corner(self, canvas: Canvas, view: View, wide: float, high: float) -> tuple[float, float]:
        """Return left and top of the corner farthest from the ball and the robot."""
        robot, ball = self.look.shot.robots[self.look.row], self.look.shot.ball
        near = [view.pixel(float(one["x"]), float(one["y"])) for one in (robot, ball)]
        margin = view.margin
        lefts, top = (margin, canvas.width - margin - wide), margin
        places = [(left, row) for row in (top, canvas.height - margin - high) for left in lefts]

        def room(place: tuple[float, float]) -> float:
            return min(hypot(place[0] + wide / 2 - x, place[1] + high / 2 - y) for x, y in near)

        return max(places, key=room)
