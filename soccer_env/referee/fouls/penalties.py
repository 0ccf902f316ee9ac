"""The whistle, and robots that are taken out for a time and come back at the halfway line.

A robot that is out is parked beside the pitch, stays an agent and stands still; its clock runs while the ball is in
play or waits for a restart. It comes back on the touchline at the halfway line, on the side that is farther from the
ball, facing the pitch, and is told where it stands.

`k`: the league's constants.
"""

from __future__ import annotations

from math import inf, pi

from soccer_env.compiled import compiled
from soccer_env.geometry import length
from soccer_env.physics.parking import parking_place
from soccer_env.referee.restarts import MARGIN, put_robot, stop

STEP_ASIDE = 0.05  # [m] by which the place of a return is moved along the touchline until it is free


@compiled
def whistle(match, robots, events, robot_events, r, foul):
    """Note a foul of robot r."""
    robot_events[r].foul = foul
    if events.foul == 0:
        events.foul = foul
        events.foul_team = robots[r].team


@compiled
def send_off(robots, r, seconds):
    """Take a robot out for a time [s]; inf: for good."""
    robot = robots[r]
    robot.active = 0
    robot.banned = 1 if seconds == inf else 0
    robot.penalty = 0.0 if seconds == inf else seconds
    robot.place_x, robot.place_y, robot.place_heading = parking_place(r)
    robot.pushing = robot.keeper_pushing = robot.holding = robot.trespass = robot.beyond = robot.fallen = 0.0
    robot.x, robot.y, robot.heading = robot.place_x, robot.place_y, robot.place_heading
    stop(robot)


@compiled
def serve_penalties(match, ball, robots, robot_events, k):
    """Let the penalties of a step run, and robots come back; tell whether one did."""
    moved = False
    for r in range(robots.shape[0]):
        if robots[r].penalty <= 0.0:
            continue
        robots[r].penalty = max(robots[r].penalty - k.dt, 0.0)
        if robots[r].penalty < 0.5 * k.dt:
            robots[r].penalty = 0.0
            come_back(match, ball, robots, r, k)
            robot_events[r].returned = 1
            moved = True
    return moved


@compiled
def come_back(match, ball, robots, r, k):
    """Put a robot back on the touchline at the halfway line, away from the ball and free of others."""
    side = 1.0 if ball.y <= 0.0 else -1.0
    back = -1.0 if (robots[r].team == 0) == (match.home_direction > 0.0) else 1.0
    y = side * (0.5 * k.pitch_width - k.body_reach - k.legs * k.pitch_board_foot - MARGIN)
    x = 0.0
    for _ in range(int(0.5 * k.pitch_length / STEP_ASIDE)):
        if is_free(robots, r, x, y, k):
            break
        x += back * STEP_ASIDE  # towards its own goal
    robots[r].active = 1
    robots[r].place_x, robots[r].place_y, robots[r].place_heading = x, y, -side * 0.5 * pi
    put_robot(robots[r])


@compiled
def is_free(robots, r, x, y, k):
    """Tell whether robot r could stand at a place [m, m] without touching another."""
    for other in range(robots.shape[0]):
        far = length(robots[other].x - x, robots[other].y - y)
        if other != r and robots[other].active == 1 and far < 2.0 * k.body_reach + MARGIN:
            return False
    return True
