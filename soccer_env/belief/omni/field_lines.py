"""The own pose of a middle-size robot, by particles weighed by the white lines and goals that the robot sees.  MH08

Each direction in which a line was seen gives a point on the ground; a pose fits if its points lie near white lines
[Lauer, Lange, Riedmiller 2006]. Lines look the same after a half-turn: the goals say which half is the own one.

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from math import pi, sqrt

import numpy as np

from soccer_env.belief.odometry import move_point
from soccer_env.belief.omni.lines import COLUMNS
from soccer_env.belief.omni.lines import ROWS as LINE_ROWS
from soccer_env.belief.own_pose import (
    estimate_and_resample,
    field_half_size,
    move_without_measurements,
    particles_are_due,
    take_summed_motion,
)
from soccer_env.belief.particles import (
    BLOCK,
    OUTLIER,
    ROWS,
    bounded_cost,
    draw_from_sighting,
    move_block,
    scatter_particle,
    store_block,
)
from soccer_env.compiled import compiled, scratch_records
from soccer_env.geometry import from_polar, into_frame, length, point_of_frame
from soccer_env.random_numbers import draw_uniform
from soccer_env.records.percepts import LINES
from soccer_env.types import RobotStream

PARTICLES = int(RobotStream.PARTICLES)
HIDDEN_SHARE = 0.25  # [1] of half a goal: sd of its visible part's middle about its own, assumed

LINE_POINT = np.dtype([("ahead", "f8"), ("left", "f8")])  # [m] robot frame

GOAL_POINT = np.dtype(
    [
        ("seen", "i8"),
        ("x", "f8"),  # [m] team frame, middle of the goal line
        ("ahead", "f8"),  # [1] robot frame, unit vector towards it
        ("left", "f8"),  # [1]
        ("far", "f8"),  # [m]
    ]
)

LINE_VIEW = np.dtype([("count", "i8"), ("points", LINE_POINT, (LINES,)), ("goals", GOAL_POINT, (2,))])


@compiled
def believe_pose_omni(percept, own, crowded, memory, particles, noise, k, s, w, table):
    """Update the own pose of a middle-size robot from the percept, by particles, white lines and goals.  MH08

    `table` is the record of `line_tables` in lines.py.
    """
    due = particles_are_due(percept.body, own, crowded, memory, particles, noise, k, s, w)
    if not due or percept.searched == 0:
        return
    view = scratch_records(1, LINE_VIEW)[0]
    seen = measure_lines_and_goals(percept, own, view, k, s, w)
    hand = np.float64(percept.body.handedness)
    if seen == 0:
        move_without_measurements(own, memory, particles, noise, hand, k, w)
        return
    motion = take_summed_motion(memory, k, w)
    half_length, half_width = field_half_size(k)
    weigh_particles_by_lines(particles, view, motion, half_length, half_width, noise, hand, k, w, table)
    if estimate_and_resample(own, memory, particles, seen, noise, w):
        for i in range(particles.shape[0]):
            if particles[i].weight == 0.0:
                draw_from_goal(particles[i], view, half_length, half_width, noise, hand, w)


@compiled
def measure_lines_and_goals(percept, own, view, k, s, w):
    """Measure the lines and goals in view; return the number of measurements.

    The picture is old when it arrives: its measurements are corrected for the robot's motion since the exposure.
    """
    age = np.float64(percept.age) if w.delay_compensation == 1 else 0.0
    forward, aside, turn = own.forward * age, own.left * age, own.turn * age
    sector = 2.0 * pi / s.lines
    view.count = 0
    for i in range(s.lines):
        # added up in mirrored pairs, i and -i, so that a mirrored match gets the same sums, to the last bit
        direction = i if percept.body.handedness >= 0.0 else -i
        distance = np.float64(percept.lines[direction % s.lines])
        if distance > 0.0:
            point = view.points[view.count]
            bearing = sector * direction
            x, y = from_polar(distance, bearing)
            point.ahead, point.left = move_point(x, y, forward, aside, turn)
            view.count += 1
    read_goal(percept.own_goal, view.goals[0], -0.5 * k.pitch_length, forward, aside, turn)
    read_goal(percept.opponent_goal, view.goals[1], 0.5 * k.pitch_length, forward, aside, turn)
    return view.count + 2 * (view.goals[0].seen + view.goals[1].seen)


@compiled
def read_goal(sighting, goal, x, forward, aside, turn):
    """Compute direction and range of a goal, corrected for the robot's motion since the exposure of the picture."""
    goal.seen, goal.x = int(sighting.seen), x
    if goal.seen == 0:
        return
    distance, bearing = np.float64(sighting.distance), np.float64(sighting.bearing)
    x_seen, y_seen = from_polar(distance, bearing)
    ahead, left = move_point(x_seen, y_seen, forward, aside, turn)
    goal.far = max(length(ahead, left), 1e-3)
    goal.ahead, goal.left = ahead / goal.far, left / goal.far


