"""Game stuck: local, where play does not move on, and global, where nobody touches the ball.

The book: if nothing substantial changes for 30 s, the robot nearest to the ball is carried to the halfway line and the
ball stays; if that robot is a goalkeeper with a foot in its own half, the ball is put on the centre spot instead. If no
robot touches the ball for 30 s, the team in whose half the ball lies kicks off.

The book of 2008 lacks the dropped ball after 15 s, which is remembered of 2001. The three rules follow each other:

* 15 s within 10 cm: a dropped ball, which takes the ball out of the scrum or off the board;
* 30 s within 50 cm of one point, also with dropped balls in between: local game stuck. Time without a robot at the ball
  does not count, and 15 s of it start the count anew;
* 30 s without a touch: global game stuck. A dropped ball that no robot comes for does not stop this clock.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.geometry import attack_direction
from soccer_env.referee.fouls.legged.pushing import squared_ball_distance
from soccer_env.referee.fouls.penalties import whistle
from soccer_env.types import AWAY, HOME, Foul, Phase

GAME_STUCK = int(Foul.GAME_STUCK)
KICK_OFF, DROP_BALL, PLAY = int(Phase.KICK_OFF), int(Phase.DROP_BALL), int(Phase.PLAY)
AT_BALL = 5.0  # [s] after a touch in which a robot is at the ball, assumed
NOBODY, STUCK, GLOBAL, TO_CENTRE = (
    0,
    1,
    2,
    3,
)  # a step: not stuck, robot removed, kick-off, ball to the centre


@inlined
def judge_stuck(match, ball, robots, events, robot_events, k):
    """Whistle a stuck game; return GLOBAL or TO_CENTRE if the ball has to be moved, STUCK or NOBODY if not."""
    if match.phase != PLAY and match.phase != DROP_BALL:
        match.idle_clock = 0.0
        restart_stuck_clock(match, ball)
        return NOBODY
    if k.rules_global_stuck == 1 and match.idle_clock > k.rules_global_stuck_time - 0.5 * k.dt:
        return GLOBAL
    if k.rules_local_stuck == 0:
        return NOBODY
    x, y, far = ball.x - match.local_x, ball.y - match.local_y, k.rules_local_stuck_radius
    if x * x + y * y > far * far:
        restart_stuck_clock(match, ball)
        return NOBODY
    if match.idle_clock < AT_BALL:
        match.local_clock += k.dt
    elif match.idle_clock > k.rules_stuck_time:
        match.local_clock = 0.0
    if match.local_clock < k.rules_local_stuck_time - 0.5 * k.dt:
        return NOBODY
    restart_stuck_clock(match, ball)
    r = nearest_robot(ball, robots)
    if r < 0:
        return NOBODY
    if robots[r].keeper == 1 and robots[r].x * attack_direction(match, robots[r].team) < k.body_reach:
        return TO_CENTRE
    whistle(match, robots, events, robot_events, r, GAME_STUCK)
    return STUCK


@compiled
def restart_stuck_clock(match, ball):
    """Restart the clock of local game stuck, and store the ball's position as the point that the ball has to leave."""
    match.local_x, match.local_y, match.local_clock = ball.x, ball.y, 0.0


@compiled
def nearest_robot(ball, robots):
    """Return the row of the robot nearest to the ball, or -1."""
    nearest, least = -1, 0.0
    for r in range(robots.shape[0]):
        square = squared_ball_distance(ball, robots[r])
        if robots[r].active == 1 and (nearest < 0 or square < least):
            nearest, least = r, square
    return nearest


@compiled
def defending_team_at(match, x):
    """Return the team in whose half a place lies."""
    return HOME if x * match.home_direction < 0.0 else AWAY
