"""Call Chipmunk, the C library under pymunk, from compiled loops over matches.

The only file that knows the private names of pymunk's functions; `engine/memory.py` and `engine/pools.py` know its
structs. Velocities are written to, and poses and velocities read from, the structs of the bodies. Only pymunk's batch
iterator moves bodies to new places, since Chipmunk then updates more than their coordinates. `cpSpaceStep` takes
addresses and doubles only, so a kernel can write velocities, step and read back without Python and without its lock.

The functions below take `links`, one record of addresses for each match, and the match's index; `engine/space_batch.py`
makes `links` and owns the arrays that it points to:

* `bodies[m]`, rows of x, y [m], angle [rad], vx, vy [m/s], angular velocity [rad/s]: read at every step, and written to
  move bodies to new places;
* `velocities[m]`, rows of vx, vy, angular velocity: written at every step.

Row r is the r-th body added to the Space. The iterator visits the static body too, after the dynamic ones, so a match
has more rows than bodies: row B belongs to the static body and stays zero, since other numbers would move the walls.
"""

from typing import Any

import numpy as np
import pymunk
from llvmlite import ir
from numba import types
from numba.extending import intrinsic
from numpy.typing import NDArray

from soccer_env.compiled import compiled, config
from soccer_env.physics.engine.memory import BODY_ANGLE, BODY_OMEGA, BODY_VX, BODY_VY, BODY_X, BODY_Y, number_at, store
from soccer_env.physics.engine.prefetch import count_space_step, prefetch_spans, spans_at
from soccer_env.physics.engine.pymunk_parts import ffi, lib
from soccer_env.physics.solver.records import MOST_ROBOTS
from soccer_env.physics.solver.rounds import drive_free_robots, solver_at

Links = Any  # array (M,) of LINK; Any because mypy knows no record fields

SPARE_ROWS = 3  # one of the static body, two that no iterator reaches
MOST_BODIES = 1 + MOST_ROBOTS  # of a match
STATE_FIELDS = lib.POSITION | lib.ANGLE | lib.VELOCITY | lib.ANGULAR_VELOCITY

C_FUNCTIONS = {  # field of LINK: C function
    "step": "cpSpaceStep",
    "set_time_step": "cpSpaceSetCurrentTimeStep",
    "each_body": "cpSpaceEachBody",
    "set_body": "pmSpaceBodySetIteratorFuncBatched",
}
SHAPE_FUNCTIONS = ("cpSpaceRemoveShape", "cpSpaceAddShape")  # called with a Space and a shape
# struct pmFloatArray: the next place, the number of places, and their address
FLOAT_ARRAY = np.dtype([("num", "i4"), ("max", "i4"), ("arr", "u8")])
# struct pmBatchedData: the fields that an iterator sets; without BODY_ID among them it never reads the intArray
BATCHED_DATA = np.dtype([("intArray", "u8"), ("floatArray", "u8"), ("fields", "i4"), ("padding", "i4")])
LINK = np.dtype(
    [
        ("space", "u8"),  # address of the match's cpSpace, 0 before there is one
        ("count", "i8"),  # bodies of a match
        ("body", "u8", (MOST_BODIES,)),  # addresses of the bodies
        ("solver", "u8"),  # address of the match's SOLVER record; 0: Chipmunk solves its contacts alone
        ("spans", "u8"),  # address of the match's SPANS record; 0: nothing is fetched ahead
        ("velocities", "u8"),  # address of `velocities[m]`
        ("bodies", "u8"),  # address of `bodies[m]`
        *[(field, "u8") for field in C_FUNCTIONS],  # addresses of the C functions
        ("body_data_at", "u8"),  # address of `body_data` in this record
        ("body_data", BATCHED_DATA),  # tells the iterator to set all six numbers of `bodies[m]`
        ("body_array", FLOAT_ARRAY),
    ]
)


# Calls of C functions by address. The address is an argument, not a constant: so the caller can be cached on disk.


