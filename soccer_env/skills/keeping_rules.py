"""How field players keep the legged league's rules: out of their own penalty area, and no shoving.

Only the goalkeeper plays a ball in the own area: an attacker waits at the area's edge, and a player inside leaves it
by the shortest way. A player that has walked into an opponent for nearly the allowed time steps back. The player
nearest to the ball may push opponents on its way to the ball, but never a goalkeeper in its area.

`k`: the league's constants; `play`: the team's settings.
"""

from math import inf

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, into_frame, length, out_of_frame
from soccer_env.skills.moves import go, push
from soccer_env.skills.sight import side_of

ROOM = 0.08  # [m] more than its reach that a field player keeps off its own area, assumed
WAIT = 0.35  # [m] from a ball in the own area at which an attacker waits for it, assumed
TOUCH = 1.8  # [body reaches] between the centres of two robots that are taken to touch, assumed
PRESS = 0.25  # [1] of the top speed towards another above which a robot walks into it, as the referee has it
AHEAD = 0.6  # [rad] off straight ahead within which the ranger meets a robot behind the ball, assumed
SHORTEST = 0.25  # [s] of a push, always allowed, assumed


@compiled
def may_not_enter(situation, k):
    """Tell whether a player is a field player that has to keep out of its own penalty area."""
    return k.rules_illegal_defender == 1 and situation.keeper == 0 and situation.teammates > 0


@compiled
def is_in_own_area(x, y, k, room):
    """Tell whether a point (x, y) [m] lies in the own penalty area or less than `room` [m] from it."""
    return x < k.pitch_penalty_depth - 0.5 * k.pitch_length + room and abs(y) < 0.5 * k.pitch_penalty_width + room


@compiled
def out_of_own_area(x, y, k, room):
    """Return the point [m] nearest to (x, y) that is `room` [m] outside the own penalty area."""
    ahead = k.pitch_penalty_depth - 0.5 * k.pitch_length + room - x
    aside = 0.5 * k.pitch_penalty_width + room - abs(y)
    if ahead <= 0.0 or aside <= 0.0:
        return x, y
    fits = 0.5 * k.pitch_penalty_width + 2.0 * room < 0.5 * k.pitch_width
    return (x, y + side_of(y) * aside) if fits and aside < ahead else (x + ahead, y)


@compiled
def leave_area(command, sight, k, play):
    """Walk out of the own penalty area by the shortest way; return whether the player's body reached into it."""
    if not is_in_own_area(sight.x, sight.y, k, k.body_reach):
        return False
    x, y = out_of_own_area(sight.x, sight.y, k, k.body_reach + ROOM)
    facing = atan2(sight.ball_y - sight.y, sight.ball_x - sight.x)
    go(command, sight, k, play, x, y, facing, k.drive_forward)
    ahead, left = into_frame(x - sight.x, y - sight.y, sight.cosine, sight.sine)
    away = max(length(ahead, left), 1e-6)
    push(command, sight, k, ahead / away, left / away, k.drive_forward)  # backwards too: turning first takes too long
    return True


@compiled
def wait_at_area(command, sight, k, play):
    """Wait at the edge of the own area, out of the goalkeeper's way, for the ball that the goalkeeper has to clear."""
    x, y = sight.ball_x + 0.5 * k.pitch_length, sight.ball_y
    away = max(length(x, y), 1e-6)
    x, y = sight.ball_x + WAIT * x / away, sight.ball_y + WAIT * side_of(y) * max(abs(y) / away, 0.5)
    edge = 0.5 * k.pitch_width - k.body_reach
    x, y = out_of_own_area(x, min(max(y, -edge), edge), k, k.body_reach + ROOM)
    go(command, sight, k, play, x, y, atan2(sight.ball_y - sight.y, sight.ball_x - sight.x), 0.0)


@compiled
def avoid_pushing_foul(obstacle, command, sight, memory, k, retreat):
    """Step back from an opponent that the player has walked into, `retreat` [s] before the allowed time is over.

    A player that looks down at the ball does not see a robot behind the ball, and robots do not feel contacts: near the
    opponents' goal a player walks on with the ball for a while, then stands for as long.
    """
    if k.rules_pushing + k.rules_keeper_pushing == 0 or k.legs + k.walled == 0:
        return
    if memory.back_off > 0.0:
        memory.back_off -= sight.elapsed
        memory.pressed = max(memory.pressed - sight.elapsed, 0.0)
        if command.kick <= 0.0:
            ahead, left = into_frame(memory.off_x, memory.off_y, sight.cosine, sight.sine)
            push(command, sight, k, ahead, left, k.drive_forward)
        return
    slot, allowed = walks_into(command, sight, k)
    x, y = 0.0, 0.0
    if slot >= 0:
        x, y = sight.x - sight.other_x[slot], sight.y - sight.other_y[slot]
    if may_meet_keeper(obstacle, command, sight, memory, k):
        slot, allowed = 0, min(allowed, k.rules_keeper_pushing_time)
    memory.pressed = memory.pressed + sight.elapsed if slot >= 0 else max(memory.pressed - sight.elapsed, 0.0)
    if slot >= 0 and memory.pressed > max(allowed - retreat, SHORTEST):
        away = max(length(x, y), 1e-6)
        memory.off_x, memory.off_y = x / away, y / away
        memory.back_off = memory.pressed + k.drive_forward / k.drive_acceleration  # and until its legs have stopped


@compiled
def may_meet_keeper(obstacle, command, sight, memory, k):
    """Tell whether the player walks with a ball at its feet near the opponents' goal, where it may meet a keeper."""
    if k.rules_keeper_pushing == 0 or memory.sweep > 0.0 or command.forward < PRESS:
        return False
    if not is_in_own_area(-sight.ball_x, sight.ball_y, k, k.body_reach):
        return False
    near = 0.0 < obstacle.distance < TOUCH * k.body_reach and abs(obstacle.bearing) < AHEAD
    return near or sight.distance < sight.touch + k.ball_radius


@compiled
def walks_into(command, sight, k):
    """Return the index of the opponent that the player walks into, -1 for none, and the allowed time [s]."""
    slot, allowed, near = -1, inf, TOUCH * k.body_reach
    exempt = sight.distance < k.rules_pushing_exempt and is_nearest(sight)
    ahead, left = command.forward * k.drive_forward, command.left * k.drive_sideways
    walk_x, walk_y = out_of_frame(ahead, left, sight.cosine, sight.sine)
    for i in range(sight.others):
        x, y = sight.other_x[i] - sight.x, sight.other_y[i] - sight.y
        away = max(length(x, y), 1e-6)
        if sight.mate[i] == 1 or walk_x * x + walk_y * y < PRESS * k.drive_forward * away:
            continue
        keeps = k.rules_keeper_pushing == 1 and is_in_own_area(-sight.other_x[i], sight.other_y[i], k, 0.0)
        time = k.rules_keeper_pushing_time if keeps else (inf if exempt else k.rules_pushing_time)
        far = near + 2.0 * k.ball_radius if keeps and sight.held == 1 else near  # through the ball counts as well
        if away < far and time < allowed:
            slot, allowed = i, time
    return slot, allowed


@compiled
def is_nearest(sight):
    """Tell whether no team-mate is nearer to the ball."""
    for i in range(sight.others):
        x, y = sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y
        if sight.mate[i] == 1 and length(x, y) < sight.distance:
            return False
    return True
