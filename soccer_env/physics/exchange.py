"""Copy numbers between the records of a match and the arrays that the engine writes and reads; the ball is row 0.

`k`: the league's constants.
"""

from __future__ import annotations

from math import ceil

from soccer_env.compiled import compiled
from soccer_env.geometry import length, wrap
from soccer_env.physics.ball import limit_speed, slow_down
from soccer_env.physics.block import most_reach
from soccer_env.physics.engine.memory import BODY_MASS_INVERSE, BODY_MOMENT_INVERSE, store
from soccer_env.physics.solver.ramps import way_up_ends, way_up_sides

HELD = 1e-9  # [1] share of its inverse mass that a ball keeps while the referee holds it


@compiled
def count_substeps(ball, robots, k):
    """Return the substeps of this control step: more if one is fast, near another or on a ramp."""
    fastest = length(ball.vx, ball.vy)
    for r in range(robots.shape[0]):
        robot = robots[r]
        fastest = max(fastest, length(robot.vx, robot.vy) + abs(robot.omega) * k.body_reach)
    wanted = int(ceil(fastest * k.dt / k.substeps_travel))
    on_ramp = way_up_ends(ball.x, ball.y, k) > 0.0 or way_up_sides(ball.y, k) > 0.0
    least = k.substeps_close if on_ramp or anyone_close(ball, robots, k) else k.substeps_least
    return min(max(wanted, least), k.substeps_most)


@compiled
def anyone_close(ball, robots, k):
    """Tell whether a robot is within reach of the ball or of another robot, where overlaps can grow."""
    to_ball, to_robot = most_reach(k) + k.ball_radius, 2.0 * most_reach(k)
    for r in range(robots.shape[0]):
        robot = robots[r]
        if robot.active == 0:
            continue
        x, y = ball.x - robot.x, ball.y - robot.y
        if x * x + y * y < to_ball * to_ball:
            return True
        for other in range(r + 1, robots.shape[0]):
            x, y = robots[other].x - robot.x, robots[other].y - robot.y
            if x * x + y * y < to_robot * to_robot:
                return True
    return False


@compiled
def write_twists(ball, robots, velocities, solver, handedness):
    """Copy the velocities of ball and robots, and the ball's roll, from the records to the engine."""
    velocities[0, 0], velocities[0, 1], velocities[0, 2] = ball.vx, ball.vy, ball.spin
    solver.time = 0.0
    solver.handedness = handedness
    solver.roll_x, solver.roll_y = ball.roll_x, ball.roll_y
    for r in range(robots.shape[0]):
        velocities[r + 1, 0], velocities[r + 1, 1] = robots[r].vx, robots[r].vy
        velocities[r + 1, 2] = robots[r].omega


@compiled
def set_ball_mass(solver, held):
    """Make the ball immovable while the referee holds it, else give it its own mass."""
    share = HELD if held == 1 else 1.0
    store(solver.ball + BODY_MASS_INVERSE, share * solver.ball_lightness)
    store(solver.ball + BODY_MOMENT_INVERSE, share * solver.ball_ease)


@compiled
def read_physics(ball, robots, bodies, velocities, solver, k):
    """Read the physics of a step, and slow the ball; return the ball's change of velocity by contacts [m/s, m/s]."""
    read_records(ball, robots, bodies, solver)
    knock_x, knock_y = ball.vx - velocities[0, 0], ball.vy - velocities[0, 1]
    slow_down(ball, k, 0.5 * k.dt)
    limit_speed(ball, k)
    return knock_x, knock_y


@compiled
def read_records(ball, robots, bodies, solver):
    """Copy poses and velocities from the engine into the records."""
    ball.roll_x, ball.roll_y = solver.roll_x, solver.roll_y
    ball.x, ball.y, ball.angle = bodies[0, 0], bodies[0, 1], wrap(bodies[0, 2])
    ball.vx, ball.vy, ball.spin = bodies[0, 3], bodies[0, 4], bodies[0, 5]
    for r in range(robots.shape[0]):
        robot = robots[r]
        robot.x, robot.y, robot.heading = bodies[r + 1, 0], bodies[r + 1, 1], wrap(bodies[r + 1, 2])
        robot.vx, robot.vy, robot.omega = bodies[r + 1, 3], bodies[r + 1, 4], bodies[r + 1, 5]


@compiled
def write_poses(ball, robots, bodies):
    """Copy poses and velocities from the records into `bodies`, from which the engine sets its bodies."""
    bodies[0, 0], bodies[0, 1], bodies[0, 2] = ball.x, ball.y, ball.angle
    bodies[0, 3], bodies[0, 4], bodies[0, 5] = ball.vx, ball.vy, ball.spin
    for r in range(robots.shape[0]):
        robot = robots[r]
        bodies[r + 1, 0], bodies[r + 1, 1], bodies[r + 1, 2] = robot.x, robot.y, robot.heading
        bodies[r + 1, 3], bodies[r + 1, 4], bodies[r + 1, 5] = robot.vx, robot.vy, robot.omega


@compiled
def write_poses_of_matches(balls, robots, bodies, rows):
    """Call `write_poses` for the matches in `rows`."""
    for m in rows:
        write_poses(balls[m], robots[m], bodies[m])


@compiled
def is_finite(bodies, count):
    """Tell whether all numbers of the first `count` bodies are finite."""
    total = 0.0
    for row in range(count):
        for column in range(6):
            total += bodies[row, column] - bodies[row, column]
    return total == 0.0
