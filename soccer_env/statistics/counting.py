"""Count one control step of a match, after the referee: time, restarts and whistles, then players and flights.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction, length
from soccer_env.statistics.flights import end_flight, follow_ball
from soccer_env.statistics.goals import count_goal
from soccer_env.statistics.maps import BALL, note_place
from soccer_env.statistics.players import count_possession_shares
from soccer_env.statistics.records import LOOK
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase

PLAY, DROP_BALL, OVER = int(Phase.PLAY), int(Phase.DROP_BALL), int(Phase.OVER)
STILL = 0.02  # [m/s] a slower ball lies still
AT_LINE, IN_CORNER = 0.20, 0.25  # [m] from the ball's centre to one line, to both lines


@compiled
def count_step(match, ball, robots, events, k, tally):
    """Count a control step in the statistics, after `count_player` has counted every robot."""
    trail = tally.trail
    tally.played += k.dt
    if match.phase == PLAY and match.placing == 0:
        count_ball(match, ball, k, tally)
        count_possession_shares(match.step, k, tally, trail)
    row = -1
    if events.touch_team != NO_TEAM:
        row = events.scorer if events.goal != NO_TEAM else match.last_touch_robot
    follow_ball(match, ball, robots[max(row, 0)], row, events, k, tally, trail)
    if events.goal != NO_TEAM:
        count_goal(match, events, k, tally, trail)
    if events.in_play == 1:
        trail.in_play = match.step
    elif match.phase != PLAY and match.phase != OVER:
        trail.kind = match.phase


@compiled
def is_notable(events):
    """Tell whether a step has events for `count_calls` to count."""
    return events.restart != 0 or events.separated == 1 or events.foul != 0 or events.annulled == 1


@compiled
def count_calls(match, robots, events, robot_events, bodies, tally):
    """Count the referee's calls; `bodies` holds the poses of the robots before the referee moved any."""
    if events.foul != 0 or events.annulled == 1:
        count_whistles(match, robots, events, robot_events, tally)
    if events.separated == 1:
        tally.separations += 1
        tally.trail.separated = match.step
    if events.restart != 0:
        count_restart(events, tally, tally.trail)
    if events.separated == 1 or events.restart == DROP_BALL:
        for r in range(robots.shape[0]):
            if robots[r].active == 1 and robot_events[r].returned == 0:
                far = length(robots[r].x - bodies[r + 1, 0], robots[r].y - bodies[r + 1, 1])
                tally.carried = max(tally.carried, far)


@compiled
def count_ball(match, ball, k, tally):
    """Count the time with the ball in play: in total, at rest, at the boards, in a corner."""
    tally.in_play += k.dt
    if ball.vx * ball.vx + ball.vy * ball.vy < STILL * STILL:
        tally.still += k.dt
    along, aside = 0.5 * k.pitch_length - abs(ball.x), 0.5 * k.pitch_width - abs(ball.y)
    if min(along, aside) < AT_LINE:
        tally.at_boards += k.dt
    if along < IN_CORNER and aside < IN_CORNER:
        tally.in_corner += k.dt
    if match.step % LOOK == 0:
        note_place(ball, BALL, attack_direction(match, HOME), k, tally.maps)


@compiled
def count_restart(events, tally, trail):
    """Count a restart, and forget the robot that played the ball before it."""
    end_flight(tally, trail)
    trail.player = trail.kicker = -1
    trail.since_restart[HOME] = trail.since_restart[AWAY] = 0
    if events.restart_team == NO_TEAM:
        tally.drops += 1
    else:
        tally.restarts[events.restart_team, events.restart] += 1


@compiled
def count_whistles(match, robots, events, robot_events, tally):
    """Count annulled goals and fouls of a step: one foul for each whistled robot, else one for the whistled team."""
    whistled = 0
    for r in range(robots.shape[0]):
        if robot_events[r].foul != 0:
            tally.fouls[robots[r].team, robot_events[r].foul] += 1
            whistled += 1
    if whistled == 0 and events.foul_team != NO_TEAM:
        tally.fouls[events.foul_team, events.foul] += 1
    if events.annulled == 1:
        home_attacks = (events.ball_x > 0.0) == (attack_direction(match, HOME) > 0.0)
        tally.annulled[HOME if home_attacks else AWAY] += 1
