"""Count how robots move in play: distance covered, time stuck, where each of them is.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import direction_of, length
from soccer_env.statistics.maps import note_place
from soccer_env.statistics.records import LOOK

WANTS = 0.15  # [1] of the top speed: who aims at less does not want to get anywhere, assumed
MAKES = 0.25  # [1] of the walk that it aims at: who is slower is stopped, assumed
STUCK = 1.5  # [s] for which a robot is stopped before it is stuck, assumed
BREAK = 0.5  # [s] of getting on that do not end it: a gait step, assumed


@compiled
def count_moving(match, robot, r, player, k, tally):
    """Count what robot r, on the pitch with the ball in play, does with its legs or wheels in a control step."""
    team = robot.team
    tally.present[team] += k.dt
    if player.seen == match.step - 1 and robot.placed == 0:
        tally.distance[team] += length(robot.x - player.x, robot.y - player.y)
    player.seen, player.x, player.y = match.step, robot.x, robot.y
    if is_stopped(robot, k):
        count_stuck(team, match.step, player, k, tally)
    if match.step % LOOK == 0:
        look(robot, r, direction_of(match, team), k, tally.maps)


@compiled
def look(robot, r, direction, k, maps):
    """Note where robot r is, for the time until the next look."""
    note_place(robot, robot.team, direction, k, maps)
    maps.places[r, 0] += LOOK * k.dt * direction * robot.x
    maps.places[r, 1] += LOOK * k.dt * direction * robot.y
    maps.places[r, 2] += LOOK * k.dt


@compiled
def is_stopped(robot, k):
    """Tell whether a robot that can walk aims at a walk and makes less than a quarter of it."""
    made = robot.vx * robot.vx + robot.vy * robot.vy
    most = max(k.drive_forward, k.drive_backward) + k.drive_sideways
    if made >= MAKES * MAKES * most * most:  # whatever it aims at: the rest of the record is not needed
        return False
    ahead, left = robot.target.forward, robot.target.left
    wanted, least = ahead * ahead + left * left, WANTS * k.drive_forward
    return made < MAKES * MAKES * wanted and wanted > least * least and robot.kick_clock <= 0.0 and robot.fallen <= 0.0


@compiled
def count_stuck(team, step, player, k, tally):
    """Count a step in which a robot is stopped, with all since it began once that has lasted long enough."""
    if (step - player.stuck_last - 1) * k.dt > BREAK + 0.5 * k.dt:
        player.stuck_since, player.stuck_steps = step, 0
    player.stuck_last = step
    steps = step - player.stuck_since + 1
    if steps * k.dt >= STUCK - 0.5 * k.dt:
        tally.stuck[team] += (steps - player.stuck_steps) * k.dt
        player.stuck_steps = steps
