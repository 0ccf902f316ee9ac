"""The contacts that our part of the solver lists in a substep: how one is added, and what it brings about.  MS51"""

from __future__ import annotations

from typing import Any

from soccer_env.compiled import compiled
from soccer_env.geometry import length
from soccer_env.physics.engine.memory import (
    BODY_MASS_INVERSE,
    BODY_MOMENT_INVERSE,
    BODY_OMEGA,
    BODY_VX,
    BODY_VY,
    BODY_X,
    BODY_Y,
    number_at,
    record_reader,
)
from soccer_env.physics.solver.records import LAST_CONTACT, POST_CONTACT, POSTS, STANCE

contact_at: Any = record_reader(POST_CONTACT)
last_at: Any = record_reader(LAST_CONTACT)
stance_at: Any = record_reader(STANCE)
CONTACT_BYTES, LAST_BYTES, STANCE_BYTES = (int(kind.itemsize) for kind in (POST_CONTACT, LAST_CONTACT, STANCE))


@compiled
def stance_of(solver, r):
    """Return a robot's STANCE, to read and to write."""
    return stance_at(solver.stances + r * STANCE_BYTES)


@compiled
def keep_impulses(solver):
    """Keep the impulses of the last substep's contacts, and forget these."""
    for i in range(solver.contact_count):
        contact, last = contact_at(solver.contacts + i * CONTACT_BYTES), last_at(solver.last_contacts + i * LAST_BYTES)
        last.key, last.push, last.rub = contact.key, contact.push, contact.rub
    solver.last_count = solver.contact_count
    solver.contact_count = 0


@compiled
def forget(contact):
    """Begin a contact of robots that hold each other with no impulse.

    Rounds that begin with none only take energy. Those of the last substep would give some, as what is held turns and
    contacts that say nearly the same agree slowly.
    """
    contact.push = contact.rub = 0.0


@compiled
def normal(x, y, gap):
    """Return the direction of a vector of a length [m]; any one if it has none."""
    return (x / gap, y / gap) if gap > 0.0 else (1.0, 0.0)


@compiled
def contact_key(r, i, other, part):
    """Return a number that is a contact's own."""
    return ((r * POSTS + i) * 32 + other) * 8 + part


@compiled
def add_contact(solver, key, a, b):
    """Return room for a contact, with the impulses of the last substep if it was there; the last if none is left."""
    if solver.contact_count < solver.contact_room:
        solver.contact_count += 1
    contact = contact_at(solver.contacts + (solver.contact_count - 1) * CONTACT_BYTES)
    contact.key, contact.a, contact.b = key, a, b
    contact.push = contact.rub = contact.shift = contact.surface_x = contact.surface_y = 0.0
    contact.ball = 0
    contact.level = 1.0
    contact.held = 0
    for i in range(solver.last_count):
        last = last_at(solver.last_contacts + i * LAST_BYTES)
        if last.key == key:
            contact.push, contact.rub = last.push, last.rub
    return contact


@compiled
def aim(solver, contact, nx, ny, x, y, gap, elasticity, friction):
    """Say what a contact at x, y [m] is to bring about: the velocity after the blow, and the end of the overlap."""
    a, b = contact.a, contact.b
    contact.nx, contact.ny, contact.friction = nx, ny, friction
    contact.ax, contact.ay = x - number_at(a + BODY_X), y - number_at(a + BODY_Y)
    contact.bx, contact.by = x - number_at(b + BODY_X), y - number_at(b + BODY_Y)
    contact.mass_along = 1.0 / softness(contact, nx, ny)
    contact.mass_across = 1.0 / softness(contact, -ny, nx)
    contact.skew = skew(contact, nx, ny)
    vx, vy = slip_of(contact)
    contact.target = -elasticity * (vx * nx + vy * ny)
    contact.repair = -solver.repair * min(0.0, gap + solver.slop)


@compiled
def softness(contact, x, y):
    """Return the change of relative velocity that a unit of impulse along a direction brings about [1/kg]."""
    a, b = contact.a, contact.b
    turn_a, turn_b = contact.ax * y - contact.ay * x, contact.bx * y - contact.by * x
    linear = number_at(a + BODY_MASS_INVERSE) + number_at(b + BODY_MASS_INVERSE)
    return (
        linear
        + number_at(a + BODY_MOMENT_INVERSE) * turn_a * turn_a
        + number_at(b + BODY_MOMENT_INVERSE) * turn_b * turn_b
    )


@compiled
def skew(contact, nx, ny):
    """Return the relative velocity across a normal that a unit of impulse along it brings about [1/kg]."""
    along_a, across_a = contact.ax * ny - contact.ay * nx, contact.ax * nx + contact.ay * ny
    along_b, across_b = contact.bx * ny - contact.by * nx, contact.bx * nx + contact.by * ny
    ease_a, ease_b = number_at(contact.a + BODY_MOMENT_INVERSE), number_at(contact.b + BODY_MOMENT_INVERSE)
    return ease_a * along_a * across_a + ease_b * along_b * across_b


@compiled
def slip_of(contact):
    """Return the velocity [m/s] of B's surface over A's where they touch."""
    a, b = contact.a, contact.b
    turn_a, turn_b = number_at(a + BODY_OMEGA), number_at(b + BODY_OMEGA)
    vx = number_at(b + BODY_VX) - turn_b * contact.by - number_at(a + BODY_VX) + turn_a * contact.ay
    vy = number_at(b + BODY_VY) + turn_b * contact.bx - number_at(a + BODY_VY) - turn_a * contact.ax
    return vx + contact.surface_x, vy + contact.surface_y


@compiled
def share_with_roll(solver, contact):
    """Leave to the level friction of a contact with the ball its share of the slip, see `solver/ball.py`."""
    vx, vy = slip_of(contact)
    level = vy * contact.nx - vx * contact.ny
    slip = length(level, solver.roll_x * contact.nx + solver.roll_y * contact.ny)
    contact.level = abs(level) / slip if slip > 0.0 else 1.0
