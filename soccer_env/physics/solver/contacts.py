"""The contacts of posts in a substep, and the impulses at them: along the normal, across it, and to part bodies.  MS51

Each round visits every contact once, as Chipmunk does, and changes its impulse: it never pulls, and its friction stays
within Coulomb's limit. Overlaps are undone by velocities apart from the bodies' own, which last for one substep and so
give no energy.
"""

from __future__ import annotations

from typing import Any

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, length
from soccer_env.physics.engine.memory import (
    BODY_MASS_INVERSE,
    BODY_MOMENT_INVERSE,
    BODY_OMEGA,
    BODY_REPAIR_OMEGA,
    BODY_REPAIR_VX,
    BODY_REPAIR_VY,
    BODY_VX,
    BODY_VY,
    BODY_X,
    BODY_Y,
    number_at,
    record_reader,
    store,
)
from soccer_env.physics.solver.records import LAST_CONTACT, POST_CONTACT, POSTS, STANCE

contact_at: Any = record_reader(POST_CONTACT)
last_at: Any = record_reader(LAST_CONTACT)
stance_at: Any = record_reader(STANCE)
CONTACT_BYTES, LAST_BYTES, STANCE_BYTES = (int(kind.itemsize) for kind in (POST_CONTACT, LAST_CONTACT, STANCE))


@compiled
def stance_of(solver, r):
    """Return the STANCE record of robot r, for reading and writing."""
    return stance_at(solver.stances + r * STANCE_BYTES)


@compiled
def keep_impulses(solver):
    """Keep the impulses of the last substep's contacts, and clear the list of contacts."""
    for i in range(solver.contact_count):
        contact, last = contact_at(solver.contacts + i * CONTACT_BYTES), last_at(solver.last_contacts + i * LAST_BYTES)
        last.key, last.push, last.rub = contact.key, contact.push, contact.rub
    solver.last_count = solver.contact_count
    solver.contact_count = 0


@compiled
def clear_impulses(contact):
    """Set the impulses of a contact of robots that hold each other to zero, so that the rounds only take energy out.

    Impulses of the last substep would add energy, since held robots turn and nearly equal contacts converge slowly.
    """
    contact.push = contact.rub = 0.0


@compiled
def unit_normal(x, y, gap):
    """Return the unit vector along (x, y), a vector of length `gap` [m]; (1, 0) at length 0."""
    return (x / gap, y / gap) if gap > 0.0 else (1.0, 0.0)


@compiled
def contact_key(r, i, other, part):
    """Return the unique key of the contact between post i of robot r and a part of another object."""
    return ((r * POSTS + i) * 32 + other) * 8 + part


@compiled
def add_contact(solver, key, a, b):
    """Add a contact of bodies a and b, with its last impulses if it existed in the last substep, and return it.
    In a full list the last contact is replaced.
    """
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
def set_contact_targets(solver, contact, nx, ny, x, y, gap, elasticity, friction):
    """Set a contact's geometry at x, y [m] and its targets: velocity after the blow, speed that undoes the overlap."""
    a, b = contact.a, contact.b
    contact.nx, contact.ny, contact.friction = nx, ny, friction
    contact.ax, contact.ay = x - number_at(a + BODY_X), y - number_at(a + BODY_Y)
    contact.bx, contact.by = x - number_at(b + BODY_X), y - number_at(b + BODY_Y)
    contact.mass_along = 1.0 / inverse_effective_mass(contact, nx, ny)
    contact.mass_across = 1.0 / inverse_effective_mass(contact, -ny, nx)
    contact.skew = cross_inverse_mass(contact, nx, ny)
    vx, vy = contact_slip(contact)
    contact.target = -elasticity * (vx * nx + vy * ny)
    contact.repair = -solver.repair * min(0.0, gap + solver.slop)


@compiled
def inverse_effective_mass(contact, x, y):
    """Return the change of the relative velocity along a direction per unit of impulse in that direction [1/kg]."""
    a, b = contact.a, contact.b
    turn_a, turn_b = contact.ax * y - contact.ay * x, contact.bx * y - contact.by * x
    linear = number_at(a + BODY_MASS_INVERSE) + number_at(b + BODY_MASS_INVERSE)
    return (
        linear
        + number_at(a + BODY_MOMENT_INVERSE) * turn_a * turn_a
        + number_at(b + BODY_MOMENT_INVERSE) * turn_b * turn_b
    )


@compiled
def cross_inverse_mass(contact, nx, ny):
    """Return the change of the relative velocity across a normal per unit of impulse along the normal [1/kg]."""
    along_a, across_a = contact.ax * ny - contact.ay * nx, contact.ax * nx + contact.ay * ny
    along_b, across_b = contact.bx * ny - contact.by * nx, contact.bx * nx + contact.by * ny
    ease_a, ease_b = number_at(contact.a + BODY_MOMENT_INVERSE), number_at(contact.b + BODY_MOMENT_INVERSE)
    return ease_a * along_a * across_a + ease_b * along_b * across_b


@compiled
def contact_slip(contact):
    """Return the velocity [m/s] of B's surface over A's where they touch."""
    a, b = contact.a, contact.b
    turn_a, turn_b = number_at(a + BODY_OMEGA), number_at(b + BODY_OMEGA)
    vx = number_at(b + BODY_VX) - turn_b * contact.by - number_at(a + BODY_VX) + turn_a * contact.ay
    vy = number_at(b + BODY_VY) + turn_b * contact.bx - number_at(a + BODY_VY) - turn_a * contact.ax
    return vx + contact.surface_x, vy + contact.surface_y


