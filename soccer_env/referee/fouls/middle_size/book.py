"""The fouls of the middle size, in their order; of several in one step the first is whistled.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled, inlined
from soccer_env.referee.calls import goal_scored
from soccer_env.referee.fouls.middle_size.areas import GOAL_AREA, find_trespassing
from soccer_env.referee.fouls.middle_size.cards import book
from soccer_env.referee.fouls.middle_size.charging import CHARGES, CHARGES_KEEPER, find_charging
from soccer_env.referee.fouls.middle_size.distances import TOUCHED, find_encroaching, put_back
from soccer_env.referee.fouls.middle_size.free_kicks import give_free_kick
from soccer_env.referee.fouls.middle_size.handling import SURROUNDS, find_handling
from soccer_env.referee.fouls.middle_size.taking import watch_taking
from soccer_env.referee.fouls.penalties import whistle
from soccer_env.referee.restart_call import call_restart
from soccer_env.types import Foul, Phase

PLAY = int(Phase.PLAY)
NONE = int(Foul.NONE)
SECOND_TOUCH = int(Foul.SECOND_TOUCH)
CHARGING = int(Foul.CHARGING)
KEEPER_CHARGE = int(Foul.KEEPER_CHARGE)
HANDLING = int(Foul.HANDLING)
DRIBBLE = int(Foul.DRIBBLE)
GOAL_AREA_FOUL = int(Foul.GOAL_AREA)
PENALTY_AREA_FOUL = int(Foul.PENALTY_AREA)
DISTANCE = int(Foul.DISTANCE)


@inlined
def judge_middle_size(match, ball, robots, events, robot_events, touching, k):
    """Whistle for a foul of the middle size; tell whether robots were moved."""
    again = watch_taking(match, ball, robots, robot_events, k)
    if match.phase != PLAY:
        return judge_distances(match, robots, events, robot_events, k)
    if again:
        return punish(match, ball, robots, events, robot_events, k, match.taker, SECOND_TOUCH, False)
    row, foul, hard = find_foul(match, ball, robots, robot_events, touching, k)
    return row >= 0 and punish(match, ball, robots, events, robot_events, k, row, foul, hard)


@inlined
def find_foul(match, ball, robots, robot_events, touching, k):
    """Return the row of a robot that commits a foul in play, or -1, the Foul, and whether it is a hard one."""
    row, what = find_charging(match, ball, robots, robot_events, touching, k)
    if row >= 0:
        return row, KEEPER_CHARGE if what == CHARGES_KEEPER else CHARGING, what > CHARGES
    row, what = find_handling(ball, robots, k)
    if row >= 0:
        return row, HANDLING if what == SURROUNDS else DRIBBLE, False
    row, what = find_trespassing(match, ball, robots, k)
    if row >= 0:
        return row, GOAL_AREA_FOUL if what == GOAL_AREA else PENALTY_AREA_FOUL, False
    return -1, NONE, False


@compiled
def punish(match, ball, robots, events, robot_events, k, r, foul, hard):
    """Whistle for a foul of robot r in play: a free kick for its opponents, maybe a card; tell whether it is out."""
    whistle(match, robots, events, robot_events, r, foul)
    events.annulled = 1 if goal_scored(ball, k) else 0
    if match.shoot_out == 0:
        give_free_kick(match, events, k, robots[r].team, robots[r].x, robots[r].y)
    else:
        match.phase_clock = k.rules_shoot_out_time  # the kick is over
    forget(robots)
    return book(robots, robot_events, r, hard, k)


@compiled
def judge_distances(match, robots, events, robot_events, k):
    """Whistle for an opponent that does not keep off a restart; tell whether robots were moved."""
    row, what = find_encroaching(match, robots, robot_events, k)
    if row < 0:
        return False
    whistle(match, robots, events, robot_events, row, DISTANCE)
    if what == TOUCHED:
        x, y = match.restart_x, match.restart_y
        call_restart(match, events, match.phase, match.restart_team, x, y)
    else:
        put_back(match, robots, row, k)
    book(robots, robot_events, row, False, k)
    return True


@compiled
def forget(robots):
    """Let all clocks of fouls begin anew: the ball is dead."""
    for r in range(robots.shape[0]):
        robot = robots[r]
        robot.charging = robot.handling = robot.backed = robot.dribbled = 0.0
        robot.area_clock = robot.crowd_clock = robot.near_clock = 0.0
