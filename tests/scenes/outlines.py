"""How far robots, ball and boards are apart, by geometry alone: the outlines of a league as convex shapes.

A shape is a polygon, a segment or a point with a radius around it. Below 0 two shapes overlap by so much: depth is what
they would have to be pulled apart by to touch only (the least over the directions square to an edge, as in the theorem
of separating axes).
"""

from collections.abc import Sequence
from itertools import combinations, product
from typing import NamedTuple

import numpy as np

from soccer_env.leagues.league import League, Pitch
from soccer_env.leagues.robot import Body

DEEP = 0.5  # [m] thickness of boards; nothing gets that far into one
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
    return np.where(overlaps, between, apart) - first.radius - second.radius


def nearest(points: np.ndarray, hull: np.ndarray) -> np.ndarray:
    """Return the least distance (...) [m] of points (..., p, 2) from the edges of a hull (..., k, 2)."""
    away, edge, squared = edges(points, hull)
    along = np.clip((away * edge).sum(axis=-1) / np.maximum(squared, POINTLESS**2), 0.0, 1.0)
    rest = away - along[..., None] * edge
    return np.sqrt((rest * rest).sum(axis=-1).min(axis=(-1, -2)))


def separation(points: np.ndarray, hull: np.ndarray) -> np.ndarray:
    """Return how far (...) [m] all points (..., p, 2) lie beyond that edge of a hull which parts them best.

    Below 0 no edge parts them; -inf for a hull that is a point and has none.
    """
    away, edge, squared = edges(points, hull)
    outward = away[..., 0] * edge[..., 1] - away[..., 1] * edge[..., 0]
    beyond = np.where(squared > POINTLESS**2, outward / np.sqrt(np.maximum(squared, POINTLESS**2)), -np.inf)
    return beyond.min(axis=-2).max(axis=-1)


def edges(points: np.ndarray, hull: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return points as seen from the beginning of each edge (..., p, k, 2), the edges, their squared lengths."""
    edge = np.roll(hull, -1, axis=-2) - hull
    away = points[..., :, None, :] - hull[..., None, :, :]
    return away, edge[..., None, :, :], (edge * edge).sum(axis=-1)[..., None, :]


def trunk_of(body: Body) -> Shape:
    """Return the hull, disc or capsule of a robot in its own frame."""
    if body.corners:
        return Shape(np.array(body.corners), 0.0)
    back = [(body.disc_x - body.disc_back, 0.0)] if body.disc_back > 0.0 else []
    return Shape(np.array([*back, (body.disc_x, 0.0)]), body.disc_radius)


def posts_of(body: Body) -> list[Shape]:
    """Return the posts of a robot in its own frame, its legs at rest."""
    return [Shape(np.array([place]), body.tip_radius) for place in body.posts]


def placed(shape: Shape, robots: np.ndarray) -> Shape:
    """Return a shape of the robot frame at the poses of robots (...) as corners (..., k, 2) of the field frame."""
    cosine, sine = np.cos(robots["heading"])[..., None], np.sin(robots["heading"])[..., None]
    ahead, left = shape.corners[..., 0], shape.corners[..., 1]
    x = robots["x"][..., None] + cosine * ahead - sine * left
    y = robots["y"][..., None] + sine * ahead + cosine * left
    return Shape(np.stack((x, y), axis=-1), shape.radius)


def board_shapes(pitch: Pitch, foot: float = 0.0) -> list[Shape]:
    """Return what stands around a pitch: boards, goals' backs, and posts with the side nets where there is a band.

    The faces of the boards stand nearer by the reach of their feet [m], for who meets these.
    """
    half_width = pitch.width / 2 + pitch.band_side
    far = pitch.length / 2 + max(pitch.band_end, pitch.goal_depth) + DEEP
    line = pitch.length / 2 + (0.0 if pitch.walled else max(pitch.band_end, pitch.goal_depth))
    back = pitch.length / 2 + pitch.goal_depth
    mouth = pitch.goal_width / 2
    shapes = [box(-far, far, side * (half_width - foot), side * (half_width + DEEP)) for side in (1, -1)]
    for end, side in product((1, -1), (1, -1)):
        shapes.append(box(end * (line - foot), end * far, side * mouth, side * (half_width + DEEP)))
        if not pitch.walled:
            y = side * (mouth + pitch.post_radius)
            start, stop = (end * (pitch.length / 2 + pitch.post_radius), y), (end * back, y)
            shapes.append(Shape(np.array([start, stop]), pitch.post_radius))
    return shapes + [box(end * back, end * (back + DEEP), -mouth, mouth) for end in (1, -1)]


def box(x1: float, x2: float, y1: float, y2: float) -> Shape:
    """Return the rectangle between two corners [m]."""
    left, right, low, high = min(x1, x2), max(x1, x2), min(y1, y2), max(y1, y2)
    return Shape(np.array([(left, low), (right, low), (right, high), (left, high)]), 0.0)


def robot_gaps(league: League, robots: np.ndarray) -> np.ndarray:
    """Return the gaps (M, P) [m] between the robots (M, R) of each pair, legs at rest."""
    pairs = np.array(list(combinations(range(robots.shape[1]), 2)), np.int64).reshape(-1, 2)
    one, other = robots[:, pairs[:, 0]], robots[:, pairs[:, 1]]
    standing = [trunk_of(league.body), *posts_of(league.body)]
    gaps = least_gap([placed(shape, one) for shape in standing], [placed(shape, other) for shape in standing])
    return np.where((one["active"] == 1) & (other["active"] == 1), gaps, np.inf)


def ball_board_gaps(league: League, balls: np.ndarray) -> np.ndarray:
    """Return the gaps (M,) [m] between balls and boards; posts and nets of goals count as boards."""
    places = np.stack((balls["x"], balls["y"]), axis=-1)[:, None, :]
    return least_gap([Shape(places, league.ball.radius)], board_shapes(league.pitch))


def robot_board_gaps(league: League, robots: np.ndarray) -> np.ndarray:
    """Return the gaps (M, R) [m] between robots and boards; posts of legs meet the feet of the boards."""
    foot = league.pitch.board_foot if league.body.legs else 0.0
    of_trunk = least_gap([placed(trunk_of(league.body), robots)], board_shapes(league.pitch))
    posts = [placed(post, robots) for post in posts_of(league.body)]
    of_posts = least_gap(posts, board_shapes(league.pitch, foot)) if posts else np.inf
    return np.where(robots["active"] == 1, np.minimum(of_trunk, of_posts), np.inf)


def least_gap(some: Sequence[Shape], others: Sequence[Shape]) -> np.ndarray:
    """Return the least gap (N,) between any shape of the one list and any of the other."""
    return np.min([gap(one, other) for one, other in product(some, others)], axis=0)
