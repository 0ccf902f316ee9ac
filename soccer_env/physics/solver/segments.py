"""Where two straight lines of some length come nearest to each other: legs that are spread for a block.  MS53"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.physics.block import share_along


@compiled
def between_segments(ax, ay, bx, by, cx, cy, dx, dy):
    """Return the point of AB [m, m] that is nearest to CD, and the vector from it to the nearest point of CD [m, m].

    Of lines that do not cross, and robots' legs and trunks hardly can, an end of one is nearest to the other.
    """
    x, y = to_segment(ax, ay, cx, cy, dx, dy)
    at_x, at_y = ax, ay
    other_x, other_y = to_segment(bx, by, cx, cy, dx, dy)
    if other_x * other_x + other_y * other_y < x * x + y * y:
        at_x, at_y, x, y = bx, by, other_x, other_y
    back_x, back_y = to_segment(cx, cy, ax, ay, bx, by)
    if back_x * back_x + back_y * back_y < x * x + y * y:
        at_x, at_y, x, y = cx + back_x, cy + back_y, -back_x, -back_y
    back_x, back_y = to_segment(dx, dy, ax, ay, bx, by)
    if back_x * back_x + back_y * back_y < x * x + y * y:
        at_x, at_y, x, y = dx + back_x, dy + back_y, -back_x, -back_y
    return at_x, at_y, x, y


@compiled
def to_segment(x, y, ax, ay, bx, by):
    """Return the vector [m, m] from a point to the nearest point of AB."""
    share = share_along(x - ax, y - ay, bx - ax, by - ay)
    return ax + share * (bx - ax) - x, ay + share * (by - ay) - y
