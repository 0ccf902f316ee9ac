"""The taker of a restart, and its touches of the ball.

FIFA's Laws 8 and 13 to 17 of 2005, which the middle size follows: the taker of a restart does not touch the ball again
before another robot has; from an indirect restart no goal is scored before another robot has touched the ball. All
restarts of the middle size are indirect, remembered. A robot that pushes is in contact for a while: all its contact up
to the moment when the ball is in play, and from then on, is one touch until it has left the ball for `touch_break` or
has moved it farther than `taking_distance` from the spot (assumed: the longer of the two distances that the ball has to
go in the books of these years).

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.types import NO_TEAM, Phase

PLAY, KICK_OFF, FREE_KICK = int(Phase.PLAY), int(Phase.KICK_OFF), int(Phase.FREE_KICK)
THROW_IN, GOAL_KICK, CORNER_KICK = int(Phase.THROW_IN), int(Phase.GOAL_KICK), int(Phase.CORNER_KICK)


@inlined
def watch_restart_taker(match, ball, robots, robot_events, k):
    """Note the taker of a restart until another robot touches the ball; tell whether it touches the ball twice."""
    if match.phase != PLAY:
        note_taker(match, robots, robot_events, k)
        return False
    if match.taker < 0:  # nobody took the restart in time
        match.indirect = 0
        return False
    for r in range(robots.shape[0]):
        if r != match.taker and touches_ball(robot_events[r]):
            match.taker = -1
            match.indirect = 0
            return False
    if not touches_ball(robot_events[match.taker]):
        match.taker_clock += k.dt
        return False
    again = match.taker_clock >= k.rules_touch_break - 0.5 * k.dt
    match.taker_clock = 0.0
    x, y = ball.x - match.restart_x, ball.y - match.restart_y
    far = k.rules_taking_distance
    return k.rules_second_touch == 1 and (again or x * x + y * y > far * far)


@compiled
def note_taker(match, robots, robot_events, k):
    """Note the last robot of the restart's team that touches the ball before it is in play."""
    if match.restart_team == NO_TEAM:
        return
    for r in range(robots.shape[0]):
        if robots[r].team == match.restart_team and touches_ball(robot_events[r]):
            match.taker = r
            match.taker_clock = 0.0
            match.indirect = 0 if allows_goal(k, match.phase) else 1


@compiled
def touches_ball(robot_event):
    """Tell whether a robot touched or kicked the ball in this step."""
    return robot_event.touch == 1 or robot_event.kick == 1


@compiled
def allows_goal(k, phase):
    """Tell whether a goal straight from a restart counts."""
    if phase == KICK_OFF:
        return k.rules_direct_kick_off == 1
    if phase == THROW_IN:
        return k.rules_direct_throw_in == 1
    if phase == GOAL_KICK:
        return k.rules_direct_goal_kick == 1
    if phase == CORNER_KICK:
        return k.rules_direct_corner_kick == 1
    return phase != FREE_KICK or k.rules_direct_free_kick == 1
