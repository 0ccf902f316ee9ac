"""The chaser: a complete small scripted team for both leagues and any number of players.

Each player decides from its own belief and tracks. One ladder for each role:

    goalkeeper   meet a shot  >  clear the ball  >  guard the line from ball to goal            goalkeeping.py
    attacker     work a stuck ball out  >  turn with the ball  >  get behind it; shoot when it can  attacking.py
    supporter    keep the rules' distance  >  stand behind the ball, the next ones spread out   supporting.py
    field player out of the own area, no shoving                                            keeping_rules.py
    everybody    without a ball: turn round, then look from elsewhere                       searching.py
                 unsure where it is: look up from the ball for landmarks                    glancing.py

Who attacks: the field player that believes itself nearest to the ball, counting the path round it. `strength` from 0 to
1 scales the pace, how often a player decides, how straight it aims and how hard it kicks; at 1 nothing is drawn at
random but the patience with a stuck ball, so that mirrored beliefs give mirrored commands.

`k`: the league's constants; `play`: the team's settings.
"""

import numpy as np

from soccer_env.baselines.chaser.attacking import attack
from soccer_env.baselines.chaser.glancing import PHANTOM, look_up
from soccer_env.baselines.chaser.goalkeeping import keep_goal
from soccer_env.baselines.chaser.supporting import support
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, length, wrap
from soccer_env.guards.checking import check_finite_number, check_names
from soccer_env.guards.ranges import NUMBER, UNIT, ranged_record
from soccer_env.leagues.league import League
from soccer_env.random_numbers import draw_uniform
from soccer_env.skills.deciding import PLAY, TEAM, apply_strength, keep_decision, must_decide, required_ball_distance
from soccer_env.skills.keeping_rules import avoid_pushing_foul, is_in_own_area, leave_area, may_not_enter, wait_at_area
from soccer_env.skills.kicking import aim_kick, time_kick
from soccer_env.skills.searching import LOST, end_search, search_for_ball
from soccer_env.skills.set_pieces import (
    HOLDS_OFF,
    leave_ball,
    note_set_piece,
    should_block_opponent,
    take_restart,
    wait_for_pass,
)
from soccer_env.skills.settings import FOLLOWS as SKILLS_FOLLOW
from soccer_env.skills.settings import NUMBERS as SKILL_NUMBERS
from soccer_env.skills.settings import fitted, settings_rows
from soccer_env.skills.sight import SIGHT, fill_sight, side_of
from soccer_env.teams import CompiledTeam
from soccer_env.teams.kernels import per_player
from soccer_env.types import PLAYERS

