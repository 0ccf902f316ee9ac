"""Supporters: who supports whom, by the distance to the ball, and their places behind it, spread out in pairs.

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, length
from soccer_env.skills.keeping_rules import ROOM as AREA_ROOM
from soccer_env.skills.keeping_rules import out_of_own_area
from soccer_env.skills.moves import go
from soccer_env.skills.set_pieces import move_out_of_area, waypoint_round_ball
from soccer_env.skills.sight import side_of

ROOM = 2.5  # [body reaches] between the first two players that keep away from the opponents' restart, assumed
HOME_EDGE = 3.0  # [body reaches] that supporters stay off the goal lines, assumed


@compiled
def support(command, sight, memory, k, play, ring, keeps_out):
    """Stand at the supporter's place for the player's rank, and face the ball; arguments as in `support_point`."""
    x, y = support_point(sight, memory, k, play, ring, keeps_out)
    go(command, sight, k, play, x, y, atan2(sight.ball_y - sight.y, sight.ball_x - sight.x), 0.0)


@compiled
def support_point(sight, memory, k, play, ring, keeps_out):
    """Return the supporter's place [m, m] for a rank, `ring` [m] from the ball; `keeps_out`: not in the own area."""
    if memory.side == 0.0 or abs(sight.ball_y) > play.change_side:
        memory.side = -side_of(sight.ball_y)
    back, aside = offset_of_rank(memory, play, ring)
    home_x, home_y = -0.5 * k.pitch_length - sight.ball_x, -sight.ball_y
    away = max(length(home_x, home_y), 1e-6)
    home_x, home_y = home_x / away, home_y / away
    off_x, off_y = back * home_x + aside * home_y, back * home_y - aside * home_x
    ring += ROOM * k.body_reach * min(memory.rank, 1)
    stretch = max(ring / length(off_x, off_y), 1.0) if ring > 0.0 else 1.0
    edge_x, edge_y = 0.5 * k.pitch_length - HOME_EDGE * k.body_reach, 0.5 * k.pitch_width - k.body_reach
    x = clip(sight.ball_x + stretch * off_x, -edge_x, edge_x)
    y = clip(sight.ball_y + stretch * off_y, -edge_y, edge_y)
    if keeps_out:
        x, y = out_of_own_area(x, y, k, k.body_reach + AREA_ROOM)
    if memory.rank > 0 or ring == 0.0:
        x, y = move_out_of_area(sight, k, x, y, ring)
    return waypoint_round_ball(sight, k, x, y)


@compiled
def offset_of_rank(memory, play, ring):
    """Return a rank's distances [m] from the ball: back towards the own goal, and to the left of that direction.

                3            ball  ->  opponents' goal       rank 0 goes to the ball, or stands right before it
    5                1   (0)           (mirrored while the   while the opponents take a restart; 1 covers the goal;
                2                      ball is on the left)  the others follow in pairs, one on either side
    """
    if memory.rank < 2:
        return (ring if memory.rank == 0 else play.cover), 0.0
    pair = memory.rank // 2
    side = memory.side if memory.rank % 2 == 0 else -memory.side
    return play.back * (pair - 0.5), side * play.aside


@compiled
def path_length_to_ball(sight, play, x, y, vx, vy):
    """Return the length [m] of a player's path to the point behind the ball, shortened if it runs towards the ball."""
    ahead, left = sight.ball_x - x, sight.ball_y - y
    away = max(length(ahead, left), 1e-6)
    return away + play.wrong_side * max(-ahead / away, 0.0) - play.foresight * (vx * ahead + vy * left) / away


@compiled
def choose_rank(sight, memory, play):
    """Update the player's rank, the number of field team-mates nearer to the ball, once a change has lasted."""
    own = path_length_to_ball(sight, play, sight.x, sight.y, sight.vx, sight.vy)
    rank = 0
    for i in range(sight.others):
        if sight.mate[i] == 1 and sight.field[i] == 1:
            other = path_length_to_ball(
                sight, play, sight.other_x[i], sight.other_y[i], sight.other_vx[i], sight.other_vy[i]
            )
            if other < own:
                rank += 1
    memory.rank_age = memory.rank_age + sight.elapsed if rank != memory.rank else 0.0
    if memory.rank_age > play.rank_time or memory.patience == 0.0:
        memory.rank, memory.rank_age = rank, 0.0
