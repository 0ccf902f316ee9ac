"""Outlines of panels and boxes in the picture: convex polygons, stored as an upper and a lower chain of corners.

A chain runs from right to left, that is with growing u, so that a walk along the columns looks at each corner only
once. An outline is traced in one of two ways:

* begin_outline, add_upper and add_lower, end_outline: its corners are known in order, and all lie before the lens;
* project_..., enclose: parts behind the lens are cut off, and the outline is the hull of the rest.
"""

from math import inf

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.perception.legged.camera import to_camera_axes

LENS = 0.01  # [m] depth at which things that reach behind the lens are cut off, assumed
CORNERS = 8  # of a box
POINTS = 16  # most corners of an outline: those of a box, and where it is cut off

CORNER = np.dtype(
    [
        ("depth", "f8"),  # [m] along the optical axis
        ("left", "f8"),  # [m]
        ("above", "f8"),  # [m]
        ("u", "f8"),  # [px] in the picture, if it is before the lens
        ("v", "f8"),  # [px]
    ]
)
POINT = np.dtype([("u", "f8"), ("v", "f8"), ("slope", "f8")])  # [px, px, 1] slope to the next point of a chain
CHAIN = np.dtype([("count", "i8"), ("points", POINT, (POINTS,))])  # points with growing u
OUTLINE = np.dtype(
    [
        ("left", "f8"),  # [px] the box round it
        ("right", "f8"),
        ("high", "f8"),
        ("low", "f8"),
        ("upper", CHAIN),
        ("lower", CHAIN),
    ]
)
TRACING = np.dtype([("corners", CORNER, (CORNERS,)), ("points", POINT, (POINTS,))])  # scratch


@compiled
def put_corner(camera, corner, ahead, left, height):
    """Convert a corner [m] to camera axes, project it if it lies in front of the lens, and return its depth [m]."""
    corner.depth, corner.left, corner.above = to_camera_axes(camera, ahead, left, height)
    if corner.depth >= LENS:
        scale = 1.0 / corner.depth
        corner.u, corner.v = camera.focal_x * corner.left * scale, camera.focal_y * corner.above * scale
    return corner.depth


# Corners in order


@compiled
def begin_outline(outline, top, bottom):
    """Begin an outline with the two corners at its right end; the corner farther right begins both chains."""
    upper, lower = outline.upper, outline.lower
    upper.count = lower.count = 0
    if top.u < bottom.u:
        add_to_chain(lower, top.u, top.v)
    else:
        add_to_chain(upper, bottom.u, bottom.v)
    add_to_chain(upper, top.u, top.v)
    add_to_chain(lower, bottom.u, bottom.v)
    outline.right = min(top.u, bottom.u)
    outline.high, outline.low = max(top.v, bottom.v), min(top.v, bottom.v)


@compiled
def add_upper(outline, corner):
    """Append a corner to the upper chain of an outline."""
    add_to_chain(outline.upper, corner.u, corner.v)
    outline.high, outline.low = max(outline.high, corner.v), min(outline.low, corner.v)


@compiled
def add_lower(outline, corner):
    """Append a corner to the lower chain of an outline."""
    add_to_chain(outline.lower, corner.u, corner.v)
    outline.high, outline.low = max(outline.high, corner.v), min(outline.low, corner.v)


@compiled
def end_outline(outline, top, bottom):
    """End an outline with the two corners at its left end; the corner farther left ends both chains."""
    add_upper(outline, top)
    add_lower(outline, bottom)
    if top.u > bottom.u:
        add_to_chain(outline.lower, top.u, top.v)
    else:
        add_to_chain(outline.upper, bottom.u, bottom.v)
    outline.left = max(top.u, bottom.u)


@compiled
def add_to_chain(chain, u, v):
    """Append a point to a chain, with the slope of the segment before it; a vertical segment gets slope 0."""
    count = chain.count
    if count > 0:
        last = chain.points[count - 1]
        wide = u - last.u
        last.slope = (v - last.v) / wide if wide > 0.0 else 0.0
    chain.points[count].u, chain.points[count].v = u, v
    chain.count = count + 1


# Cut off at the lens


@compiled
def project_box(camera, tracing):
    """Project the 8 corners of a box into the picture, clipped at the lens; return the number of points.

    Corners whose numbers differ in one bit share an edge.
    """
    corners = tracing.corners
    points = tracing.points
    count = 0
    for i in range(CORNERS):
        if corners[i].depth >= LENS:
            count = add_point(points, count, corners[i].u, corners[i].v)
        for bit in (1, 2, 4):
            if i & bit == 0:
                count = add_lens_crossing(camera, points, count, corners[i], corners[i + bit])
    return count


@compiled
def project_rectangle(camera, tracing):
    """Project the first 4 corners, a rectangle, into the picture, clipped at the lens; return the number of points."""
    corners = tracing.corners
    points = tracing.points
    count = 0
    for i in range(4):
        if corners[i].depth >= LENS:
            count = add_point(points, count, corners[i].u, corners[i].v)
        count = add_lens_crossing(camera, points, count, corners[i], corners[(i + 1) % 4])
    return count


@compiled
def add_point(points, count, u, v):
    """Append a point of the picture to the points; return the new number of points."""
    points[count].u, points[count].v = u, v
    return count + 1


@compiled
def add_lens_crossing(camera, points, count, one, other):
    """Append the point where an edge between two corners crosses the lens plane; return the number of points."""
    if (one.depth < LENS) == (other.depth < LENS):
        return count
    share = (LENS - one.depth) / (other.depth - one.depth)
    left, above = one.left + share * (other.left - one.left), one.above + share * (other.above - one.above)
    return add_point(points, count, camera.focal_x * left / LENS, camera.focal_y * above / LENS)


@compiled
def set_convex_hull(outline, points, count):
    """Set the outline to the convex hull of the points; sorts the points.  [Andrew 1979, monotone chain]"""
    sort_points(points, count)
    outline.upper.count = outline.lower.count = 0
    outline.left = outline.high = -inf
    outline.right = outline.low = inf
    for i in range(count):
        u, v = points[i].u, points[i].v
        add_convex_point(outline.lower, u, v, 1.0)
        add_convex_point(outline.upper, u, v, -1.0)
        outline.left, outline.right = max(outline.left, u), min(outline.right, u)
        outline.high, outline.low = max(outline.high, v), min(outline.low, v)


@compiled
def sort_points(points, count):
    """Sort points by u, then v."""
    for i in range(1, count):
        u = points[i].u
        v = points[i].v
        place = i
        while place > 0 and (points[place - 1].u > u or (points[place - 1].u == u and points[place - 1].v > v)):
            points[place] = points[place - 1]
            place -= 1
        points[place].u, points[place].v = u, v


@compiled
def add_convex_point(chain, u, v, side):
    """Append a point to a chain and drop points now inside the hull; side 1: the lower chain, -1: the upper chain."""
    points = chain.points
    while chain.count >= 2:
        before, last = points[chain.count - 2], points[chain.count - 1]
        if side * ((last.u - before.u) * (v - before.v) - (last.v - before.v) * (u - before.u)) > 0.0:
            break
        chain.count -= 1
    add_to_chain(chain, u, v)


@compiled
def segment_at(points, at, last, u):
    """Return the index of a chain's segment at column u [px], searched from index `at` to `last`."""
    while at < last and points[at + 1].u < u:
        at += 1
    return at


@compiled
def chain_height(chain, u):
    """Return the height v [px] of a chain at column u [px]."""
    points = chain.points
    at = segment_at(points, 0, chain.count - 2, u)
    return points[at].v + points[at].slope * (u - points[at].u)
