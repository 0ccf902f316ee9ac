"""The fouls of the middle size in their order, with free kicks and cards; of several in one step the first counts.

FIFA's Law 13 of 2005: a free kick is taken where the foul happened, by the team that did not commit it; opponents keep
their distance, except on their own goal line between the posts. Its distances and its time are those of the other
restarts.

`k`: the league's constants.
"""

from math import inf

from soccer_env.compiled import compiled, inlined
from soccer_env.geometry import clip
from soccer_env.referee.calls import goal_scored
from soccer_env.referee.fouls.middle_size.areas import GOAL_AREA, find_trespassing
from soccer_env.referee.fouls.middle_size.charging import CHARGES, CHARGES_KEEPER, find_charging
from soccer_env.referee.fouls.middle_size.distances import TOUCHED, find_encroaching, put_back_robot
from soccer_env.referee.fouls.middle_size.handling import SURROUNDS, find_handling
from soccer_env.referee.fouls.middle_size.taking import watch_restart_taker
from soccer_env.referee.fouls.penalties import send_off, whistle
from soccer_env.referee.restart_call import call_restart, other_team
from soccer_env.types import Foul, Phase

PLAY, FREE_KICK = int(Phase.PLAY), int(Phase.FREE_KICK)
NONE, SECOND_TOUCH, DISTANCE = int(Foul.NONE), int(Foul.SECOND_TOUCH), int(Foul.DISTANCE)
CHARGING, KEEPER_CHARGE = int(Foul.CHARGING), int(Foul.KEEPER_CHARGE)
HANDLING, DRIBBLE = int(Foul.HANDLING), int(Foul.DRIBBLE)
GOAL_AREA_FOUL, PENALTY_AREA_FOUL = int(Foul.GOAL_AREA), int(Foul.PENALTY_AREA)
YELLOW, OUT = 1, 2  # cards


@inlined
def judge_middle_size(match, ball, robots, events, robot_events, touching, k):
    """Whistle for a foul of the middle size; tell whether robots were moved."""
    again = watch_restart_taker(match, ball, robots, robot_events, k)
    if match.phase != PLAY:
        return judge_distances(match, robots, events, robot_events, k)
    if again:
        return punish(match, ball, robots, events, robot_events, k, match.taker, SECOND_TOUCH, False)
    row, foul, hard = find_foul(match, ball, robots, robot_events, touching, k)
    return row >= 0 and punish(match, ball, robots, events, robot_events, k, row, foul, hard)


@inlined
def find_foul(match, ball, robots, robot_events, touching, k):
    """Return the row of a robot that commits a foul in play, or -1, the Foul, and whether the foul is hard."""
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
    """Whistle for a foul of robot r in play, call the free kick, maybe show a card; tell whether it is sent off."""
    whistle(match, robots, events, robot_events, r, foul)
    events.annulled = 1 if goal_scored(ball, k) else 0
    if match.shoot_out == 0:
        give_free_kick(match, events, k, robots[r].team, robots[r].x, robots[r].y)
    else:
        match.phase_clock = k.rules_shoot_out_time  # the kick is over
    reset_foul_clocks(robots)
    return book_foul(robots, robot_events, r, hard, k)


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
        put_back_robot(match, robots, row, k)
    book_foul(robots, robot_events, row, False, k)
    return True


@compiled
def reset_foul_clocks(robots):
    """Reset all clocks of fouls: the ball is dead."""
    for r in range(robots.shape[0]):
        robot = robots[r]
        robot.charging = robot.handling = robot.backed = robot.dribbled = 0.0
        robot.area_clock = robot.crowd_clock = robot.near_clock = 0.0


@compiled
def give_free_kick(match, events, k, culprit_team, x, y):
    """Call a free kick for the opponents of a team, near a point of the field [m]."""
    x, y = free_kick_spot(k, x, y)
    call_restart(match, events, FREE_KICK, other_team(culprit_team), x, y)


@compiled
def free_kick_spot(k, x, y):
    """Return the spot of a free kick for a foul at a point [m]: on the pitch, not within a goal area.

    FIFA's Law 13 of 2005: a free kick within the opponents' goal area is taken from that area's line, at the point
    nearest to the foul. A free kick in the own goal area is moved there too; the law allows any point of the area.
    """
    edge_x, edge_y = 0.5 * k.pitch_length - k.rules_corner_offset, 0.5 * k.pitch_width - k.rules_corner_offset
    x, y = clip(x, -edge_x, edge_x), clip(y, -edge_y, edge_y)
    line = 0.5 * k.pitch_length - k.pitch_goal_area_depth
    if abs(x) > line and abs(y) < 0.5 * k.pitch_goal_area_width:
        x = line if x > 0.0 else -line
    return x, y


@compiled
def book_foul(robots, robot_events, r, hard, k):
    """Count a foul of robot r; tell whether it is sent off for it.

    FIFA's Laws 5 and 12 of 2005: two yellow cards are a red card, for the rest of the match. Remembered: this held in
    the middle size of 2006, and in later years a robot was out for 90 s (the switch `timed_cards`). Assumed: the number
    of fouls that are too many. No robot takes the place of a goalkeeper that is sent off.
    """
    if k.rules_cards == 0:
        return False
    robots[r].fouls += 1
    if not hard and robots[r].fouls % k.rules_card_fouls != 0.0:
        return False
    robots[r].yellow += 1
    robot_events[r].card = YELLOW
    if robots[r].yellow % 2 == 1:
        return False
    robot_events[r].card = OUT
    send_off(robots, r, k.rules_card_time if k.rules_timed_cards == 1 else inf)
    return True
