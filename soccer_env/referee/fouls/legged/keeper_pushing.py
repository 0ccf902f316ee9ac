"""Goalkeeper pushing: an attacker that walks into a goalkeeper in its own area for longer than 1 s is taken out.

The book, in the legged book's words: while the goalkeeper has a foot on or inside the line of its area, no attacker
may be in contact with it, or push it through the ball, for more than a second; of two attackers at once the second is
removed immediately; short pushes count as one, unless the attacker backs off for as long as it pushed. Unlike the book,
an attacker is guilty only if it walks into the goalkeeper, not if the goalkeeper runs into it, and only while the ball
or the attacker is in the area: a foot of the goalkeeper makes no foul of a duel outside. No robot is exempt.

`referee.fouls.goals` decides whether a goal after such a push counts.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.referee.fouls.legged.contact import KEEPER, run_clock
from soccer_env.referee.fouls.penalties import whistle
from soccer_env.types import Foul

KEEPER_PUSHING = int(Foul.KEEPER_PUSHING)


@inlined
def judge_keeper_pushing(match, robots, events, robot_events, k):
    """Whistle attackers that have pushed the goalkeeper for too long, or that join an attacker who already pushes."""
    for r in range(robots.shape[0]):
        pushes = robot_events[r].pushes == KEEPER
        if pushes or robots[r].keeper_pushing > 0.0:
            robots[r].keeper_pushing = run_clock(robots[r].keeper_pushing, pushes, k.dt)
    for r in range(robots.shape[0]):
        if robot_events[r].pushes != KEEPER:
            continue
        if robots[r].keeper_pushing > k.rules_keeper_pushing_time + 0.5 * k.dt or joins_pushing_mate(
            robots, robot_events, r, k
        ):
            whistle(match, robots, events, robot_events, r, KEEPER_PUSHING)


@compiled
def joins_pushing_mate(robots, robot_events, r, k):
    """Tell whether robot r joins a mate that has pushed the goalkeeper for longer; at equal times neither joins."""
    for mate in range(robots.shape[0]):
        if mate == r or robots[mate].team != robots[r].team or robot_events[mate].pushes != KEEPER:
            continue
        if robots[mate].keeper_pushing > robots[r].keeper_pushing + 0.5 * k.dt:
            return True
    return False
