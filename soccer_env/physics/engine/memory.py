"""Read and write Chipmunk's structs in memory, from compiled code.

pymunk hides the layout of most structs. The offsets below are those of the 64-bit builds of pymunk 7.3 (Munk2D,
`chipmunk_structs.h`); `layout_fits` checks each offset on a struct with known numbers before anything relies on it.
"""

from __future__ import annotations

import functools
import struct
from math import cos, sin
from typing import Any

import numpy as np
import pymunk
from numba import types
from numba.extending import intrinsic

from soccer_env.compiled import config
from soccer_env.compiling.numba_parts import from_dtype
from soccer_env.physics.engine.pymunk_parts import ffi

# struct cpBody
BODY_MASS_INVERSE = 24  # [1/kg]
BODY_MOMENT_INVERSE = 40  # [1/(kg m2)]
BODY_X, BODY_Y = 64, 72  # [m]
BODY_VX, BODY_VY = 80, 88  # [m/s]
BODY_ANGLE, BODY_OMEGA = 112, 120  # [rad], [rad/s]
BODY_COS, BODY_SIN = 136, 144  # of its angle
BODY_SHIFT_X, BODY_SHIFT_Y = 168, 176  # [m] its place again, in the transform that pymunk reads
BODY_REPAIR_VX, BODY_REPAIR_VY, BODY_REPAIR_OMEGA = 192, 200, 208  # [m/s], [rad/s] that undo overlaps
BODY_ARBITERS = 232  # address of the first of its contacts in this substep, 0 without any
# struct cpArbiter: two shapes in contact
ARBITER_ELASTICITY, ARBITER_FRICTION = 0, 8  # [1]
ARBITER_SHAPE_A, ARBITER_SHAPE_B = 40, 48
ARBITER_BODY_A, ARBITER_BODY_B = 56, 64
ARBITER_NEXT_OF_A, ARBITER_NEXT_OF_B = 72, 88  # the next contact of each of the bodies
ARBITER_COUNT, ARBITER_CONTACTS = 104, 112
ARBITER_NORMAL = 120  # two numbers: from A to B
# struct cpContact, `count` of them in a row
CONTACT_SIZE = 96
CONTACT_BOUNCE = 48  # [m/s] velocity along the normal before the blow, times elasticity
CONTACT_PUSH, CONTACT_RUB = 56, 64  # [N s] impulses along and across the normal in this substep
# struct cpConstraint, and behind it cpSimpleMotor
SPACE_ROUNDS = 0  # struct cpSpace: how many rounds of impulses a substep has, an int
CONSTRAINT_CLASS = 0  # address of the addresses of its four functions
MOTOR_RATE = 104  # a number of eight bytes that only the functions of the class read


# Reading and writing at an address


def _make_loader(kind: Any) -> Any:
    def typed(typing_context: Any, address: Any) -> Any:
        def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            place = builder.inttoptr(arguments[0], context.get_value_type(kind).as_pointer())
            return builder.load(place)

        return kind(types.uintp), build

    return intrinsic(typed)


def _make_storer(kind: Any) -> Any:
    def typed(typing_context: Any, address: Any, value: Any) -> Any:
        def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            place = builder.inttoptr(arguments[0], context.get_value_type(kind).as_pointer())
            builder.store(arguments[1], place)
            return context.get_dummy_value()

        return types.void(types.uintp, kind), build

    return intrinsic(typed)


def _python_load(name: str) -> Any:
    return lambda address: ffi.cast(f"{name} *", int(address))[0]


def _python_store(name: str, kind: Any) -> Any:
    def write(address: Any, value: Any) -> None:
        ffi.cast(f"{name} *", int(address))[0] = kind(value)

    return write


if config.DISABLE_JIT:
    number_at: Any = _python_load("double")
    address_at: Any = _python_load("uintptr_t")
    count_at: Any = _python_load("int")
    store: Any = _python_store("double", float)
    store_count: Any = _python_store("int", int)
else:
    number_at, address_at, count_at = _make_loader(types.float64), _make_loader(types.uintp), _make_loader(types.int32)
    store, store_count = _make_storer(types.float64), _make_storer(types.int32)


def record_reader(dtype: np.dtype) -> Any:
    """Return a function for kernels that maps a memory address to a record of the dtype, for reading and writing."""
    if config.DISABLE_JIT:
        return lambda address: np.frombuffer(ffi.buffer(ffi.cast("char *", int(address)), dtype.itemsize), dtype).view(
            np.recarray
        )[0]
    kind = from_dtype(dtype)

    def typed(typing_context: Any, address: Any) -> Any:
        def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return builder.inttoptr(arguments[0], context.get_value_type(kind))

        return kind(types.uintp), build

    return intrinsic(typed)