@compiled
def share_with_roll(solver, contact):
    """Set the level share of the friction of a contact with the ball, see `solver/ball.py`."""
    vx, vy = contact_slip(contact)
    level = vy * contact.nx - vx * contact.ny
    slip = length(level, solver.roll_x * contact.nx + solver.roll_y * contact.ny)
    contact.level = abs(level) / slip if slip > 0.0 else 1.0


@compiled
def resume_posts(solver, share):
    """Apply the last substep's impulses at the contacts of posts, times the ratio `share` of the substeps' lengths."""
    for i in range(solver.contact_count):
        contact = contact_at(solver.contacts + i * CONTACT_BYTES)
        contact.push *= share
        contact.rub *= share
        apply_impulses(contact, contact.push, contact.rub)


@compiled
def solve_posts(solver):
    """Run one solver iteration over all contacts of the posts."""
    for i in range(solver.contact_count):
        contact = contact_at(solver.contacts + i * CONTACT_BYTES)
        part(contact)
        vx, vy = contact_slip(contact)
        along, across = vx * contact.nx + vy * contact.ny, vy * contact.nx - vx * contact.ny
        if contact.held == 1:
            push, rub = held_leg_impulses(contact, along, across)
        else:
            push = max(contact.push + (contact.target - along) * contact.mass_along, 0.0)
            most = contact.friction * contact.level * push
            rub = clip(contact.rub - across * contact.mass_across, -most, most)
        apply_impulses(contact, push - contact.push, rub - contact.rub)
        contact.push = push
        contact.rub = rub


@compiled
def held_leg_impulses(contact, along, across):
    """Return the impulses along and across the normal that let a held leg only move straight out of its gap.

    Both are solved at once, since each changes the other: in turn they would not agree within the rounds of a substep.
    """
    soft_along, soft_across = 1.0 / contact.mass_along, 1.0 / contact.mass_across
    size = soft_along * soft_across - contact.skew * contact.skew
    push = contact.push + (contact.skew * across - soft_across * along) / size
    if push < 0.0:  # it moves out
        return 0.0, contact.rub + (contact.skew * contact.push - across) * contact.mass_across
    return push, contact.rub + (contact.skew * along - soft_along * across) / size


@compiled
def apply_impulses(contact, push, rub):
    """Apply the impulses [N s] of a contact, along the normal and across it, to its two bodies."""
    x, y = push * contact.nx - rub * contact.ny, push * contact.ny + rub * contact.nx
    a, b = contact.a, contact.b
    light_a, light_b = number_at(a + BODY_MASS_INVERSE), number_at(b + BODY_MASS_INVERSE)
    store(a + BODY_VX, number_at(a + BODY_VX) - light_a * x)
    store(a + BODY_VY, number_at(a + BODY_VY) - light_a * y)
    store(b + BODY_VX, number_at(b + BODY_VX) + light_b * x)
    store(b + BODY_VY, number_at(b + BODY_VY) + light_b * y)
    turn_a = number_at(a + BODY_MOMENT_INVERSE) * (contact.ax * y - contact.ay * x)
    turn_b = number_at(b + BODY_MOMENT_INVERSE) * (contact.bx * y - contact.by * x)
    store(a + BODY_OMEGA, number_at(a + BODY_OMEGA) - turn_a)
    store(b + BODY_OMEGA, number_at(b + BODY_OMEGA) + turn_b)


@compiled
def part(contact):
    """Set extra velocities, for one substep, that separate two overlapping bodies."""
    a, b, nx, ny = contact.a, contact.b, contact.nx, contact.ny
    turn_a, turn_b = number_at(a + BODY_REPAIR_OMEGA), number_at(b + BODY_REPAIR_OMEGA)
    vx = number_at(b + BODY_REPAIR_VX) - turn_b * contact.by - number_at(a + BODY_REPAIR_VX) + turn_a * contact.ay
    vy = number_at(b + BODY_REPAIR_VY) + turn_b * contact.bx - number_at(a + BODY_REPAIR_VY) - turn_a * contact.ax
    shift = max(contact.shift + (contact.repair - vx * nx - vy * ny) * contact.mass_along, 0.0)
    size = shift - contact.shift
    contact.shift = shift
    light_a, light_b = size * number_at(a + BODY_MASS_INVERSE), size * number_at(b + BODY_MASS_INVERSE)
    store(a + BODY_REPAIR_VX, number_at(a + BODY_REPAIR_VX) - light_a * nx)
    store(a + BODY_REPAIR_VY, number_at(a + BODY_REPAIR_VY) - light_a * ny)
    store(b + BODY_REPAIR_VX, number_at(b + BODY_REPAIR_VX) + light_b * nx)
    store(b + BODY_REPAIR_VY, number_at(b + BODY_REPAIR_VY) + light_b * ny)
    light_a = size * number_at(a + BODY_MOMENT_INVERSE) * (contact.ax * ny - contact.ay * nx)
    light_b = size * number_at(b + BODY_MOMENT_INVERSE) * (contact.bx * ny - contact.by * nx)
    store(a + BODY_REPAIR_OMEGA, turn_a - light_a)
    store(b + BODY_REPAIR_OMEGA, turn_b + light_b)
