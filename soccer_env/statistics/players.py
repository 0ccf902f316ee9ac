"""Count what every robot does in a control step: possession and its spells, touches, idle mates, goalkeepers.

`k`: the league's constants.
"""

from __future__ import annotations

from math import log2

from soccer_env.compiled import compiled
from soccer_env.geometry import direction_of
from soccer_env.leagues.robot import DRIVE_KINDS
from soccer_env.statistics.records import BINS, BINS_PER_OCTAVE, SHORTEST
from soccer_env.types import AWAY, HOME

GAIT = DRIVE_KINDS["gait"]
LOST = 0.5  # [s] without the ball that end a spell
AGAIN = 1.0  # [s] without a touch after which the next one counts anew
CROWD = 3  # robots that make a scrum
MARGIN = 0.10  # [m] beyond the reach of a robot that lies at the ball: 30 cm between centres in the legged league
SLOW_LEGS, SLOW_WHEELS = 0.01, 0.05  # [m/s] a slower mate is idle
PUSHED = 1.0  # [s] in contact that make a pushed goalkeeper, rule book of 2008
FAR = 0.25  # [1] of the pitch's length from its goal: the goalkeeper is away


@compiled
def count_players(match, ball, robots, robot_events, k, tally, trail, in_play):
    """Count what all robots do; a spell ends with the play."""
    near = k.body_reach + k.ball_radius + MARGIN
    crowd = has_home = has_away = 0
    for team in range(2):
        trail.nearest[team], trail.nearest_counts[team] = 1e5, 0
    for r in range(robots.shape[0]):
        robot = robots[r]
        if robot.active == 0:
            count_absent(robot, r, k, tally, trail)
            continue
        if robot.locked > trail.locked[r]:
            trail.contact[r] = match.step
        trail.locked[r] = robot.locked
        tally.kicks[robot.team] += robot_events[r].kick
        if not in_play:
            if trail.held_since[r] > 0:
                end_spell(robot.team, r, k, tally, trail)
            continue
        x, y = robot.x - ball.x, robot.y - ball.y
        squared = x * x + y * y
        crowd += squared < near * near
        if robot.team == HOME:
            has_home |= robot.has_ball
        else:
            has_away |= robot.has_ball
        note_touch(robot, r, robot_events[r].touch, match.step, k, tally, trail)
        count_standing(match, robot, squared, k, tally, trail)
    if in_play:
        share_out(match, crowd, has_home, has_away, k, tally, trail)


@compiled
def count_absent(robot, r, k, tally, trail):
    """Count the penalty of a robot that is out, which ends its spell; it has never been in contact."""
    if robot.penalty > 0.0 or robot.banned == 1:
        tally.out[robot.team] += k.dt
    if trail.held_since[r] > 0:
        end_spell(robot.team, r, k, tally, trail)
    trail.locked[r] = 0.0


@compiled
def note_touch(robot, r, touch, step, k, tally, trail):
    """Count a touch, and begin, go on with or end the spell of a robot."""
    if touch == 1:
        if (step - trail.touched_by[r] - 1) * k.dt > AGAIN + 0.5 * k.dt:
            tally.touches[robot.team] += 1
        trail.touched_by[r] = step
    if trail.held_since[r] > 0 and (step - trail.held_last[r] - robot.has_ball) * k.dt > LOST + 0.5 * k.dt:
        end_spell(robot.team, r, k, tally, trail)
    if robot.has_ball == 1:
        if trail.held_since[r] == 0:
            trail.held_since[r] = step
        trail.held_last[r] = step


@compiled
def end_spell(team, r, k, tally, trail):
    """Count the spell of a robot that has lost the ball."""
    seconds = (trail.held_last[r] - trail.held_since[r] + 1) * k.dt
    trail.held_since[r] = 0
    tally.spells[team] += 1
    tally.spell_time[team] += seconds
    tally.longest_spell[team] = max(tally.longest_spell[team], seconds)
    place = int(BINS_PER_OCTAVE * log2(max(seconds, SHORTEST) / SHORTEST) + 1e-9)
    tally.spell_lengths[team, min(place, BINS - 1)] += 1


@compiled
def count_standing(match, robot, squared, k, tally, trail):
    """Count where a goalkeeper stands, and whether a field player moves; note who is its team's nearest to the ball."""
    team, counts = robot.team, 0
    if robot.keeper == 1:
        count_keeper(match, robot, k, tally, trail)
    else:
        slow = SLOW_LEGS if k.drive_kind == GAIT else SLOW_WHEELS
        counts = 2 if robot.vx * robot.vx + robot.vy * robot.vy < slow * slow else 1
        tally.mates[team] += k.dt
        if counts == 2:
            tally.idle[team] += k.dt
    if squared < trail.nearest[team]:
        trail.nearest[team], trail.nearest_counts[team] = squared, counts


@compiled
def count_keeper(match, robot, k, tally, trail):
    """Count a goalkeeper's time away from its goal and in it, and note that it is being pushed."""
    ahead = direction_of(match, robot.team) * robot.x + 0.5 * k.pitch_length  # of its goal line
    far = FAR * k.pitch_length
    if ahead * ahead + robot.y * robot.y > far * far:
        tally.keeper_away[robot.team] += k.dt
    elif ahead < 0.0:
        tally.keeper_in_goal[robot.team] += k.dt
    if robot.locked >= PUSHED - 0.5 * k.dt:
        trail.keeper_pushed[robot.team] = match.step


@compiled
def share_out(match, crowd, has_home, has_away, k, tally, trail):
    """Count possession and scrums; a team's nearest robot is no idle mate, whatever it does."""
    if has_home == 1 and has_away == 1:
        tally.both += k.dt
    elif has_home == 1:
        tally.possession[HOME] += k.dt
    elif has_away == 1:
        tally.possession[AWAY] += k.dt
    if crowd >= CROWD:
        tally.scrum += k.dt
        trail.crowded = match.step
    for team in range(2):
        if trail.nearest_counts[team] >= 1:
            tally.mates[team] -= k.dt
        if trail.nearest_counts[team] == 2:
            tally.idle[team] -= k.dt
