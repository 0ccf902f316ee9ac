"""Contacts of posts, the legs or tips of a guide, with other robots and with the ball.  MS51, MS53

Posts are no shapes of Chipmunk's, whose search for pairs would cost more than the rest of a match. In each substep
their contacts are found here, by the distances of circles from circles, discs and capsules, and take part in Chipmunk's
rounds of impulses (`solver/contacts.py`). A leg touches robots and boards where it stands, in mid-stroke, since a leg
that swings against something heavy gives way; it touches the ball where it is. A leg spread for a block touches along
its whole length, from paw to shoulder; boards it touches with its paw alone.

`k`: the league's constants.
"""

from __future__ import annotations

from math import exp, log

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, into_frame, length, out_of_frame, point_of_frame
from soccer_env.physics.block import leg_vector, most_reach, nearest_leg_fraction, paw_shift
from soccer_env.physics.engine.memory import BODY_COS, BODY_SIN, BODY_X, BODY_Y, number_at
from soccer_env.physics.gait import TIPS
from soccer_env.physics.solver.contacts import (
    add_contact,
    clear_impulses,
    contact_key,
    keep_impulses,
    set_contact_targets,
    share_with_roll,
    stance_of,
    unit_normal,
)
from soccer_env.physics.solver.records import OVERLAP_LEFT

BALL = 30  # in the place of the other robot's row in a contact's key
TRUNK = 4  # in the place of the other robot's post


@compiled
def find_post_contacts(solver, k, dt):
    """List the contacts of posts with other robots and with the ball in this substep of dt [s]."""
    keep_impulses(solver)
    solver.repair = (1.0 - exp(log(OVERLAP_LEFT) * dt)) / dt
    for r in range(solver.robots):
        stance = stance_of(solver, r)
        stance.meets = stance.placed = 0
    near = 2.0 * most_reach(k)
    for r in range(solver.robots):
        if stance_of(solver, r).active == 0:
            continue
        body = stance_of(solver, r).body
        x, y = number_at(body + BODY_X), number_at(body + BODY_Y)
        for other in range(r + 1, solver.robots):
            away = stance_of(solver, other).body
            away_x, away_y = number_at(away + BODY_X) - x, number_at(away + BODY_Y) - y
            if away_x * away_x + away_y * away_y < near * near:
                add_robot_contacts(solver, k, r, other)
    add_ball_contacts(solver, k)


@compiled
def place_posts(solver, k, stance):
    """Compute the places of a robot's posts in the field frame, once a substep.

    In a mirrored match the posts of the other side come first.
    """
    if stance.placed == 1:
        return
    stance.placed = 1
    body = stance.body
    x, y = number_at(body + BODY_X), number_at(body + BODY_Y)
    cosine, sine = number_at(body + BODY_COS), number_at(body + BODY_SIN)
    spread = foreleg_spread_now(solver, stance)
    for i in range(solver.posts):
        post = stance.posts[i]
        ahead, left = post.stand_x, solver.handedness * post.stand_y
        if k.legs == 0:
            post.x, post.y = ahead, left
        if spread > 0.0 and i < TIPS:
            out_x, out_y = paw_shift(k, i, spread, solver.handedness)
            ahead += out_x
            left += out_y
            leg_x, leg_y = leg_vector(k, i, spread, solver.handedness)
            post.root_x, post.root_y = point_of_frame(x, y, ahead + leg_x, left + leg_y, cosine, sine)
        post.field_x, post.field_y = point_of_frame(x, y, ahead, left, cosine, sine)
        if spread <= 0.0 or i >= TIPS:
            post.root_x, post.root_y = post.field_x, post.field_y


@compiled
def foreleg_spread_now(solver, stance):
    """Return how far a robot's forelegs are spread for a block in this substep: 0 not at all, 1 all the way."""
    return stance.spread + solver.time * stance.spread_rate


