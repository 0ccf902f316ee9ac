"""Hold M pymunk Spaces, and the arrays through which kernels write velocities and read bodies.

Two backends copy between the arrays and the Spaces, with bit-identical results: `"c"` calls Chipmunk from compiled
code (`engine/chipmunk.py`), `"batch"` calls the public `pymunk.batch` from Python, match by match.

At a match's first reset `batch.set_space(m, space)`; at later ones `batch.put_back`, which costs a tenth (see
`engine/reseat.py`, the C backend only). At each step a kernel fills `batch.velocities`, `batch.step_all(dt, substeps)`
uses either backend, and the next kernel reads `batch.bodies`; with the C backend one kernel can do all three.
"""

import functools
import math
import platform
import sys
import threading
import warnings
import weakref
from typing import Any, Literal, NoReturn

import numpy as np
import pymunk
from numpy.typing import ArrayLike, NDArray
from pymunk import batch as pymunk_batch
from pymunk.batch import BodyFields

from soccer_env.guards.interrupts import SignalsHeld
from soccer_env.leagues.league import League
from soccer_env.physics.engine import chipmunk, prefetch
from soccer_env.physics.engine.memory import address_of
from soccer_env.physics.engine.pools import layout_fits
from soccer_env.physics.engine.reseat import SpaceResetter
from soccer_env.physics.solver import rounds
from soccer_env.physics.solver.records import LAST_CONTACT, POST_CONTACT, POST_CONTACTS, SOLVER, STANCE

Backend = Literal["c", "batch"]

VELOCITY = BodyFields.VELOCITY | BodyFields.ANGULAR_VELOCITY
STATE = BodyFields.POSITION | BodyFields.ANGLE | VELOCITY


