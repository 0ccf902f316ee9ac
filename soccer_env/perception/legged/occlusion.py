"""Occlusion: find the visible parts of a thing behind other robots, column by column of the picture.

The thing is cut into columns of two pixels at most. In each column the outlines of bodies before it hide an
interval; neighbouring columns with a visible part make a piece. A piece ends where the hiding outline begins.
"""

from math import ceil, sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import into_frame, length
from soccer_env.perception.legged.bodies import HEAD, TRUNK, in_box_axes, trace_box
from soccer_env.perception.legged.outlines import OUTLINE, chain_height, segment_at

PIECES = 96  # pieces of a kind that a sketch has room for: the stickers of 11 others, and some cuts
COLUMNS = 176  # of a thing, at most
COLUMNS_LEAST = 8  # of a thing, at least
COLUMN_MOST = 2.0  # [px] width of a column, at most
SINKS = 0.008  # [m] by which bodies may overlap where they touch, far more than the physics lets them
HIDDEN = -1  # returned in place of a number of hiders: all is hidden
LEAST_AREA = 0.5  # [px] a thing that fills less than half of a pixel gives no pixel its colour

PIECE = np.dtype(
    [
        ("left", "f8"),  # [px] the box round it
        ("right", "f8"),
        ("high", "f8"),
        ("low", "f8"),
        ("area", "f8"),  # [px] of its colour
    ]
)
COLUMN = np.dtype(
    [  # the visible part of a column of the target, in one interval or two; [px]
        ("low", "f8"),
        ("high", "f8"),  # not above low: nothing is left
        ("second_low", "f8"),
        ("second_high", "f8"),  # not above second_low: there is no second part
    ]
)
TARGET = np.dtype(
    [
        ("ahead", "f8"),  # [m] its middle, in the level axes of the camera
        ("left", "f8"),  # [m]
        ("across", "f8"),  # [m] of a panel from the middle to one end: ahead
        ("aside", "f8"),  # [m] left
        ("reach", "f8"),  # [m] of a sphere: its radius; of a panel 0
        ("low", "f8"),  # [m] over the ground
        ("high", "f8"),  # [m]
        ("is_round", "i8"),  # 1 a sphere, 0 a polygon
        ("outline", OUTLINE),  # of a sphere only the box round it is filled in, of a panel its chains as well
        # Of a sphere: column u goes from m - r to m + r, m = middle + lean u, r^2 = square + along u + bend u^2  [px]
        ("middle", "f8"),
        ("lean", "f8"),
        ("square", "f8"),
        ("along", "f8"),
        ("bend", "f8"),
    ]
)


@compiled
def add_piece(sketch, kind, left, right, high, low, area):
    """Append a visible piece to the sketch's list of its kind, unless the piece is too small or the list is full."""
    count = sketch.counts[kind]
    if area < LEAST_AREA or count >= PIECES:
        return
    piece = sketch.pieces[kind, count]
    piece.left, piece.right, piece.high, piece.low = left, right, high, low
    piece.area = area
    sketch.counts[kind] = count + 1


@compiled
def find_hiders(sketch, owner, own_head, apart):
    """List the outlines that may hide the target; return their number, or HIDDEN if one of them hides all of it.

    `owner`, `own_head` and `apart` are as in `draw_panel`.
    """
    camera, target = sketch.camera, sketch.target
    ahead = target.ahead
    left = target.left
    eye = camera.height
    count = 0
    distance, radius = length(ahead, left), target.reach + length(target.across, target.aside)
    for i in range(sketch.body_count):
        for part in (TRUNK, HEAD):
            box, outline = sketch.bodies[i].boxes[part], sketch.outlines[2 * i + part]
            if i == owner and not (own_head and part == HEAD):
                continue
            if box.shown == 0 or box.distance - box.radius > distance + radius:
                continue  # it stands behind, or out of the picture
            if box.high <= eye <= target.low or target.high <= eye <= box.low:
                continue  # it stands below the height of the eye and the target above, or the other way round
            if abs(box.ahead * left - box.left * ahead) > box.radius * distance + radius * box.distance:
                continue  # it stands aside: the sine of the angle between is more than what both fill
            if not (apart or box_may_hide(camera, box, target)):
                continue
            if box.traced == 0:
                trace_box(camera, box, sketch.body_tracing, outline)
            if not boxes_overlap(outline, target.outline):
                continue
            if covers_box(outline, target.outline):
                return HIDDEN
            sketch.hiders[count] = 2 * i + part
            count += 1
    return count


