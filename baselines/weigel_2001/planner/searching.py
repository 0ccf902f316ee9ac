"""Out of a local minimum: a search along the grid from where the way came to a cell twice.  [Heinemann 2006, 3]  MH12

Neighbours are tried in the order of potential plus way so far, until one is found that lies below all that the way has
come by, or beside its end. What is searched for its way round keeps its marks on the grid, a pass's and a search's own.
"""

from __future__ import annotations

from math import inf

import numpy as np

from soccer_env.baselines.weigel_2001.planner.heap import pop, push
from soccer_env.baselines.weigel_2001.planner.potential import gap_at, potential
from soccer_env.baselines.weigel_2001.planner.records import CAPPED, ENCLOSED, MOST_CELLS, MOST_NODES
from soccer_env.baselines.weigel_2001.planner.stepping import obstacle_time, step_length, step_time
from soccer_env.compiled import compiled

GOES_ON = -1  # a pass that has not ended
NEAR_U = np.array([1, 1, 0, -1, -1, -1, 0, 1])
NEAR_V = np.array([0, 1, 1, 1, 0, -1, -1, -1])


@compiled
def index_of(u, v, scratch):
    """Return where the mark of a cell stands."""
    return (u + scratch.half_u) * (2 * scratch.half_v + 1) + v + scratch.half_v


@compiled
def is_inside(u, v, scratch):
    """Tell whether there is such a cell."""
    return abs(u) <= scratch.half_u and abs(v) <= scratch.half_v


@compiled
def is_at_end(u, v, scratch):
    """Tell whether a cell is that where the way ends, or one of its eight neighbours."""
    return abs(u - scratch.end_u) <= 1 and abs(v - scratch.end_v) <= 1


@compiled
def add_cell(u, v, t, scratch):
    """Put a cell at the end of the way; the caller has made sure that there is room."""
    cell = scratch.way[scratch.count]
    cell.u, cell.v, cell.t = u, v, t
    cell.slope_x, cell.slope_y = 0.0, 0.0
    scratch.count += 1
    scratch.marks[index_of(u, v, scratch)] = scratch.count


@compiled
def cut_way(count, scratch):
    """Keep the first cells of the way."""
    for i in range(count, scratch.count):
        scratch.marks[index_of(scratch.way[i].u, scratch.way[i].v, scratch)] = 0
    scratch.count = count


@compiled
def potential_of(u, v, t, obstacles, settings, scratch):
    """Return the potential at the middle of a cell for obstacles moved by t [s], and count the evaluation."""
    scratch.evaluations += 1
    return potential(u * settings.cell, v * settings.cell, t, scratch.goal, obstacles, settings)


@compiled
def leave_minimum(obstacles, settings, scratch):
    """Go on from the lowest of the way's last cells; return GOES_ON, or how the pass ends.  MH12"""
    scratch.searches += 1
    lowest, at = inf, scratch.count - 1
    for i in range(max(scratch.count - settings.last_cells, 0), scratch.count):
        cell = scratch.way[i]
        found = potential_of(cell.u, cell.v, obstacle_time(cell.t, settings), obstacles, settings, scratch)
        if found < lowest:
            lowest, at = found, i
    scratch.lowest = min(scratch.lowest, lowest)
    cut_way(at + 1, scratch)
    last, made, ended = search(lowest, obstacles, settings, scratch)
    for i in range(made):
        scratch.marks[index_of(scratch.nodes[i].u, scratch.nodes[i].v, scratch)] = scratch.nodes[i].under
    return ended if join(last, settings, scratch) else CAPPED


@compiled
def search(lowest, obstacles, settings, scratch):
    """Search from the way's last cell; return the last node of the way out, how many were made, and GOES_ON.

    If there is no way out: the node of lowest potential, and how the pass ends.
    """
    nodes, heap, begin = scratch.nodes, scratch.heap, scratch.way[scratch.count - 1]
    made = add_node(0, begin.u, begin.v, begin.t, 0.0, lowest, -1, settings, scratch)
    size = push(heap, 0, 0, nodes)
    best = 0
    while size > 0:
        node = pop(heap, size, nodes)
        size -= 1
        if is_way_out(node, scratch):
            return node, made, GOES_ON
        if nodes[node].potential < nodes[best].potential:
            best = node
        made, size = expand(node, made, size, obstacles, settings, scratch)
        if made > MOST_NODES - len(NEAR_U) or scratch.evaluations >= settings.most_evaluations:
            return best, made, CAPPED
    return best, made, ENCLOSED


@compiled
def is_way_out(node, scratch):
    """Tell whether a node ends the search: beside the way's end, or new and lower than anything before."""
    one = scratch.nodes[node]
    return is_at_end(one.u, one.v, scratch) or (one.under == 0 and one.potential < scratch.lowest)


@compiled
def add_node(made, u, v, t, far, height, parent, settings, scratch):
    """Make a node of a cell; return how many there are."""
    node, index = scratch.nodes[made], index_of(u, v, scratch)
    node.u, node.v, node.t = u, v, t
    node.far, node.potential, node.parent = far, height, parent
    node.key = height + settings.search_length * far
    node.under = scratch.marks[index]
    scratch.marks[index] = -1 - made
    return made + 1


@compiled
def expand(node, made, size, obstacles, settings, scratch):
    """Make nodes of the free neighbours of one; return how many nodes there are, and the heap's size."""
    here = scratch.nodes[node]
    for i in range(len(NEAR_U)):
        du, dv = NEAR_U[i], NEAR_V[i] * scratch.side
        u, v = here.u + du, here.v + dv
        if not is_inside(u, v, scratch) or scratch.marks[index_of(u, v, scratch)] < 0:
            continue
        t = here.t + scratch.clock * step_time(du, dv, settings)
        now = obstacle_time(t, settings)
        if gap_at(u * settings.cell, v * settings.cell, now, obstacles, settings) <= scratch.tight:
            continue
        height = potential_of(u, v, now, obstacles, settings, scratch)
        far = here.far + step_length(du, dv, settings)
        size = push_node(made, size, u, v, t, far, height, node, settings, scratch)
        made += 1
    return made, size


@compiled
def push_node(made, size, u, v, t, far, height, parent, settings, scratch):
    """Make a node and put it into the heap; return the heap's size."""
    add_node(made, u, v, t, far, height, parent, settings, scratch)
    return push(scratch.heap, size, made, scratch.nodes)


@compiled
def join(last, settings, scratch):
    """Put the nodes up to one at the end of the way, less what is a loop then; return False if there is no room."""
    nodes, way = scratch.nodes, scratch.way
    many, node = 0, last
    while nodes[node].under == 0:
        many, node = many + 1, nodes[node].parent
    cut_way(nodes[node].under, scratch)
    if scratch.count + many > MOST_CELLS - 1:
        return False
    at, node = scratch.count + many - 1, last
    while at >= scratch.count:
        way[at].u, way[at].v = nodes[node].u, nodes[node].v
        at, node = at - 1, nodes[node].parent
    for i in range(scratch.count, scratch.count + many):
        before = way[i - 1]
        t = before.t + scratch.clock * step_time(way[i].u - before.u, way[i].v - before.v, settings)
        add_cell(way[i].u, way[i].v, t, scratch)
    return True
