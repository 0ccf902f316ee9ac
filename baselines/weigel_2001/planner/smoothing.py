"""The path that a robot drives along a way of cells: a mean over neighbours, between the exact places; its length.

A way of cells is longer than the path it stands for, by 8 % where it goes 22.5 degrees off an axis: T is measured on
the path (MH16).
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import length


@compiled
def reflected(i, last):
    """Return the index within 0 to last, and the index of the end that a number beyond them is reflected at, or -1."""
    if i < 0:
        return -i, 0
    if i > last:
        return 2 * last - i, last
    return i, -1


@compiled
def cell_at(i, last, way):
    """Return a cell's u and v; beyond both ends the way goes on turned about its end, so that the end is a mean too."""
    inner, end = reflected(i, last)
    if end < 0:
        return way[inner].u, way[inner].v
    return 2 * way[end].u - way[inner].u, 2 * way[end].v - way[inner].v


@compiled
def smooth(begin, end, settings, scratch):
    """Fill the path: the way's cells, each the mean of those around it, shifted onto begin and end.  MH16

    The shift goes evenly from that of the first cell to that of the last.
    """
    way, path, last = scratch.way, scratch.path, scratch.count - 1
    h = min(settings.smoothing, last)
    sum_u, sum_v = 0, 0
    for i in range(-h, h + 1):
        u, v = cell_at(i, last, way)
        sum_u, sum_v = sum_u + u, sum_v + v
    first_x, first_y = begin.x - settings.cell * way[0].u, begin.y - settings.cell * way[0].v
    last_x, last_y = end.x - settings.cell * way[last].u, end.y - settings.cell * way[last].v
    for i in range(last + 1):
        share = i / last
        path[i].x = settings.cell * sum_u / (2 * h + 1) + first_x + share * (last_x - first_x)
        path[i].y = settings.cell * sum_v / (2 * h + 1) + first_y + share * (last_y - first_y)
        if i < last:
            gone_u, gone_v = cell_at(i - h, last, way)
            u, v = cell_at(i + 1 + h, last, way)
            sum_u, sum_v = sum_u + u - gone_u, sum_v + v - gone_v
    path[0].x, path[0].y = begin.x, begin.y
    path[last].x, path[last].y = end.x, end.y


@compiled
def length_of(path, count):
    """Return the length [m] of a path of so many points."""
    total = 0.0
    for i in range(1, count):
        total += length(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y)
    return total