@compiled
def box_may_hide(camera, box, target):
    """Tell whether a box may hide the target: no side face of the box has camera and target both outside of it.

    A target that crosses the plane of a side counts as inside, which is right where the two overlap in the picture. A
    target may sink into a touching robot by SINKS.
    """
    eye_x, eye_y = in_box_axes(box, 0.0, 0.0)
    x, y = in_box_axes(box, target.ahead, target.left)
    deep = target.reach - SINKS
    along, beside = into_frame(target.across, target.aside, box.cosine, box.sine)
    along, beside = deep + abs(along), deep + abs(beside)
    return not (
        min(eye_x, x - along) >= box.half_length
        or max(eye_x, x + along) <= -box.half_length
        or min(eye_y, y - beside) >= box.half_width
        or max(eye_y, y + beside) <= -box.half_width
        or min(camera.height, target.low + SINKS) >= box.high
        or max(camera.height, target.high - SINKS) <= box.low
    )


@compiled
def boxes_overlap(one, other):
    """Tell whether the bounding boxes of two outlines overlap in the picture."""
    return one.right < other.left and other.right < one.left and one.low < other.high and other.low < one.high


@compiled
def covers_box(outline, other):
    """Tell whether an outline contains the whole bounding box of another outline."""
    if outline.right > other.right or outline.left < other.left:
        return False
    lower, upper = outline.lower, outline.upper
    return (
        chain_height(upper, other.right) >= other.high
        and chain_height(upper, other.left) >= other.high
        and chain_height(lower, other.right) <= other.low
        and chain_height(lower, other.left) <= other.low
    )


@compiled
def cut_into_pieces(sketch, kind, hiders):
    """Add the visible pieces of the target to the sketch; the first `hiders` listed outlines may hide parts of it."""
    camera = sketch.camera
    outline = sketch.target.outline
    columns = sketch.columns
    right, left = max(outline.right, -camera.half_width), min(outline.left, camera.half_width)
    if right >= left:
        return
    count = min(max(int(ceil((left - right) / COLUMN_MOST)), COLUMNS_LEAST), COLUMNS)
    width = (left - right) / count
    fill_columns(sketch.target, columns, count, right, width, camera.half_height)
    for i in range(hiders):
        hide_columns(sketch.outlines[sketch.hiders[i]], columns, count, right, width)
    end = 0
    while end < count:
        begin = end
        while begin < count and columns[begin].low >= columns[begin].high:
            begin += 1
        end = begin
        while end < count and columns[end].low < columns[end].high:
            end += 1
        if begin < end:
            first = visible_edge(sketch, hiders, begin, count, right, width, True)
            last = visible_edge(sketch, hiders, end, count, right, width, False)
            add_piece_of_columns(sketch, kind, columns, begin, end, first, last, width)


@compiled
def add_piece_of_columns(sketch, kind, columns, begin, end, first, last, width):
    """Add the piece that consists of columns begin, ..., end - 1, from u = first to u = last [px]."""
    bottom = columns[begin].low
    top = columns[begin].high
    total = 0.0
    for i in range(begin, end):
        column = columns[i]
        bottom = min(bottom, column.low)
        top = max(top, column.high)
        total = total + column.high - column.low
        if column.second_low < column.second_high:
            bottom, top = min(bottom, column.second_low), max(top, column.second_high)
            total += column.second_high - column.second_low
    share = (last - first) / ((end - begin) * width)  # of the columns' area: the piece may end within a column
    add_piece(sketch, kind, last, first, top, bottom, total * width * share)


