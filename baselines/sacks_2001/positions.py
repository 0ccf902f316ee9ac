"""The choice of the player that goes to the ball, and the positions of the others.  [Sacks 2001, 1]

Team-mates tell each other by loudspeaker how far they are from the ball, in words of four bits (MS06). A player that
believes itself nearer than the others say attacks; the others support.

`k`: the league's constants; `play`: the team's settings.
"""

from math import inf

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, length
from soccer_env.skills.keeping_rules import ROOM, may_not_enter, out_of_own_area
from soccer_env.skills.moves import go
from soccer_env.skills.sight import side_of

OLD_WORD = 2.5  # [s] after which a team-mate's word no longer counts, assumed
EDGE = 3.0  # [body reaches] that supporters stay off the goal lines, assumed
CHANGE_SIDE = 0.2  # [m] that the ball is off the middle before supporters change sides, assumed
ROW = 0.6  # [m] between one pair of supporters and the next behind it, assumed


@compiled
def choose_role(belief, memory, play, elapsed):
    """Choose to attack if no team-mate reports to be nearer to the ball; a new role must last for play.role_time."""
    ball, heard = belief.ball, belief.heard
    other = heard.distance if heard.age <= OLD_WORD else inf
    attacks = 1 if ball.filtered_distance <= other else 0
    if memory.clock == 0.0 and memory.role_clock < 0.0:
        memory.attacks, memory.role_clock = attacks, 0.0
    memory.role_clock = memory.role_clock + elapsed if attacks != memory.attacks else 0.0
    if memory.role_clock > play.role_time:
        memory.attacks, memory.role_clock = attacks, 0.0


@compiled
def support(command, sight, memory, situation, k, play, ring):
    """Stand behind and beside the ball, in pairs by number, at least `ring` [m] away, facing the ball."""
    if memory.side == 0.0 or abs(sight.ball_y) > CHANGE_SIDE:
        memory.side = -side_of(sight.ball_y)
    if ring > 0.0 and memory.attacks == 1:
        wait_for_restart(command, sight, k, play, ring)
        return
    pair = max(situation.number - 1, 0) // 2
    side = memory.side if situation.number % 2 == 0 or situation.teammates < 3 else -memory.side
    off_x, off_y = -(play.cover + ROW * pair), side * play.aside
    stretch = max(ring / length(off_x, off_y), 1.0) if ring > 0.0 else 1.0
    edge_x, edge_y = 0.5 * k.pitch_length - EDGE * k.body_reach, 0.5 * k.pitch_width - k.body_reach
    x = clip(sight.ball_x + stretch * off_x, -edge_x, edge_x)
    y = clip(sight.ball_y + stretch * off_y, -edge_y, edge_y)
    if play.keeps_out == 1 and may_not_enter(situation, k):
        x, y = out_of_own_area(x, y, k, k.body_reach + ROOM)
    go(command, sight, k, play, x, y, atan2(sight.ball_y - sight.y, sight.ball_x - sight.x), 0.0)


@compiled
def wait_for_restart(command, sight, k, play, ring):
    """Stand `ring` [m] from the ball, between the ball and the own goal."""
    home_x, home_y = -0.5 * k.pitch_length - sight.ball_x, -sight.ball_y
    away = max(length(home_x, home_y), 1e-6)
    x, y = sight.ball_x + ring * home_x / away, sight.ball_y + ring * home_y / away
    go(command, sight, k, play, x, y, atan2(sight.ball_y - sight.y, sight.ball_x - sight.x), 0.0)


@compiled
def go_home(command, sight, situation, k, play):
    """Go to the player's own position and face up the field, after a full turn did not find the ball."""
    half = 0.25 * k.pitch_width
    y = half if situation.number % 2 == 0 else -half
    x = -0.5 * k.pitch_length + EDGE * k.body_reach if situation.keeper == 1 else -0.15 * k.pitch_length
    go(command, sight, k, play, x, 0.0 if situation.keeper == 1 else y, 0.0, 0.0)