# For Python


def address_of(thing: Any) -> int:
    """Return the address of the struct of a pymunk Space, Body, Shape or Constraint."""
    names = {pymunk.Space: "_space", pymunk.Body: "_body", pymunk.Shape: "_shape", pymunk.Constraint: "_constraint"}
    name = next(name for kind, name in names.items() if isinstance(thing, kind))
    return int(ffi.cast("uintptr_t", getattr(thing, name)))


@functools.cache
def layout_fits() -> bool:
    """Tell whether the structs of this pymunk have the offsets above."""
    try:
        return _arbiter_fits() and _bodies_fit()
    except (AttributeError, ffi.error):
        return False


def _arbiter_fits() -> bool:
    """Tell whether the structs that pymunk declares have the offsets above."""
    arbiter = {name: field.offset for name, field in ffi.typeof("cpArbiter").fields}
    contact = {name: field.offset for name, field in ffi.typeof("struct cpContact").fields}
    expected = {
        "e": ARBITER_ELASTICITY, "u": ARBITER_FRICTION, "a": ARBITER_SHAPE_A,
        "b": ARBITER_SHAPE_B, "body_a": ARBITER_BODY_A, "body_b": ARBITER_BODY_B, "thread_a": ARBITER_NEXT_OF_A,
        "thread_b": ARBITER_NEXT_OF_B, "count": ARBITER_COUNT, "contacts": ARBITER_CONTACTS, "n": ARBITER_NORMAL,
    }  # fmt: skip
    places = {"bounce": CONTACT_BOUNCE, "jnAcc": CONTACT_PUSH, "jtAcc": CONTACT_RUB}
    return (
        all(arbiter[name] == offset for name, offset in expected.items())
        and all(contact[name] == offset for name, offset in places.items())
        and ffi.sizeof("struct cpContact") == CONTACT_SIZE
        and ffi.sizeof("void *") == ffi.sizeof("cpFloat") == 8
    )


def _bodies_fit() -> bool:
    """Tell whether the offsets fit a body and a motor with known numbers, and two bodies after a collision."""
    space = pymunk.Space()
    space.iterations = 37
    body, other = pymunk.Body(4.0, 8.0), pymunk.Body(4.0, 8.0)
    body.position, body.velocity, body.angle, body.angular_velocity = (1.25, -2.5), (3.5, -4.5), 0.5, 7.25
    other.position = body.position + (0.5, 0.25)
    motor = pymunk.SimpleMotor(space.static_body, body, 123.5)
    space.add(body, other, pymunk.Circle(body, 0.375), pymunk.Circle(other, 1.0), motor)
    places = [
        (body, BODY_MASS_INVERSE, 0.25), (body, BODY_MOMENT_INVERSE, 0.125), (body, BODY_X, 1.25), (body, BODY_Y, -2.5),
        (body, BODY_VX, 3.5), (body, BODY_VY, -4.5), (body, BODY_ANGLE, 0.5), (body, BODY_OMEGA, 7.25),
        (body, BODY_COS, cos(0.5)), (body, BODY_SIN, sin(0.5)), (body, BODY_SHIFT_X, 1.25), (body, BODY_SHIFT_Y, -2.5),
        (motor, MOTOR_RATE, 123.5),
    ]  # fmt: skip
    if any(_value(*place[:2], "d") != place[2] for place in places) or _value(body, BODY_ARBITERS, "Q") != 0:
        return False
    if _value(space, SPACE_ROUNDS, "i") != 37:
        return False
    space.step(1e-9)
    arbiter = _value(body, BODY_ARBITERS, "Q")
    repair = _value(body, BODY_REPAIR_VX, "d"), _value(body, BODY_REPAIR_VY, "d")
    back = _value(other, BODY_REPAIR_VX, "d"), _value(other, BODY_REPAIR_VY, "d")
    parts = 0.0 != repair[0] == -back[0] and 0.0 != repair[1] == -back[1]
    turns = _value(body, BODY_REPAIR_OMEGA, "d") != 0.0
    return bool(parts and turns and arbiter != 0 and arbiter == _value(other, BODY_ARBITERS, "Q"))


def _value(thing: Any, offset: int, form: str) -> Any:
    return struct.unpack(form, ffi.buffer(ffi.cast("char *", address_of(thing) + offset), struct.calcsize(form)))[0]
