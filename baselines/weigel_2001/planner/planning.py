"""Repeated passes over the grid until the way takes as long as its planning assumed.  [Heinemann 2006, 3]  MH16, MH17

Planning backwards needs the robot's travel time T before there is a way. T begins as the time of the straight line,
and moves towards the time of each way found, until both agree:

    T_0 = |target - robot| / v_max,    T_{n+1} = T_n + (1 - damping) (time of way n - T_n)

By the paper's words alone (`literal`) there is no damping. T may then swing between two times, each of which leads to
a way that takes the other, and the last plan is one of the two: hence damping, a cap on passes, and the best plan as a
fallback.
"""

from math import floor, inf

from soccer_env.baselines.weigel_2001.planner.records import ARRIVED, GRID
from soccer_env.baselines.weigel_2001.planner.settings import FALLBACKS
from soccer_env.baselines.weigel_2001.planner.stepping import step_length
from soccer_env.baselines.weigel_2001.planner.walking import plan_pass
from soccer_env.compiled import compiled
from soccer_env.geometry import length

BEST, FIRST = FALLBACKS["best"], FALLBACKS["first"]
WORSE = 1e6  # [s] by which a way that does not join robot and target is worse than one that does


@compiled
def plan_way(robot_x, robot_y, target_x, target_y, side, obstacles, settings, scratch, plan):
    """Plan a path from robot to target [m] past obstacles (OBSTACLE) and write it into `plan`.  MH16, MH17

    side: the side of y on which to pass if both are equal: +1, or -1 in the mirrored scene.
    settings, scratch (SCRATCH), plan (PLAN): records.
    """
    begin_plan(robot_x, robot_y, target_x, target_y, side, settings, scratch, plan)
    guess, best = plan.least_time, inf
    again = depends_on_time(obstacles, settings)
    for i in range(settings.most_iterations):
        ended = plan_pass(guess, obstacles, settings, scratch, plan)
        took = smooth_and_time(settings, scratch, plan)
        plan.guesses[i], plan.times[i], plan.iterations = guess, took, i + 1
        off = abs(took - guess)
        agrees = not again or off < settings.threshold
        worth = off if ended == ARRIVED else off + WORSE
        if i == 0 or agrees or is_kept(worth, best, settings):
            copy_pass_to_plan(i, ended, took, settings, scratch, plan)
            best = worth
        if agrees:
            plan.converged = 1
            break
        damping = 0.0 if settings.literal == 1 else settings.damping
        guess = max(guess + (1.0 - damping) * (took - guess), plan.least_time)
    plan.evaluations, plan.searches = scratch.evaluations, scratch.searches


