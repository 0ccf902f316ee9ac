"""One pass over the grid, from target to robot or the other way.  [Heinemann 2006, 3]  MH11, MH13, MH15"""

from math import inf

from soccer_env.baselines.weigel_2001.planner.potential import gap_at, gradient
from soccer_env.baselines.weigel_2001.planner.records import ARRIVED, CAPPED, LOOPED, MOST_CELLS
from soccer_env.baselines.weigel_2001.planner.searching import (
    GOES_ON,
    add_cell,
    index_of,
    is_at_end,
    is_inside,
    leave_minimum,
)
from soccer_env.baselines.weigel_2001.planner.stepping import cell_of, next_cell, obstacle_time, step_time
from soccer_env.compiled import compiled


@compiled
def plan_pass(guess, obstacles, settings, scratch, plan):
    """Plan the way from its beginning to its end for an assumed time `guess` [s]; return how it ended.  MH13, MH15

    A backward way begins at the target, with the obstacles predicted for T, and time decreases from cell to cell; a
    forward way begins at the robot, now. The marks are 0 again afterwards.
    """
    backward = settings.backward == 1
    begin, end = (plan.target, plan.robot) if backward else (plan.robot, plan.target)
    scratch.clock = -1.0 if backward else 1.0
    scratch.goal.x, scratch.goal.y = end.x, end.y
    scratch.end_u = cell_of(end.x, scratch.half_u, settings)
    scratch.end_v = cell_of(end.y, scratch.half_v, settings)
    scratch.count, scratch.lowest = 0, inf
    t = guess if backward else 0.0
    scratch.tight = blocking_gap(begin, t, end, guess - t, obstacles, settings)
    add_cell(cell_of(begin.x, scratch.half_u, settings), cell_of(begin.y, scratch.half_v, settings), t, scratch)
    ended = descend_potential(obstacles, settings, scratch)
    complete_way_straight(settings, scratch)
    for i in range(scratch.count):
        scratch.marks[index_of(scratch.way[i].u, scratch.way[i].v, scratch)] = 0
    return ended


@compiled
def blocking_gap(begin, t_begin, end, t_end, obstacles, settings):
    """Return the gap [m] at or below which a cell is blocked: 0, or less if an end of the way is inside an obstacle."""
    first = gap_at(begin.x, begin.y, obstacle_time(t_begin, settings), obstacles, settings)
    last = gap_at(end.x, end.y, obstacle_time(t_end, settings), obstacles, settings)
    nearer = min(first, last)
    return nearer - 2.0 * settings.cell if nearer < settings.cell else 0.0


@compiled
def descend_potential(obstacles, settings, scratch):
    """Descend the potential from cell to cell until the way's end is a neighbour; return how the pass ended.  MH11"""
    rest_x, rest_y, ended = 0.0, 0.0, GOES_ON
    while ended == GOES_ON:
        here = scratch.way[scratch.count - 1]
        if is_at_end(here.u, here.v, scratch):
            ended = ARRIVED
        elif scratch.count >= MOST_CELLS - 1 or scratch.evaluations >= settings.most_evaluations:
            ended = CAPPED
        else:
            now = obstacle_time(here.t, settings)
            here.slope_x, here.slope_y = gradient(here.u, here.v, now, scratch.goal, obstacles, settings)
            scratch.evaluations += 4
            du, dv, rest_x, rest_y = next_cell(-here.slope_x, -here.slope_y, rest_x, rest_y, settings)
            if is_new(here.u + du, here.v + dv, scratch):
                t = here.t + scratch.clock * step_time(du, dv, settings)
                add_cell(here.u + du, here.v + dv, t, scratch)
            elif settings.search == 1:
                ended = leave_minimum(obstacles, settings, scratch)
                rest_x, rest_y = 0.0, 0.0
            else:
                ended = LOOPED
    return ended


@compiled
def is_new(u, v, scratch):
    """Tell whether a cell lies inside the grid and is not yet on the way.  MH12"""
    return is_inside(u, v, scratch) and scratch.marks[index_of(u, v, scratch)] == 0


@compiled
def complete_way_straight(settings, scratch):
    """Append the end cell to the way, after a straight line of cells if the pass did not arrive."""
    here, rest_x, rest_y = scratch.way[scratch.count - 1], 0.0, 0.0
    while not is_at_end(here.u, here.v, scratch) and scratch.count < MOST_CELLS - 1:
        to_u, to_v = scratch.end_u - here.u, scratch.end_v - here.v
        du, dv, rest_x, rest_y = next_cell(float(to_u), float(to_v), rest_x, rest_y, settings)
        t = here.t + scratch.clock * step_time(du, dv, settings)
        add_cell(here.u + du, here.v + dv, t, scratch)
        here = scratch.way[scratch.count - 1]
    t = here.t + scratch.clock * step_time(scratch.end_u - here.u, scratch.end_v - here.v, settings)
    add_cell(scratch.end_u, scratch.end_v, t, scratch)
