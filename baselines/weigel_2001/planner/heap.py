"""A binary heap of numbers of nodes: the one of least potential is at its root, of equal ones the older."""

from soccer_env.compiled import compiled


@compiled
def before(a, b, nodes):
    """Tell whether node a comes before node b."""
    return nodes[a].potential < nodes[b].potential or (nodes[a].potential == nodes[b].potential and a < b)


@compiled
def push(heap, size, node, nodes):
    """Add a node to a heap of some size; return the new size."""
    at = size
    while at > 0:
        above = (at - 1) // 2
        if not before(node, heap[above], nodes):
            break
        heap[at] = heap[above]
        at = above
    heap[at] = node
    return size + 1


@compiled
def pop(heap, size, nodes):
    """Take the first node out of a heap that is not empty; return it, the size is one less."""
    first, last = heap[0], heap[size - 1]
    at, below = 0, 1
    while below < size - 1:
        if below + 1 < size - 1 and before(heap[below + 1], heap[below], nodes):
            below += 1
        if before(last, heap[below], nodes):
            break
        heap[at] = heap[below]
        at, below = below, 2 * below + 1
    heap[at] = last
    return first
