"""Who stands though its place or the ball is out of its reach goes a quarter round the ball and tries from there.

Plans end before a ring of robots, and whoever holds off an opponent with the ball waits for it to move: both may last.

`k`: the league's constants; `play`: the team's settings.
"""

from math import atan2

from soccer_env.baselines.heinemann_2006.driving import drive_to
from soccer_env.compiled import compiled
from soccer_env.geometry import clip, length
from soccer_env.skills.deciding import PLAY
from soccer_env.skills.sight import side_of

PATIENCE = 5.0  # [s] of standing, assumed
DETOUR = 2.0  # [s] of going round, assumed
STAYS = 0.6  # [m] within which a robot stands that does not get there, assumed: wheels that spin tell it nothing
LEAST_RADIUS = 1.2  # [m] about the ball, assumed


@compiled
def note_standing(told, memory, sight):
    """Note for how long a field player has stood in play without the ball and away from its place."""
    memory.detour = max(memory.detour - sight.elapsed, 0.0)
    waits = (memory.arrived == 1 and memory.skill.rank > 0) or sight.held == 1
    if waits or told.phase != PLAY or length(sight.x - memory.stands_x, sight.y - memory.stands_y) > STAYS:
        memory.stood, memory.stands_x, memory.stands_y = 0.0, sight.x, sight.y
    memory.stood += sight.elapsed
    if memory.stood > PATIENCE:
        memory.stood, memory.detour = 0.0, DETOUR
        if memory.detour_side == 0.0:
            memory.detour_side = side_of(sight.y - sight.ball_y)


@compiled
def go_round(command, memory, k, play, scratch):
    """Drive a quarter round the ball, always to the same side."""
    sight = scratch.sight
    x, y = sight.x - sight.ball_x, sight.y - sight.ball_y
    away = max(length(x, y), 1e-6)
    far = memory.detour_side * max(away, LEAST_RADIUS) / away
    edge_x, edge_y = 0.5 * k.pitch_length, 0.5 * k.pitch_width
    to_x, to_y = clip(sight.ball_x - far * y, -edge_x, edge_x), clip(sight.ball_y + far * x, -edge_y, edge_y)
    drive_to(command, memory, k, play, scratch, to_x, to_y, atan2(-y, -x), 0.0)
