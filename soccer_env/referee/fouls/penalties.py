"""The whistle, and robots that are taken out for a time and come back at the halfway line.

The book [RoboCup-SPL/Rules, NaoRules2008.tex, standard removal penalty]: the robot is placed outside the field. When
its time is over, it is put on the halfway line as close to the sideline as possible, on the side farther from the ball,
facing the opposite sideline; if another robot stands there, nearby along the sideline, preferably away from the ball.
All penalties end when the game stops: for goals, half-time and game stuck.

A robot that is out is parked beside the pitch, stays an agent and stands still; its clock runs while the ball is in
play or waits for a restart. When it comes back it is told its place.

`k`: the league's constants.
"""

from math import inf, pi

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction, length
from soccer_env.physics.parking import parking_place
from soccer_env.referee.places import MARGIN
from soccer_env.referee.restarts import put_robot, stop_robot
from soccer_env.types import Phase

KICK_OFF = int(Phase.KICK_OFF)
STEP_ASIDE = 0.05  # [m] step along the touchline in the search for a free place


@compiled
def whistle(match, robots, events, robot_events, r, foul):
    """Note a foul of robot r, the first of several in one step."""
    if robot_events[r].foul == 0:
        robot_events[r].foul = foul
    if events.foul == 0:
        events.foul = foul
        events.foul_team = robots[r].team


@compiled
def take_out_robot(match, ball, robots, robot_events, r, seconds, k):
    """Take a robot out for a time [s]; 0: put it on the halfway line at once."""
    send_off(robots, r, seconds)
    if seconds <= 0.0:
        bring_back_robot(match, ball, robots, r, k)
        robot_events[r].returned = 1


@compiled
def send_off(robots, r, seconds):
    """Take a robot out for a time [s]; inf: for good. Legs that were caught in each other come free."""
    robot = robots[r]
    robot.active = 0
    robot.banned = 1 if seconds == inf else 0
    robot.penalty = 0.0 if seconds == inf else seconds
    robot.place_x, robot.place_y, robot.place_heading = parking_place(r)
    robot.pushing = robot.keeper_pushing = robot.holding = robot.trespass = robot.beyond = robot.fallen = 0.0
    robot.x, robot.y, robot.heading = robot.place_x, robot.place_y, robot.place_heading
    stop_robot(robot)
    robot.caught_by = 0
    for other in range(robots.shape[0]):
        if robots[other].caught_by == r + 1:
            robots[other].caught_by = 0


@compiled
def serve_penalties(match, ball, robots, robot_events, k):
    """Run the clocks of penalties, and bring robots back; tell whether any came back."""
    moved = False
    for r in range(robots.shape[0]):
        if robots[r].penalty <= 0.0:
            continue
        robots[r].penalty -= k.dt
        if robots[r].penalty < 0.5 * k.dt:
            bring_back_robot(match, ball, robots, r, k)
            robot_events[r].returned = 1
            moved = True
    return moved


@compiled
def pardon(match, ball, robots, events, robot_events, k):
    """End all running penalties at a kick-off, in which the robots then take their places."""
    if k.rules_pardon == 0 or events.restart != KICK_OFF:
        return
    for r in range(robots.shape[0]):
        if robots[r].penalty > 0.0:
            bring_back_robot(match, ball, robots, r, k)
            robot_events[r].returned = 1


@compiled
def bring_back_robot(match, ball, robots, r, k):
    """Put a robot back on the touchline at the halfway line, away from the ball and clear of other robots."""
    robot, ahead = robots[r], attack_direction(match, robots[r].team)
    side = -1.0 if ball.y > 0.0 else (1.0 if ball.y < 0.0 else ahead * match.handedness)
    edge = 0.5 * k.pitch_width - k.body_reach - k.legs * k.pitch_board_foot - MARGIN
    aside = nearest_free_distance(ball, robots, r, ahead, side * edge, k)
    if aside < 0.0:  # no room on that side
        side = -side
        aside = max(nearest_free_distance(ball, robots, r, ahead, side * edge, k), 0.0)
    robot.active, robot.penalty = 1, 0.0
    robot.place_x, robot.place_y, robot.place_heading = -ahead * aside, side * edge, -side * 0.5 * pi
    put_robot(robot)


@compiled
def nearest_free_distance(ball, robots, r, ahead, y, k):
    """Return the distance [m] from the halfway line back to robot r's first free place in its own half; -1: none."""
    for step in range(int((0.5 * k.pitch_length - k.body_reach) / STEP_ASIDE)):
        if is_place_free(ball, robots, r, -ahead * step * STEP_ASIDE, y, k):
            return step * STEP_ASIDE
    return -1.0


@compiled
def is_place_free(ball, robots, r, x, y, k):
    """Tell whether robot r could stand at a place [m, m] without touching another robot or the ball."""
    if length(ball.x - x, ball.y - y) < k.body_reach + k.ball_radius + MARGIN:
        return False
    for other in range(robots.shape[0]):
        far = length(robots[other].x - x, robots[other].y - y)
        if other != r and robots[other].active == 1 and far < 2.0 * k.body_reach + MARGIN:
            return False
    return True
