"""The actions of a player of heinemann-2006: restarts first, then its role.  MH05, MH23

A player that has stood still for long, away from its place and without the ball, drives a quarter circle round the
ball: a path may end at a ring of robots, or a player may wait for an opponent to move, and both may last.

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.baselines.heinemann_2006.attacking import attack
from soccer_env.baselines.heinemann_2006.driving import drive_to
from soccer_env.baselines.heinemann_2006.goalkeeper import keep_goal
from soccer_env.baselines.heinemann_2006.memory import KEEPER
from soccer_env.baselines.heinemann_2006.passing import open_place, own_team_is_nearer
from soccer_env.baselines.heinemann_2006.roles import choose_role
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, length
from soccer_env.skills.attacking import ball_comes_to_me, receive_ball, time_stuck_ball
from soccer_env.skills.deciding import PLAY, required_ball_distance
from soccer_env.skills.searching import LOST, end_search, search_for_ball
from soccer_env.skills.set_pieces import (
    HOLDS_OFF,
    leave_ball,
    note_set_piece,
    should_block_opponent,
    take_restart,
    wait_for_pass,
    waypoint_round_ball,
)
from soccer_env.skills.sight import side_of
from soccer_env.skills.supporting import support_point

SAME_TIME = 1e-6  # [s] less than a control step: sums of steps differ by rounding
PATIENCE = 5.0  # [s] of standing, assumed
DETOUR = 2.0  # [s] of going round, assumed
STAYS = 0.6  # [m] within which a robot counts as standing, assumed: spinning wheels tell it nothing
LEAST_RADIUS = 1.2  # [m] about the ball, assumed


@compiled
def decide(belief, command, memory, noise, k, play, scratch):
    """Play the player's present role; search for the ball if the player has not seen it for a while."""
    sight, told = scratch.sight, scratch.told
    hear(belief.situation, told, memory, sight, play)
    memory.drove = max(memory.drove - 1, 0)
    if belief.ball.age > LOST:
        search_for_ball(belief, command, sight, memory.skill, k, play.skills)
        return
    end_search(memory.skill)
    if belief.situation.keeper == 1:
        memory.role = KEEPER
        keep_goal(command, memory, k, play, scratch)
    else:
        choose_role(sight, memory, k, play)
        note_set_piece(told, sight, memory.skill, k)
        time_stuck_ball(sight, memory.skill, noise, k, play.skills)
        note_standing(told, memory, sight)
        memory.arrived = 0
        play_role(told, command, memory, k, play, scratch)


@compiled
def hear(situation, told, memory, sight, play):
    """Write the state of the match that the referee box sent by radio, with the radio's delay, into `told`.  MH05"""
    heard, said = memory.heard, memory.said
    memory.said_age = 0.0 if is_new_call(situation, said) else memory.said_age + sight.elapsed
    said.phase, said.placing = situation.phase, situation.placing
    said.ours, said.clock = situation.ours, situation.phase_clock
    heard.clock += sight.elapsed
    if memory.listens == 0 or memory.said_age > play.word_delay - SAME_TIME:
        heard.phase, heard.placing, heard.ours = said.phase, said.placing, said.ours
        heard.clock, memory.listens = max(said.clock - play.word_delay, 0.0), 1
    told.keeper, told.teammates = situation.keeper, situation.teammates
    told.phase, told.placing, told.ours, told.phase_clock = heard.phase, heard.placing, heard.ours, heard.clock


@compiled
def is_new_call(situation, said):
    """Tell whether the referee has made a new call since the last call that the player heard."""
    same = situation.phase == said.phase and situation.placing == said.placing and situation.ours == said.ours
    return not same or situation.phase_clock < said.clock


@compiled
def play_role(situation, command, memory, k, play, scratch):
    """Play as a field player: take part in a restart, else play the role."""
    sight, skill = scratch.sight, memory.skill
    if skill.set_piece != 0.0 and situation.phase != PLAY:
        if skill.set_piece > 0.0:
            take_restart(command, situation, sight, k, play.skills)
        else:
            wait_for_pass(command, sight, k, play.skills)
    elif memory.detour > 0.0 and situation.phase == PLAY:
        drive_round_ball(command, memory, k, play, scratch)
    elif skill.set_piece > 0.0:
        leave_ball(command, sight, k, play.skills)
    elif skill.rank > 0 and play.intercepts == 1 and situation.phase == PLAY and ball_comes_to_me(sight, k):
        receive_ball(command, sight, k, play.skills)
    elif skill.rank > (1 if skill.set_piece < 0.0 else 0) or (situation.phase != PLAY and situation.ours < 0.0):
        stand_ready(command, memory, k, play, scratch, required_ball_distance(situation, k))
    elif should_block_opponent(sight, k):
        stand_ready(command, memory, k, play, scratch, HOLDS_OFF)
    else:
        attack(command, memory, k, play, scratch)


@compiled
def stand_ready(command, memory, k, play, scratch, ring):
    """Drive to the role's position, at least `ring` [m] from the ball, facing the ball all the time."""
    sight = scratch.sight
    x, y = support_point(sight, memory.skill, k, play.skills, ring, False)
    if play.stands_open == 1 and ring == 0.0 and memory.skill.rank >= 2 and own_team_is_nearer(sight):
        x, y = open_place(sight, memory.skill, k)
        x, y = waypoint_round_ball(sight, k, x, y)
    drive_to(command, memory, k, play, scratch, x, y, atan2(sight.ball_y - sight.y, sight.ball_x - sight.x), 0.0)


@compiled
def note_standing(situation, memory, sight):
    """Update the time for which a field player has stood still in play, without the ball and out of position."""
    memory.detour = max(memory.detour - sight.elapsed, 0.0)
    waits = (memory.arrived == 1 and memory.skill.rank > 0) or sight.held == 1
    if waits or situation.phase != PLAY or length(sight.x - memory.stands_x, sight.y - memory.stands_y) > STAYS:
        memory.stood, memory.stands_x, memory.stands_y = 0.0, sight.x, sight.y
    memory.stood += sight.elapsed
    if memory.stood > PATIENCE:
        memory.stood, memory.detour = 0.0, DETOUR
        if memory.detour_side == 0.0:
            memory.detour_side = side_of(sight.y - sight.ball_y)


@compiled
def drive_round_ball(command, memory, k, play, scratch):
    """Drive a quarter round the ball, always to the same side."""
    sight = scratch.sight
    x, y = sight.x - sight.ball_x, sight.y - sight.ball_y
    away = max(length(x, y), 1e-6)
    far = memory.detour_side * max(away, LEAST_RADIUS) / away
    edge_x, edge_y = 0.5 * k.pitch_length, 0.5 * k.pitch_width
    to_x, to_y = clip(sight.ball_x - far * y, -edge_x, edge_x), clip(sight.ball_y + far * x, -edge_y, edge_y)
    drive_to(command, memory, k, play, scratch, to_x, to_y, atan2(-y, -x), 0.0)
