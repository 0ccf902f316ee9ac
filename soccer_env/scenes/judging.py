"""The success tests of drills, in compiled code after each control step.

    home scores          home scores a goal
    away saves           a shot stops or leaves the field without a goal
    home gets the ball   the ball lies between the paws (in the pocket, at the kicker) of a robot of home
    home gets free       home has the ball and no robot of away is near it; or home has carried it CARRIED away
    home gets past       home carries the ball past away's last player, or into the goal, without touching a robot
    home keeps the ball  until the time limit away never has the ball, it is never out and there is no goal

Any goal ends a drill. A stuck game that the referee restarts with a kick-off ends it as a failure, since ball and
robots are then moved. After a dropped ball, which stays near the place where it stuck, the drill goes on.

Written for the direction in which home attacks; the dribbler is home's last active robot.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import length
from soccer_env.physics.contacts import ball_gap
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase

KICK_OFF, OVER = int(Phase.KICK_OFF), int(Phase.OVER)
NO_DRILL, SCORE, SAVE, GET, FREE, PASS_BY, KEEP = range(7)
SUCCESS = {
    "none": NO_DRILL,
    "home scores": SCORE,
    "away saves": SAVE,
    "home gets the ball": GET,
    "home gets free": FREE,
    "home gets past": PASS_BY,
    "home keeps the ball": KEEP,
}
SLOW_BALL = 0.2  # [m/s] a shot this slow is saved, assumed
NEAR_BALL = 0.05  # [m] from a robot's outline to the ball: a nearer robot contests the ball, assumed
CARRIED = 0.3  # [m] from where the ball lay at the start, assumed
PAST = 0.2  # [m] beyond the last player's centre, assumed
LOST = 0.35  # [m] from the dribbler's centre to the ball, assumed
LOST_TIME = 2.0  # [s] for which the ball may be farther than LOST, assumed


@compiled
def judge_drill(match, ball, robots, robot_events, events, k):
    """Judge a drill: set +1 for success, -1 for failure, 0 while open; a drill that is decided ends the episode."""
    if k.drill == NO_DRILL:
        return
    result = 0
    if events.goal != NO_TEAM:
        result = 1 if events.goal == HOME and k.drill != SAVE and k.drill != KEEP else -1
    elif events.restart == KICK_OFF:
        result = -1
    elif k.drill == SCORE:
        result = -1 if events.out == 1 else 0
    elif k.drill == SAVE:
        result = 1 if events.out == 1 or ball.vx * match.home_direction <= SLOW_BALL else 0
    elif k.drill == GET:
        result = 1 if team_has_ball(robots, HOME) else 0
    elif k.drill == FREE:
        result = judge_challenge(match, ball, robots, k)
    elif k.drill == KEEP:
        result = judge_keeping(match, robots, events, k)
    else:
        result = judge_dribble(match, ball, robots, robot_events, k)
    events.drill = result
    if result != 0:
        match.over = 1
        match.phase = OVER


@compiled
def team_has_ball(robots, team):
    """Tell whether any robot of a team had the ball after the last step."""
    held = False
    for r in range(robots.shape[0]):
        held = held or (robots[r].team == team and robots[r].has_ball == 1)
    return held


@compiled
def is_team_near_ball(ball, robots, team, k):
    """Tell whether a robot of a team is near enough to contest the ball."""
    far = k.body_reach + k.ball_radius + NEAR_BALL
    for r in range(robots.shape[0]):
        if robots[r].team == team and robots[r].active == 1:
            x, y = ball.x - robots[r].x, ball.y - robots[r].y
            if x * x + y * y < far * far and ball_gap(robots[r], k, ball.x, ball.y) < NEAR_BALL:
                return True
    return False


@compiled
def judge_challenge(match, ball, robots, k):
    """Return +1 if home has won the ball, -1 if away has, else 0; the ball started at restart_x, restart_y.

    If both have a ball that was carried far, the winner is the team that attacks in the direction of that motion.
    """
    home, away = team_has_ball(robots, HOME), team_has_ball(robots, AWAY)
    if home and not is_team_near_ball(ball, robots, AWAY, k):
        return 1
    if away and not is_team_near_ball(ball, robots, HOME, k):
        return -1
    x, y = ball.x - match.restart_x, ball.y - match.restart_y
    if not (home or away) or length(x, y) <= CARRIED:
        return 0
    if home and away:
        return 1 if x * match.home_direction > 0.0 else -1
    return 1 if home else -1


@compiled
def judge_keeping(match, robots, events, k):
    """Return -1 if the ball is out or away has it, +1 at the time limit, else 0."""
    if events.out == 1 or team_has_ball(robots, AWAY):
        return -1
    return 1 if match.step * k.dt >= k.drill_time - 0.5 * k.dt else 0


@compiled
def judge_dribble(match, ball, robots, robot_events, k):
    """Return +1 if the dribbler is past all opponents, -1 if it touched a robot or lost the ball, else 0."""
    dribbler, last = 0, -1e9
    for r in range(robots.shape[0]):
        if robots[r].active == 1:
            if robots[r].team == HOME:
                dribbler = r
            else:
                last = max(last, robots[r].x * match.home_direction)
    robot = robots[dribbler]
    if robot_events[dribbler].collision == 1:
        return -1
    near = length(ball.x - robot.x, ball.y - robot.y) <= LOST
    match.drill_clock = 0.0 if near else match.drill_clock + k.dt
    if match.drill_clock > LOST_TIME:
        return -1
    return 1 if robot.has_ball == 1 and ball.x * match.home_direction > last + PAST else 0
