"""The potential field that a robot's team computes from the robot's beliefs, over the whole pitch."""

from __future__ import annotations

from math import cos, sin

import numpy as np

from soccer_env.leagues.robot_kind import CENTI
from soccer_env.records.beliefs import BELIEF, TRACK
from soccer_env.render.colours import Colour
from soccer_env.render.overlays.cast import Cast, Snapshot, TeamPart
from soccer_env.render.overlays.paths import planned_path
from soccer_env.render.overlays.shapes import ArrowGrid, Overlay
from soccer_env.teams import DecisionInputs
from soccer_env.thoughts.thought import Thought

ACROSS = 24  # arrows along the pitch
WEAK: Colour = (126, 190, 140)
STRONG: Colour = (255, 236, 130)


def force_arrows(
    cast: Cast, shot: Snapshot, row: int, thought: Thought, target: np.ndarray, unit: float
) -> list[Overlay]:
    """Return arrows on a grid that point in the direction of the force; length and colour show its strength."""
    points, cell = grid(cast.league.pitch.length, cast.league.pitch.width)
    vectors = forces_at(cast, shot, row, thought, target, points)
    size = np.hypot(*vectors.T)
    share = relative_strengths(size)
    long = cell * (0.25 + 0.7 * share) / np.maximum(size, 1e-12)
    return [ArrowGrid(points, long[:, None] * vectors, share, WEAK, STRONG, 1.9 * unit)]


def forces_at(
    cast: Cast, shot: Snapshot, row: int, thought: Thought, target: np.ndarray, points: np.ndarray
) -> np.ndarray:
    """Return the forces (P, 2) on robot `row` if it stood at each of the points (P, 2), field frame."""
    part = cast.parts[row]
    home_ahead = float(shot.match["home_direction"]) > 0.0
    sign = 1.0 if home_ahead == (int(shot.robots["team"][row]) == 0) else -1.0
    assert part.explanation is not None and part.explanation.forces is not None and part.settings is not None
    mind = rebuild_inputs(thought, sign, cast.constants, part.settings)
    return sign * part.explanation.forces(mind, sign * target, sign * points)


def relative_strengths(size: np.ndarray) -> np.ndarray:
    """Return the relative strength of forces (P,), from 0 to 1: one half for the median."""
    return np.asarray(size / (size + np.median(size) + 1e-12))


def has_forces(part: TeamPart | None) -> bool:
    """Tell whether a team explains its forces."""
    explanation = None if part is None else part.explanation
    return explanation is not None and explanation.forces is not None and part is not None and part.settings is not None


def force_target(part: TeamPart, thought: Thought) -> np.ndarray | None:
    """Return the target of the forces (2,) [m]: the end of the plan; None if there is no plan but forces need one."""
    plan = planned_path(thought)
    if len(plan):
        return np.asarray(plan[-1])
    return None if part.explanation is not None and part.explanation.needs_target else np.zeros(2)


def grid(length: float, width: float) -> tuple[np.ndarray, float]:
    """Return the middles (P, 2) [m] of square cells that fill a pitch, and the side of a cell [m]."""
    cell = length / ACROSS
    up = max(1, round(width / cell))
    x = (np.arange(ACROSS) + 0.5) * cell - length / 2
    y = (np.arange(up) + 0.5) * width / up - width / 2
    return np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2), cell


def rebuild_inputs(thought: Thought, sign: float, constants: np.ndarray, settings: np.ndarray) -> DecisionInputs:
    """Rebuild the records that a team decides from out of a note; `sign` -1 turns the field frame by half a turn."""
    beliefs, tracks = np.zeros(1, BELIEF), np.zeros((1, max(1, len(thought.players))), TRACK)
    x, y, heading = thought.pose
    own = beliefs["own"][0]
    own["x"], own["y"] = sign * x, sign * y
    own["heading"] = heading if sign > 0.0 else heading + np.pi
    for track, player in zip(tracks[0], thought.players, strict=False):
        track["present"], track["teammate"], track["age"] = 1, int(player.mate), player.age
        track["x"], track["y"] = to_pose_frame(thought.pose, player.x, player.y)
        track["distance"], track["bearing"] = np.hypot(track["x"], track["y"]), np.arctan2(track["y"], track["x"])
    if thought.ball is not None:
        beliefs["ball"]["x"][0], beliefs["ball"]["y"][0] = to_pose_frame(thought.pose, *thought.ball)
    if "obstacle" in thought.groups:
        bearing, distance = (thought.groups["obstacle"][0] / CENTI).tolist()
        beliefs["obstacle"]["bearing"], beliefs["obstacle"]["distance"] = bearing, distance
    return DecisionInputs(beliefs, tracks, np.zeros(1), np.zeros((1, 1)), constants, settings)


def to_pose_frame(pose: tuple[float, float, float], x: float, y: float) -> tuple[float, float]:
    """Convert a point of the field to the frame of a pose: metres ahead, metres to the left."""
    across, up, heading = x - pose[0], y - pose[1], pose[2]
    return cos(heading) * across + sin(heading) * up, cos(heading) * up - sin(heading) * across
