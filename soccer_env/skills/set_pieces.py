"""The chaser's restarts where the taker may not touch the ball twice: pass to a mate, then keep off the ball.

A player remembers the restart of its own team for a while: the taker keeps off the ball until somebody else has
touched it, and the taker's nearest mate goes for the ball.

`k`: the league's constants; `play`: the team's settings.
"""

from math import sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, length, wrap
from soccer_env.skills.deciding import PLAY
from soccer_env.skills.moves import go, turn_by
from soccer_env.skills.sight import side_of
from soccer_env.types import Phase

PENALTY_KICK = int(Phase.PENALTY_KICK)
KICK_OFF = int(Phase.KICK_OFF)
KEPT = 8.0  # [s] for which a restart is remembered at most, assumed
WAIT = 0.5  # [s] that the taker lets its mates stand before it passes, assumed
HURRY = 5.0  # [s] after which anybody takes it, assumed
PASS = 2.0  # [m] of a pass, to where the referee lets a mate stand, assumed
TAP = 1.0  # [m] of a kick-off, assumed
ARRIVAL = 0.8  # [m/s] of a pass, assumed
STEP = 0.4  # [m/s] at which the taker steps up to the ball, assumed
TOUCHED = 0.12  # [m] between ball and front of another player that has it, assumed
HAS = 0.45  # [m] from the ball within which an opponent has it, assumed
HOLDS_OFF = 0.9  # [m] from a ball that an opponent has at which a player stands before its goal, assumed
DEFEND = 3.0  # [m] from the own goal line within which it goes for the ball all the same, assumed
OFF = 3.0  # [body reaches] that the taker leaves to the ball, assumed
PASSES_BY = 0.1  # [m] that a supporter on its way leaves between itself and the ball, assumed


@compiled
def note_set_piece(situation, sight, memory, k):
    """Remember the own team's restart and the player's part, in memory: above 0 taker, below 0 mate, 0 neither."""
    if k.rules_second_touch == 0 or situation.phase == PENALTY_KICK:
        memory.set_piece = 0.0
    elif situation.phase != PLAY:
        if situation.ours <= 0.0 or situation.placing == 1:
            memory.set_piece = 0.0
        elif situation.phase_clock < HURRY:
            memory.set_piece = KEPT if memory.rank == 0 else -KEPT
    elif memory.set_piece != 0.0:
        left = max(abs(memory.set_piece) - sight.elapsed, 0.0)
        memory.set_piece = left if memory.set_piece > 0.0 else -left
        near = sight.distance < sight.touch + TOUCHED
        if other_has_ball(sight) or (near and memory.set_piece < 0.0):
            memory.set_piece = 0.0


@compiled
def other_has_ball(sight):
    """Tell whether another player touches the ball or nearly does."""
    for i in range(sight.others):
        if length(sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y) < sight.touch + TOUCHED:
            return True
    return False


@compiled
def take_restart(command, situation, sight, k, play):
    """Pass the ball straight ahead, to where a mate stands."""
    if situation.phase_clock < WAIT:
        return
    far = TAP if situation.phase == KICK_OFF else PASS
    command.kick = kick_strength_for(k, far, ARRIVAL if far == PASS else 0.0)
    if sight.held == 0:
        command.forward = STEP / k.drive_forward
        turn_by(command, sight, k, play, clip(sight.bearing, -0.3, 0.3))


@compiled
def kick_strength_for(k, far, arrival):
    """Return the strength of a kick [1] after which the ball rolls past a distance [m] at a speed [m/s].

    The distance over which the ball first slides is left out.
    """
    speed = sqrt(arrival * arrival + 2.0 * k.ball_rolling * far) * (1.0 + k.ball_shell)
    share = (speed - k.kicker_slowest) / (k.kicker_fastest - k.kicker_slowest)
    return clip(share, max(k.kicker_least, 0.02), 1.0)


@compiled
def wait_for_pass(command, sight, k, play):
    """Stand and face the ball."""
    turn_by(command, sight, k, play, wrap(atan2(sight.ball_y - sight.y, sight.ball_x - sight.x) - sight.heading))


@compiled
def leave_ball(command, sight, k, play):
    """Move straight away from the ball and face it."""
    x, y = sight.x - sight.ball_x, sight.y - sight.ball_y
    away = max(length(x, y), 1e-6)
    far = max(OFF * k.body_reach, away) / away
    edge_x, edge_y = 0.5 * k.pitch_length, 0.5 * k.pitch_width
    to_x = clip(sight.ball_x + far * x, -edge_x, edge_x)
    to_y = clip(sight.ball_y + far * y, -edge_y, edge_y)
    go(command, sight, k, play, to_x, to_y, atan2(-y, -x), 0.0)


@compiled
def move_out_of_area(sight, k, x, y, ring):
    """Return a supporter's place [m, m] moved out of its own penalty area, at least `ring` [m] from the ball."""
    if k.rules_penalty_area == 0 or abs(y) > 0.5 * k.pitch_penalty_width + k.body_reach:
        return x, y
    x = max(x, k.pitch_penalty_depth + k.body_reach - 0.5 * k.pitch_length)
    if length(x - sight.ball_x, y - sight.ball_y) < ring:
        y = sight.ball_y + (ring if y > sight.ball_y else -ring)
    return x, y


@compiled
def waypoint_round_ball(sight, k, x, y):
    """Return the point [m, m] to pass first on the way to (x, y), so that a supporter does not run into the ball.

    A player that runs back past the ball would otherwise push it towards its own goal.
    """
    far = max(length(x - sight.x, y - sight.y), 1e-6)
    ux, uy = (x - sight.x) / far, (y - sight.y) / far
    ball_x, ball_y = sight.ball_x - sight.x, sight.ball_y - sight.y
    along, across = ux * ball_x + uy * ball_y, ux * ball_y - uy * ball_x
    room = k.body_reach + k.ball_radius + PASSES_BY
    if k.walled == 1 or along < 0.0 or along > far or abs(across) > room:
        return x, y
    aside = -side_of(across) * room
    return sight.ball_x - aside * uy, sight.ball_y + aside * ux


@compiled
def should_block_opponent(sight, k):
    """Tell whether to block an opponent that has the ball rather than fight for the ball, which would be a foul."""
    if k.rules_charging == 0 or sight.ball_x < DEFEND - 0.5 * k.pitch_length:
        return False
    for i in range(sight.others):
        away = length(sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y)
        if sight.mate[i] == 0 and away < min(HAS, sight.distance - 0.1):
            return True
    return False
