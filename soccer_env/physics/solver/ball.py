"""Blows to a rolling ball: friction acts against the whole slip of the two surfaces.

Chipmunk knows the ball's spin about the vertical, not its roll. Let n be the normal from the ball to the other surface,
u the level relative velocity along that surface, and w = roll . n the speed at which the ball's surface moves up or
down there. Coulomb's friction has the size mu times the normal impulse P and the direction of the slip (u, w):

    level share      Chipmunk's own friction, with mu |u| / hypot(u, w)
    upright share    at most sqrt((mu P)^2 - Q^2), with Q the level impulse of the friction

The upright impulse J acts at the side of the ball and turns it. With the inertia shell m r^2 the roll along n changes
by J / (shell m), until nothing slips. For a ball that rolls head-on at v into something heavy, P = (1 + e) m v, so that

    change of roll = min(v, mu (1 + e) v / shell).

The roll along the surface does not change: the contact lies on its axis. Assumed: the ball stays on the carpet; real
balls hop a little. Friction in the direction of the slip, limited by the normal impulse, is the usual model of a
spinning ball's bounce, for instance in R. Cross, "Bounce of a spinning ball near normal incidence", American Journal of
Physics 73 (2005).
"""

from __future__ import annotations

from math import sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, length
from soccer_env.physics.engine.memory import (
    ARBITER_BODY_A,
    ARBITER_BODY_B,
    ARBITER_CONTACTS,
    ARBITER_COUNT,
    ARBITER_FRICTION,
    ARBITER_NEXT_OF_A,
    ARBITER_NEXT_OF_B,
    ARBITER_NORMAL,
    BODY_ARBITERS,
    BODY_OMEGA,
    BODY_VX,
    BODY_VY,
    CONTACT_PUSH,
    CONTACT_RUB,
    CONTACT_SIZE,
    address_at,
    count_at,
    number_at,
    store,
)
from soccer_env.physics.solver.contacts import CONTACT_BYTES, contact_at
from soccer_env.physics.solver.records import MOST_CONTACTS


@compiled
def list_ball_contacts(solver):
    """List the contacts of the ball, and set the level share of the friction in each."""
    solver.ball_contact_count = 0
    arbiter = address_at(solver.ball + BODY_ARBITERS)
    while arbiter != 0 and solver.ball_contact_count < MOST_CONTACTS:
        first = address_at(arbiter + ARBITER_BODY_A) == solver.ball
        if count_at(arbiter + ARBITER_COUNT) > 0:
            contact = solver.ball_contacts[solver.ball_contact_count]
            solver.ball_contact_count += 1
            contact.arbiter = arbiter
            contact.friction = number_at(arbiter + ARBITER_FRICTION)
            share_friction(solver, contact, arbiter, first)
        arbiter = address_at(arbiter + (ARBITER_NEXT_OF_A if first else ARBITER_NEXT_OF_B))


@compiled
def count_ball_contacts(solver):
    """Return the number of things that the ball touches in this substep."""
    count = solver.ball_contact_count
    for i in range(solver.contact_count):
        count += contact_at(solver.contacts + i * CONTACT_BYTES).ball
    return count


@compiled
def share_friction(solver, contact, arbiter, first):
    """Reduce the friction of a contact in Chipmunk to its level share."""
    level = level_slip(arbiter)
    upright = roll_speed_at_contact(solver, arbiter, first)
    slip = length(level, upright)
    if slip > 0.0:
        store(arbiter + ARBITER_FRICTION, contact.friction * abs(level) / slip)


@compiled
def level_slip(arbiter):
    """Return the velocity [m/s] of B's surface over A's, level and across the normal, where they touch."""
    a, b = address_at(arbiter + ARBITER_BODY_A), address_at(arbiter + ARBITER_BODY_B)
    point = address_at(arbiter + ARBITER_CONTACTS)
    turn_a, turn_b = number_at(a + BODY_OMEGA), number_at(b + BODY_OMEGA)
    x = number_at(b + BODY_VX) - turn_b * number_at(point + 24) - number_at(a + BODY_VX) + turn_a * number_at(point + 8)
    y = number_at(b + BODY_VY) + turn_b * number_at(point + 16) - number_at(a + BODY_VY) - turn_a * number_at(point)
    return y * number_at(arbiter + ARBITER_NORMAL) - x * number_at(arbiter + ARBITER_NORMAL + 8)


@compiled
def roll_speed_at_contact(solver, arbiter, first):
    """Return the speed [m/s] at which the ball's surface moves down where it touches: its roll along the normal."""
    nx, ny = number_at(arbiter + ARBITER_NORMAL), number_at(arbiter + ARBITER_NORMAL + 8)
    along = solver.roll_x * nx + solver.roll_y * ny
    return along if first else -along


@compiled
def slow_roll_by_contacts(solver):
    """Slow the ball's roll by the friction of all its contacts in this substep, each along its normal."""
    for i in range(solver.ball_contact_count):
        contact = solver.ball_contacts[i]
        arbiter = contact.arbiter
        points = address_at(arbiter + ARBITER_CONTACTS)
        push = rub = 0.0
        for j in range(count_at(arbiter + ARBITER_COUNT)):
            push += number_at(points + j * CONTACT_SIZE + CONTACT_PUSH)
            rub += number_at(points + j * CONTACT_SIZE + CONTACT_RUB)
        nx, ny = number_at(arbiter + ARBITER_NORMAL), number_at(arbiter + ARBITER_NORMAL + 8)
        slow_roll(solver, nx, ny, contact.friction * push, rub)
    for i in range(solver.contact_count):
        leg = contact_at(solver.contacts + i * CONTACT_BYTES)
        if leg.ball == 1:
            slow_roll(solver, leg.nx, leg.ny, leg.friction * leg.push, leg.rub)


@compiled
def slow_roll(solver, nx, ny, most, rub):
    """Slow the roll along a normal by the upright friction [N s] that the level impulse `rub` leaves of `most`."""
    left = most * most - rub * rub
    if left > 0.0:
        change = sqrt(left) / solver.spin_mass
        taken = clip(solver.roll_x * nx + solver.roll_y * ny, -change, change)
        solver.roll_x -= taken * nx
        solver.roll_y -= taken * ny
