"""The sketch of a picture: the position of each coloured thing, in fractions of pixels and without noise.

A thing is a sphere (the ball) or an upright panel (stickers, goals, landmarks, patches). It becomes one piece or, where
bodies stand before it, several: each a box and its coloured area. Pieces are listed by kind; `sketch` is scratch that a
slice of matches makes once.

`k`: the league's constants; `s`: settings of the sensors.
"""

from math import inf, pi, sqrt

import numpy as np

from soccer_env.compiled import compiled, scratch_records
from soccer_env.leagues.legged_sensors import STICKERS_MOST
from soccer_env.perception.legged.bodies import BODY, RECTANGLE, measure_hull
from soccer_env.perception.legged.camera import (
    CAMERA,
    POSE,
    face_ahead,
    in_view,
    open_camera,
    sphere_box,
    to_camera_axes,
)
from soccer_env.perception.legged.occlusion import (
    COLUMN,
    COLUMNS,
    HIDDEN,
    PIECE,
    PIECES,
    TARGET,
    add_piece,
    cut_into_pieces,
    fill_sphere_ellipse,
    find_hiders,
)
from soccer_env.perception.legged.outlines import (
    LENS,
    OUTLINE,
    TRACING,
    begin_outline,
    end_outline,
    project_rectangle,
    put_corner,
    set_convex_hull,
)
from soccer_env.records.percepts import BLOB, LANDMARKS, OTHERS
from soccer_env.types import MAX_TEAM

BALL, TEAMMATES, OPPONENTS, OWN_GOAL, OPPONENT_GOAL, PATCHES, LANDMARK = range(7)  # kinds of pieces
KINDS = 7
STICKERS = 2 * STICKERS_MOST  # of a body in view at once, at most: two sides of its trunk
NOBODY = -1

PANEL = np.dtype(
    [  # an upright rectangle, in the level axes of the camera
        ("ahead", "f8"),  # [m] its middle
        ("left", "f8"),  # [m]
        ("across", "f8"),  # [m] from the middle to one end, over the ground: ahead
        ("aside", "f8"),  # [m] left
        ("low", "f8"),  # [m] over the ground
        ("high", "f8"),  # [m]
    ]
)
SKETCH = np.dtype(
    [
        ("camera", CAMERA),
        ("hull", RECTANGLE),
        ("poses", POSE, (2 * MAX_TEAM,)),  # of all robots
        ("bodies", BODY, (OTHERS,)),
        ("body_count", "i8"),
        ("outlines", OUTLINE, (2 * OTHERS,)),  # of the boxes of each body
        ("hiders", "i8", (2 * OTHERS,)),  # outlines that hide a part of the target
        ("columns", COLUMN, (COLUMNS,)),  # into which the target is cut
        ("target", TARGET),  # what is being drawn
        ("tracing", TRACING),
        ("body_tracing", TRACING),
        ("panel", PANEL),
        ("stickers", PANEL, (STICKERS,)),
        ("counts", "i8", (KINDS,)),  # pieces of each kind
        ("pieces", PIECE, (KINDS, PIECES)),
        ("landmarks", PIECE, (LANDMARKS,)),  # the largest piece of each; area 0: none
        ("spare_piece", PIECE, (1,)),  # for the exchange of two
        ("spare_blob", BLOB, (1,)),
    ]
)


@compiled
def make_sketch(k, s):
    """Return an empty sketch (1,) that holds the constants of a league's robots and of their camera."""
    sketches = scratch_records(1, SKETCH)
    open_camera(sketches[0].camera, s)
    measure_hull(sketches[0].hull, k, s)
    for r in range(2 * MAX_TEAM):
        face_ahead(sketches[0].poses[r])
    return sketches


@compiled
def draw_panel(sketch, panel, kind, owner, own_head, apart):
    """Draw an upright panel into a sketch.

    `owner` is the body that wears it, or NOBODY; `own_head` True: the owner's head may hide it. `apart` True: the panel
    stands beyond all robots, so that every body that overlaps it hides it.
    """
    camera, target = sketch.camera, sketch.target
    outline = target.outline
    if not project_panel(camera, panel, sketch.tracing, outline) or is_outside(camera, outline):
        return
    target.ahead, target.left, target.low, target.high = panel.ahead, panel.left, panel.low, panel.high
    target.across = panel.across
    target.aside = panel.aside
    target.reach = 0.0
    hiders = find_hiders(sketch, owner, own_head, apart)
    if hiders == HIDDEN:
        return
    if hiders == 0 and is_inside(camera, outline):
        add_piece(sketch, kind, outline.left, outline.right, outline.high, outline.low, quadrangle_area(sketch.tracing))
        return
    trace_panel(sketch.tracing, outline)
    target.is_round = 0
    cut_into_pieces(sketch, kind, hiders)