@compiled
def visible_edge(sketch, hiders, column, count, right, width, opens):
    """Return the position u [px] of the edge between a visible column and a neighbouring hidden column.

    The edge is where a hider ends or begins between the middles of the two columns, else half-way between them.
    """
    edge = right + column * width
    if column == 0 or column == count:
        return edge
    low, high = edge - 0.5 * width, edge + 0.5 * width
    for i in range(hiders):
        outline = sketch.outlines[sketch.hiders[i]]
        u = outline.left if opens else outline.right
        if low < u < high:
            return u
    return edge


@compiled
def fill_columns(target, columns, count, right, width, border):
    """Compute the lower and upper end [px] of the target in the middle of each column, within the picture."""
    if target.is_round == 1:
        for i in range(count):
            u, column = right + (i + 0.5) * width, columns[i]
            middle = target.middle + target.lean * u
            half = sqrt(max(target.square + (target.along + target.bend * u) * u, 0.0))
            column.low, column.high = max(middle - half, -border), min(middle + half, border)
            column.second_low = column.second_high = 0.0
        return
    lower, upper = target.outline.lower.points, target.outline.upper.points
    lower_last, upper_last = target.outline.lower.count - 2, target.outline.upper.count - 2
    i = j = 0
    for at in range(count):
        u, column = right + (at + 0.5) * width, columns[at]
        i, j = segment_at(lower, i, lower_last, u), segment_at(upper, j, upper_last, u)
        low, high = segment_height(lower[i], u), segment_height(upper[j], u)
        column.low, column.high = max(low, -border), min(high, border)
        column.second_low = column.second_high = 0.0


@compiled
def segment_height(point, u):
    """Return the height v [px] at column u [px] on the chain's segment that begins at `point`."""
    return point.v + point.slope * (u - point.u)


@compiled
def hide_columns(outline, columns, count, right, width):
    """Remove from each column the interval that an outline hides."""
    lower, upper = outline.lower.points, outline.upper.points
    lower_last, upper_last = outline.lower.count - 2, outline.upper.count - 2
    first = max(int(ceil((outline.right - right) / width - 0.5)), 0)
    last = min(int(ceil((outline.left - right) / width - 0.5)), count)
    i = j = 0
    for at in range(first, last):
        u = right + (at + 0.5) * width
        i, j = segment_at(lower, i, lower_last, u), segment_at(upper, j, upper_last, u)
        low, high = segment_height(lower[i], u), segment_height(upper[j], u)
        hide_interval(columns[at], low, high)


@compiled
def hide_interval(column, low, high):
    """Remove the interval low ... high [px] from a column's visible parts, of which at most two are kept."""
    if column.second_low < column.second_high:
        if low <= column.second_low:
            column.second_low = max(column.second_low, high)
        else:
            column.second_high = min(column.second_high, low)
    if low > column.low and high < column.high:
        if column.high - high > column.second_high - column.second_low:
            column.second_low, column.second_high = high, column.high
        column.high = low
    elif low <= column.low:
        column.low = max(column.low, high)
    else:
        column.high = min(column.high, low)
    if column.low >= column.high and column.second_low < column.second_high:
        column.low, column.high = column.second_low, column.second_high
        column.second_low = column.second_high = 0.0


@compiled
def fill_sphere_ellipse(camera, target, depth, beside, above, beyond):
    """Compute the ellipse that a sphere makes in the picture.

    The sphere's middle c is at depth, beside, above [m] in camera axes; `beyond` is |c|^2 less the square of the
    radius. A line of sight r touches the sphere where (r . c)^2 = |r|^2 beyond, a quadratic equation in r's slopes.
    """
    narrow = beyond - above * above  # above 0: the sphere lies before the lens
    slope, scale = 1.0 / camera.focal_x, camera.focal_y / narrow
    beside *= slope
    target.is_round = 1
    target.middle, target.lean = scale * above * depth, scale * above * beside
    # (above along)^2 + narrow (along^2 - beyond (1 + slope^2)) with along = depth + beside u; the squares of u, u, 1:
    scale *= scale * beyond
    target.square = scale * (depth * depth - narrow)
    target.along = scale * 2.0 * depth * beside
    target.bend = scale * (beside * beside - narrow * slope * slope)
