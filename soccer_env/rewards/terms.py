"""The functions of reward terms: potentials of a team, events and costs of a robot, listed in `rewards.TERMS`.

`k`: the league's constants.
"""

from math import asin, inf, pi, sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, attack_direction, clip, length
from soccer_env.statistics.flights import ON_TARGET, predict_aim
from soccer_env.types import NO_TEAM

CROWD = 3.0  # [body reaches] from the ball: a second robot within is in its mate's way, assumed


@compiled
def score(match, ball, robots, events, robot_events, k, r, weight):
    """Return the weight for a goal of the robot's team, minus the weight for a goal of the opponents."""
    if events.goal == NO_TEAM:
        return 0.0
    return weight if events.goal == robots[r].team else -weight


@compiled
def shot(match, ball, robots, events, robot_events, k, r, weight):
    """Return the weight if the robot kicks and the ball would roll between the opponents' posts, else 0."""
    if robot_events[r].kick == 0 or events.restart != 0:
        return 0.0
    return weight if predict_aim(ball, attack_direction(match, robots[r].team), k) == ON_TARGET else 0.0


@compiled
def progress(match, ball, robots, k, team):
    """Return (distance of the ball from the own goal - distance from the opponents' goal) / (2 x pitch length)."""
    half = 0.5 * k.pitch_length
    left, right = length(ball.x + half, ball.y), length(ball.x - half, ball.y)
    return attack_direction(match, team) * (left - right) / (2.0 * k.pitch_length)


@compiled
def approach(match, ball, robots, k, team):
    """Return minus the distance from the ball to the team's nearest active robot, divided by the pitch's diagonal."""
    diagonal = sqrt(k.pitch_length * k.pitch_length + k.pitch_width * k.pitch_width)
    square = squared_nearest_distance(ball, robots, team)
    return -(0.0 if square == inf else sqrt(square)) / diagonal


@compiled
def squared_nearest_distance(ball, robots, team):
    """Return the square of the distance [m2] of a team's nearest active robot from the ball, inf if it has none."""
    least = inf
    for r in range(robots.shape[0]):
        if robots[r].team == team and robots[r].active == 1:
            x, y = robots[r].x - ball.x, robots[r].y - ball.y
            least = min(least, x * x + y * y)
    return least


@compiled
def cover(match, ball, robots, k, team):
    """Return minus the distance from the cover place to the nearest team-mate of the robot at the ball, scaled.

    The cover place is halfway between the ball and the own goal, outside the penalty area, where field players may not
    be. The scale is the pitch's diagonal. A mate that is out counts as a diagonal away; a team of one robot gets 0.
    """
    first, mates = nearest_robot_to_ball(ball, robots, team), 0
    goal = -0.5 * k.pitch_length * attack_direction(match, team)
    outside = 0.5 * k.pitch_length - k.pitch_penalty_depth - k.body_reach
    x, y = clip(0.5 * (ball.x + goal), -outside, outside), 0.5 * ball.y
    diagonal = length(k.pitch_length, k.pitch_width)
    least = diagonal
    for r in range(robots.shape[0]):
        if robots[r].team == team and r != first:
            mates += 1
            if robots[r].active == 1:
                least = min(least, length(robots[r].x - x, robots[r].y - y))
    return -least / diagonal if mates > 0 else 0.0


@compiled
def guard(match, ball, robots, k, team):
    """Return minus the open angle of the own goal, seen from the ball past the goalkeeper, divided by pi.

    The goalkeeper counts as a disc of its reach; the farther it stands behind the line, the less it covers.
    """
    forward = attack_direction(match, team)
    x, y = 0.5 * k.pitch_length + forward * ball.x, forward * ball.y  # of the ball, from the middle of the own goal
    if x <= 0.0:
        return -1.0
    left, right = atan2(0.5 * k.pitch_goal_width - y, x), atan2(-0.5 * k.pitch_goal_width - y, x)
    covered = 0.0
    for r in range(robots.shape[0]):
        if robots[r].team == team and robots[r].keeper == 1 and robots[r].active == 1:
            out = 0.5 * k.pitch_length + forward * robots[r].x
            ahead, aside = x - out, forward * robots[r].y - y
            bearing, half = atan2(aside, ahead), asin(min(k.body_reach / max(length(ahead, aside), k.body_reach), 1.0))
            share = clip(1.0 + out / k.body_reach, 0.0, 1.0)
            covered += share * max(min(left, bearing + half) - max(right, bearing - half), 0.0)
    return -max(left - right - covered, 0.0) / pi


@compiled
def crowding(match, ball, robots, k, team):
    """Return minus the closeness to the ball of the team's second-nearest robot: 0 far from the ball, -1 at it."""
    first, far = nearest_robot_to_ball(ball, robots, team), CROWD * k.body_reach
    least = far
    for r in range(robots.shape[0]):
        if robots[r].team == team and r != first and robots[r].active == 1:
            least = min(least, length(robots[r].x - ball.x, robots[r].y - ball.y))
    return least / far - 1.0


@compiled
def nearest_robot_to_ball(ball, robots, team):
    """Return the row of a team's active robot nearest to the ball, -1 if no robot is active."""
    first, least = -1, inf
    for r in range(robots.shape[0]):
        if robots[r].team == team and robots[r].active == 1:
            x, y = robots[r].x - ball.x, robots[r].y - ball.y
            if x * x + y * y < least:
                first, least = r, x * x + y * y
    return first


@compiled
def strength(match, ball, robots, k, team):
    """Return minus the fraction of a team's robots that serve a penalty."""
    out, all_of_it = 0, 0
    for r in range(robots.shape[0]):
        if robots[r].team == team:
            out += 1 if robots[r].penalty > 0.0 or robots[r].banned == 1 else 0
            all_of_it += 1
    return -out / max(all_of_it, 1)


@compiled
def foul(match, ball, robots, events, robot_events, k, r, weight):
    """Return the weight if the referee has whistled a foul of this robot, else 0."""
    return weight if robot_events[r].foul != 0 else 0.0


@compiled
def effort(match, ball, robots, events, robot_events, k, r, weight):
    """Return the cost of a control step: weight a second times the mean square of a robot's walk command.

    It is 0 while the referee steers the robot.
    """
    if match.placing == 1:
        return 0.0
    command = robots[r].command
    square = command.forward * command.forward + command.left * command.left + command.turn * command.turn
    return weight * square / 3.0 * k.dt
