"""Bodies, boards and posts as convex shapes, from what a league says of them.

A league of before legs had posts has no such fields: what is missing counts as none.
"""

from __future__ import annotations

from itertools import product

import numpy as np

from soccer_env.leagues.league import Pitch
from soccer_env.leagues.robot import Body
from soccer_env.train.play.convex import Shape

DEEP = 0.5  # [m] thickness of boards; nothing gets that far into one


def shapes_of(body: Body) -> list[Shape]:
    """Return the shapes of a robot in its own frame: trunk, tips (or fore posts) and hind posts that stand still."""
    back = getattr(body, "disc_back", 0.0)
    if body.corners:
        trunk = Shape(np.array(body.corners), 0.0)
    elif back > 0.0:
        trunk = Shape(np.array([(body.disc_x - back, 0.0), (body.disc_x, 0.0)]), body.disc_radius)
    else:
        trunk = Shape(np.array([(body.disc_x, 0.0)]), body.disc_radius)
    return [trunk, *posts_of(body)]


def posts_of(body: Body) -> list[Shape]:
    """Return the tips of the pocket, and the hind posts of a body that has some."""
    places = [(body.tip_x, body.tip_y), (getattr(body, "hind_x", 0.0), getattr(body, "hind_y", 0.0))]
    return [
        Shape(np.array([(x, side * y)]), body.tip_radius)
        for (x, y), side in product(places, (1.0, -1.0))
        if body.tip_radius > 0.0 and (x, y) != (0.0, 0.0)
    ]


def placed(shape: Shape, robots: np.ndarray) -> Shape:
    """Return a shape of the robot frame at the poses of robots (...) as corners (..., k, 2) of the field frame."""
    cosine, sine = np.cos(robots["heading"])[..., None], np.sin(robots["heading"])[..., None]
    ahead, left = shape.corners[..., 0], shape.corners[..., 1]
    x = robots["x"][..., None] + cosine * ahead - sine * left
    y = robots["y"][..., None] + sine * ahead + cosine * left
    return Shape(np.stack((x, y), axis=-1), shape.radius)


def board_shapes(pitch: Pitch) -> list[Shape]:
    """Return what stands around a pitch: boards, goals' backs, and posts with the side nets where there is a band."""
    half_width = pitch.width / 2 + pitch.band_side
    far = pitch.length / 2 + max(pitch.band_end, pitch.goal_depth) + DEEP
    line = pitch.length / 2 + (0.0 if pitch.walled else max(pitch.band_end, pitch.goal_depth))
    back = pitch.length / 2 + pitch.goal_depth
    mouth = pitch.goal_width / 2
    shapes = [box(-far, far, side * half_width, side * (half_width + DEEP)) for side in (1, -1)]
    for end, side in product((1, -1), (1, -1)):
        shapes.append(box(end * line, end * far, side * mouth, side * (half_width + DEEP)))
        if not pitch.walled:
            y = side * (mouth + pitch.post_radius)
            start, stop = (end * (pitch.length / 2 + pitch.post_radius), y), (end * back, y)
            shapes.append(Shape(np.array([start, stop]), pitch.post_radius))
    return shapes + [box(end * back, end * (back + DEEP), -mouth, mouth) for end in (1, -1)]


def box(x1: float, x2: float, y1: float, y2: float) -> Shape:
    """Return the rectangle between two corners [m]."""
    left, right, low, high = min(x1, x2), max(x1, x2), min(y1, y2), max(y1, y2)
    return Shape(np.array([(left, low), (right, low), (right, high), (left, high)]), 0.0)
