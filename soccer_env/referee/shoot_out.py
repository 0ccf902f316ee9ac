"""Penalty kicks after a drawn match, in turn, until one team cannot be caught.

As in FIFA's "kicks from the penalty mark" of 2005: five kicks each in turn, then single pairs. A kick is over when the
ball is in the goal, out of play or at rest, when the taker touches the ball again, or when the time is up. Only the
taker and the other team's goalkeeper play; the referee keeps the other robots at their places. Unlike FIFA's rule: each
team shoots at the goal that it attacks, one taker takes all kicks of a team, and after `shoot_out_most` pairs the match
is a draw (assumed, so that every match ends).

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction
from soccer_env.referee.restart_call import call_restart, other_team
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase

PLAY, PENALTY_KICK, OVER = int(Phase.PLAY), int(Phase.PENALTY_KICK), int(Phase.OVER)
AT_REST = 0.05  # [m/s] a ball slower than this has come to rest, assumed
SCORED, MISSED = 1, 2


@compiled
def is_shoot_out_due(match, k):
    """Tell whether a match at full time goes on with penalty kicks."""
    return k.rules_shoot_out == 1 and match.score[HOME] == match.score[AWAY]


@compiled
def begin_shoot_out(match, events, k):
    """Call the first penalty kick."""
    match.shoot_out = 1
    match.shoot_out_score[HOME] = match.shoot_out_score[AWAY] = 0
    call_penalty(match, events, k)


@compiled
def kicking_team(match):
    """Return the team whose turn it is; the team of the first kick-off begins."""
    return match.kick_off_team if match.shoot_out % 2 == 1 else other_team(match.kick_off_team)


@compiled
def call_penalty(match, events, k):
    """Call a penalty kick by the team whose turn it is."""
    team = kicking_team(match)
    x = attack_direction(match, team) * (0.5 * k.pitch_length - k.rules_penalty_mark)
    call_restart(match, events, PENALTY_KICK, team, x, 0.0)


@compiled
def judge_penalty(match, ball, events, k, in_goal, out):
    """End a penalty kick that is over, and count it."""
    team = kicking_team(match)
    late = match.phase_clock >= k.rules_shoot_out_time - 0.5 * k.dt
    rests = match.phase == PLAY and ball.vx * ball.vx + ball.vy * ball.vy < AT_REST * AT_REST
    if in_goal and not late and ball.x * attack_direction(match, team) > 0.0:
        end_kick(match, events, k, team, SCORED)
    elif in_goal or out or late or rests:
        end_kick(match, events, k, team, MISSED)


@compiled
def end_kick(match, events, k, team, result):
    """Count a penalty kick; call the next one or end the match."""
    events.penalty = result
    if result == SCORED:
        match.shoot_out_score[team] += 1
    if is_decided(match, k):
        end_match(match, events)
    else:
        match.shoot_out += 1
        call_penalty(match, events, k)


@compiled
def is_decided(match, k):
    """Tell whether a shoot-out is over after the kicks taken so far."""
    taken = match.shoot_out
    first, second = match.kick_off_team, other_team(match.kick_off_team)
    lead = match.shoot_out_score[first] - match.shoot_out_score[second]
    if taken >= 2.0 * k.rules_shoot_out_kicks:
        return taken % 2 == 0 and (lead != 0 or taken >= 2.0 * k.rules_shoot_out_most)
    left_first = k.rules_shoot_out_kicks - (taken + 1) // 2
    left_second = k.rules_shoot_out_kicks - taken // 2
    return lead > left_second or -lead > left_first


@compiled
def end_match(match, events):
    """Blow the final whistle."""
    match.over = 1
    match.phase = OVER
    match.restart_team = NO_TEAM
    events.final_whistle = 1
    events.restart = 0
    events.restart_team = NO_TEAM