class SpaceBatch:
    """M Spaces of B dynamic bodies each, and the arrays through which they are written and read.

    `bodies` (M, B + SPARE_ROWS, 6) holds x, y [m], angle [rad], vx, vy [m/s], angular velocity [rad/s]; `velocities`
    (M, B + SPARE_ROWS, 3) holds vx, vy, angular velocity. Callers leave rows from B on alone. `solvers` (M,) are the
    records of our part of the solver. Kernels take `links` (M,) (the C backend only), which holds addresses: keep the
    batch as long as a kernel may use it.
    """

    def __init__(self, matches: int, bodies: int, backend: Backend | None = None) -> None:
        if matches < 1 or bodies < 1:
            raise ValueError(f"matches and bodies must be at least 1, got {matches} and {bodies}")
        if bodies > chipmunk.MOST_BODIES:
            raise ValueError(f"bodies must be at most {chipmunk.MOST_BODIES}, got {bodies}")
        if backend not in ("c", "batch", None):
            raise ValueError(f"backend must be 'c' or 'batch', got {backend!r}")
        self.backend: Backend = backend or default_backend()
        self.size = bodies
        self.spaces: list[pymunk.Space | None] = [None] * matches
        self._kept: list[list[pymunk.Space]] = [[] for _ in range(matches)]  # one for each match between resets
        self.bodies = np.zeros((matches, bodies + chipmunk.SPARE_ROWS, 6))
        self.velocities = np.zeros((matches, bodies + chipmunk.SPARE_ROWS, 3))
        self.solvers = np.zeros(matches, SOLVER)
        room = matches, POST_CONTACTS * bodies
        self._room = np.zeros((matches, bodies - 1), STANCE), np.zeros(room, POST_CONTACT), np.zeros(room, LAST_CONTACT)
        self.spans = np.zeros(matches if prefetch.is_prefetch_useful(matches) else 0, prefetch.SPANS)
        self.links = chipmunk.make_links(self.bodies, self.velocities) if self.backend == "c" else None
        reusable = self.links is not None and layout_fits()
        self.seats = SpaceResetter(matches, self.solvers, self._room[0]) if reusable else None
        self._read_buffer, self._write_buffer = pymunk_batch.Buffer(), pymunk_batch.Buffer()
        self._lock = threading.Lock()  # around the buffers

    def __reduce__(self) -> NoReturn:
        raise TypeError("a SpaceBatch holds addresses of this process and cannot be copied or pickled")

    def __del__(self) -> None:
        if sys is None or sys.is_finalizing():  # pymunk itself may be gone
            return
        with SignalsHeld(later=True):
            self.__dict__.pop("spaces", None)
            for kept in self.__dict__.get("_kept", ()):
                while kept:
                    free_first_space(kept)

    def set_space(self, m: int, space: pymunk.Space) -> None:
        """Set the Space of match m, and read its bodies; the batch keeps the Space alive until it is replaced."""
        _check_space(space, self.size)
        with SignalsHeld():
            self._kept[m].append(space)  # first, so that a Space in `links` is alive whatever raises below
            self._link(m, space)
            self.spaces[m] = space
            while len(self._kept[m]) > 1:
                free_first_space(self._kept[m])
        self.bodies[m] = self.velocities[m] = 0.0
        self.read_bodies(m)

    def _link(self, m: int, space: pymunk.Space) -> None:
        """Write the addresses of match m's Space into `links`."""
        if self.links is not None:
            link = self.links[m : m + 1]
            link["space"], link["count"] = chipmunk.space_address(space), self.size
            link["solver"] = 0
            link["body"][0, : self.size] = [address_of(body) for body in space.bodies]
            if len(self.spans):
                self.spans["steps"][m] = self.spans["count"][m] = 0
                link["spans"] = self.spans[m : m + 1].ctypes.data
        if self.seats is not None:
            self.seats.known[m] = False

    def attach_solver(self, m: int, league: League, constants: NDArray[Any]) -> None:
        """Attach our part of the solver to match m's Space; the caller keeps the league's constants (1,) in place."""
        if self.links is not None:
            self.links["solver"][m] = self.solvers[m : m + 1].ctypes.data
        room = rounds.SolverArrays(*(array[m] for array in self._room))
        rounds.attach_solver(self._space(m), self.solvers[m : m + 1], room, league, constants)
        if self.seats is not None:
            self.seats.remember(m, self._space(m))

    def reusable(self, m: int) -> bool:
        """Tell whether `put_back` can reset the Space of match m."""
        return self.seats is not None and bool(self.seats.known[m])

    def forget(self) -> None:
        """Make every match get a new Space at its next rebuild, after a change that `put_back` does not undo."""
        if self.seats is not None:
            self.seats.known[:] = False

    def put_back(self, rows: NDArray[np.int64]) -> None:
        """Reset the Spaces of the matches in `rows` to new ones, ball and robots placed by `bodies[rows]`."""
        assert self.seats is not None and self.seats.known[rows].all()
        self.seats.put_back(self.links, self.bodies, self.velocities, rows)
        if len(self.spans):
            self.spans["steps"][rows] = self.spans["count"][rows] = 0

    def step_all(self, dt: float, substeps: ArrayLike) -> None:
        """Write the velocities of all matches, step them by dt [s] and read their bodies; `substeps` () or (M,)."""
        self.step_slice(dt, substeps, 0, len(self.spaces))

    def step_slice(self, dt: float, substeps: ArrayLike, first: int, last: int) -> None:
        """Step the matches first, ..., last - 1 as `step_all` does; threads may share out the slices."""
        if not 0 <= first <= last <= len(self.spaces):
            raise ValueError(f"there is no slice {first}:{last} of {len(self.spaces)} matches")
        if not (math.isfinite(dt) and dt > 0.0):
            raise ValueError(f"dt must be a positive number of seconds, got {dt}")
        counts = np.empty(len(self.spaces), np.int64)
        counts[:] = substeps
        if self.links is not None:
            chipmunk.advance_slice(self.links, counts, float(dt), first, last)
            return
        for m in range(first, last):
            self.write_velocities(m)
            if counts[m] > 0:
                chipmunk.keep_impulses(self._space(m), dt / int(counts[m]))
                rounds.drive_free_robots(self.solvers[m], dt)
            for _ in range(counts[m]):
                self._space(m).step(dt / int(counts[m]))
            self.read_bodies(m)

    def write_velocities(self, m: int) -> None:
        """Give match m's bodies the velocities in `velocities[m]`."""
        if self.links is not None:
            chipmunk.write_velocities(self.links, m)
        else:
            self._write(m, VELOCITY, self.velocities[m])

    def write_bodies(self, m: int) -> None:
        """Set poses and velocities of match m's bodies from `bodies[m]`; an unchanged row has no effect."""
        if self.links is not None:
            chipmunk.write_bodies(self.links, m)
        else:
            self._write(m, STATE, self.bodies[m])

    def read_bodies(self, m: int) -> None:
        """Fill `bodies[m]` with match m's poses and velocities."""
        if self.links is not None:
            chipmunk.read_bodies(self.links, m)
            return
        with self._lock:
            self._read_buffer.clear()
            pymunk_batch.get_space_bodies(self._space(m), STATE, self._read_buffer)
            numbers = np.frombuffer(self._read_buffer.float_buf())
            self.bodies[m].reshape(-1)[: len(numbers)] = numbers

    def _write(self, m: int, fields: BodyFields, rows: NDArray[np.float64]) -> None:
        # pymunk checks nothing here, and reads one more row, for the static body
        assert rows.flags.c_contiguous and rows.dtype == np.float64 and len(rows) > self.size
        with self._lock:
            self._write_buffer.set_float_buf(rows)
            pymunk_batch.set_space_bodies(self._space(m), fields, self._write_buffer)

    def _space(self, m: int) -> pymunk.Space:
        space = self.spaces[m]
        if space is None:
            raise ValueError("the match has no Space yet")
        return space


