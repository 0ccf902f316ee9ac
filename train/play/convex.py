"""Signed distance of convex shapes: polygons, segments and points, all with a radius around them.

Depth is what two shapes would have to be pulled apart by to touch only (the least over the directions square to an
edge, as in the theorem of separating axes).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

POINTLESS = 1e-12  # [m] an edge this short is a point


class Shape(NamedTuple):
    """A convex hull of corners, drawn out by a radius: one corner is a disc, two are a capsule."""

    corners: np.ndarray  # (..., k, 2) [m] counter-clockwise
    radius: float  # [m]


def gap(first: Shape, second: Shape) -> np.ndarray:
    """Return the distance (...) [m] of two shapes; below 0 it is minus the depth by which they overlap."""
    one, other = first.corners, second.corners
    apart = np.minimum(nearest(one, other), nearest(other, one))
    between = np.maximum(separation(one, other), separation(other, one))
    overlaps = (between < 0.0) & np.isfinite(between)
    found: np.ndarray = np.where(overlaps, between, apart) - first.radius - second.radius
    return found


def nearest(points: np.ndarray, hull: np.ndarray) -> np.ndarray:
    """Return the least distance (...) [m] of points (..., p, 2) from the edges of a hull (..., k, 2)."""
    away, edge, squared = edges(points, hull)
    along = np.clip((away * edge).sum(axis=-1) / np.maximum(squared, POINTLESS**2), 0.0, 1.0)
    rest = away - along[..., None] * edge
    found: np.ndarray = np.sqrt((rest * rest).sum(axis=-1).min(axis=(-1, -2)))
    return found


def separation(points: np.ndarray, hull: np.ndarray) -> np.ndarray:
    """Return how far (...) [m] all points (..., p, 2) lie beyond that edge of a hull which parts them best.

    Below 0 no edge parts them; -inf for a hull that is a point and has none.
    """
    away, edge, squared = edges(points, hull)
    outward = away[..., 0] * edge[..., 1] - away[..., 1] * edge[..., 0]
    beyond = np.where(squared > POINTLESS**2, outward / np.sqrt(np.maximum(squared, POINTLESS**2)), -np.inf)
    found: np.ndarray = beyond.min(axis=-2).max(axis=-1)
    return found


def edges(points: np.ndarray, hull: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return points as seen from the beginning of each edge (..., p, k, 2), the edges, their squared lengths."""
    edge = np.roll(hull, -1, axis=-2) - hull
    away = points[..., :, None, :] - hull[..., None, :, :]
    return away, edge[..., None, :, :], (edge * edge).sum(axis=-1)[..., None, :]
