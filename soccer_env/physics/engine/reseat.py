"""Put a used Space back into the state of a fresh one: a small part of the cost of making one, the same to the bit.

`build_space` makes a Space without a past. What of a used Space's past would show in its future goes here:

* the tree of moving shapes follows from the order in which they came and from where they were then: all are taken out
  and come back in the order of `build_space`, bodies in their places and without speed, which stretches shapes' boxes;
* contacts with their impulses, and pairs of neighbours, go with the shapes;
* the numbers by which Chipmunk goes through the shapes of a tree: its counter is set back;
* what undoes overlaps in the next substep;
* what our part of the solver remembers: its records become what they were at first.

Boards, posts and nets stay. Chipmunk's stamps go on, and are only compared; its pools of memory keep their sizes.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pymunk
from numpy.typing import NDArray

from soccer_env.compiled import compiled
from soccer_env.physics.engine.chipmunk import (
    Links,
    call_with_shape,
    read_bodies,
    shape_functions,
    write_bodies,
    write_velocities,
)
from soccer_env.physics.engine.memory import (
    BODY_REPAIR_OMEGA,
    BODY_REPAIR_VX,
    BODY_REPAIR_VY,
    SPACE_ROUNDS,
    address_of,
    store,
    store_count,
)
from soccer_env.physics.engine.pools import SPACE_SHAPE_IDS, layout_fits

WALLS, ROUNDS, SHAPES = 0, 1, 2  # columns of a seat: shapes that never move, rounds of a substep, shapes that move


@compiled
def reseat(links, seats, shapes, functions, bodies, velocities, rows):
    """Put the Spaces of some matches back, with ball and robots as `bodies` says."""
    for m in rows:
        take_out, put_in = functions[0], functions[1]
        link = links[m]
        for i in range(seats[m, SHAPES]):
            call_with_shape(take_out, link.space, shapes[m, i])
        place_bodies(links, bodies, velocities, m)
        store_count(link.space + SPACE_SHAPE_IDS, np.int32(seats[m, WALLS]))
        store_count(link.space + SPACE_ROUNDS, np.int32(seats[m, ROUNDS]))
        for i in range(seats[m, SHAPES]):
            call_with_shape(put_in, link.space, shapes[m, i])
        write_velocities(links, m)
        velocities[m] = 0.0
        read_bodies(links, m)


@compiled
def place_bodies(links, bodies, velocities, m):
    """Put match m's bodies where `bodies[m]` says, without speed; their speeds are then in `velocities[m]`."""
    link = links[m]
    for i in range(link.count):
        bodies[m, i, 0] += 0.0  # -0 becomes 0, as it does when Chipmunk places a body that is new
        bodies[m, i, 1] += 0.0
        for axis in range(3):
            velocities[m, i, axis] = bodies[m, i, 3 + axis]
            bodies[m, i, 3 + axis] = 0.0
        body = link.body[i]
        store(body + BODY_REPAIR_VX, 0.0)
        store(body + BODY_REPAIR_VY, 0.0)
        store(body + BODY_REPAIR_OMEGA, 0.0)
    write_bodies(links, m)


@compiled
def forget(memory, first, address, rows):
    """Set what the solver remembers of some matches, in words (M, n), to what it was at first, but for addresses."""
    for m in rows:
        for i in range(len(first)):
            if not address[i]:
                memory[m, i] = first[i]


class Memory:
    """What the solver remembers of M matches, and how it was at first: alike in all matches but for addresses."""

    def __init__(self, records: NDArray[Any]) -> None:
        self.words = records.view(np.uint64).reshape(len(records), -1)
        self.first: NDArray[np.uint64] | None = None
        offsets = [offset for kind, offset, *_ in (records.dtype.fields or {}).values() if kind == np.uint64]
        self.address = np.zeros(records.dtype.itemsize // 8, bool)
        self.address[[offset // 8 for offset in offsets]] = True
        self.address = np.tile(self.address, self.words.shape[1] // len(self.address))

    def remember(self, m: int) -> None:
        """Take match m's for what all are at first."""
        if self.first is None:
            self.first = self.words[m].copy()

    def put_back(self, rows: NDArray[np.int64]) -> None:
        """Set that of some matches to what it was at first."""
        forget(self.words, self.first, self.address, rows)


class Seats:
    """What is needed to put the Spaces of M matches back: where their shapes are, and the solver's first memory."""

    def __init__(self, matches: int, solvers: NDArray[Any], stances: NDArray[Any]) -> None:
        self.known = np.zeros(matches, bool)  # whose Spaces can be put back
        self.seats = np.zeros((matches, 3), np.int64)
        self.shapes = np.zeros((matches, 0), np.uint64)  # addresses, in the order of coming
        self.functions = shape_functions()
        self._memories = Memory(solvers), Memory(stances)

    def remember(self, m: int, space: pymunk.Space) -> None:
        """Remember match m's Space, in which our part of the solver takes part and which was never stepped."""
        moving = [address_of(shape) for shape in space.shapes if shape.body is not space.static_body]
        if len(moving) > self.shapes.shape[1]:
            self.shapes = np.zeros((len(self.shapes), len(moving)), np.uint64)
            self.known[:] = False
        self.seats[m] = len(space.shapes) - len(moving), space.iterations, len(moving)
        self.shapes[m, : len(moving)] = moving
        for memory in self._memories:
            memory.remember(m)
        self.known[m] = True

    def put_back(self, links: Links, bodies: NDArray[Any], velocities: NDArray[Any], rows: NDArray[np.int64]) -> None:
        """Put the Spaces of some matches back, with ball and robots as `bodies` says."""
        for memory in self._memories:
            memory.put_back(rows)
        reseat(links, self.seats, self.shapes, self.functions, bodies, velocities, rows)


__all__ = ["Seats", "layout_fits"]
