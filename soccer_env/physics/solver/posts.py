"""What the posts of robots touch, legs or tips of a guide: other robots, boards and their feet, the ball.  MS51

Posts are no shapes of Chipmunk's, whose search for pairs would cost more than all the rest of a match: they are found
here, in each substep, by the distances of circles from circles, from discs and capsules and from boards, and take part
in the same rounds of impulses (`solver/impulses.py`). A leg meets robots and boards where it stands, in the middle of
its stroke, since a leg that swings against something heavy gives way; it meets the ball where it is.

`k`: the league's constants.
"""

from __future__ import annotations

from math import exp, log
from typing import Any

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, into_frame, length, out_of_frame, point_of_frame
from soccer_env.physics.engine.memory import (
    BODY_COS,
    BODY_MASS_INVERSE,
    BODY_MOMENT_INVERSE,
    BODY_OMEGA,
    BODY_SIN,
    BODY_VX,
    BODY_VY,
    BODY_X,
    BODY_Y,
    number_at,
    record_reader,
)
from soccer_env.physics.solver.records import LAST_CONTACT, OVERLAP_LEFT, POST_CONTACT, POSTS, STANCE

BALL = 30  # in the place of the other robot's row in a contact's key
TRUNK = 4  # in the place of the other robot's post

contact_at: Any = record_reader(POST_CONTACT)
last_at: Any = record_reader(LAST_CONTACT)
stance_at: Any = record_reader(STANCE)
CONTACT_BYTES, LAST_BYTES, STANCE_BYTES = (int(kind.itemsize) for kind in (POST_CONTACT, LAST_CONTACT, STANCE))


@compiled
def stance_of(solver, r):
    """Return a robot's STANCE, to read and to write."""
    return stance_at(solver.stances + r * STANCE_BYTES)


@compiled
def find_post_contacts(solver, k, dt):
    """List what the posts of a match touch of other robots and the ball, in this substep of dt [s]."""
    keep_impulses(solver)
    solver.repair = (1.0 - exp(log(OVERLAP_LEFT) * dt)) / dt
    for r in range(solver.robots):
        stance = stance_of(solver, r)
        stance.meets = stance.placed = 0
    near = 2.0 * k.body_reach
    for r in range(solver.robots):
        if stance_of(solver, r).active == 0:
            continue
        body = stance_of(solver, r).body
        x, y = number_at(body + BODY_X), number_at(body + BODY_Y)
        for other in range(r + 1, solver.robots):
            away = stance_of(solver, other).body
            away_x, away_y = number_at(away + BODY_X) - x, number_at(away + BODY_Y) - y
            if away_x * away_x + away_y * away_y < near * near:
                meet_robot(solver, k, r, other)
    meet_ball(solver, k)


@compiled
def keep_impulses(solver):
    """Keep the impulses of the last substep's contacts, and forget these."""
    for i in range(solver.contact_count):
        contact, last = contact_at(solver.contacts + i * CONTACT_BYTES), last_at(solver.last_contacts + i * LAST_BYTES)
        last.key, last.push, last.rub = contact.key, contact.push, contact.rub
    solver.last_count = solver.contact_count
    solver.contact_count = 0


@compiled
def place_posts(solver, k, stance):
    """Say where the posts of a robot stand in the field, if nobody has asked for it in this substep.

    In a mirrored match those of the other side come first.
    """
    if stance.placed == 1:
        return
    stance.placed = 1
    body = stance.body
    x, y = number_at(body + BODY_X), number_at(body + BODY_Y)
    cosine, sine = number_at(body + BODY_COS), number_at(body + BODY_SIN)
    for i in range(solver.posts):
        post = stance.posts[i]
        ahead, left = post.stand_x, solver.handedness * post.stand_y
        post.field_x, post.field_y = point_of_frame(x, y, ahead, left, cosine, sine)
        if k.legs == 0:
            post.x, post.y = ahead, left


@compiled
def meet_robot(solver, k, r, other):
    """List the contacts of two robots near each other: posts with posts, and of each with the trunk of the other."""
    place_posts(solver, k, stance_of(solver, r))
    place_posts(solver, k, stance_of(solver, other))
    both = 2.0 * k.body_tip_radius
    for i in range(solver.posts):
        post = stance_of(solver, r).posts[i]
        for its in range(solver.posts):
            across = stance_of(solver, other).posts[its]
            x, y = across.field_x - post.field_x, across.field_y - post.field_y
            if x * x + y * y < both * both:
                gap = length(x, y)
                touch_robot(solver, k, r, i, other, its, x, y, gap, both)
    for i in range(solver.posts):
        meet_trunk(solver, k, r, i, other)
        meet_trunk(solver, k, other, i, r)


