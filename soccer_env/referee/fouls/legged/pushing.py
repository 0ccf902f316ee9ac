"""Pushing: a robot that walks into an opponent for longer than 3 s is taken out.

The book: a robot that pushes another robot for more than 3 s is removed for 30 s. Exempt are the robot of each team
closest to the ball, if within 50 cm of it, a robot that stands still, and a goalkeeper with at least two feet in its
own area. Two robots that charge into each other are both removed.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.referee.fouls.legged.areas import FEET, in_own_area
from soccer_env.referee.fouls.legged.contact import run_clock
from soccer_env.referee.fouls.penalties import whistle
from soccer_env.types import Foul

PUSHING = int(Foul.PUSHING)


@inlined
def judge_pushing(match, ball, robots, events, robot_events, k):
    """Whistle robots that have pushed for too long."""
    for r in range(robots.shape[0]):
        robot = robots[r]
        guilty = robot_events[r].pushes > 0 and not may_push(match, ball, robots, r, k)
        if not guilty and robot.pushing == 0.0:
            continue
        robot.pushing = run_clock(robot.pushing, guilty, k.dt)
        if guilty and robot.pushing > k.rules_pushing_time + 0.5 * k.dt:
            whistle(match, robots, events, robot_events, r, PUSHING)


@compiled
def may_push(match, ball, robots, r, k):
    """Tell whether a robot may push: its team's nearest to the ball and near it, or a goalkeeper in its area."""
    if robots[r].keeper == 1 and in_own_area(match, robots[r], k, FEET):
        return True
    mine = squared_ball_distance(ball, robots[r])
    if mine > k.rules_pushing_exempt * k.rules_pushing_exempt:
        return False
    for mate in range(robots.shape[0]):
        plays = robots[mate].active == 1 and robots[mate].team == robots[r].team
        if plays and squared_ball_distance(ball, robots[mate]) < mine:
            return False
    return True


@compiled
def squared_ball_distance(ball, robot):
    """Return the squared distance of a robot's centre from the ball [m2]."""
    x, y = ball.x - robot.x, ball.y - robot.y
    return x * x + y * y
