"""Where a robot plans to go, where it and the ball came from."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

import numpy as np

from soccer_env.leagues.robot_kind import CENTI
from soccer_env.render.colours import BALL_SHINE, CARPET, INK, TEAMS_LIGHT, WHITE, Colour
from soccer_env.render.overlays.cast import Shot
from soccer_env.render.overlays.shapes import Overlay, Points, Polyline
from soccer_env.thoughts.thought import Thought

TRAVELLED = 6.0  # [s] of a robot's way that are shown
TRAIL = 2.5  # [s] of the ball's way
JUMP = 0.6  # [m] from shot to shot: it was put there
PIECES = 10  # of a trail, each paler than the one before
LEAST_STEP = 0.01  # [m] of a way between two of its points


def plan_of(thought: Thought) -> np.ndarray:
    """Return the planned way (N, 2) [m], field frame, empty where there is none."""
    path = thought.groups.get("plan", np.zeros((0, 2))) / CENTI
    return path if np.any(path) else np.zeros((0, 2))


def planned(path: np.ndarray, unit: float) -> list[Overlay]:
    """Return the planned way, a light line with a dark rim, and a ring round its end."""
    if len(path) < 2:
        return []
    rim = Polyline(path, INK, 4.6 * unit)
    return [rim, Polyline(path, WHITE, 2.4 * unit), Points([path[-1]], WHITE, 7.0 * unit, hollow=True)]


def travelled(past: Sequence[Shot], shot: Shot, row: int, rate: float, unit: float) -> list[Overlay]:
    """Return the way that a robot has come in the last seconds; `rate`: control steps a second."""
    tint = TEAMS_LIGHT[int(shot.robots["team"][row])]
    path = [(float(one.robots["x"][row]), float(one.robots["y"][row])) for one in latest(past, shot, TRAVELLED * rate)]
    return [Polyline(unbroken(path), tint, 2.0 * unit, under=True)]


def ball_trail(past: Sequence[Shot], shot: Shot, rate: float, unit: float) -> list[Overlay]:
    """Return the ball's way of the last seconds, the older the paler."""
    path = [(float(one.ball["x"]), float(one.ball["y"])) for one in latest(past, shot, TRAIL * rate)]
    piece = unbroken(path)
    ends = np.linspace(0, len(piece) - 1, PIECES + 1).round().astype(int).tolist()
    return [
        Polyline(piece[first : last + 1], mixed(CARPET, BALL_SHINE, (at + 1) / PIECES), 3.0 * unit, under=True)
        for at, (first, last) in enumerate(zip(ends, ends[1:]))
        if last > first
    ]


def latest(past: Sequence[Shot], shot: Shot, steps: float) -> list[Shot]:
    """Return the shots of the last control steps, this one the last; none from before the match began anew."""
    shots, now = [shot], step_of(shot)
    before = now
    for one in reversed(past):
        step = step_of(one)
        if now - step > steps or step >= before:
            break
        shots.append(one)
        before = step
    return shots[::-1]


def step_of(shot: Shot) -> int:
    """Return the control steps that the match has taken."""
    return int(shot.match["step"])


def unbroken(path: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return the part of a way since the last jump, without points that hardly differ."""
    piece = [path[-1]]
    for x, y in reversed(path[:-1]):
        away = hypot(x - piece[-1][0], y - piece[-1][1])
        if away > JUMP:
            break
        if away > LEAST_STEP:
            piece.append((x, y))
    return piece[::-1]


def mixed(one: Colour, other: Colour, share: float) -> Colour:
    """Return a colour between two."""
    red, green, blue = (round(a + share * (b - a)) for a, b in zip(one, other, strict=True))
    return red, green, blue