@compiled
def project_panel(camera, panel, tracing, outline):
    """Project a panel and compute its bounding box; return whether any part of the panel is in front of the lens.

    `trace_panel` computes the chains for the few panels that need them; a panel cut off at the lens gets them here.
    """
    corners = tracing.corners
    nearest = inf
    farthest = -inf
    for i in range(4):  # round it
        side = 1.0 if i < 2 else -1.0
        height = panel.high if i == 1 or i == 2 else panel.low
        ahead, left = panel.ahead + side * panel.across, panel.left + side * panel.aside
        depth = put_corner(camera, corners[i], ahead, left, height)
        nearest, farthest = min(nearest, depth), max(farthest, depth)
    if farthest < LENS:
        return False
    if nearest < LENS:
        set_convex_hull(outline, tracing.points, project_rectangle(camera, tracing))
        return True
    one, other = (0, 2) if corners[0].u < corners[3].u else (2, 0)  # at the right end and at the left one
    outline.right = min(corners[one].u, corners[one + 1].u)
    outline.left = max(corners[other].u, corners[other + 1].u)
    outline.high = max(max(corners[0].v, corners[1].v), max(corners[2].v, corners[3].v))
    outline.low = min(min(corners[0].v, corners[1].v), min(corners[2].v, corners[3].v))
    return True


@compiled
def trace_panel(tracing, outline):
    """Compute the upper and lower chain of a panel that `project_panel` has projected."""
    corners = tracing.corners
    if min(min(corners[0].depth, corners[1].depth), min(corners[2].depth, corners[3].depth)) < LENS:
        return  # `project_panel` has traced them already
    if corners[0].u < corners[3].u:
        begin_outline(outline, corners[1], corners[0])
        end_outline(outline, corners[2], corners[3])
    else:
        begin_outline(outline, corners[2], corners[3])
        end_outline(outline, corners[1], corners[0])


@compiled
def quadrangle_area(tracing):
    """Return the area [px] of the quadrangle between the first four corners, as half a cross product."""
    a, b, c, d = tracing.corners[0], tracing.corners[1], tracing.corners[2], tracing.corners[3]
    return 0.5 * abs((c.u - a.u) * (d.v - b.v) - (c.v - a.v) * (d.u - b.u))


@compiled
def is_outside(camera, outline):
    """Tell whether an outline lies wholly outside the picture."""
    return (
        outline.right >= camera.half_width
        or outline.left <= -camera.half_width
        or outline.low >= camera.half_height
        or outline.high <= -camera.half_height
    )


@compiled
def is_inside(camera, outline):
    """Tell whether an outline lies wholly inside the picture."""
    return (
        outline.left <= camera.half_width
        and outline.right >= -camera.half_width
        and outline.high <= camera.half_height
        and outline.low >= -camera.half_height
    )


@compiled
def draw_sphere(sketch, ahead, left, radius, kind):
    """Draw a ball that lies on the ground into a sketch: the ellipse that a sphere makes in the picture.  MS04"""
    camera, target = sketch.camera, sketch.target
    if not in_view(camera, ahead, left, radius, radius):
        return
    depth, beside, above = to_camera_axes(camera, ahead, left, radius)
    beyond = depth * depth + beside * beside + above * above - radius * radius
    if depth <= radius + LENS or beyond <= 0.0:  # beside the lens or round it
        return
    outline = target.outline
    outline.left, outline.right, outline.high, outline.low = sphere_box(camera, depth, beside, above, radius)
    if is_outside(camera, outline):
        return
    target.ahead, target.left, target.low, target.high = ahead, left, 0.0, 2.0 * radius
    target.across = 0.0
    target.aside = 0.0
    target.reach = radius
    hiders = find_hiders(sketch, NOBODY, False, False)
    if hiders == HIDDEN:
        return
    if hiders == 0 and is_inside(camera, outline):
        inner = depth * depth - radius * radius
        area = pi * radius * radius * sqrt(beyond) / (inner * sqrt(inner)) * camera.focal_x * camera.focal_y
        add_piece(sketch, kind, outline.left, outline.right, outline.high, outline.low, area)
        return
    fill_sphere_ellipse(camera, target, depth, beside, above, beyond)
    cut_into_pieces(sketch, kind, hiders)
