"""Robots that may not stay in the areas before the goals.

The rules of the middle size, remembered: only the goalkeeper stays in its own goal area; opponents stay in it for at
most 10 s; at most one field player is in its own penalty area. Assumed: the 10 s hold in all three cases. Of several
field players in the penalty area the nearest to the ball may stay.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.geometry import length
from soccer_env.referee.areas import in_goal_area, in_penalty_area
from soccer_env.types import AWAY, HOME

FAIR, GOAL_AREA, PENALTY_AREA = 0, 1, 2


@inlined
def find_trespassing(match, ball, robots, k):
    """Run the clocks of the areas; return the row of a robot that stays too long, or -1, and the area."""
    row, where = -1, FAIR
    if k.rules_goal_area == 0 and k.rules_penalty_area == 0:
        return row, where
    limit = k.rules_area_time - 0.5 * k.dt
    outer = 0.5 * k.pitch_length - k.pitch_penalty_depth
    for r in range(robots.shape[0]):
        robot = robots[r]
        if robot.active == 0 or abs(robot.x) < outer:
            robot.area_clock = robot.crowd_clock = 0.0
            continue
        trespasses = in_goal_area(match, robot, HOME, k) or in_goal_area(match, robot, AWAY, k)
        trespasses = trespasses and not (robot.keeper == 1 and in_goal_area(match, robot, robot.team, k))
        robot.area_clock = robot.area_clock + k.dt if trespasses else 0.0
        robot.crowd_clock = robot.crowd_clock + k.dt if crowds_own_area(match, ball, robots, r, k) else 0.0
        if k.rules_goal_area == 1 and robot.area_clock >= limit:
            row, where = r, GOAL_AREA
        elif k.rules_penalty_area == 1 and robot.crowd_clock >= limit:
            row, where = r, PENALTY_AREA
    return row, where


@compiled
def crowds_own_area(match, ball, robots, r, k):
    """Tell whether field player r is in its own penalty area with a mate that is nearer to the ball."""
    if robots[r].keeper == 1 or not in_penalty_area(match, robots[r], robots[r].team, k):
        return False
    own = length(robots[r].x - ball.x, robots[r].y - ball.y)
    for mate in range(robots.shape[0]):
        if mate == r or robots[mate].team != robots[r].team or robots[mate].active == 0 or robots[mate].keeper == 1:
            continue
        nearer = length(robots[mate].x - ball.x, robots[mate].y - ball.y) < own
        if nearer and in_penalty_area(match, robots[mate], robots[mate].team, k):
            return True
    return False
