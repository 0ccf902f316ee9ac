"""Leaving the field: on a pitch with boards a robot leaves it through a goal.

The book: a robot that leaves the carpet is removed for 30 s, unless it chases the ball off the field, then turns and
comes straight back. Here a robot has left when its centre is beyond the goal line, and has 5 s to turn and come back,
assumed: half a turn takes 4 s. A goalkeeper may stand in its own goal.

`k`: the league's constants.
"""

from soccer_env.compiled import inlined
from soccer_env.geometry import attack_direction
from soccer_env.referee.fouls.penalties import whistle
from soccer_env.types import Foul

LEFT_FIELD = int(Foul.LEFT_FIELD)


@inlined
def judge_leaving(match, robots, events, robot_events, k):
    """Whistle robots that stay in a goal."""
    edge = 0.5 * k.pitch_length
    for r in range(robots.shape[0]):
        robot = robots[r]
        away = robot.active == 1 and abs(robot.x) > edge
        if not away or (robot.keeper == 1 and robot.x * attack_direction(match, robot.team) < 0.0):
            robot.beyond = 0.0
            continue
        robot.beyond += k.dt
        if robot.beyond > k.rules_leaving_time + 0.5 * k.dt:
            whistle(match, robots, events, robot_events, r, LEFT_FIELD)