@compiled
def weigh_particles_by_lines(particles, view, motion, half_length, half_width, noise, hand, k, w, table):
    """Move all particles, and store in each weight the cost of the measurements for the particle's pose.  MH08"""
    block = scratch_records(1, BLOCK)[0]
    for first in range(0, particles.shape[0], ROWS):
        count = move_block(block, particles, first, motion, half_length, half_width, noise, hand)
        for i in range(view.count):
            add_line_costs(block, view.points[i].ahead, view.points[i].left, table)
        for i in range(2):
            if view.goals[i].seen == 1:
                add_goal_costs(block, view.goals[i], k, w)
        store_block(block, particles, first, count)


@compiled
def add_line_costs(block, ahead, left, table):
    """Add for each pose of a BLOCK the cost of a line seen at a point of the robot frame [m]."""
    costs, per_metre = table.line_cost, 1.0 / table.cell
    for j in range(ROWS):  # no loop that reads a place it has just computed takes several at once
        x, y = point_of_frame(block.x[j], block.y[j], ahead, left, block.cosine[j], block.sine[j])
        column, row = min(abs(x) * per_metre, COLUMNS - 0.5), min(abs(y) * per_metre, LINE_ROWS - 0.5)
        block.cell[j] = np.int32(column) * np.int32(LINE_ROWS) + np.int32(row)
    for j in range(ROWS):
        block.cost[j] += np.float64(costs[block.cell[j]])


@compiled
def add_goal_costs(block, goal, k, w):
    """Add for each pose of a BLOCK the cost of a goal's measured bearing and range."""
    for j in range(ROWS):
        block.cost[j] += goal_cost(goal, block.x[j], block.y[j], block.cosine[j], block.sine[j], k, w)


@compiled
def goal_cost(goal, x, y, cosine, sine, k, w):
    """Return the cost of a goal's measured bearing and range for a robot at x, y with a heading (cosine, sine)."""
    along, far = goal.x - x, sqrt((goal.x - x) * (goal.x - x) + y * y)
    far = max(far, 1e-3)
    ahead, left = into_frame(along, -y, cosine, sine)
    straight = (ahead * goal.ahead + left * goal.left) / far
    hidden = HIDDEN_SHARE * 0.5 * k.pitch_goal_width / far
    square = max(2.0 - 2.0 * straight, 0.0) / (w.pose_bearing_noise * w.pose_bearing_noise + hidden * hidden)
    miss = (goal.far / far - 1.0) / w.pose_range_noise
    return bounded_cost(square, OUTLIER) + bounded_cost(miss * miss, OUTLIER)


@compiled
def draw_from_goal(particle, view, half_length, half_width, noise, hand, w):
    """Draw a new pose for a particle from a goal in view; if no goal is in view, anywhere on the field.  MH08"""
    goals = view.goals[0].seen + view.goals[1].seen
    if goals == 0:
        scatter_particle(particle, half_length, half_width, noise, hand)
        return
    other = view.goals[0].seen == 0 or (goals == 2 and draw_uniform(noise, PARTICLES) < 0.5)
    goal = view.goals[1] if other else view.goals[0]
    sight = (goal.x, 0.0, goal.ahead, goal.left, goal.far, w.pose_range_noise, 0.0, 0.0)
    draw_from_sighting(particle, sight, half_length, half_width, noise, hand)
