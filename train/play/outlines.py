"""Bodies, boards and posts as convex shapes, from what a league says of them.

In a checkout of before robots had legs the fields that say so are missing: they count as none.
"""

from __future__ import annotations

from itertools import product

import numpy as np

from soccer_env.leagues.league import League, Pitch
from soccer_env.leagues.robot import Body
from soccer_env.train.play.convex import Shape

DEEP = 0.5  # [m] thickness of boards; nothing gets that far into one
SWINGS_FIRST = (0, 3)  # left fore and right hind


def trunk_of(body: Body) -> Shape:
    """Return the hull, disc or capsule of a robot in its own frame."""
    back = getattr(body, "disc_back", 0.0)
    if body.corners:
        return Shape(np.array(body.corners), 0.0)
    if back > 0.0:
        return Shape(np.array([(body.disc_x - back, 0.0), (body.disc_x, 0.0)]), body.disc_radius)
    return Shape(np.array([(body.disc_x, 0.0)]), body.disc_radius)


def posts_of(body: Body) -> list[Shape]:
    """Return the posts of a robot in its own frame, standing: left fore, right fore, and left hind, right hind if any.

    The fore posts are the tips of the pocket.
    """
    places = [(body.tip_x, body.tip_y)] if body.tip_radius > 0.0 else []
    if getattr(body, "hind_y", 0.0) > 0.0:
        places.append((body.hind_x, body.hind_y))
    return [Shape(np.array([(x, side * y)]), body.tip_radius) for (x, y), side in product(places, (1.0, -1.0))]


def swung(league: League, robots: np.ndarray) -> list[Shape]:
    """Return the posts of robots (N,) in their own frames as their gait has swung them, see `physics.gait`.

    For matches of the usual handedness. The stroke is what the ground under a post's stance does in half a gait step.
    """
    posts = posts_of(league.body)
    if not has_legs(league.body):
        return posts
    walk, done = robots["walk"], robots["gait_phase"] % league.drive.gait_steps / league.drive.gait_steps
    ahead = np.where(done <= 0.5, 4.0 * done - 1.0, 3.0 - 4.0 * done) * 0.25 * league.drive.gait_steps * league.dt
    found = []
    for leg, post in enumerate(posts):
        (x, y), half = post.corners[0], ahead if leg in SWINGS_FIRST else -ahead
        offset = half * (walk["forward"] - walk["turn"] * y), half * (walk["left"] + walk["turn"] * x)
        found.append(Shape(post.corners + np.stack(offset, axis=-1)[:, None, :], post.radius))
    return found


def has_legs(body: Body) -> bool:
    """Tell whether a robot's posts are legs, which swing and meet the feet of boards."""
    return getattr(body, "legs", False)


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
