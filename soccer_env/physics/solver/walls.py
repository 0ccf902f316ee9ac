"""Contacts of posts with static things: boards with their ramps, the backs and sides of goals, goal posts.

Boards are faces along the axes, which end in a corner beside the mouth of a goal. A pitch without boards on its lines
has goal posts and side nets: thick lines from the goal line to the back of the goal.

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, length
from soccer_env.physics.block import most_reach
from soccer_env.physics.solver.contacts import add_contact, contact_key, set_contact_targets, stance_of, unit_normal
from soccer_env.physics.solver.posts import place_posts

WALL = 31  # in the place of the other robot's row in a contact's key
SIDE, BACK, END, GOAL_POST = 0, 1, 2, 3  # in the place of the other robot's post


@compiled
def add_wall_contacts(solver, k, r, x, y):
    """List the contacts of a robot at x, y [m] with boards, goals and goal posts.  MS51"""
    half_width = 0.5 * k.pitch_width + k.pitch_band_side
    reach = most_reach(k) + k.pitch_board_foot
    if abs(x) + reach < 0.5 * k.pitch_length and abs(y) + reach < half_width:
        return
    place_posts(solver, k, stance_of(solver, r))
    for i in range(solver.posts):
        post = stance_of(solver, r).posts[i]
        room = half_width - k.pitch_board_foot - abs(post.field_y)
        if room < k.body_tip_radius:
            add_static_contact(solver, k, r, i, SIDE, 0.0, 1.0 if post.field_y > 0.0 else -1.0, room)
        end = 1.0 if post.field_x > 0.0 else -1.0
        side = 1.0 if post.field_y > 0.0 else -1.0
        aside = 0.5 * k.pitch_goal_width - abs(post.field_y)  # [m] room to the goal's side
        back = 0.5 * k.pitch_length + k.pitch_goal_depth - abs(post.field_x)
        if back < k.body_tip_radius and aside > -k.body_tip_radius:
            add_static_contact(solver, k, r, i, BACK, end, 0.0, back)
        add_board_contact(solver, k, r, i, end, side, aside)
        if k.walled == 0:
            add_goal_post_contact(solver, k, r, i, end, side)


@compiled
def add_board_contact(solver, k, r, i, end, side, aside):
    """List the contact of a post with the boards beside a goal's mouth, or with their ends, the sides of the goal."""
    behind = 0.0 if k.walled == 1 else max(k.pitch_band_end, k.pitch_goal_depth)
    past = abs(stance_of(solver, r).posts[i].field_x) - 0.5 * k.pitch_length - behind + k.pitch_board_foot
    if past + k.body_tip_radius <= 0.0 or aside >= k.body_tip_radius:
        return
    if past <= 0.0 and aside > 0.0:  # before the mouth: the corner of the boards
        gap = length(past, aside)
        if gap < k.body_tip_radius:
            nx, ny = unit_normal(-past * end, aside * side, gap)
            add_static_contact(solver, k, r, i, END, nx, ny, gap)
    elif past < -aside:
        add_static_contact(solver, k, r, i, END, end, 0.0, -past)
    else:
        add_static_contact(solver, k, r, i, END, 0.0, side, aside)


@compiled
def add_goal_post_contact(solver, k, r, i, end, side):
    """List the contact of a post with a goal post and the side net behind it."""
    post = stance_of(solver, r).posts[i]
    line = 0.5 * k.pitch_length
    x = end * clip(abs(post.field_x), line + k.pitch_post_radius, line + k.pitch_goal_depth) - post.field_x
    y = side * (0.5 * k.pitch_goal_width + k.pitch_post_radius) - post.field_y
    reach = k.body_tip_radius + k.pitch_post_radius
    if x * x + y * y < reach * reach:
        gap = length(x, y)
        nx, ny = unit_normal(x, y, gap)
        add_static_contact(solver, k, r, i, GOAL_POST, nx, ny, gap - k.pitch_post_radius)


@compiled
def add_static_contact(solver, k, r, i, part, nx, ny, room):
    """List a contact of a robot's post with a static surface, `room` [m] from the post's axis."""
    stance = stance_of(solver, r)
    stance.meets = 1
    post = stance.posts[i]
    contact = add_contact(solver, contact_key(r, i, WALL, part), stance.body, solver.ground)
    gap = room - k.body_tip_radius
    place_x, place_y = post.field_x + nx * room, post.field_y + ny * room
    set_contact_targets(solver, contact, nx, ny, place_x, place_y, gap, solver.board_elasticity, solver.board_friction)
