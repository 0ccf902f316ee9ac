"""No goal straight from the kick-off.

The book: a kick-off shot never scores. Before the team that kicked off can score, the whole ball must leave the centre
circle, and then a player of that team must touch it, whichever robots it touches on its way; else the defenders kick
off.

`k`: the league's constants.
"""

from soccer_env.compiled import inlined
from soccer_env.types import NO_TEAM, Phase

KICK_OFF = int(Phase.KICK_OFF)


@inlined
def watch_kick_off(match, ball, robots, robot_events, k):
    """Note the team that kicks off, until it touches the ball beyond the centre circle."""
    if match.phase == KICK_OFF:
        match.kick_off_shot = match.restart_team
    if match.kick_off_shot == NO_TEAM:
        return
    far = k.pitch_circle + k.ball_radius
    if ball.x * ball.x + ball.y * ball.y <= far * far:
        return
    for r in range(robots.shape[0]):
        if robots[r].team == match.kick_off_shot and robot_events[r].touch == 1:
            match.kick_off_shot = NO_TEAM
            return
