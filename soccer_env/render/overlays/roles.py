"""Role and recovery state of every robot in words, and the beams of the rangers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import cos, sin
from typing import TYPE_CHECKING

from soccer_env.leagues.robot_kind import CENTI
from soccer_env.render.canvas import Canvas
from soccer_env.render.colours import AMBER, TEAMS_LIGHT, WHITE, Colour
from soccer_env.render.overlays.belief import letter_height
from soccer_env.render.overlays.cast import Cast, Snapshot
from soccer_env.render.overlays.shapes import Label, Overlay, Points, Polyline
from soccer_env.render.view import View

if TYPE_CHECKING:
    from soccer_env.render.overlays.layers import LayerInput

BEAM: Colour = (255, 84, 150)
READING: Colour = (255, 186, 214)  # of the words of a beam: in its own colour they cannot be read on blue
FIELD_ROLES = ("attacker", "supporter")
RECOVERIES = ("back", "sidestep", "rotate")  # behaviours of a stuck robot
PLATE = 2.5  # [1] half the width of the mark of a fall, in sizes of the letters beside it
COUNTED = {"detour": "goes round", "wriggle": "wriggles", "back_off": "backs off"}  # [s] left of such a recovery


@dataclass(frozen=True, eq=False)
class TextTags:
    """Words under robots or places; above them or farther away if other words or the mark of a fall are in the way."""

    tags: tuple[tuple[tuple[float, float], str, Colour], ...]  # place of a robot [m], words, colour
    away: float  # [m] from a robot's middle to its words
    size: float  # [px]
    fallen: tuple[tuple[float, float], ...] = ()  # [m] robots with the mark of a fall under them
    under: bool = False

    def draw_on(self, canvas: Canvas, view: View) -> None:
        """Write the words, one label after the other."""
        down = self.away * view.scale + 0.5 * self.size
        marks = (view.pixel(x, y) for x, y in self.fallen)
        taken = [(column, row + down, PLATE * self.size) for column, row in marks]  # middles and half widths
        for (x, y), words, tint in self.tags:
            half = canvas.word_width(words, self.size) / 2 + 2.0
            column, row = view.pixel(x, y)
            column = min(max(column, half), canvas.width - half)
            rows = (row + down, row - down, row + down + self.size, row - down - self.size)
            row = next((one for one in rows if self._free(taken, column, one, half)), rows[0])
            taken.append((column, row, half))
            place = ((column - view.centre_x) / view.scale, (view.centre_y - row) / view.scale)
            Label(place, words, tint, self.size).draw_on(canvas, view)

    def _free(self, taken: list[tuple[float, float, float]], column: float, row: float, half: float) -> bool:
        return all(abs(row - y) > 0.8 * self.size or abs(column - x) > half + wide for x, y, wide in taken)


def role_labels(cast: Cast, shot: Snapshot, unit: float) -> list[Overlay]:
    """Return labels for the activity of each robot whose team explains it; amber for a robot in recovery."""
    tags: list[tuple[tuple[float, float], str, Colour]] = []
    lie = shot.robots[(shot.robots["fallen"] > 0.0) & (shot.robots["active"] == 1)]
    fallen = tuple((float(robot["x"]), float(robot["y"])) for robot in lie)
    for row, robot in enumerate(shot.robots):
        if not robot["active"] or cast.reader is None or shot.note is None:
            continue
        words, recovers = activity_words(
            *cast.reader.memory(shot.note, row), bool(robot["keeper"]), bool(robot["fallen"] > 0.0)
        )
        if words:
            tint = AMBER if recovers else TEAMS_LIGHT[int(robot["team"])]
            tags.append(((float(robot["x"]), float(robot["y"])), words, tint))
    return [TextTags(tuple(tags), 1.1 * cast.league.body.reach, letter_height(unit), fallen)] if tags else []


def activity_words(
    team_words: tuple[str, ...], numbers: Mapping[str, float], keeper: bool, fallen: bool
) -> tuple[str, bool]:
    """Return the activity of a robot in words, and whether the robot recovers; words and numbers as in `Thought`."""
    words = [word for word in team_words if not (keeper and word in FIELD_ROLES)]
    words = [word for word in words if not any(other != word and other.startswith(word) for other in words)]
    if not words and "rank" in numbers:
        words = ["goalkeeper" if keeper else FIELD_ROLES[min(1, int(numbers["rank"]))]]
    words += [word for name, word in COUNTED.items() if numbers.get(name, 0.0) > 0.0]
    recovers = any(word in RECOVERIES or word in COUNTED.values() for word in words)
    if recovers and numbers.get("tries", 0.0) > 0.0:
        words.append(f"try {numbers['tries']:.0f}")
    return ", ".join(["fallen", *words] if fallen else words), recovers or fallen


def ranger_beams(cast: Cast, shot: Snapshot, unit: float) -> list[Overlay]:
    """Return the beam of every ranger with a reading, as long as the reading, along the axis of the camera."""
    overlays: list[Overlay] = []
    tags: list[tuple[tuple[float, float], str, Colour]] = []
    neck = cast.camera.neck if cast.camera is not None else 0.0
    for row, robot in enumerate(shot.robots):
        thought = cast.thought(shot, row)
        if not robot["active"] or thought is None or thought.infrared <= 0.0:
            continue
        heading = float(robot["heading"])
        gaze = heading + (float(thought.groups["head"][0, 0]) / CENTI if "head" in thought.groups else 0.0)
        start = (float(robot["x"]) + neck * cos(heading), float(robot["y"]) + neck * sin(heading))
        end = (start[0] + thought.infrared * cos(gaze), start[1] + thought.infrared * sin(gaze))
        overlays.append(Polyline([start, end], BEAM, 2.2 * unit))
        overlays.append(Points([end], BEAM, 3.6 * unit))
        tags.append((end, f"{thought.infrared:.2f} m", READING))
    return [*overlays, TextTags(tuple(tags), 0.5 * cast.league.body.reach, letter_height(unit))] if tags else []


def selection_ring(look: LayerInput) -> Overlay:
    """Return a ring around the selected robot."""
    robot = look.shot.robots[look.row]
    reach = look.cast.league.body.reach
    corners = [
        (float(robot["x"]) + 1.3 * reach * cos(0.262 * i), float(robot["y"]) + 1.3 * reach * sin(0.262 * i))
        for i in range(24)
    ]
    return Polyline(corners, WHITE, 1.6 * look.unit, closed=True, under=True)
