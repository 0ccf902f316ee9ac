"""Tell whether the centre of a robot stands in a goal area or penalty area.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction


@compiled
def in_area(match, robot, team, k, depth, width):
    """Tell whether a robot stands in an area of depth and width [m, m] before the goal of a team."""
    inside = -attack_direction(match, team) * robot.x > 0.5 * k.pitch_length - depth
    return inside and abs(robot.y) < 0.5 * width


@compiled
def in_goal_area(match, robot, team, k):
    """Tell whether a robot stands in the goal area of a team."""
    return in_area(match, robot, team, k, k.pitch_goal_area_depth, k.pitch_goal_area_width)


@compiled
def in_penalty_area(match, robot, team, k):
    """Tell whether a robot stands in the penalty area of a team."""
    return in_area(match, robot, team, k, k.pitch_penalty_depth, k.pitch_penalty_width)