@compiled
def meet_trunk(solver, k, r, i, other):
    """List the contact of a post of robot r with the trunk of another robot, if they touch."""
    post = stance_of(solver, r).posts[i]
    body = stance_of(solver, other).body
    cosine, sine = number_at(body + BODY_COS), number_at(body + BODY_SIN)
    x, y = number_at(body + BODY_X) - post.field_x, number_at(body + BODY_Y) - post.field_y
    ahead, _ = into_frame(-x, -y, cosine, sine)
    ahead = clip(ahead, k.body_disc_x - k.body_disc_back, k.body_disc_x)
    x += cosine * ahead
    y += sine * ahead
    reach = k.body_tip_radius + k.body_disc_radius
    if x * x + y * y < reach * reach:
        touch_robot(solver, k, r, i, other, TRUNK, x, y, length(x, y), reach)


@compiled
def touch_robot(solver, k, r, i, other, part, x, y, gap, reach):
    """List a contact of robot r's post with a part of another robot whose axis is x, y [m] away; they reach so far."""
    stance_of(solver, r).meets = 1
    stance_of(solver, other).meets = 1
    post = stance_of(solver, r).posts[i]
    nx, ny = normal(x, y, gap)
    place_x, place_y = post.field_x + nx * k.body_tip_radius, post.field_y + ny * k.body_tip_radius
    key = contact_key(r, i, other, part)
    contact = add_contact(solver, key, stance_of(solver, r).body, stance_of(solver, other).body)
    elasticity = solver.robot_elasticity
    if stance_of(solver, r).caught_by == other + 1 or stance_of(solver, other).caught_by == r + 1:
        elasticity = 0.0  # a bounce against a hold would give energy
        forget(contact)
    aim(solver, contact, nx, ny, place_x, place_y, gap - reach, elasticity, solver.robot_friction)


@compiled
def forget(contact):
    """Begin a contact of robots that hold each other with no impulse.

    Rounds that begin with none only take energy. Those of the last substep would give some, as what is held turns and
    contacts that say nearly the same agree slowly.
    """
    contact.push = contact.rub = 0.0


@compiled
def meet_ball(solver, k):
    """List the contacts of posts, paws where they swing, with the ball."""
    x, y = number_at(solver.ball + BODY_X), number_at(solver.ball + BODY_Y)
    near = 1.5 * k.body_reach + k.ball_radius
    for r in range(solver.robots):
        stance = stance_of(solver, r)
        body = stance.body
        away_x, away_y = x - number_at(body + BODY_X), y - number_at(body + BODY_Y)
        if away_x * away_x + away_y * away_y < near * near:
            place_posts(solver, k, stance)
            cosine, sine = number_at(body + BODY_COS), number_at(body + BODY_SIN)
            ahead, left = into_frame(away_x, away_y, cosine, sine)
            for i in range(solver.posts):
                meet_paw(solver, k, r, i, ahead, left, cosine, sine)


@compiled
def meet_paw(solver, k, r, i, ahead, left, cosine, sine):
    """List the contact of a post with the ball, which lies ahead and left [m] of its robot, if they touch."""
    stance = stance_of(solver, r)
    paw = stance.posts[i]
    x, y = ahead - paw.x - solver.time * paw.vx, left - paw.y - solver.time * paw.vy
    reach = k.body_tip_radius + k.ball_radius
    if x * x + y * y >= reach * reach:
        return
    stance.meets = 1
    gap = length(x, y)
    x, y = out_of_frame(x, y, cosine, sine)
    nx, ny = normal(x, y, gap)
    place_x = number_at(solver.ball + BODY_X) - nx * k.ball_radius
    place_y = number_at(solver.ball + BODY_Y) - ny * k.ball_radius
    contact = add_contact(solver, contact_key(r, i, BALL, 0), stance.body, solver.ball)
    contact.ball = 1
    vx, vy = out_of_frame(paw.vx, paw.vy, cosine, sine)
    contact.surface_x = -vx
    contact.surface_y = -vy
    aim(solver, contact, nx, ny, place_x, place_y, gap - reach, solver.ball_elasticity, solver.ball_friction)
    share_with_roll(solver, contact)


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
