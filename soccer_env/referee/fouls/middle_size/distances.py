"""Opponents keep off a restart until the ball is in play.

FIFA's Laws 8 and 13 to 17: a player who is too near is put back and cautioned; after a touch by an opponent the restart
is taken again. Law 13 exempts opponents "on their own goal line between the goalposts". Assumed: how long and how far a
robot, which knows its place only roughly, may be too near. The goalkeeper may stay in its goal area.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction, length
from soccer_env.referee.areas import in_goal_area
from soccer_env.referee.fouls.middle_size.taking import touches_ball
from soccer_env.referee.restarts import distance_from_ball, keep_present_pose, put_robot, send_back
from soccer_env.types import NO_TEAM, Phase

PLAY = int(Phase.PLAY)
FAIR, TOO_NEAR, TOUCHED = 0, 1, 2


@compiled
def find_encroaching(match, robots, robot_events, k):
    """Run the clocks of opponents too near a restart; return the row of an offender, or -1, and its offence."""
    if k.rules_distances == 0 or match.phase == PLAY or match.restart_team == NO_TEAM:
        return -1, FAIR
    row, what = -1, FAIR
    for r in range(robots.shape[0]):
        robot = robots[r]
        if robot.team == match.restart_team or robot.active == 0:
            continue
        if touches_ball(robot_events[r]):
            return r, TOUCHED
        far = distance_from_ball(match, robot, k) - k.rules_distance_slack
        near = length(robot.x - match.restart_x, robot.y - match.restart_y) < far
        keeps = robot.keeper == 1 and in_goal_area(match, robot, robot.team, k)
        if not near or keeps or stands_on_goal_line(match, robot, k):
            robot.near_clock = 0.0
            continue
        robot.near_clock += k.dt
        if robot.near_clock >= k.rules_distance_time - 0.5 * k.dt:
            row, what = r, TOO_NEAR
    return row, what


@compiled
def stands_on_goal_line(match, robot, k):
    """Tell whether a robot stands on or behind its own goal line, between the posts."""
    line = 0.5 * k.pitch_length - k.body_reach
    return -attack_direction(match, robot.team) * robot.x > line and abs(robot.y) < 0.5 * k.pitch_goal_width


@compiled
def put_back_robot(match, robots, r, k):
    """Put robot r back to the nearest place where it may stand at the restart."""
    for other in range(robots.shape[0]):
        keep_present_pose(robots[other])
    send_back(match, robots, r, k)
    put_robot(robots[r])
    robots[r].near_clock = 0.0
