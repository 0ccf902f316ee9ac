"""Artificial potential fields: Khatib's forces and the changes of Sacks.  [Sacks 2001, 4.2, 4.3]  MS38 to MS44

Robot and players are points (MS44); distances are as sensed: from the camera to a player's surface (MS42). Walls are
not sensed: their distance follows from the believed own place. Vectors are in metres of the team frame, +x towards the
opponents' goal; forces have no unit.

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.baselines.sacks_2001.settings import DISTANCES, GOAL_FORCES
from soccer_env.belief.legged.surface import surface_distance
from soccer_env.compiled import compiled
from soccer_env.geometry import length

PROPORTIONAL = GOAL_FORCES["proportional"]
SURFACE = DISTANCES["surface"]
NEAREST = 0.01  # [m] a nearer player repels as at this distance: no division by zero


@compiled
def goal_force(dx, dy, play):
    """Return the force towards a goal that lies at (dx, dy) [m]: F = -k1 (x - xg), or a unit vector.  MS38, MS40"""
    if play.goal_force == PROPORTIONAL:
        return play.goal_gain * dx, play.goal_gain * dy  # (1)
    away = max(length(dx, dy), NEAREST)
    return dx / away, dy / away


@compiled
def repulsion(distance, gain, far, play):
    """Return the magnitude of an obstacle's force at a distance x [m]: k2 (1/x - 1/x0) / x^(n-1), 0 beyond x0.

    The exponent n is 3 in theory (MS38), 1 in the end (MS39). Without a cut-off x0 is infinite.
    """
    x = max(distance, NEAREST)
    beyond = 1.0 / far if play.cut_off == 1 else 0.0
    size = max(gain * (1.0 / x - beyond), 0.0)  # (2)
    for _ in range(play.exponent - 1):
        size /= x
    return size


@compiled
def as_sensed(x, y, k, play):
    """Convert a player's believed middle x, y to the vector that sensors would measure [m], robot frame.  MS42

    The vector goes from the camera, head level, to the player's surface, half a body nearer than its middle (as in
    MS35): beliefs add both to the readings. The setting "middle" keeps the vector from middle to middle, 25 cm longer
    for a player straight ahead.
    """
    if play.distance_from != SURFACE:
        return x, y
    gap = max(surface_distance(x, y, k), NEAREST)
    x -= k.head_camera_ahead
    away = length(x, y)
    if away < NEAREST:
        return NEAREST, 0.0
    return gap / away * x, gap / away * y


@compiled
def player_force(dx, dy, goal_x, goal_y, play):
    """Return the force of a player sensed at (dx, dy) [m], with the goal at (goal_x, goal_y).  MS41, MS42

    A factor max(0, cos(angle to player - angle to goal)): players beside or behind the robot do not repel.
    """
    away = max(length(dx, dy), NEAREST)
    size = repulsion(away, play.player_gain, play.player_range, play)
    if play.cosine_factor == 1:
        goal = max(length(goal_x, goal_y), NEAREST)
        size *= max((dx * goal_x + dy * goal_y) / (away * goal), 0.0)
    return -size * dx / away, -size * dy / away


@compiled
def wall_force(y, half_width, play):
    """Return the force of both side walls, along y and perpendicular to them, on a point at y [m].  MS43"""
    if play.walls == 0:
        return 0.0
    to_left, to_right = half_width - y, half_width + y
    force = repulsion(to_right, play.wall_gain, play.wall_range, play)
    return force - repulsion(to_left, play.wall_gain, play.wall_range, play)
