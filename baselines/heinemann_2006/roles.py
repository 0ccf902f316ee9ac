"""Choice of attacker, defender and supporters: each player decides from the shared beliefs, with hysteresis.  MH23

The attacker is the field player with the shortest path to behind the ball or, if the ball rolls, the player that can
meet it first; the defender is the other player nearest to a place between ball and goal; the rest support.
The shared skills read `skill.rank`: 0 attacks, 1 defends, 2 and on support in pairs.

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.baselines.heinemann_2006.intercepting import meeting_time
from soccer_env.baselines.heinemann_2006.memory import ATTACKER, DEFENDER, SUPPORTER
from soccer_env.compiled import compiled
from soccer_env.geometry import length
from soccer_env.skills.supporting import path_length_to_ball

ROLLS = 0.8  # [m/s] from which a ball is met where it rolls to, assumed
MOUTH = 2.0  # [m] before the middle of the goal that a defender's place is reckoned from, assumed


@compiled
def choose_role(sight, memory, k, play):
    """Adopt the rank that `right_rank` returns, and its role, once that rank has been stable for long enough."""
    rank = right_rank(sight, memory, k, play)
    memory.role_age = memory.role_age + sight.elapsed if rank != memory.skill.rank else 0.0
    if memory.role_age > play.role_time or memory.begun == 0:
        memory.skill.rank, memory.role_age, memory.begun = rank, 0.0, 1
    memory.role = ATTACKER if memory.skill.rank == 0 else (DEFENDER if memory.skill.rank == 1 else SUPPORTER)


@compiled
def right_rank(sight, memory, k, play):
    """Compute the player's present rank: 0 attacks, 1 defends, 2 and up support."""
    keeps = play.role_gain
    own = way_there(sight, k, play, sight.x, sight.y, sight.vx, sight.vy)
    own -= keeps if memory.begun == 1 and memory.skill.rank == 0 else 0.0
    first, least = -1, own
    for i in range(sight.others):
        if sight.mate[i] == 1 and sight.field[i] == 1:
            x, y, vx, vy = sight.other_x[i], sight.other_y[i], sight.other_vx[i], sight.other_vy[i]
            way = way_there(sight, k, play, x, y, vx, vy)
            if way < least:
                first, least = i, way
    if first < 0:
        return 0
    mine = distance_to_defender_place(sight.x, sight.y, sight, k)
    mine -= keeps if memory.skill.rank == 1 else 0.0
    rank = 1
    for i in range(sight.others):
        counts = sight.mate[i] == 1 and sight.field[i] == 1 and i != first
        if counts and distance_to_defender_place(sight.other_x[i], sight.other_y[i], sight, k) < mine:
            rank += 1
    return rank


@compiled
def way_there(sight, k, play, x, y, vx, vy):
    """Return a player's path length [m] to the ball; to a rolling ball, the meeting time times top speed.  MH22"""
    if play.intercepts == 0 or length(sight.ball_vx, sight.ball_vy) < ROLLS:
        return path_length_to_ball(sight, play.skills, x, y, vx, vy)
    return k.drive_forward * meeting_time(sight, x, y, vx, vy, play.lead, k)


@compiled
def distance_to_defender_place(x, y, sight, k):
    """Return the distance [m] from (x, y) to the defender's place, half-way between ball and own goal."""
    place_x, place_y = 0.5 * (sight.ball_x - 0.5 * k.pitch_length + MOUTH), 0.5 * sight.ball_y
    return length(x - place_x, y - place_y)