def _check_space(space: pymunk.Space, bodies: int) -> None:
    """Raise ValueError for a Space with other bodies than expected, or that `Space.step` would refuse.
    The C backend calls Chipmunk directly and so bypasses the checks of `Space.step`.
    """
    if len(space.bodies) != bodies or any(body.body_type != pymunk.Body.DYNAMIC for body in space.bodies):
        raise ValueError(f"the Space must hold {bodies} dynamic bodies and no others; walls go on its static body")
    if not all(0.0 < number < math.inf for body in space.bodies for number in (body.mass, body.moment)):
        raise ValueError("every body needs a finite positive mass and moment")
    if space.sleep_time_threshold != math.inf or space.threaded:
        raise ValueError("the Space must neither let bodies sleep nor be threaded")


def free_first_space(spaces: list[pymunk.Space]) -> None:
    """Remove the first Space from a list; free it at once with its parts, unless it is referenced elsewhere.

    Each of pymunk's bodies, shapes and constraints holds a handle of itself: a reference cycle that only Python's
    garbage collector breaks, at any time and in any thread. Without the handles all parts go with the last reference.
    The caller holds interrupts back, so that no half of a Space stays behind.
    """
    space = spaces.pop(0)
    handled: list[Any] = [*space.constraints, *space.bodies, space.static_body]
    shapes: list[Any] = list(space.shapes)
    kept = weakref.ref(space)
    del space
    if kept() is None:
        for part in handled:
            part._data_handle = None
        for shape in shapes:
            shape._h = None


@functools.cache
def default_backend() -> Backend:
    """Return "c" where it is known to work (Linux on 64-bit x86) or passes a test now, and "batch" elsewhere."""
    if not chipmunk.layout_fits():
        warnings.warn(f"pymunk {pymunk.version} is not the one known; physics is slower", RuntimeWarning, stacklevel=3)
        return "batch"
    known = sys.platform == "linux" and platform.machine() == "x86_64"
    with SignalsHeld():
        return "c" if known or _simulate_collision("c") == _simulate_collision("batch") else "batch"


def _simulate_collision(backend: Backend) -> bytes:
    """Simulate a short collision and return the bodies at its end."""
    space = pymunk.Space()
    space.add(pymunk.Segment(space.static_body, (1.0, -1.0), (1.0, 1.0), 0.05))
    for x in (-0.5, 0.0, 0.5):
        body = pymunk.Body(1.0, 0.01)
        body.position = (x, 0.1 * x)
        space.add(body, pymunk.Circle(body, 0.1))
    batch = SpaceBatch(1, 3, backend)
    batch.set_space(0, space)
    for _ in range(20):
        batch.velocities[0, :3] = (0.8, 0.1, 0.5), (0.0, 0.0, 0.0), (-0.4, 0.0, 0.2)
        batch.step_all(0.1, 4)
    return batch.bodies.tobytes()