def _build_call(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
    kinds = [context.get_value_type(kind) for kind in signature.args[1:]]
    function = builder.inttoptr(arguments[0], ir.FunctionType(ir.VoidType(), kinds).as_pointer())
    builder.call(function, arguments[1:])
    return context.get_dummy_value()


def _compiled_step(typing_context: Any, function: Any, space: Any, dt: Any) -> Any:
    return types.void(types.uintp, types.uintp, types.float64), _build_call


def _compiled_each(typing_context: Any, function: Any, space: Any, visitor: Any, data: Any) -> Any:
    return types.void(types.uintp, types.uintp, types.uintp, types.uintp), _build_call


def _compiled_shape(typing_context: Any, function: Any, space: Any, shape: Any) -> Any:
    return types.void(types.uintp, types.uintp, types.uintp), _build_call


def _python_step(function: Any, space: Any, dt: Any) -> None:
    ffi.cast("void(*)(uintptr_t, double)", int(function))(int(space), float(dt))


def _python_each(function: Any, space: Any, visitor: Any, data: Any) -> None:
    ffi.cast("void(*)(uintptr_t, uintptr_t, uintptr_t)", int(function))(int(space), int(visitor), int(data))


def _python_shape(function: Any, space: Any, shape: Any) -> None:
    ffi.cast("void(*)(uintptr_t, uintptr_t)", int(function))(int(space), int(shape))


_call_step: Any = _python_step if config.DISABLE_JIT else intrinsic(_compiled_step)
_call_each: Any = _python_each if config.DISABLE_JIT else intrinsic(_compiled_each)
call_with_shape: Any = _python_shape if config.DISABLE_JIT else intrinsic(_compiled_shape)


# For kernels


@compiled
def write_velocities(links: Links, m: int) -> None:
    """Give match m's bodies the velocities in `velocities[m]`."""
    link = links[m]
    check_space(link)
    row = link.velocities
    for i in range(link.count):
        body = link.body[i]
        store(body + BODY_VX, number_at(row))
        store(body + BODY_VY, number_at(row + 8))
        store(body + BODY_OMEGA, number_at(row + 16))
        row += 24


@compiled
def read_bodies(links: Links, m: int) -> None:
    """Fill `bodies[m]` with match m's poses and velocities."""
    link = links[m]
    check_space(link)
    row = link.bodies
    for i in range(link.count):
        body = link.body[i]
        store(row, number_at(body + BODY_X))
        store(row + 8, number_at(body + BODY_Y))
        store(row + 16, number_at(body + BODY_ANGLE))
        store(row + 24, number_at(body + BODY_VX))
        store(row + 32, number_at(body + BODY_VY))
        store(row + 40, number_at(body + BODY_OMEGA))
        row += 48


@compiled
def write_bodies(links: Links, m: int) -> None:
    """Set poses and velocities of match m's bodies from `bodies[m]`; rows unchanged since reading have no effect."""
    link = links[m]
    check_space(link)
    link.body_array.num = 0
    _call_each(link.each_body, link.space, link.set_body, link.body_data_at)


@compiled
def check_space(link: Any) -> None:
    """Raise ValueError if a match has no Space."""
    if link.space == 0:
        raise ValueError("the match has no Space yet")


@compiled
def advance(links: Links, m: int, substeps: int, dt: float) -> None:
    """Step match m by dt [s] in equal substeps; with 0 substeps nothing moves."""
    link = links[m]
    check_space(link)
    if substeps == 0:
        return
    substep = dt / substeps  # [s]
    _call_step(link.set_time_step, link.space, substep)  # see `keep_impulses`
    if link.solver != 0:
        drive_free_robots(solver_at(link.solver), dt)
    for _ in range(substeps):
        _call_step(link.step, link.space, substep)


@compiled
def step_match(links: Links, m: int, substeps: int, dt: float) -> None:
    """Write match m's velocities, step it by dt [s], and read its bodies."""
    write_velocities(links, m)
    advance(links, m, substeps, dt)
    read_bodies(links, m)
    link = links[m]
    if link.spans != 0:
        count_space_step(spans_at(link.spans), np.int64(link.space))


@compiled
def prefetch_step(links: Links, m: int) -> bool:
    """Prefetch the memory of match m's next step into the cache; return False if match or spans do not exist."""
    if m >= len(links) or links[m].spans == 0:
        return False
    prefetch_spans(spans_at(links[m].spans))
    return True


@compiled
def advance_slice(links: Links, substeps: NDArray[np.int64], dt: float, first: int, last: int) -> None:
    """Step the matches first, ..., last - 1, match m by dt [s] in substeps[m] substeps."""
    for m in range(first, last):
        prefetch_step(links, m + 1)
        step_match(links, m, substeps[m], dt)


# For the class that owns the arrays


def make_links(bodies: NDArray[np.float64], velocities: NDArray[np.float64]) -> Links:
    """Return links (M,) to bodies (M, rows, 6) and velocities (M, rows, 3), still without Spaces.

    The caller keeps all three arrays alive and in place. Both arguments need SPARE_ROWS rows more than bodies.
    """
    links = np.zeros(len(bodies), LINK)
    for field, address in c_addresses().items():
        links[field] = address
    for name, rows in (("bodies", bodies), ("velocities", velocities)):
        assert rows.flags.c_contiguous and rows.dtype == np.float64 and len(rows) == len(links)
        links[name] = _addresses(rows)
    links["body_array"]["max"], links["body_array"]["arr"] = bodies[0].size, links["bodies"]
    links["body_data"]["floatArray"], links["body_data"]["fields"] = _addresses(links["body_array"]), STATE_FIELDS
    links["body_data_at"] = _addresses(links["body_data"])
    return links


def _addresses(items: NDArray[Any]) -> NDArray[np.uint64]:
    """Return the address of each item along the first axis."""
    return np.uint64(items.ctypes.data) + np.arange(len(items), dtype=np.uint64) * np.uint64(items.strides[0])


def keep_impulses(space: pymunk.Space, substep: float) -> None:
    """Tell a Space the length of its next substep [s], so that it starts with the last impulses unscaled.

    Chipmunk would scale them by the ratio of the lengths, and the solver would take them back unscaled: a bounce
    followed by a longer substep would act twice.
    """
    lib.cpSpaceSetCurrentTimeStep(space._space, substep)


def space_address(space: pymunk.Space) -> int:
    """Return the address of a Space's cpSpace."""
    return int(ffi.cast("uintptr_t", space._space))


def c_addresses() -> dict[str, int]:
    """Return a dict from fields of LINK to the addresses of the C functions that they hold."""
    return {field: _function_address(name) for field, name in C_FUNCTIONS.items()}


def shape_functions() -> NDArray[np.uint64]:
    """Return the addresses (2,) of the C functions that remove a shape from a Space and add one."""
    return np.array([_function_address(name) for name in SHAPE_FUNCTIONS], np.uint64)


def _function_address(name: str) -> int:
    return int(ffi.cast("uintptr_t", ffi.addressof(lib, name)))


def layout_fits() -> bool:
    """Tell whether this pymunk has the C functions and structs that this file is written for."""
    try:
        c_addresses()
        layouts = [_layout(ffi.typeof(name)) for name in ("pmFloatArray", "pmBatchedData")]
    except (AttributeError, ffi.error):
        return False
    expected = [(16, {"num": 0, "max": 4, "arr": 8}), (24, {"intArray": 0, "floatArray": 8, "fields": 16})]
    return layouts == expected and ffi.sizeof("cpFloat") == 8


def _layout(struct: Any) -> tuple[int, dict[str, int]]:
    return ffi.sizeof(struct), {name: field.offset for name, field in struct.fields}
