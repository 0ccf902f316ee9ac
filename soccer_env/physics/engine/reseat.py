"""Reset a used Space to the state of a new one: bit for bit equal, for a small part of the cost of making one.

`build_space` makes a Space without a past. These traces of a past would change the future of a used Space, and are
removed here:

* the tree of moving shapes depends on the order in which shapes were added, and on their places then: all are removed
  and added again in the order of `build_space`, with bodies in their places and without speed, which stretches boxes;
* contacts with their impulses, and pairs of neighbours: they go with the shapes;
* Chipmunk's counter of shapes, which orders the shapes of a tree: it is set back;
* the velocities that undo overlaps in the next substep: they are set to zero;
* the records of our part of the solver: they get their first values again.

Boards, posts and nets stay. Chipmunk's time stamps run on, since they are only compared; its memory pools keep their
sizes.
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
from soccer_env.physics.engine.pools import SPACE_SHAPE_IDS

WALLS, ROUNDS, SHAPES = 0, 1, 2  # columns of a seat: how many static shapes, rounds of a substep, moving shapes


@compiled
def reset_spaces(links, seats, shapes, functions, bodies, velocities, rows):
    """Reset the Spaces of the matches in `rows`, with ball and robots placed by `bodies`."""
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
    """Move match m's bodies to the poses in `bodies[m]`, at rest; move the velocities in it to `velocities[m]`."""
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
def reset_solver_records(memory, first, address, rows):
    """Reset the solver's records of the matches in `rows`, as words (M, n), to the initial values, except addresses."""
    for m in rows:
        for i in range(len(first)):
            if not address[i]:
                memory[m, i] = first[i]


class SolverMemory:
    """The solver's records of M matches, and their initial values, equal in all matches except for addresses."""

    def __init__(self, records: NDArray[Any]) -> None:
        self.words = records.view(np.uint64).reshape(len(records), -1)
        self.first: NDArray[np.uint64] | None = None
        offsets = [offset for kind, offset, *_ in (records.dtype.fields or {}).values() if kind == np.uint64]
        self.address = np.zeros(records.dtype.itemsize // 8, bool)
        self.address[[offset // 8 for offset in offsets]] = True
        self.address = np.tile(self.address, self.words.shape[1] // len(self.address))

    def remember(self, m: int) -> None:
        """Keep the records of match m as the initial values of all matches, unless there are initial values already."""
        if self.first is None:
            self.first = self.words[m].copy()

    def put_back(self, rows: NDArray[np.int64]) -> None:
        """Reset the records of the matches in `rows` to their initial values."""
        reset_solver_records(self.words, self.first, self.address, rows)


class SpaceResetter:
    """The data that resets the Spaces of M matches: the addresses of their shapes, and the solver's initial values."""

    def __init__(self, matches: int, solvers: NDArray[Any], stances: NDArray[Any]) -> None:
        self.known = np.zeros(matches, bool)  # matches whose Spaces can be reset
        self.seats = np.zeros((matches, 3), np.int64)
        self.shapes = np.zeros((matches, 0), np.uint64)  # addresses, in the order of adding
        self.functions = shape_functions()
        self._memories = SolverMemory(solvers), SolverMemory(stances)

    def remember(self, m: int, space: pymunk.Space) -> None:
        """Store the data that resets match m's Space, which was never stepped and has our part of the solver."""
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
        """Reset the Spaces of the matches in `rows`, with ball and robots placed by `bodies`."""
        for memory in self._memories:
            memory.put_back(rows)
        reset_spaces(links, self.seats, self.shapes, self.functions, bodies, velocities, rows)
