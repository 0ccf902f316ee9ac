"""Passes over the grid until the time of the way is the one that it was planned for.  [Heinemann 2006, 3]  MH16, MH17

Backwards the time T that the robot will need must be known before there is a way. It begins as that of the straight
line, and becomes that of the way found, until both agree:

    T_0 = |target - robot| / v_max,    T_{n+1} = T_n + (1 - damping) (time of way n - T_n)

By the paper's words alone (`literal`) there is no damping. Where two times cannot agree, because each leads to a way
of the other, T swings then and the last plan is any of two: hence damping, a cap and the best plan as a fallback.
"""

from math import floor, inf

from soccer_env.baselines.weigel_2001.planner.records import ARRIVED, GRID
from soccer_env.baselines.weigel_2001.planner.settings import FALLBACKS
from soccer_env.baselines.weigel_2001.planner.smoothing import length_of, smooth
from soccer_env.baselines.weigel_2001.planner.stepping import step_length
from soccer_env.baselines.weigel_2001.planner.walking import plan_pass
from soccer_env.compiled import compiled
from soccer_env.geometry import length

BEST, FIRST = FALLBACKS["best"], FALLBACKS["first"]
WORSE = 1e6  # [s] by which a way that does not join robot and target is worse than one that does


@compiled
def plan_way(robot_x, robot_y, target_x, target_y, side, obstacles, settings, scratch, plan):
    """Fill a plan from robot to target [m] past obstacles (OBSTACLE), as many as the array holds.  MH16, MH17

    side: +1, or -1 in the mirrored scene: to which side of y a way goes that could as well go to the other.
    settings, scratch (SCRATCH), plan (PLAN): records.
    """
    begin_plan(robot_x, robot_y, target_x, target_y, side, settings, scratch, plan)
    guess, best = plan.least_time, inf
    again = depends_on_time(obstacles, settings)
    for i in range(settings.most_iterations):
        ended = plan_pass(guess, obstacles, settings, scratch, plan)
        took = take_time(settings, scratch, plan)
        plan.guesses[i], plan.times[i], plan.iterations = guess, took, i + 1
        off = abs(took - guess)
        agrees = not again or off < settings.threshold
        worth = off if ended == ARRIVED else off + WORSE
        if i == 0 or agrees or is_kept(worth, best, settings):
            keep(i, ended, took, settings, scratch, plan)
            best = worth
        if agrees:
            plan.converged = 1
            break
        damping = 0.0 if settings.literal == 1 else settings.damping
        guess = max(guess + (1.0 - damping) * (took - guess), plan.least_time)
    plan.evaluations, plan.searches = scratch.evaluations, scratch.searches


@compiled
def begin_plan(robot_x, robot_y, target_x, target_y, side, settings, scratch, plan):
    """Note what is asked for, places held inside the grid."""
    half_u = int(floor((0.5 * settings.pitch_length + settings.margin) / settings.cell))
    half_v = int(floor((0.5 * settings.pitch_width + settings.margin) / settings.cell))
    half_v = min(half_v, (GRID // (2 * half_u + 1) - 1) // 2)  # never beyond the marks, whatever the record says
    far_x, far_y = half_u * settings.cell, half_v * settings.cell
    plan.robot.x, plan.robot.y = held(robot_x, far_x), held(robot_y, far_y)
    plan.target.x, plan.target.y = held(target_x, far_x), held(target_y, far_y)
    straight = length(plan.target.x - plan.robot.x, plan.target.y - plan.robot.y)
    plan.least_time = straight / settings.speed
    plan.side, plan.converged, plan.iterations = side, 0, 0
    scratch.side, scratch.half_u, scratch.half_v = side, half_u, half_v
    scratch.evaluations, scratch.searches = 0, 0


@compiled
def held(place, far):
    """Return a coordinate held within +-far; what is no number becomes -far."""
    if not place > -far:
        return -far
    return far if place > far else place


@compiled
def depends_on_time(obstacles, settings):
    """Tell whether another T could give another way: planned backwards past somebody who moves."""
    if settings.time_variant == 0 or settings.backward == 0:
        return False
    speeds = 0.0
    for i in range(len(obstacles)):
        speeds += abs(obstacles[i].vx) + abs(obstacles[i].vy)
    return speeds > 0.0


@compiled
def take_time(settings, scratch, plan):
    """Smooth the way and return how long it takes [s], never less than the straight line."""
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
    """Tell whether a plan that may not be the last replaces the one before."""
    if settings.literal == 1:
        return True
    return settings.fallback != FIRST and (settings.fallback != BEST or worth < best)


@compiled
def keep(number, ended, took, settings, scratch, plan):
    """Make a pass the plan, from robot to target."""
    last = scratch.count - 1
    for i in range(scratch.count):
        j = last - i if settings.backward == 1 else i
        plan.cells[i] = scratch.way[j]
        plan.path[i] = scratch.path[j]
    plan.count, plan.ended, plan.kept = scratch.count, ended, number
    plan.time, plan.length = took, length_of(plan.path, plan.count)
