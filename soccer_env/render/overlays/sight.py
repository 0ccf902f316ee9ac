"""The field of view of a camera and its percepts, drawn from the true pose of the robot."""

from __future__ import annotations

from collections.abc import Mapping
from math import atan, cos, pi, sin

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.leagues.robot_kind import CENTI, LINE_STEPS
from soccer_env.render.colours import BALL, GOALS, KEEPER, TEAMS_LIGHT, WHITE, Colour
from soccer_env.render.overlays.cast import Camera, Cast, Snapshot
from soccer_env.render.overlays.shapes import Area, Overlay, Points, Polyline

SIGHT: Colour = (255, 246, 190)
RAYS = 41  # of the fan that shows the field of view
BLOB_RAYS = 5

Pose = tuple[float, float, float]
Groups = Mapping[str, np.ndarray]


def sight_overlays(cast: Cast, shot: Snapshot, row: int, groups: Groups, unit: float) -> list[Overlay]:
    """Return overlays of the field of view and the percepts of a robot (row)."""
    robot = shot.robots[row]
    pose = (float(robot["x"]), float(robot["y"]), float(robot["heading"]))
    tints = thing_colours(int(robot["team"]), float(shot.match["home_direction"]))
    if "head" in groups and cast.camera is not None:
        return head_camera_overlays(cast.league, cast.camera, pose, groups, tints, unit)
    return omni_camera_overlays(cast, pose, groups, tints, unit)


def thing_colours(team: int, home_direction: float) -> dict[str, Colour]:
    """Return the colours of the things that a robot of a team sees."""
    own_end = 0 if (home_direction > 0.0) == (team == 0) else 1
    return {
        "ball": BALL,
        "own_goal": GOALS[own_end],
        "opponent_goal": GOALS[1 - own_end],
        "teammates": TEAMS_LIGHT[team],
        "opponents": TEAMS_LIGHT[1 - team],
        "landmarks": WHITE,
    }


def head_camera_overlays(
    league: League, camera: Camera, pose: Pose, groups: Groups, tints: Mapping[str, Colour], unit: float
) -> list[Overlay]:
    """Return overlays of the field of view of a camera on a head, and a sector for each blob."""
    x, y = pose[0] + camera.neck * cos(pose[2]), pose[1] + camera.neck * sin(pose[2])
    middle = pose[2] + float(groups["head"][0, 0]) / CENTI
    edge = fan_of_rays(league, x, y, middle - camera.view / 2, middle + camera.view / 2, RAYS)
    overlays: list[Overlay] = [Area([(x, y), *edge], SIGHT, 55)]
    overlays.append(Polyline([edge[0], (x, y), edge[-1]], SIGHT, 1.5 * unit, under=True))
    for name in ("landmarks", "own_goal", "opponent_goal", "teammates", "opponents", "ball"):
        for left, right, _, _ in blob_boxes(groups.get(name)):
            low, high = (middle + atan(side / camera.focal) for side in sorted((left, right)))
            rim = fan_of_rays(league, x, y, low, high, BLOB_RAYS)
            overlays.append(Area([(x, y), *rim], tints[name], 105))
            overlays.append(Polyline([rim[0], (x, y), rim[-1]], tints[name], 1.2 * unit, under=True))
    return overlays


def blob_boxes(blobs: np.ndarray | None) -> list[tuple[int, int, int, int]]:
    """Return left, right, high and low [px] of each seen blob."""
    return [] if blobs is None else [tuple(box) for box in blobs.tolist() if any(box)]


def fan_of_rays(league: League, x: float, y: float, low: float, high: float, rays: int) -> list[tuple[float, float]]:
    """Return the points where rays from a point, spread between two directions [rad], leave the pitch."""
    return [ray_end(league, x, y, angle) for angle in np.linspace(low, high, rays).tolist()]


def ray_end(league: League, x: float, y: float, angle: float) -> tuple[float, float]:
    """Return the point where a ray from a point of the pitch leaves the pitch."""
    across, up = cos(angle), sin(angle)
    distances = []
    if abs(across) > 1e-9:
        distances.append((np.copysign(league.pitch.length / 2, across) - x) / across)
    if abs(up) > 1e-9:
        distances.append((np.copysign(league.pitch.width / 2, up) - y) / up)
    distance = max(0.0, float(min(distances)))
    return x + distance * across, y + distance * up


def omni_camera_overlays(
    cast: Cast, pose: Pose, groups: Groups, tints: Mapping[str, Colour], unit: float
) -> list[Overlay]:
    """Return rays to the percepts of an omnidirectional camera, and dots where it found white lines."""
    x, y, heading = pose
    overlays: list[Overlay] = []

    def ray(bearing: float, distance: float, tint: Colour) -> None:
        end = (x + distance * cos(heading + bearing), y + distance * sin(heading + bearing))
        overlays.append(Polyline([(x, y), end], tint, 1.6 * unit, under=True))
        overlays.append(Points([end], tint, 4.5 * unit))

    seen = groups.get("lines")
    if seen is not None:
        turn = 2.0 * pi / max(1, cast.line_directions)
        ranges = seen[: cast.line_directions, 0] / LINE_STEPS
        angles = heading + turn * np.arange(len(ranges))
        there = ranges > 0.0
        dots = np.column_stack([x + ranges * np.cos(angles), y + ranges * np.sin(angles)])[there]
        overlays.append(Points(dots, KEEPER, 2.6 * unit))
    for name in reversed(cast.rays):
        for bearing, distance in groups[name].tolist():
            mate = "teammates" if distance > 0 else "opponents"
            if distance != 0:
                ray(bearing / CENTI, abs(distance) / CENTI, tints.get(mate if name == "players" else name, WHITE))
    return overlays
