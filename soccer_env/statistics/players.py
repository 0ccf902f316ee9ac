"""Count the play of each robot in a control step: possession, spells, touches, idle mates, goalkeepers, motion.

`k`: the league's constants.
"""

from math import log2

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction, length
from soccer_env.leagues.robot import DRIVE_KINDS
from soccer_env.physics.contacts import TOUCH_GAP, robots_touch
from soccer_env.statistics.maps import note_place
from soccer_env.statistics.records import BINS, BINS_PER_OCTAVE, LOOK, NOBODY, SHORTEST
from soccer_env.types import AWAY, HOME, Phase

PLAY = int(Phase.PLAY)
GAIT = DRIVE_KINDS["gait"]
LOST = 0.5  # [s] without the ball after which a spell ends
AGAIN = 1.0  # [s] without a touch after which the next touch counts
CROWD = 3  # robots that make a scrum
MARGIN = 0.10  # [m] beyond the reach of a robot at the ball: 30 cm between centres in the legged league
SLOW_LEGS, SLOW_WHEELS = 0.01, 0.05  # [m/s] a slower mate is idle
PUSHED = 1.0  # [s] in contact after which a goalkeeper counts as pushed, rule book of 2008
FAR = 0.25  # [1] of the pitch's length: a goalkeeper farther from its goal is away
WANTS = 0.15  # [1] of the top speed: a robot that aims at less does not want to move, assumed
MAKES = 0.25  # [1] of the walk that a robot aims at: a slower robot is stopped, assumed
STUCK = 1.5  # [s] for which a robot is stopped before it is stuck, assumed
BREAK = 0.5  # [s] of moving on that do not end a time stuck: a gait step, assumed


@compiled
def count_player(match, ball, robots, events, r, k, tally):
    """Count the play of robot r in a control step; a spell of possession ends when play stops."""
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
        count_role_near_ball(match, ball, robot, player.contact, k, tally, trail)
        count_motion(match, robot, r, player, k, tally)
    elif player.held_since > 0:
        count_ended_spell(robot.team, player, k, tally)


@compiled
def touches_opponent(robots, r, k):
    """Tell whether robot r touches an opponent, rather than only the legs of a mate."""
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
    """Count a touch of the ball, unless the robot touched it shortly before."""
    if (step - player.touched - 1) * k.dt > AGAIN + 0.5 * k.dt:
        tally.touches[team] += 1
    player.touched = step


@compiled
def count_possession(robot, player, step, k, tally, trail):
    """Begin, continue or end a robot's spell of possession."""
    if robot.has_ball == 0:
        if (step - player.held_last) * k.dt > LOST + 0.5 * k.dt:
            count_ended_spell(robot.team, player, k, tally)
        return
    trail.has_ball |= 1 << robot.team
    if player.held_since == 0:
        player.held_since = step
    player.held_last = step


@compiled
def count_ended_spell(team, player, k, tally):
    """Count the spell of possession of a robot that has lost the ball."""
    player.held_steps = player.held_last - player.held_since + 1
    player.held_since = 0
    seconds = player.held_steps * k.dt
    tally.spells[team] += 1
    tally.spell_time[team] += seconds
    tally.longest_spell[team] = max(tally.longest_spell[team], seconds)
    place = int(BINS_PER_OCTAVE * log2(max(seconds, SHORTEST) / SHORTEST) + 1e-9)
    tally.spell_lengths[team, min(place, BINS - 1)] += 1


@compiled
def count_role_near_ball(match, ball, robot, contact, k, tally, trail):
    """Count a robot as near the ball, as an idle mate or as goalkeeper; note its team's nearest robot to the ball.

    `contact` is the last step in which the robot touched an opponent.
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
    """Count the time of a goalkeeper away from its goal and behind its goal line, and note whether it is pushed."""
    ahead = attack_direction(match, robot.team) * robot.x + 0.5 * k.pitch_length  # [m] ahead of its goal line
    far = FAR * k.pitch_length
    if ahead * ahead + robot.y * robot.y > far * far:
        tally.keeper_away[robot.team] += k.dt
    elif ahead < 0.0:
        tally.keeper_in_goal[robot.team] += k.dt
    if robot.locked >= PUSHED - 0.5 * k.dt and (match.step - contact) * k.dt < PUSHED:
        trail.keeper_pushed[robot.team] = match.step


@compiled
def count_possession_shares(step, k, tally, trail):
    """Count a step in play as possession or scrum, and do not count the nearest robots to the ball as idle mates."""
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


@compiled
def count_motion(match, robot, r, player, k, tally):
    """Count distance covered, time stuck and position of robot r, while on the pitch with the ball in play."""
    team = robot.team
    tally.present[team] += k.dt
    if player.seen == match.step - 1 and robot.placed == 0:
        tally.distance[team] += length(robot.x - player.x, robot.y - player.y)
    player.seen, player.x, player.y = match.step, robot.x, robot.y
    if is_stopped(robot, k):
        count_stuck(team, match.step, player, k, tally)
    if match.step % LOOK == 0:
        sample_position(robot, r, attack_direction(match, team), k, tally.maps)


@compiled
def sample_position(robot, r, direction, k, maps):
    """Add the position of robot r to the heat maps, for the time until its next sample."""
    note_place(robot, robot.team, direction, k, maps)
    maps.places[r, 0] += LOOK * k.dt * direction * robot.x
    maps.places[r, 1] += LOOK * k.dt * direction * robot.y
    maps.places[r, 2] += LOOK * k.dt


@compiled
def is_stopped(robot, k):
    """Tell whether a robot that wants to walk, and can, moves at less than a quarter of its target speed."""
    made = robot.vx * robot.vx + robot.vy * robot.vy
    most = max(k.drive_forward, k.drive_backward) + k.drive_sideways
    if made >= MAKES * MAKES * most * most:  # whatever it aims at; the target is not read
        return False
    ahead, left = robot.target.forward, robot.target.left
    wanted, least = ahead * ahead + left * left, WANTS * k.drive_forward
    return made < MAKES * MAKES * wanted and wanted > least * least and robot.kick_clock <= 0.0 and robot.fallen <= 0.0


@compiled
def count_stuck(team, step, player, k, tally):
    """Count a step in which a robot is stopped; once it counts as stuck, add all steps since it stopped."""
    if (step - player.stuck_last - 1) * k.dt > BREAK + 0.5 * k.dt:
        player.stuck_since, player.stuck_steps = step, 0
    player.stuck_last = step
    steps = step - player.stuck_since + 1
    if steps * k.dt >= STUCK - 0.5 * k.dt:
        tally.stuck[team] += (steps - player.stuck_steps) * k.dt
        player.stuck_steps = steps
