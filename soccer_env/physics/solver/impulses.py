"""Impulses at the contacts of legs, as Chipmunk gives them at its own: along the normal, across it, and to part bodies.

Each round looks at every contact once and adds to the impulse that it has given so far, which is never a pull and
whose friction stays within Coulomb's limit. Overlaps are undone by velocities apart from the bodies' own, which last
for one substep, so that they give no energy.
"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.physics.engine.memory import (
    BODY_MASS_INVERSE,
    BODY_MOMENT_INVERSE,
    BODY_OMEGA,
    BODY_REPAIR_OMEGA,
    BODY_REPAIR_VX,
    BODY_REPAIR_VY,
    BODY_VX,
    BODY_VY,
    number_at,
    store,
)
from soccer_env.physics.solver.contacts import CONTACT_BYTES, contact_at, slip_of


@compiled
def resume_posts(solver, share):
    """Begin with the impulses of the last substep, times the ratio of the substeps' lengths."""
    for i in range(solver.contact_count):
        contact = contact_at(solver.contacts + i * CONTACT_BYTES)
        contact.push *= share
        contact.rub *= share
        give(contact, contact.push, contact.rub)


@compiled
def solve_posts(solver):
    """Look at all contacts once."""
    for i in range(solver.contact_count):
        contact = contact_at(solver.contacts + i * CONTACT_BYTES)
        part(contact)
        vx, vy = slip_of(contact)
        along, across = vx * contact.nx + vy * contact.ny, vy * contact.nx - vx * contact.ny
        if contact.held == 1:
            push, rub = hold(contact, along, across)
        else:
            push = max(contact.push + (contact.target - along) * contact.mass_along, 0.0)
            most = contact.friction * contact.level * push
            rub = clip(contact.rub - across * contact.mass_across, -most, most)
        give(contact, push - contact.push, rub - contact.rub)
        contact.push = push
        contact.rub = rub


@compiled
def hold(contact, along, across):
    """Return the impulses by which a held leg moves straight out or not at all: both at once, as one turns the other.

    Taken one after the other they would not agree within the rounds of a substep.
    """
    soft_along, soft_across = 1.0 / contact.mass_along, 1.0 / contact.mass_across
    size = soft_along * soft_across - contact.skew * contact.skew
    push = contact.push + (contact.skew * across - soft_across * along) / size
    if push < 0.0:  # it moves out
        return 0.0, contact.rub + (contact.skew * contact.push - across) * contact.mass_across
    return push, contact.rub + (contact.skew * along - soft_along * across) / size


@compiled
def give(contact, push, rub):
    """Give two bodies the impulses [N s] of a contact, along the normal and across it."""
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
    """Give two bodies that overlap velocities that part them."""
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