@compiled
def add_robot_contacts(solver, k, r, other):
    """List the contacts of two near robots: posts (legs, corners) with posts, and with the other robot's trunk."""
    place_posts(solver, k, stance_of(solver, r))
    place_posts(solver, k, stance_of(solver, other))
    if (
        foreleg_spread_now(solver, stance_of(solver, r)) > 0.0
        or foreleg_spread_now(solver, stance_of(solver, other)) > 0.0
    ):
        add_spread_leg_contacts(solver, k, r, other)
        return
    both = 2.0 * k.body_tip_radius
    for i in range(solver.posts):
        post = stance_of(solver, r).posts[i]
        for its in range(solver.posts):
            across = stance_of(solver, other).posts[its]
            x, y = across.field_x - post.field_x, across.field_y - post.field_y
            if x * x + y * y < both * both:
                gap = length(x, y)
                add_post_contact(solver, k, r, i, other, its, post.field_x, post.field_y, x, y, gap, both)
    for i in range(solver.posts):
        add_trunk_contact(solver, k, r, i, other)
        add_trunk_contact(solver, k, other, i, r)


@compiled
def add_trunk_contact(solver, k, r, i, other):
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
        add_post_contact(solver, k, r, i, other, TRUNK, post.field_x, post.field_y, x, y, length(x, y), reach)


@compiled
def add_spread_leg_contacts(solver, k, r, other):
    """List the contacts of two robots, of which at least one blocks, at the nearest points of their legs.  MS53"""
    both = 2.0 * k.body_tip_radius
    for i in range(solver.posts):
        a = stance_of(solver, r).posts[i]
        for its in range(solver.posts):
            b = stance_of(solver, other).posts[its]
            at_x, at_y, x, y = nearest_between_segments(
                a.field_x, a.field_y, a.root_x, a.root_y, b.field_x, b.field_y, b.root_x, b.root_y
            )
            if x * x + y * y < both * both:
                add_post_contact(solver, k, r, i, other, its, at_x, at_y, x, y, length(x, y), both)
    for i in range(solver.posts):
        add_leg_trunk_contact(solver, k, r, i, other)
        add_leg_trunk_contact(solver, k, other, i, r)


@compiled
def add_leg_trunk_contact(solver, k, r, i, other):
    """List the contact of a whole leg of robot r with the trunk of another robot, if they touch."""
    leg = stance_of(solver, r).posts[i]
    body = stance_of(solver, other).body
    cosine, sine = number_at(body + BODY_COS), number_at(body + BODY_SIN)
    x, y = number_at(body + BODY_X), number_at(body + BODY_Y)
    rear = k.body_disc_x - k.body_disc_back
    at_x, at_y, x, y = nearest_between_segments(
        leg.field_x, leg.field_y, leg.root_x, leg.root_y,
        x + cosine * k.body_disc_x, y + sine * k.body_disc_x, x + cosine * rear, y + sine * rear,
    )  # fmt: skip
    reach = k.body_tip_radius + k.body_disc_radius
    if x * x + y * y < reach * reach:
        add_post_contact(solver, k, r, i, other, TRUNK, at_x, at_y, x, y, length(x, y), reach)


@compiled
def add_post_contact(solver, k, r, i, other, part, at_x, at_y, x, y, gap, reach):
    """List a contact of robot r's post, its axis at at_x, at_y [m], with a part of another robot.

    The vector from the post's axis to the axis of that part is x, y [m]; the two touch within `reach` [m].
    """
    stance_of(solver, r).meets = 1
    stance_of(solver, other).meets = 1
    nx, ny = unit_normal(x, y, gap)
    place_x, place_y = at_x + nx * k.body_tip_radius, at_y + ny * k.body_tip_radius
    key = contact_key(r, i, other, part)
    contact = add_contact(solver, key, stance_of(solver, r).body, stance_of(solver, other).body)
    elasticity = solver.robot_elasticity
    if stance_of(solver, r).caught_by == other + 1 or stance_of(solver, other).caught_by == r + 1:
        elasticity = 0.0  # a bounce against a hold would add energy
        clear_impulses(contact)
    set_contact_targets(solver, contact, nx, ny, place_x, place_y, gap - reach, elasticity, solver.robot_friction)