MEMORY = ranged_record(
    [
        ("wait", "f8", NUMBER),  # [s] until the next decision
        ("rank", "i8", PLAYERS),  # field team-mates nearer to the ball: 0 the attacker
        ("rank_age", "f8", NUMBER),  # [s] for which another rank has been right
        ("side", "f8", UNIT),  # +1 supports on the left of the ball, -1 on its right, 0 undecided
        ("way", "f8", UNIT),  # +1 goes round the ball counter-clockwise, -1 clockwise
        ("aim_error", "f8", NUMBER),  # [rad]
        ("stuck", "f8", NUMBER),  # [s] that the ball at my feet has not moved
        ("patience", "f8", NUMBER),  # [s] of being stuck until it is worked out
        ("wriggle", "f8", NUMBER),  # [s] left of working it out
        ("wriggle_side", "f8", UNIT),  # +1 turning left, -1 right
        ("set_piece", "f8", NUMBER),  # [s] left of remembering our restart: above 0 as its taker, below 0 its mate
        ("sweep", "f8", NUMBER),  # [s] left of sweeping it out of a corner
        ("sweep_way", "f8", NUMBER),  # [rad] in which it is swept, team frame
        ("sweep_side", "f8", UNIT),  # +1 turning left, -1 right
        ("pressed", "f8", NUMBER),  # [s] for which the robot has walked into an opponent
        ("back_off", "f8", NUMBER),  # [s] left of stepping back from it
        ("off_x", "f8", NUMBER),  # unit vector away from it, team frame
        ("off_y", "f8", NUMBER),
        ("search_side", "f8", UNIT),  # +1 searches turning left, -1 right, 0 knows the ball
        ("turned", "f8", NUMBER),  # [rad] since it began to turn on the spot
        ("search_clock", "f8", NUMBER),  # [s] on the way to a lookout
        ("lookout", "f8", NUMBER),  # [m] x of it, team frame
        ("look_side", "f8", UNIT),  # +1 the head began to search on the left, -1 right, 0 knows the ball
        ("look_clock", "f8", NUMBER),  # [s] in the head's two sweeps
        ("phantom", "f8", NUMBER),  # [s] for which the ball was seen only where it cannot be
        ("glance", "f8", NUMBER),  # [s] left of looking up from the ball; below 0 until the next look
        ("glance_side", "f8", UNIT),  # +1 the next look begins on the right, -1 on the left, 0 none yet
        ("forward", "f8", NUMBER),  # the command that is repeated until the next decision
        ("aside", "f8", NUMBER),
        ("turn", "f8", NUMBER),
        ("kick", "f8", NUMBER),
        ("kicking", "f8", NUMBER),  # [s] for which a kick has been commanded with the ball at the feet
        ("kick_side", "f8", UNIT),  # of that kick: +1 to the left, -1 right, 0 ahead
    ]
)

