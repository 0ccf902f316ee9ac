"""Escape from a local minimum: a grid search that begins when the way meets itself.  [Heinemann 2006, 3]  MH12

Neighbours are tried in the order of their potential, until one is lower than every cell of the way. A search also ends
near the way's end if the straight line to the end is free: an obstacle beside the end can move the minimum elsewhere.
"""

from math import inf

import numpy as np

from soccer_env.baselines.weigel_2001.planner.potential import gap_at, potential
from soccer_env.baselines.weigel_2001.planner.records import ARRIVED, CAPPED, ENCLOSED, MOST_CELLS, MOST_NODES
from soccer_env.baselines.weigel_2001.planner.stepping import obstacle_time, step_length, step_time
from soccer_env.compiled import compiled

GOES_ON = -1  # a pass that has not ended
NEAR_U = np.array([1, 1, 0, -1, -1, -1, 0, 1])
NEAR_V = np.array([0, 1, 1, 1, 0, -1, -1, -1])


@compiled
def index_of(u, v, scratch):
    """Return the index of a cell (u, v) in `scratch.marks`."""
    return (u + scratch.half_u) * (2 * scratch.half_v + 1) + v + scratch.half_v


@compiled
def is_inside(u, v, scratch):
    """Tell whether a cell (u, v) lies inside the grid."""
    return abs(u) <= scratch.half_u and abs(v) <= scratch.half_v


@compiled
def is_at_end(u, v, scratch):
    """Tell whether a cell (u, v) is the way's end cell or one of its eight neighbours."""
    return abs(u - scratch.end_u) <= 1 and abs(v - scratch.end_v) <= 1


@compiled
def add_cell(u, v, t, scratch):
    """Append a cell to the way, which must have room."""
    cell = scratch.way[scratch.count]
    cell.u, cell.v, cell.t = u, v, t
    cell.slope_x, cell.slope_y = 0.0, 0.0
    scratch.count += 1
    scratch.marks[index_of(u, v, scratch)] = scratch.count


@compiled
def cut_way(count, scratch):
    """Shorten the way to its first `count` cells."""
    for i in range(count, scratch.count):
        scratch.marks[index_of(scratch.way[i].u, scratch.way[i].v, scratch)] = 0
    scratch.count = count


@compiled
def potential_of_cell(u, v, t, obstacles, settings, scratch):
    """Return the potential at a cell's middle, with obstacles moved by t [s], and count the evaluation."""
    scratch.evaluations += 1
    return potential(u * settings.cell, v * settings.cell, t, scratch.goal, obstacles, settings)


@compiled
def leave_minimum(obstacles, settings, scratch):
    """Search for an escape from the lowest of the way's last cells; return GOES_ON, or how the pass ends.  MH12"""
    scratch.searches += 1
    lowest, at = inf, scratch.count - 1
    for i in range(max(scratch.count - settings.last_cells, 0), scratch.count):
        cell = scratch.way[i]
        value = potential_of_cell(cell.u, cell.v, obstacle_time(cell.t, settings), obstacles, settings, scratch)
        if value < lowest:
            lowest, at = value, i
    scratch.lowest = min(scratch.lowest, lowest)
    cut_way(at + 1, scratch)
    last, made, ended = search_escape(obstacles, settings, scratch)
    for i in range(made):
        scratch.marks[index_of(scratch.nodes[i].u, scratch.nodes[i].v, scratch)] = scratch.nodes[i].under
    return ended if append_escape(last, settings, scratch) else CAPPED


@compiled
def search_escape(obstacles, settings, scratch):
    """Search from the way's last cell; return the escape's last node, the number of nodes, and how the pass ends.

    GOES_ON: the node is lower than every cell of the way. ARRIVED: the line from node to end is free. Without an escape
    the node of lowest potential is returned.
    """
    nodes, heap, begin = scratch.nodes, scratch.heap, scratch.way[scratch.count - 1]
    made = add_node(0, begin.u, begin.v, -1, obstacles, settings, scratch)
    size = push(heap, 0, 0, nodes)
    best = 0
    while size > 0:
        node = pop(heap, size, nodes)
        size -= 1
        one = nodes[node]
        if has_free_line_to_end(one, obstacles, settings, scratch):
            return node, made, ARRIVED
        if one.under == 0 and one.potential < scratch.lowest - settings.gained:
            return node, made, GOES_ON
        if nodes[node].potential < nodes[best].potential:
            best = node
        made, size = expand_node(node, made, size, obstacles, settings, scratch)
        if made > MOST_NODES - len(NEAR_U) or scratch.evaluations >= settings.most_evaluations:
            return best, made, CAPPED
    return best, made, ENCLOSED