@compiled
def add_ball_contacts(solver, k):
    """List the contacts of posts with the ball, paws taken where they are in their swing."""
    x, y = number_at(solver.ball + BODY_X), number_at(solver.ball + BODY_Y)
    near = max(1.5 * k.body_reach, most_reach(k)) + k.ball_radius
    for r in range(solver.robots):
        stance = stance_of(solver, r)
        body = stance.body
        away_x, away_y = x - number_at(body + BODY_X), y - number_at(body + BODY_Y)
        if away_x * away_x + away_y * away_y < near * near:
            place_posts(solver, k, stance)
            cosine, sine = number_at(body + BODY_COS), number_at(body + BODY_SIN)
            ahead, left = into_frame(away_x, away_y, cosine, sine)
            for i in range(solver.posts):
                add_paw_contact(solver, k, r, i, ahead, left, cosine, sine)


@compiled
def add_paw_contact(solver, k, r, i, ahead, left, cosine, sine):
    """List the contact of a post with the ball, which lies ahead and left [m] of its robot, if they touch."""
    stance = stance_of(solver, r)
    paw = stance.posts[i]
    x, y = ahead - paw.x - solver.time * paw.vx, left - paw.y - solver.time * paw.vy
    vx, vy = paw.vx, paw.vy
    spread = foreleg_spread_now(solver, stance)
    if spread > 0.0 and i < TIPS:  # the point of the leg nearest to the ball, instead of the paw
        leg_x, leg_y = leg_vector(k, i, spread, solver.handedness)
        share = nearest_leg_fraction(x, y, leg_x, leg_y)
        x -= share * leg_x
        y -= share * leg_y
        vx += share * stance.spread_rate / spread * leg_x
        vy += share * stance.spread_rate / spread * leg_y
    reach = k.body_tip_radius + k.ball_radius
    if x * x + y * y >= reach * reach:
        return
    stance.meets = 1
    gap = length(x, y)
    x, y = out_of_frame(x, y, cosine, sine)
    nx, ny = unit_normal(x, y, gap)
    place_x = number_at(solver.ball + BODY_X) - nx * k.ball_radius
    place_y = number_at(solver.ball + BODY_Y) - ny * k.ball_radius
    contact = add_contact(solver, contact_key(r, i, BALL, 0), stance.body, solver.ball)
    contact.ball = 1
    vx, vy = out_of_frame(vx, vy, cosine, sine)
    contact.surface_x = -vx
    contact.surface_y = -vy
    set_contact_targets(
        solver, contact, nx, ny, place_x, place_y, gap - reach, solver.ball_elasticity, solver.ball_friction
    )
    share_with_roll(solver, contact)


@compiled
def nearest_between_segments(ax, ay, bx, by, cx, cy, dx, dy):
    """Return the point of AB [m, m] that is nearest to CD, and the vector from it to the nearest point of CD [m, m].

    Legs and trunks hardly ever cross, and then an end of one segment is nearest to the other.
    """
    x, y = vector_to_segment(ax, ay, cx, cy, dx, dy)
    at_x, at_y = ax, ay
    other_x, other_y = vector_to_segment(bx, by, cx, cy, dx, dy)
    if other_x * other_x + other_y * other_y < x * x + y * y:
        at_x, at_y, x, y = bx, by, other_x, other_y
    back_x, back_y = vector_to_segment(cx, cy, ax, ay, bx, by)
    if back_x * back_x + back_y * back_y < x * x + y * y:
        at_x, at_y, x, y = cx + back_x, cy + back_y, -back_x, -back_y
    back_x, back_y = vector_to_segment(dx, dy, ax, ay, bx, by)
    if back_x * back_x + back_y * back_y < x * x + y * y:
        at_x, at_y, x, y = dx + back_x, dy + back_y, -back_x, -back_y
    return at_x, at_y, x, y


@compiled
def vector_to_segment(x, y, ax, ay, bx, by):
    """Return the vector [m, m] from a point to the nearest point of AB."""
    share = nearest_leg_fraction(x - ax, y - ay, bx - ax, by - ay)
    return ax + share * (bx - ax) - x, ay + share * (by - ay) - y