NUMBERS = {  # all assumed; for a gait, an omnidirectional and a differential base
    **SKILL_NUMBERS,
    "run_in_cosine": (0.3, 0.94, 0.9),  # cosine of the angle off the line behind the ball for a run straight in
    "square_up": (0.0, 0.1, 0.0),  # [m] into the ball that a base which steps aside aims; 0: it faces the ball instead
    "near": (1.6, 1.8, 1.3),  # [touch distances] within which `near_cosine` counts instead
    "near_cosine": (-0.5, 0.85, 0.3),  # the same cosine near the ball
    "clearance": (0.05, 0.15, 0.25),  # [m] between front and ball on the way round
    "orbit_step": (0.6, 0.7, 0.6),  # [rad] of the way round that is looked ahead
    "orbit_speed": (0.12, 1.0, 0.6),  # [m/s] least on the way round
    "bump": (0.12, 0.5, 0.5),  # [m/s] at which the ball is met
    "delay": (0.1, 0.12, 0.12),  # [s] least time by which the ball is led
    "lead": (3.0, 1.5, 2.0),  # [s] greatest time by which the ball is led
    "kick_gap": (0.025, 0.04, 0.04),  # [m] the ball is at most this far from the front
    "kick_aside": (0.035, 0.08, 0.08),  # [m] and this far aside
    "room": (0.03, 0.03, 0.03),  # [rad] beside a shot
    "shot_range": (1.3, 7.0, 7.0),  # [m] of a shot at the goal
    "arrival": (0.0, 5.0, 5.0),  # [m/s] of a shot at the goal; 0: with all strength
    "plays_aside": (1.0, 0.0, 0.0),  # 1: kicks past what stands ahead, with one foreleg; 0: never
    "clears": (0.0, 1.0, 1.0),  # 1: kicks the ball away when it is pressed in its own half; 0: never
    "fetches": (1.0, 0.0, 0.0),  # 1: a goalkeeper goes for a ball in its third, off the corners; 0: near its goal
    "faces_ball": (1.2, 0.0, 0.0),  # [m] to a ball that a goalkeeper on legs faces even while it walks
    "beyond": (0.3, 0.0, 0.0),  # [m] off the pitch from which a ball is taken for something else; 0: never
    "wriggle_ahead": (-0.3, 0.3, 0.3),  # [1] speed ahead while working a ball out
    "wriggle_time": (3.0, 0.6, 0.8),  # [s]
    "patience": (3.0, 1.2, 1.5),  # [s]
    "still": (0.02, 0.15, 0.15),  # [m/s] a ball slower than this does not move
    "rank_time": (1.0, 0.3, 0.4),  # [s] before a player changes its rank
    "foresight": (1.0, 0.5, 0.6),  # [s] by which a player's own motion shortens its way to the ball
    "wrong_side": (0.3, 0.8, 1.0),  # [m] that a way from ahead of the ball is longer
    "cover": (0.8, 2.5, 2.5),  # [m] of the first supporter behind the ball, on its way to the own goal
    "back": (0.6, 2.0, 2.0),  # [m] between the next pairs of supporters
    "aside": (0.5, 1.5, 1.5),  # [m] of a pair beside the ball
    "change_side": (0.2, 0.6, 0.6),  # [m] from the middle before a supporter changes sides
    "keeper_out": (1.8, 1.8, 2.0),  # [body reaches] from the middle of the goal
    "keeper_zone": (0.4, 2.0, 2.0),  # [m] round the middle of the goal from which balls are cleared
    "shot_speed": (0.15, 0.5, 0.5),  # [m/s] a ball this fast towards the goal is a shot
    "dive": (0.0, 0.0, 0.0),  # [m/s] at which a shot is met
    "clear_cosine": (0.77, 0.77, 0.77),  # cosine of the angle to the way clear of the goal for a kick, 40 degrees
    "retreat": (0.75, 0.75, 0.75),  # [s] before a push is for too long it steps back: delay, gait step, legs' ramp
    "unsure": (45.0, 0.0, 0.0),  # [1] confidence in the own pose below which a player looks up for landmarks
    "lost": (15.0, 0.0, 0.0),  # [1] the same with the ball so near that it loses it
    "glance_time": (0.9, 0.9, 0.9),  # [s] of such a look
    "glance_rest": (1.0, 1.0, 1.0),  # [s] until the next
    "raised": (0.25, 0.0, 0.0),  # [rad] that the camera is raised above a ball farther away
    "slowest": (0.7, 0.8, 0.8),  # [1] pace at strength 0
    "laziest": (0.5, 0.1, 0.1),  # [s] between decisions at strength 0
    "crookedest": (0.3, 0.1, 0.1),  # [rad] deviation of the aim at strength 0
    "softest": (0.7, 0.7, 0.7),  # [1] strength of a kick at strength 0
}
FOLLOWS = SKILLS_FOLLOW | {  # what a number grows with in leagues of other families: 0 pitch, 1 robot, 2 its top speed
    **dict.fromkeys(("shot_range", "cover", "back", "aside", "change_side", "keeper_zone"), 0),
    **dict.fromkeys(("clearance", "wrong_side", "kick_gap", "kick_aside", "square_up"), 1),
    **dict.fromkeys(("orbit_speed", "bump", "shot_speed", "arrival", "still"), 2),
}


def team(strength: float = 1.0, **changes: float) -> CompiledTeam:
    """Return the chaser; `changes` replace settings (NUMBERS) by name, for all kinds of base.

    `settings` has a row for each kind of base, in the order of `DRIVE_KINDS`. ValueError for an unknown name.
    """
    check_names("setting of chaser", changes, NUMBERS)
    given = {name: 3 * (check_finite_number(f"{name} of chaser", value),) for name, value in changes.items()}
    settings = settings_rows({"strength": 3 * (strength,), **NUMBERS, **given})
    return CompiledTeam("chaser", CHASER, MEMORY, settings, fit=scale_settings)


def scale_settings(settings: np.ndarray, league: League) -> np.ndarray:
    """Return the team's settings, scaled to a league."""
    return fitted(settings, league, FOLLOWS)