@compiled
def begin_plan(robot_x, robot_y, target_x, target_y, side, settings, scratch, plan):
    """Initialise a plan from robot to target, with both positions moved into the grid."""
    half_u = int(floor((0.5 * settings.pitch_length + settings.margin) / settings.cell))
    half_v = int(floor((0.5 * settings.pitch_width + settings.margin) / settings.cell))
    half_v = min(half_v, (GRID // (2 * half_u + 1) - 1) // 2)  # never beyond the marks, whatever the record says
    far_x, far_y = half_u * settings.cell, half_v * settings.cell
    plan.robot.x, plan.robot.y = clip_coordinate(robot_x, far_x), clip_coordinate(robot_y, far_y)
    plan.target.x, plan.target.y = clip_coordinate(target_x, far_x), clip_coordinate(target_y, far_y)
    straight = length(plan.target.x - plan.robot.x, plan.target.y - plan.robot.y)
    plan.least_time = straight / settings.speed
    plan.side, plan.converged, plan.iterations = side, 0, 0
    scratch.side, scratch.half_u, scratch.half_v = side, half_u, half_v
    scratch.evaluations, scratch.searches = 0, 0


@compiled
def clip_coordinate(place, far):
    """Return a coordinate clipped to the range -far to +far; NaN becomes -far."""
    if not place > -far:
        return -far
    return far if place > far else place


@compiled
def depends_on_time(obstacles, settings):
    """Tell whether the way depends on the assumed time T: it is planned backwards, and an obstacle moves."""
    if settings.time_variant == 0 or settings.backward == 0:
        return False
    speeds = 0.0
    for i in range(len(obstacles)):
        speeds += abs(obstacles[i].vx) + abs(obstacles[i].vy)
    return speeds > 0.0


@compiled
def smooth_and_time(settings, scratch, plan):
    """Smooth the way to a path and return the path's driving time [s], at least that of the straight line."""
    if settings.backward == 1:
        smooth(plan.target, plan.robot, settings, scratch)
    else:
        smooth(plan.robot, plan.target, settings, scratch)
    far = length_of(scratch.path, scratch.count)
    if settings.literal == 1:
        far = 0.0
        for i in range(1, scratch.count):
            here, before = scratch.way[i], scratch.way[i - 1]
            far += step_length(here.u - before.u, here.v - before.v, settings)
    return max(far / settings.speed, plan.least_time)


@compiled
def is_kept(worth, best, settings):
    """Tell whether a plan whose times do not agree yet is better than the best plan so far."""
    if settings.literal == 1:
        return True
    return settings.fallback != FIRST and (settings.fallback != BEST or worth < best)


@compiled
def copy_pass_to_plan(number, ended, took, settings, scratch, plan):
    """Copy the cells and the path of a pass into the plan, in order from robot to target."""
    last = scratch.count - 1
    for i in range(scratch.count):
        j = last - i if settings.backward == 1 else i
        plan.cells[i] = scratch.way[j]
        plan.path[i] = scratch.path[j]
    plan.count, plan.ended, plan.kept = scratch.count, ended, number
    plan.time, plan.length = took, length_of(plan.path, plan.count)


# The path that a robot drives along a way of cells. T is measured on the path: the way of cells is longer, by 8 % where
# it goes 22.5 degrees off an axis  (MH16)


@compiled
def reflect_index(i, last):
    """Reflect an index into the range 0 to last; return the index and the end that reflected it, -1 for none."""
    if i < 0:
        return -i, 0
    if i > last:
        return 2 * last - i, last
    return i, -1


@compiled
def cell_of_way(i, last, way):
    """Return u, v of cell i of the way; for an index beyond an end, of the reflection about that end."""
    inner, end = reflect_index(i, last)
    if end < 0:
        return way[inner].u, way[inner].v
    return 2 * way[end].u - way[inner].u, 2 * way[end].v - way[inner].v


@compiled
def smooth(begin, end, settings, scratch):
    """Compute the path: a running mean of the way's cells, shifted to start at `begin` and stop at `end`.  MH16

    The shift changes linearly from the first cell to the last.
    """
    way, path, last = scratch.way, scratch.path, scratch.count - 1
    h = min(settings.smoothing, last)
    sum_u, sum_v = 0, 0
    for i in range(-h, h + 1):
        u, v = cell_of_way(i, last, way)
        sum_u, sum_v = sum_u + u, sum_v + v
    first_x, first_y = begin.x - settings.cell * way[0].u, begin.y - settings.cell * way[0].v
    last_x, last_y = end.x - settings.cell * way[last].u, end.y - settings.cell * way[last].v
    for i in range(last + 1):
        share = i / last
        path[i].x = settings.cell * sum_u / (2 * h + 1) + first_x + share * (last_x - first_x)
        path[i].y = settings.cell * sum_v / (2 * h + 1) + first_y + share * (last_y - first_y)
        if i < last:
            gone_u, gone_v = cell_of_way(i - h, last, way)
            u, v = cell_of_way(i + 1 + h, last, way)
            sum_u, sum_v = sum_u + u - gone_u, sum_v + v - gone_v
    path[0].x, path[0].y = begin.x, begin.y
    path[last].x, path[last].y = end.x, end.y


@compiled
def length_of(path, count):
    """Return the length [m] of the first `count` points of a path."""
    total = 0.0
    for i in range(1, count):
        total += length(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y)
    return total