@compiled
def has_free_line_to_end(node, obstacles, settings, scratch):
    """Tell whether the way's end is near a node and the straight line from the node to the end is free."""
    to_u, to_v = scratch.end_u - node.u, scratch.end_v - node.v
    away = step_length(to_u, to_v, settings)
    if away > settings.reach:
        return False
    pieces = max(abs(to_u), abs(to_v))
    for i in range(1, pieces):
        share = i / pieces
        now = obstacle_time(node.t + scratch.clock * share * away / settings.speed, settings)
        x, y = (node.u + share * to_u) * settings.cell, (node.v + share * to_v) * settings.cell
        if gap_at(x, y, now, obstacles, settings) <= scratch.tight:
            return False
    return True


@compiled
def expand_node(node, made, size, obstacles, settings, scratch):
    """Add nodes for the free neighbours of a node; return the number of nodes and the size of the heap."""
    here = scratch.nodes[node]
    for i in range(len(NEAR_U)):
        du, dv = NEAR_U[i], NEAR_V[i] * scratch.side
        u, v = here.u + du, here.v + dv
        if is_inside(u, v, scratch) and scratch.marks[index_of(u, v, scratch)] >= 0:
            before = made
            made = add_node(made, u, v, node, obstacles, settings, scratch)
            if made > before:
                size = push(scratch.heap, size, before, scratch.nodes)
    return made, size


@compiled
def add_node(made, u, v, parent, obstacles, settings, scratch):
    """Add a node for a cell unless an obstacle blocks the cell; return the number of nodes."""
    node, first = scratch.nodes[made], scratch.way[scratch.count - 1]
    node.far = 0.0
    if parent >= 0:
        before = scratch.nodes[parent]
        node.far = before.far + step_length(u - before.u, v - before.v, settings)
    node.t = first.t + scratch.clock * node.far / settings.speed
    now = obstacle_time(node.t, settings)
    node.gap = gap_at(u * settings.cell, v * settings.cell, now, obstacles, settings)
    if parent >= 0 and node.gap <= scratch.tight and node.gap <= scratch.nodes[parent].gap:
        return made
    node.u, node.v, node.parent = u, v, parent
    node.potential = potential_of_cell(u, v, now, obstacles, settings, scratch)
    index = index_of(u, v, scratch)
    node.under = scratch.marks[index]
    scratch.marks[index] = -1 - made
    return made + 1


@compiled
def append_escape(last, settings, scratch):
    """Append the nodes up to `last` to the way, without loops; return False if the way is full."""
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


# The queue of a search: a binary heap of node numbers, the node of least potential at its root, of equal ones the older


@compiled
def precedes(a, b, nodes):
    """Tell whether node a comes before node b in the queue: lower potential, or equal and older."""
    return nodes[a].potential < nodes[b].potential or (nodes[a].potential == nodes[b].potential and a < b)


@compiled
def push(heap, size, node, nodes):
    """Add a node to a heap of `size` nodes; return the heap's new size."""
    at = size
    while at > 0:
        above = (at - 1) // 2
        if not precedes(node, heap[above], nodes):
            break
        heap[at] = heap[above]
        at = above
    heap[at] = node
    return size + 1


@compiled
def pop(heap, size, nodes):
    """Remove and return the first node of a heap of `size` >= 1 nodes; the caller decrements the size."""
    first, last = heap[0], heap[size - 1]
    at, below = 0, 1
    while below < size - 1:
        if below + 1 < size - 1 and precedes(heap[below + 1], heap[below], nodes):
            below += 1
        if precedes(last, heap[below], nodes):
            break
        heap[at] = heap[below]
        at, below = below, 2 * below + 1
    heap[at] = last
    return first