@compiled
def decide_or_repeat(belief, tracks, memory, noise, command, k, play, sight):
    """Make a new decision if it is due, else repeat the last command."""
    decides = must_decide(belief, memory, command, k)
    look_up(belief, command, memory, k, play)
    if not decides:
        aim_kick(command, k, memory.kick_side)
        return
    weakness = 1.0 - play.strength
    apply_strength(sight, memory, noise, k, weakness, play.laziest, play.crookedest, play.slowest)
    fill_sight(sight, belief, tracks, k)
    time_kick(sight, memory)
    memory.kick_side = 0.0
    decide(belief, command, sight, memory, noise, k, play)
    command.kick *= 1.0 - weakness * (1.0 - play.softest)
    keep_decision(memory, command)
    aim_kick(command, k, memory.kick_side)


@compiled
def decide(belief, command, sight, memory, noise, k, play):
    """Choose and play the player's role: goalkeeper, field player, or search for a lost ball."""
    situation = belief.situation
    keeps_out = may_not_enter(situation, k)
    if keeps_out and leave_area(command, sight, k, play):
        return
    if belief.ball.age > LOST or memory.phantom > PHANTOM:
        search_for_ball(belief, command, sight, memory, k, play)
        return
    end_search(memory)
    if situation.keeper == 1:
        keep_goal(command, sight, memory, k, play)
    else:
        play_in_field(situation, command, sight, memory, noise, k, play, keeps_out)
        avoid_pushing_foul(belief.obstacle, command, sight, memory, k, play.retreat)


@compiled
def play_in_field(situation, command, sight, memory, noise, k, play, keeps_out):
    """Play as a field player that knows the ball's position; `keeps_out`: must stay out of its own penalty area."""
    choose_rank(sight, memory, play)
    note_set_piece(situation, sight, memory, k)
    time_stuck_ball(sight, memory, noise, k, play)
    play_role(situation, command, sight, memory, k, play, keeps_out)


@compiled
def play_role(situation, command, sight, memory, k, play, keeps_out):
    """Play as taker of a restart, as attacker or as supporter, given the restart and the player's rank."""
    if memory.set_piece != 0.0 and situation.phase != PLAY:
        if memory.set_piece > 0.0:
            take_restart(command, situation, sight, k, play)
        else:
            wait_for_pass(command, sight, k, play)
    elif memory.set_piece > 0.0:
        leave_ball(command, sight, k, play)
    elif memory.rank > (1 if memory.set_piece < 0.0 else 0) or (situation.phase != PLAY and situation.ours < 0.0):
        support(command, sight, memory, k, play, required_ball_distance(situation, k), keeps_out)
    elif keeps_out and is_in_own_area(sight.ball_x, sight.ball_y, k, k.ball_radius):
        wait_at_area(command, sight, k, play)
    elif should_block_opponent(sight, k):
        support(command, sight, memory, k, play, HOLDS_OFF, keeps_out)
    else:
        attack(command, sight, memory, k, play)


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


@compiled
def time_stuck_ball(sight, memory, noise, k, play):
    """Measure how long the ball is stuck at the player's feet, and start to free it when the patience is over."""
    memory.wriggle = max(memory.wriggle - sight.elapsed, 0.0)
    if memory.patience == 0.0:
        memory.patience = play.patience * (0.7 + 0.6 * draw_uniform(noise, TEAM))
    near = sight.distance < sight.touch + k.body_reach
    slow = length(sight.ball_vx, sight.ball_vy) < play.still
    memory.stuck = memory.stuck + sight.elapsed if near and slow else 0.0
    if memory.stuck > memory.patience:
        memory.stuck, memory.patience = 0.0, play.patience * (0.7 + 0.6 * draw_uniform(noise, TEAM))
        memory.wriggle = play.wriggle_time
        goal = atan2(-sight.ball_y, 0.5 * k.pitch_length - sight.ball_x)
        memory.wriggle_side = side_of(wrap(goal - sight.heading))


CHASER = per_player(decide_or_repeat, SIGHT)
