"""Count what every robot does in a control step: possession and its spells, touches, idle mates, goalkeepers.

`k`: the league's constants.
"""

from math import log2

from soccer_env.compiled import compiled
from soccer_env.geometry import direction_of
from soccer_env.leagues.robot import DRIVE_KINDS
from soccer_env.physics.contacts import TOUCH_GAP, robots_touch
from soccer_env.statistics.moving import count_moving
from soccer_env.statistics.records import BINS, BINS_PER_OCTAVE, NOBODY, SHORTEST
from soccer_env.types import AWAY, HOME, Phase

PLAY = int(Phase.PLAY)
GAIT = DRIVE_KINDS["gait"]
LOST = 0.5  # [s] without the ball that end a spell
AGAIN = 1.0  # [s] without a touch after which the next one counts anew
CROWD = 3  # robots that make a scrum
MARGIN = 0.10  # [m] beyond the reach of a robot that lies at the ball: 30 cm between centres in the legged league
SLOW_LEGS, SLOW_WHEELS = 0.01, 0.05  # [m/s] a slower mate is idle
PUSHED = 1.0  # [s] in contact that make a pushed goalkeeper, rule book of 2008
FAR = 0.25  # [1] of the pitch's length from its goal: the goalkeeper is away


@compiled
def count_player(match, ball, robots, events, r, k, tally):
    """Count what robot r does; a spell ends with the play."""
    robot, trail = robots[r], tally.trail
    player = trail.players[r]
    if robot.active == 0:
        if robot.penalty > 0.0 or robot.banned == 1:
            tally.out[robot.team] += k.dt
        player.locked = 0.0
    elif robot.locked != player.locked:
        if robot.locked > player.locked and touches_opponent(robots, r, k):
            player.contact = match.step
        player.locked = robot.locked
    if events.kick == 1:
        tally.kicks[robot.team] += 1
        trail.kicker, trail.kicker_team = r, robot.team
    if match.phase == PLAY and match.placing == 0 and robot.active == 1:
        if events.touch == 1:
            count_touch(robot.team, player, match.step, k, tally)
        if robot.has_ball == 1 or player.held_since > 0:
            count_possession(robot, player, match.step, k, tally, trail)
        count_standing(match, ball, robot, player.contact, k, tally, trail)
        count_moving(match, robot, r, player, k, tally)
    elif player.held_since > 0:
        end_spell(robot.team, player, k, tally)


@compiled
def touches_opponent(robots, r, k):
    """Tell whether robot r, which is in contact with somebody, touches an opponent: it may be a mate's legs alone."""
    near = 2.0 * k.body_reach + TOUCH_GAP
    for other in range(robots.shape[0]):
        if robots[other].team == robots[r].team or robots[other].active == 0:
            continue
        x, y = robots[other].x - robots[r].x, robots[other].y - robots[r].y
        if x * x + y * y < near * near and robots_touch(robots[r], robots[other], k):
            return True
    return False


@compiled
def count_touch(team, player, step, k, tally):
    """Count a touch, unless the robot touched the ball shortly before."""
    if (step - player.touched - 1) * k.dt > AGAIN + 0.5 * k.dt:
        tally.touches[team] += 1
    player.touched = step


@compiled
def count_possession(robot, player, step, k, tally, trail):
    """Begin, go on with or end the spell of a robot."""
    if robot.has_ball == 0:
        if (step - player.held_last) * k.dt > LOST + 0.5 * k.dt:
            end_spell(robot.team, player, k, tally)
        return
    trail.has_ball |= 1 << robot.team
    if player.held_since == 0:
        player.held_since = step
    player.held_last = step


@compiled
def end_spell(team, player, k, tally):
    """Count the spell of a robot that has lost the ball."""
    player.held_steps = player.held_last - player.held_since + 1
    player.held_since = 0
    seconds = player.held_steps * k.dt
    tally.spells[team] += 1
    tally.spell_time[team] += seconds
    tally.longest_spell[team] = max(tally.longest_spell[team], seconds)
    place = int(BINS_PER_OCTAVE * log2(max(seconds, SHORTEST) / SHORTEST) + 1e-9)
    tally.spell_lengths[team, min(place, BINS - 1)] += 1


@compiled
def count_standing(match, ball, robot, contact, k, tally, trail):
    """Count where a robot stands: about the ball, idle, or as a goalkeeper; note its team's nearest to the ball.

    `contact` is the last step in which it touched an opponent.
    """
    team, counts = robot.team, 0
    x, y, near = robot.x - ball.x, robot.y - ball.y, k.body_reach + k.ball_radius + MARGIN
    squared = x * x + y * y
    if squared < near * near:
        trail.crowd += 1
    if robot.keeper == 1:
        count_keeper(match, robot, contact, k, tally, trail)
    else:
        slow = SLOW_LEGS if k.drive_kind == GAIT else SLOW_WHEELS
        counts = 2 if robot.vx * robot.vx + robot.vy * robot.vy < slow * slow else 1
        tally.mates[team] += k.dt
        if counts == 2:
            tally.idle[team] += k.dt
    if squared < trail.nearest[team]:
        trail.nearest[team], trail.nearest_counts[team] = squared, counts


@compiled
def count_keeper(match, robot, contact, k, tally, trail):
    """Count a goalkeeper's time away from its goal and in it, and note that it is being pushed."""
    ahead = direction_of(match, robot.team) * robot.x + 0.5 * k.pitch_length  # of its goal line
    far = FAR * k.pitch_length
    if ahead * ahead + robot.y * robot.y > far * far:
        tally.keeper_away[robot.team] += k.dt
    elif ahead < 0.0:
        tally.keeper_in_goal[robot.team] += k.dt
    if robot.locked >= PUSHED - 0.5 * k.dt and (match.step - contact) * k.dt < PUSHED:
        trail.keeper_pushed[robot.team] = match.step


@compiled
def share_out(step, k, tally, trail):
    """Count possession and scrums of a step in play; a team's nearest robot is no idle mate, whatever it does."""
    if trail.has_ball == 3:
        tally.both += k.dt
    elif trail.has_ball > 0:
        tally.possession[HOME if trail.has_ball == 1 else AWAY] += k.dt
    if trail.crowd >= CROWD:
        tally.scrum += k.dt
        trail.crowded = step
    for team in range(2):
        if trail.nearest_counts[team] >= 1:
            tally.mates[team] -= k.dt
        if trail.nearest_counts[team] == 2:
            tally.idle[team] -= k.dt
        trail.nearest[team], trail.nearest_counts[team] = NOBODY, 0
    trail.crowd = trail.has_ball = 0
