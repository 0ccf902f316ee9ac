"""All rules of the legged league in their order, and the removal of guilty robots.

All fouls are judged before any robot is moved, so that no robot is favoured by its number.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.referee.fouls.goals import note_whistled_attack
from soccer_env.referee.fouls.legged.areas import judge_areas
from soccer_env.referee.fouls.legged.contact import note_pushes
from soccer_env.referee.fouls.legged.falling import judge_falling
from soccer_env.referee.fouls.legged.holding import judge_holding
from soccer_env.referee.fouls.legged.keeper_pushing import judge_keeper_pushing
from soccer_env.referee.fouls.legged.kick_off_shot import watch_kick_off
from soccer_env.referee.fouls.legged.leaving import judge_leaving
from soccer_env.referee.fouls.legged.pushing import judge_pushing
from soccer_env.referee.fouls.legged.stuck import GLOBAL, TO_CENTRE, defending_team_at, judge_stuck
from soccer_env.referee.fouls.penalties import take_out_robot
from soccer_env.referee.restart_call import call_restart
from soccer_env.types import NO_TEAM, Foul, Phase

HOLDING, FALLEN, GAME_STUCK = int(Foul.HOLDING), int(Foul.FALLEN), int(Foul.GAME_STUCK)
KICK_OFF, DROP_BALL = int(Phase.KICK_OFF), int(Phase.DROP_BALL)


@inlined
def judge_legged(match, ball, robots, events, robot_events, touching, k):
    """Whistle for the fouls of a step; tell whether robots were moved."""
    if k.rules_kick_off_shot == 1:
        watch_kick_off(match, ball, robots, robot_events, k)
    if k.rules_pushing + k.rules_keeper_pushing + k.rules_illegal_defender + k.rules_falling > 0:
        note_pushes(match, ball, robots, robot_events, touching, k)
    if k.rules_keeper_pushing == 1:
        judge_keeper_pushing(match, robots, events, robot_events, k)
    if k.rules_holding + k.rules_carrying > 0:
        judge_holding(match, ball, robots, events, robot_events, k)
    if k.rules_pushing == 1:
        judge_pushing(match, ball, robots, events, robot_events, k)
    if k.rules_illegal_defender + k.rules_illegal_attacker > 0:
        judge_areas(match, ball, robots, events, robot_events, k)
    if k.rules_leaving_field == 1:
        judge_leaving(match, robots, events, robot_events, k)
    if k.rules_falling == 1:
        judge_falling(match, robots, events, robot_events, k)
    if k.rules_local_stuck + k.rules_global_stuck > 0:
        restart_if_stuck(match, ball, robots, events, robot_events, k)
    if k.rules_keeper_pushing + k.rules_holding > 0:
        note_whistled_attack(match, robots, robot_events, k)
    return events.foul != 0 and take_out_guilty(match, ball, robots, robot_events, k)


@inlined
def restart_if_stuck(match, ball, robots, events, robot_events, k):
    """Call the restart of a stuck game, if it needs one."""
    verdict = judge_stuck(match, ball, robots, events, robot_events, k)
    if verdict == GLOBAL:
        events.stuck = 1
        call_restart(match, events, KICK_OFF, defending_team_at(match, ball.x), 0.0, 0.0)
    elif verdict == TO_CENTRE:
        events.stuck = 1
        call_restart(match, events, DROP_BALL, NO_TEAM, 0.0, 0.0)


@compiled
def take_out_guilty(match, ball, robots, robot_events, k):
    """Take out whistled robots; tell whether there are any.

    A fallen robot, a robot in the way of a stuck game and a goalkeeper that held the ball come back at once.
    """
    moved = False
    for r in range(robots.shape[0]):
        foul = robot_events[r].foul
        if foul == 0:
            continue
        at_once = foul in (FALLEN, GAME_STUCK) or (foul == HOLDING and robots[r].keeper == 1)
        take_out_robot(match, ball, robots, robot_events, r, 0.0 if at_once else k.rules_removal_time, k)
        moved = True
    return moved
