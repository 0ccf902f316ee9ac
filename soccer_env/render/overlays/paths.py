"""The planned and the travelled path of a robot, and the trail of the ball."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

import numpy as np

from soccer_env.leagues.robot_kind import CENTI
from soccer_env.render.colours import BALL_SHINE, CARPET, INK, TEAMS_LIGHT, WHITE, Colour
from soccer_env.render.overlays.cast import Snapshot
from soccer_env.render.overlays.shapes import Overlay, Points, Polyline
from soccer_env.thoughts.thought import Thought

TRAVELLED = 6.0  # [s] of a robot's travelled path
TRAIL = 2.5  # [s] of the ball's trail
JUMP = 0.6  # [m] from shot to shot: a longer move is a placement
PIECES = 10  # of a trail, the older the paler
LEAST_STEP = 0.01  # [m] between two points of a path


def planned_path(thought: Thought) -> np.ndarray:
    """Return the planned path (N, 2) [m], field frame, empty without a plan."""
    path = thought.groups.get("plan", np.zeros((0, 2))) / CENTI
    return path if np.any(path) else np.zeros((0, 2))


def plan_overlays(path: np.ndarray, unit: float) -> list[Overlay]:
    """Return overlays of a planned path: a light line with a dark rim, and a ring around its end."""
    if len(path) < 2:
        return []
    rim = Polyline(path, INK, 4.6 * unit)
    return [rim, Polyline(path, WHITE, 2.4 * unit), Points([path[-1]], WHITE, 7.0 * unit, hollow=True)]


def travelled_path_overlay(
    past: Sequence[Snapshot], shot: Snapshot, row: int, rate: float, unit: float
) -> list[Overlay]:
    """Return an overlay of the path of a robot in the last seconds; `rate`: control steps a second."""
    tint = TEAMS_LIGHT[int(shot.robots["team"][row])]
    path = [
        (float(one.robots["x"][row]), float(one.robots["y"][row])) for one in latest_shots(past, shot, TRAVELLED * rate)
    ]
    return [Polyline(path_since_jump(path), tint, 2.0 * unit, under=True)]


def ball_trail(past: Sequence[Snapshot], shot: Snapshot, rate: float, unit: float) -> list[Overlay]:
    """Return overlays of the path of the ball in the last seconds, the older the paler."""
    path = [(float(one.ball["x"]), float(one.ball["y"])) for one in latest_shots(past, shot, TRAIL * rate)]
    piece = path_since_jump(path)
    ends = np.linspace(0, len(piece) - 1, PIECES + 1).round().astype(int).tolist()
    return [
        Polyline(piece[first : last + 1], mix_colours(CARPET, BALL_SHINE, (at + 1) / PIECES), 3.0 * unit, under=True)
        for at, (first, last) in enumerate(zip(ends, ends[1:]))
        if last > first
    ]


def latest_shots(past: Sequence[Snapshot], shot: Snapshot, steps: float) -> list[Snapshot]:
    """Return the shots of the last control steps up to `shot`, without shots of an earlier episode."""
    shots, now = [shot], steps_since_start(shot)
    before = now
    for one in reversed(past):
        step = steps_since_start(one)
        if now - step > steps or step >= before:
            break
        shots.append(one)
        before = step
    return shots[::-1]


def steps_since_start(shot: Snapshot) -> int:
    """Return the number of control steps since the match began."""
    return int(shot.match["step"])


def path_since_jump(path: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return the part of a path since the last jump, without points that lie very near their neighbours."""
    piece = [path[-1]]
    for x, y in reversed(path[:-1]):
        away = hypot(x - piece[-1][0], y - piece[-1][1])
        if away > JUMP:
            break
        if away > LEAST_STEP:
            piece.append((x, y))
    return piece[::-1]


def mix_colours(one: Colour, other: Colour, share: float) -> Colour:
    """Mix two colours; share 0 gives the first, 1 the second."""
    red, green, blue = (round(a + share * (b - a)) for a, b in zip(one, other, strict=True))
    return red, green, blue
