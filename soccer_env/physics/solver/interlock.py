"""Legs that interlock: a leg of one robot stands between two legs of another.  [Sacks 2001, 1, 3]  MS51

Where the circle of a leg crosses the line between two neighbouring legs of another robot, the two hold each other for a
gait step: they can only move straight apart, out of that gap. The places of the legs decide; nothing is random.

`k`: the league's constants.
"""

from __future__ import annotations

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, cosine_and_sine, into_frame, length, out_of_frame, point_of_frame
from soccer_env.physics.block import is_blocking
from soccer_env.physics.engine.memory import BODY_COS, BODY_SIN, BODY_X, BODY_Y, number_at
from soccer_env.physics.gait import LEGS, stance
from soccer_env.physics.solver.contacts import add_contact, clear_impulses, contact_key, set_contact_targets, stance_of
from soccer_env.physics.solver.posts import place_posts

GAPS = 4  # between two neighbouring legs: the fore ones, the hind ones, the left, the right
HOLD = 6  # in the place of the other robot's leg in a contact's key


@compiled
def catch_legs(robots, r, k, handedness):
    """Record, at the start of a robot's gait step, whether one of its legs is caught between the legs of another robot.

    Legs that are spread for a block neither catch nor are caught.
    """
    robot = robots[r]
    robot.caught_by = 0
    if robot.active == 0 or is_blocking(robot, k):
        return
    cosine, sine = cosine_and_sine(robot.heading)
    near = 2.0 * k.body_reach
    for other in range(robots.shape[0]):
        away_x, away_y = robot.x - robots[other].x, robot.y - robots[other].y
        if other == r or robots[other].active == 0 or away_x * away_x + away_y * away_y > near * near:
            continue
        if is_blocking(robots[other], k):
            continue
        its_cosine, its_sine = cosine_and_sine(robots[other].heading)
        for leg in range(LEGS):
            x, y = stance(k, leg, handedness)
            x, y = point_of_frame(away_x, away_y, x, y, cosine, sine)
            ahead, left = into_frame(x, y, its_cosine, its_sine)
            gap = leg_gap_at(k, ahead, left, handedness)
            if gap >= 0:
                robot.caught_by, robot.caught_leg, robot.caught_gap = other + 1, leg, gap
                return


@compiled
def leg_gap_at(k, ahead, left, handedness):
    """Return the index of the gap between a robot's legs in which a point [m], robot frame, lies; -1: in none."""
    for gap in range(GAPS):
        if gap_distance(k, gap, ahead, left, handedness) < k.body_tip_radius:
            return gap
    return -1


@compiled
def gap_distance(k, gap, ahead, left, handedness):
    """Return the distance [m] of a place from the line between the axes of two legs, in the frame of their robot."""
    first, second = 2 * (gap == 1) + (gap == 3), 1 + (gap == 1) + (gap == 2) + 2 * (gap == 3)
    x, y = stance(k, first, handedness)
    end_x, end_y = stance(k, second, handedness)
    line = length(end_x - x, end_y - y)
    along = clip(((ahead - x) * (end_x - x) + (left - y) * (end_y - y)) / line, 0.0, line)
    return length(ahead - x - along * (end_x - x) / line, left - y - along * (end_y - y) / line)


@compiled
def way_out_of_gap(gap, handedness):
    """Return the unit vector out of a gap between two legs, in the frame of the legs' robot."""
    if gap < 2:
        return (1.0, 0.0) if gap == 0 else (-1.0, 0.0)
    return (0.0, handedness) if gap == 2 else (0.0, -handedness)


@compiled
def hold_caught(solver, k):
    """Add a contact for each caught leg that is still near its gap: the leg can then only move out of the gap."""
    solver.holds = 0
    for r in range(solver.robots):
        other = stance_of(solver, r).caught_by - 1
        if other >= 0 and is_leg_held(solver, k, r):
            mutual = stance_of(solver, other).caught_by - 1 == r and is_leg_held(solver, k, other)
            if not mutual or r < other:
                hold_leg(solver, k, r, other, mutual)


@compiled
def is_leg_held(solver, k, r):
    """Tell whether the caught leg of a robot is still within a leg's width of the gap in which it was caught."""
    robot = stance_of(solver, r)
    body = stance_of(solver, robot.caught_by - 1).body
    leg = robot.posts[robot.caught_leg]
    place_posts(solver, k, robot)
    x, y = leg.field_x - number_at(body + BODY_X), leg.field_y - number_at(body + BODY_Y)
    ahead, left = into_frame(x, y, number_at(body + BODY_COS), number_at(body + BODY_SIN))
    return gap_distance(k, robot.caught_gap, ahead, left, solver.handedness) <= 2.0 * k.body_tip_radius


@compiled
def hold_leg(solver, k, r, other, mutual):
    """Add the contact that holds robot r's leg between the legs of another robot.

    Two robots that hold a leg of each other get one contact, midway between both legs, along the mean direction:
    two nearly equal contacts would need too many rounds to converge.
    """
    robot, holder = stance_of(solver, r), stance_of(solver, other)
    solver.holds += 1
    robot.meets = 1
    holder.meets = 1
    x, y, nx, ny = held_leg_place(solver, r)
    if mutual:
        its_x, its_y, its_nx, its_ny = held_leg_place(solver, other)
        x, y = 0.5 * (x + its_x), 0.5 * (y + its_y)
        size = length(nx - its_nx, ny - its_ny)
        if size > 1e-6:
            nx, ny = (nx - its_nx) / size, (ny - its_ny) / size
    contact = add_contact(solver, contact_key(r, robot.caught_leg, other, HOLD), robot.body, holder.body)
    contact.held = 1
    clear_impulses(contact)
    set_contact_targets(solver, contact, nx, ny, x, y, 0.0, 0.0, 0.0)


@compiled
def held_leg_place(solver, r):
    """Return the position of robot r's caught leg [m, m] and the unit vector into the gap, field frame."""
    robot = stance_of(solver, r)
    body = stance_of(solver, robot.caught_by - 1).body
    out_x, out_y = way_out_of_gap(robot.caught_gap, solver.handedness)
    nx, ny = out_of_frame(-out_x, -out_y, number_at(body + BODY_COS), number_at(body + BODY_SIN))
    leg = robot.posts[robot.caught_leg]
    return leg.field_x, leg.field_y, nx, ny
