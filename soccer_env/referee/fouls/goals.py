"""Whether a ball in the goal counts.

The book annuls goals that an attacker, or a mate of it, scores after it has pushed the goalkeeper for too long and
before it is taken out, and goals while holding the ball: "considered out", the ball goes to the halfway line. A
kick-off shot gives the defenders a kick-off. Here a robot is taken out at once, so that a goal does not count

* for some seconds after its team was whistled for pushing the goalkeeper or holding the ball, as long as a referee's
  assistant takes;
* while one of its team has pushed the goalkeeper for half a second or longer, or has the ball and has held it for
  that long. Unlike in the book, where the second has to be full: an attacker could shove goalkeeper and ball over the
  line together in less. A shorter contact is a gait step, which a walking robot cannot break off.

In the middle size a goal from an indirect restart counts once somebody but the taker has touched the ball
(`taking.py`).

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.types import NO_TEAM, Foul

KEEPER_PUSHING, HOLDING = int(Foul.KEEPER_PUSHING), int(Foul.HOLDING)


@compiled
def goal_counts(match, ball, robots, k, scorer):
    """Tell whether a goal of a team counts."""
    if match.indirect == 1 or match.whistled == scorer or is_kick_off_shot(match, k, scorer):
        return False
    for r in range(robots.shape[0]):
        robot = robots[r]
        if robot.team != scorer or robot.active == 0:
            continue
        if k.rules_keeper_pushing == 1 and robot.keeper_pushing >= k.rules_annulled_push - 0.5 * k.dt:
            return False
        if k.rules_holding == 1 and robot.has_ball == 1 and robot.holding >= k.rules_annulled_push - 0.5 * k.dt:
            return False
    return True


@compiled
def is_kick_off_shot(match, k, scorer):
    """Tell whether a team scores straight from its kick-off where it may not."""
    return k.rules_kick_off_shot == 1 and match.kick_off_shot == scorer


@inlined
def note_whistled_attack(match, robots, robot_events, k):
    """Remember for a while whose attack was whistled; if both teams' were, the later robot's counts."""
    if match.whistled != NO_TEAM:
        match.whistled_clock += k.dt
        if match.whistled_clock > k.rules_annulled_time - 0.5 * k.dt:
            match.whistled = NO_TEAM
    for r in range(robots.shape[0]):
        if robot_events[r].foul == KEEPER_PUSHING or robot_events[r].foul == HOLDING:
            match.whistled = robots[r].team
            match.whistled_clock = 0.0


@compiled
def is_own_goal(match, robots, scorer):
    """Tell whether the taker of a restart has put the ball into its own goal, untouched by anybody else."""
    return match.taker >= 0 and robots[match.taker].team != scorer
