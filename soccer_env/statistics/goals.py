"""Count goals by kind, and by the events shortly before them.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.statistics.flights import seconds_to_steps
from soccer_env.statistics.maps import note_shot
from soccer_env.statistics.records import LONG_AGO, ROWS, Aim, GoalKind, Outcome

CLEAN_KICK, DEFLECTED_KICK = int(GoalKind.CLEAN_KICK), int(GoalKind.DEFLECTED_KICK)
CLEAN_DRIBBLE, PUSHED_IN = int(GoalKind.CLEAN_DRIBBLE), int(GoalKind.PUSHED_IN)
SCRUM, OWN_GOAL = int(GoalKind.SCRUM), int(GoalKind.OWN_GOAL)
ELSEWHERE, ON_TARGET = int(Aim.ELSEWHERE), int(Aim.ON_TARGET)
GOAL = int(Outcome.GOAL)
KEPT = 1.0  # [s] with the ball after which a robot counts as carrying it, even in a scrum, assumed
JUST = 0.5  # [s] before the goal in which there was a scrum, or its scorer still had the ball, assumed
CONTACT = 3.0  # [s] before the goal in which the scorer touched an opponent, assumed
SEPARATION, RESTART, PUSHED_KEEPER = 6.0, 10.0, 10.0  # [s] before the goal


@compiled
def count_goal(match, events, k, tally, trail):
    """Count a goal; a clean kick not yet counted as a shot is counted as a shot on target."""
    step, team = match.step, events.goal
    kind = goal_kind(step, team, events.scorer, k, trail)
    tally.goals[team, kind] += 1
    if kind == CLEAN_KICK and trail.aim != ON_TARGET:
        tally.shots[team] += trail.aim == ELSEWHERE
        tally.on_target[team] += 1
        if trail.aim == ELSEWHERE:
            note_shot(match, trail.flight, team, GOAL, tally, trail)
    if trail.shot >= 0 and kind in (CLEAN_KICK, DEFLECTED_KICK):
        tally.maps.shots[trail.shot].outcome = GOAL
    trail.saved = 0
    if step - trail.separated <= seconds_to_steps(SEPARATION, k):
        tally.after_separation[team] += 1
    if step - trail.in_play <= seconds_to_steps(RESTART, k):
        tally.after_restart[team, trail.kind] += 1
    if step - trail.keeper_pushed[1 - team] <= seconds_to_steps(PUSHED_KEEPER, k):
        tally.after_pushed_keeper[team] += 1
    if count_bits(trail.since_restart[team]) == 1:
        tally.solo[team] += 1


@compiled
def goal_kind(step, team, scorer, k, trail):
    """Return the kind of a goal of a team; `scorer` is the row that last touched the ball, or -1."""
    if trail.flight >= 0 and trail.flight_team == team:
        return CLEAN_KICK if trail.deflected == LONG_AGO else DEFLECTED_KICK
    if scorer < 0 or trail.player != scorer:
        return SCRUM
    if trail.player_team != team:
        return OWN_GOAL
    player = trail.players[scorer]
    kept = player.held_steps if player.held_since == 0 else player.held_last - player.held_since + 1
    if step - player.held_last > seconds_to_steps(JUST, k):
        kept = 0
    if kept < seconds_to_steps(KEPT, k) and step - trail.crowded <= seconds_to_steps(JUST, k):
        return SCRUM
    return PUSHED_IN if step - player.contact <= seconds_to_steps(CONTACT, k) else CLEAN_DRIBBLE


@compiled
def count_bits(number):
    """Return the number of set bits in a number."""
    count = 0
    for bit in range(ROWS):
        count += (number >> bit) & 1
    return count
