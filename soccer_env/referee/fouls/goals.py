"""Tell whether a ball in the goal counts.

The book annuls goals that an attacker or a mate scores between pushing the goalkeeper for too long and being taken out,
and goals while holding the ball: "considered out", the ball goes to the halfway line. After a kick-off shot the
defenders kick off. Here a guilty robot is taken out at once, and a goal of its team does not count

* for some seconds after the whistle for pushing the goalkeeper or holding the ball: the time that a referee's
  assistant takes to remove a robot;
* while a robot of the team has pushed the goalkeeper, or has held the ball, for half a second or longer. Unlike the
  book, which allows a full second: in less an attacker could shove goalkeeper and ball over the line together. A
  shorter contact is a gait step, which a walking robot cannot break off.

In the middle size a goal from an indirect restart counts once another robot than the taker has touched the ball
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
    """Tell whether a team scores straight from its kick-off although the rules forbid it."""
    return k.rules_kick_off_shot == 1 and match.kick_off_shot == scorer


@inlined
def note_whistled_attack(match, robots, robot_events, k):
    """Remember for a while a team whistled for keeper pushing or holding; of both teams, that of the later row."""
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
    """Tell whether the taker of a restart has put the ball into its own goal, untouched by other robots."""
    return match.taker >= 0 and robots[match.taker].team != scorer
