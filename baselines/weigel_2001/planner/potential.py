"""The potential field: the forces of target, obstacles and lines, the potential, and its gradient.  MH09, MH10

Two readings of P = |f_att + sum f_rep,i|  (1): "vector" adds the forces as vectors and takes the norm of the sum, as
the equation is written; "scalar" adds their norms. The way descends the chosen potential.

All places are in metres, t in seconds from now.
"""

from math import sqrt

from soccer_env.baselines.weigel_2001.planner.settings import FORMS, REPULSIONS
from soccer_env.compiled import compiled
from soccer_env.geometry import length

VECTOR = FORMS["vector"]
KHATIB = REPULSIONS["khatib"]
FARTHEST = 1e9  # [m] gap to an obstacle where there is none


@compiled
def size_at(gap, gain, reach, settings):
    """Return the magnitude of a repulsive force at a gap d [m] within its reach d0: F = kr (1/d - 1/d0), or F / d^2.

    Below a least gap the force grows linearly: a way that begins inside an obstacle leaves it on the nearest side.
    """
    d = max(gap, settings.floor)
    size = gain * (1.0 / d - 1.0 / reach)
    if settings.repulsion == KHATIB:
        size /= d * d
    return size if gap >= settings.floor else size * (2.0 - gap / settings.floor)


@compiled
def border_force(place, half, settings):
    """Return the force along one axis of the two border lines at +-half on a point at `place` [m], with its sign."""
    force = 0.0
    if half - place < settings.border_reach:
        force -= size_at(half - place, settings.border_gain, settings.border_reach, settings)
    if half + place < settings.border_reach:
        force += size_at(half + place, settings.border_gain, settings.border_reach, settings)
    return force


@compiled
def scalar_potential(x, y, t, goal, obstacles, settings):
    """Return the sum of the magnitudes of all forces at a position ("scalar")."""
    total = settings.attraction * length(goal.x - x, goal.y - y)
    for i in range(len(obstacles)):
        o = obstacles[i]
        dx, dy = o.x + t * o.vx - x, o.y + t * o.vy - y  # (3)
        within, away = o.radius + settings.robot_radius, dx * dx + dy * dy
        if away < (within + settings.reach) * (within + settings.reach):
            total += size_at(sqrt(away) - within, settings.gain, settings.reach, settings)
    if settings.borders == 1:
        total += abs(border_force(x, 0.5 * settings.pitch_length, settings))
        total += abs(border_force(y, 0.5 * settings.pitch_width, settings))
    return total


@compiled
def repulsive_force(x, y, t, obstacles, settings):
    """Return the summed force of obstacles and border lines at a position, as a vector."""
    fx, fy = 0.0, 0.0
    for i in range(len(obstacles)):
        o = obstacles[i]
        dx, dy = o.x + t * o.vx - x, o.y + t * o.vy - y  # (3)
        within, away = o.radius + settings.robot_radius, dx * dx + dy * dy
        if 0.0 < away < (within + settings.reach) * (within + settings.reach):
            d = sqrt(away)
            size = size_at(d - within, settings.gain, settings.reach, settings)
            fx, fy = fx - size * dx / d, fy - size * dy / d
    if settings.borders == 1:
        fx += border_force(x, 0.5 * settings.pitch_length, settings)
        fy += border_force(y, 0.5 * settings.pitch_width, settings)
    return fx, fy


@compiled
def attractive_force(x, y, goal, settings):
    """Return the force towards the way's goal as a vector, proportional to the goal's distance."""
    return settings.attraction * (goal.x - x), settings.attraction * (goal.y - y)


@compiled
def potential(x, y, t, goal, obstacles, settings):
    """Return the potential at a position, with the obstacles as predicted for t [s] from now.  MH09"""
    if settings.form == VECTOR:
        ax, ay = attractive_force(x, y, goal, settings)
        rx, ry = repulsive_force(x, y, t, obstacles, settings)
        return length(ax + rx, ay + ry)  # (1)
    return scalar_potential(x, y, t, goal, obstacles, settings)


@compiled
def gradient(u, v, t, goal, obstacles, settings):
    """Return the gradient of the potential at a cell by central differences over its four neighbours.  MH10"""
    a = settings.cell
    right = potential((u + 1) * a, v * a, t, goal, obstacles, settings)
    left = potential((u - 1) * a, v * a, t, goal, obstacles, settings)
    above = potential(u * a, (v + 1) * a, t, goal, obstacles, settings)
    below = potential(u * a, (v - 1) * a, t, goal, obstacles, settings)
    return (right - left) / a, (above - below) / a  # (2)


@compiled
def gap_at(x, y, t, obstacles, settings):
    """Return the smallest gap [m] between the robot's surface and obstacles, below 0 where they overlap."""
    least = FARTHEST
    for i in range(len(obstacles)):
        o = obstacles[i]
        d = length(o.x + t * o.vx - x, o.y + t * o.vy - y)
        if d - o.radius - settings.robot_radius < least:
            least = d - o.radius - settings.robot_radius
    return least
