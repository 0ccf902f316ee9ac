"""Skills with a target that learners, searches and people choose by number, and which of them apply now.

If the chosen skill does not apply, the robot searches: it faces the ball, or looks for a ball that it has lost. With
every skill a field player keeps the rules as scripted players do: it leaves its own penalty area where it may not
stand, and does not shove.

`k`: the league's constants; `play`: the numbers of the skills.
"""

import numpy as np

from soccer_env.compiled import compiled, scratch_records
from soccer_env.compiling.borrowing import borrow_arrays, keep_alive
from soccer_env.geometry import atan2, length
from soccer_env.skills.attacking import bring_ball, choose_aim, shoot_if_free, time_stuck_ball
from soccer_env.skills.deciding import PLAY, keep_decision, required_ball_distance
from soccer_env.skills.glancing import PHANTOM, look_up
from soccer_env.skills.goalkeeping import clear_ball, keep_goal
from soccer_env.skills.keeping_rules import avoid_pushing_foul, is_in_own_area, leave_area, may_not_enter
from soccer_env.skills.kicking import (
    aim_kick,
    choose_mate,
    clearance_strength,
    count_mates,
    is_at_kicker,
    is_foiled,
    mate_by_distance,
    time_kick,
)
from soccer_env.skills.moves import clearing_direction, faces, go, stand
from soccer_env.skills.searching import LOST, end_search, search_for_ball
from soccer_env.skills.set_pieces import ARRIVAL, kick_strength_for, note_set_piece, take_restart, wait_for_pass
from soccer_env.skills.sight import SIGHT, fill_sight
from soccer_env.skills.supporting import choose_rank, support

# up to GO: always possible; from APPROACH: with the ball
STAND, SEARCH, GO, KEEP, BLOCK, COVER, APPROACH, DRIBBLE, SHOOT, PASS, CLEAR = range(11)
THIRD = 2.0 / 3.0  # [1] of half the pitch from its middle: the middle of an outer third
SKILLS: dict[str, tuple[int, float, float]] = {  # skill and target
    "stand": (STAND, 0, 0),
    "search": (SEARCH, 0, 0),
    "approach": (APPROACH, 0, 0),
    "dribble to goal": (DRIBBLE, 0, 0),
    "dribble left": (DRIBBLE, 1, 0),  # side of the wing
    "dribble right": (DRIBBLE, -1, 0),
    "shoot": (SHOOT, 0, 0),
    "shoot left": (SHOOT, 1, 0),  # side of the goal, as the robot's team sees it
    "shoot right": (SHOOT, -1, 0),
    "pass": (PASS, 0, 0),
    "pass to first": (PASS, 1, 0),  # team-mate, the nearest first
    "pass to second": (PASS, 2, 0),
    "pass to third": (PASS, 3, 0),
    "clear": (CLEAR, 0, 0),
    "block": (BLOCK, 0, 0),
    "cover": (COVER, 0, 0),
    "keep goal": (KEEP, 0, 0),
    "go back left": (GO, -THIRD, THIRD),  # share of half the length, of half the width
    "go back": (GO, -THIRD, 0),
    "go back right": (GO, -THIRD, -THIRD),
    "go left": (GO, 0, THIRD),
    "go to centre": (GO, 0, 0),
    "go right": (GO, 0, -THIRD),
    "go forward left": (GO, THIRD, THIRD),
    "go forward": (GO, THIRD, 0),
    "go forward right": (GO, THIRD, -THIRD),
}
MEANINGS = {
    STAND: "stand still",
    SEARCH: "face the ball, or look for a ball that is lost; what a choice that does not apply becomes",
    APPROACH: "get behind the ball, facing the goal",
    DRIBBLE: "get the ball and carry it: past opponents to the goal, or along a wing",
    SHOOT: "get the ball and shoot: wherever a way into the goal is free, or beside a post",
    PASS: "get the ball and pass it: to the mate with the freest way, or to a mate by its distance",
    CLEAR: "get a ball in the own half and kick it away from the own goal",
    BLOCK: "stand near the ball, between it and the own goal",
    COVER: "stand farther behind the ball, on its way to the own goal",
    KEEP: "keep goal: meet a shot, clear a ball near the goal, guard",
    GO: "go to the middle of one of nine parts of the pitch, and face the ball",
}
KIND = np.array([kind for kind, _, _ in SKILLS.values()], np.int64)
TARGET = np.array([target for _, *target in SKILLS.values()], np.float64)

AIMED = 0.993  # cosine of the angle off its aim within which a robot kicks, 7 degrees, assumed
WING = (0.5, 0.6)  # [1] of half the pitch: the place on a wing that a ball is dribbled to, assumed
BESIDE_POST = 0.6  # [1] of the way from the middle of the goal to a post that a shot is aimed at, assumed
BLOCKING = 3.0  # [body reaches] from the ball at which a player blocks its way to the goal, assumed


@compiled
def play_skill(choice, belief, tracks, memory, noise, command, k, play, sight):
    """Write the command of a chosen skill, the number of one of SKILLS, from a player's belief and memory."""
    stand(command)
    if belief.situation.active == 0:
        return
    look_up(belief, command, memory, k, play)
    sight.pace, sight.elapsed = 1.0, k.dt
    fill_sight(sight, belief, tracks, k)
    time_kick(sight, memory)
    memory.kick_side = 0.0
    knows = knows_ball(belief, memory)
    if knows:
        end_search(memory)
        if belief.situation.keeper == 0:
            choose_rank(sight, memory, play)
            note_set_piece(belief.situation, sight, memory, k)
            time_stuck_ball(sight, memory, noise, k, play)
    kind = KIND[choice] if applies(choice, belief, sight, memory, k, play) else SEARCH
    keeps_out = may_not_enter(belief.situation, k)
    if kind != STAND and not (keeps_out and leave_area(command, sight, k, play)):
        if kind == SEARCH and not knows:
            search_for_ball(belief, command, sight, memory, k, play)
        else:
            carry_out(kind, choice, belief.situation, command, sight, memory, k, play, keeps_out)
        if knows and kind != SEARCH and belief.situation.keeper == 0:
            avoid_pushing_foul(belief.obstacle, command, sight, memory, k, play.retreat)
    keep_decision(memory, command)
    aim_kick(command, k, memory.kick_side)


@compiled
def knows_ball(belief, memory):
    """Tell whether the player has seen the ball of late, where a ball can be."""
    return belief.ball.age <= LOST and memory.phantom <= PHANTOM


@compiled
def applies(choice, belief, sight, memory, k, play):
    """Tell whether a choice can be carried out now, as far as the player knows."""
    kind, situation = KIND[choice], belief.situation
    if kind <= GO:
        return True
    if not knows_ball(belief, memory):
        return False
    if kind == KEEP:
        return situation.keeper == 1 or situation.teammates == 0
    if kind < APPROACH:
        return True
    return may_play_ball(situation, sight, memory, k) and suits_ball(choice, situation, sight, k, play)


@compiled
def may_play_ball(situation, sight, memory, k):
    """Tell whether the rules let the player go for the ball: restarts, second touch, and its own penalty area."""
    if situation.phase != PLAY and situation.ours < 0.0:
        return False
    if memory.set_piece != 0.0 and (memory.set_piece > 0.0) == (situation.phase == PLAY):
        return False  # the taker has to leave the ball to others, and others to the taker before
    return not (may_not_enter(situation, k) and is_in_own_area(sight.ball_x, sight.ball_y, k, k.ball_radius))


@compiled
def suits_ball(choice, situation, sight, k, play):
    """Tell whether a skill with the ball suits the place of the ball, the kicker, and the mates that are seen."""
    kind, target = KIND[choice], TARGET[choice, 0]
    if kind == APPROACH:
        return sight.held == 0
    if kind == DRIBBLE:
        return True
    if kind == CLEAR and sight.ball_x >= 0.0:
        return False
    if situation.keeper == 1 and k.keeper_kicks == 0:
        return kind == CLEAR
    if kind == SHOOT:
        return target == 0.0 or 0.5 * k.pitch_length - sight.ball_x < play.shot_range
    return kind == CLEAR or count_mates(sight) >= max(target, 1.0)


@compiled
def carry_out(kind, choice, situation, command, sight, memory, k, play, keeps_out):
    """Carry out a skill that applies, except the search for a lost ball."""
    if kind == GO:
        x, y = 0.5 * k.pitch_length * TARGET[choice, 0], 0.5 * k.pitch_width * TARGET[choice, 1]
        go(command, sight, k, play, x, y, atan2(sight.ball_y - sight.y, sight.ball_x - sight.x), 0.0)
    elif kind == SEARCH:
        wait_for_pass(command, sight, k, play)
    elif kind == KEEP:
        keep_goal(command, sight, memory, k, play)
    elif kind < APPROACH:
        stand_behind_ball(kind, situation, command, sight, memory, k, play, keeps_out)
    elif memory.set_piece > 0.0:
        take_restart(command, situation, sight, k, play)
    else:
        play_ball(kind, TARGET[choice, 0], situation, command, sight, memory, k, play)


@compiled
def stand_behind_ball(kind, situation, command, sight, memory, k, play, keeps_out):
    """Stand between the ball and the own goal, near the ball to block it, or farther off to cover the goal."""
    rank, ring = memory.rank, required_ball_distance(situation, k)
    memory.rank = 0 if kind == BLOCK else max(rank, 1)
    support(command, sight, memory, k, play, max(ring, BLOCKING * k.body_reach if kind == BLOCK else 0.0), keeps_out)
    memory.rank = rank


@compiled
def play_ball(kind, target, situation, command, sight, memory, k, play):
    """Get the ball; then carry, shoot, pass or clear it."""
    if kind == CLEAR and situation.keeper == 1:
        clear_ball(command, sight, memory, k, play)
        return
    ux, uy, strength, cosine = aim_of(kind, target, sight, k, play)
    bring_ball(command, sight, memory, k, play, ux, uy)
    if kind == SHOOT and target == 0.0:
        foiled = play.plays_aside > 0.0 and is_foiled(sight, memory, k)
        shoot_if_free(command, sight, memory, k, play, foiled)
        return
    ready = sight.held == 1 or k.kicker_wind_up <= 0.0
    if strength > 0.0 and ready and is_at_kicker(sight, play) and faces(sight, ux, uy, cosine):
        command.kick = strength


@compiled
def aim_of(kind, target, sight, k, play):
    """Return the unit vector along which to play the ball, the strength of the kick, and how well to face that way.

    A strength of 0 carries the ball; the last number is the cosine of the greatest angle off the way for a kick.
    """
    if kind == PASS:
        ux, uy, far = choose_mate(sight, k) if target == 0.0 else mate_by_distance(sight, int(target))
        return ux, uy, kick_strength_for(k, far, ARRIVAL), AIMED
    if kind == CLEAR:
        ux, uy = clearing_direction(sight, k)
        return ux, uy, clearance_strength(sight, k), play.clear_cosine
    if target == 0.0:
        ux, uy = choose_aim(sight, k, play)
        return ux, uy, 0.0, AIMED
    if kind == SHOOT:
        x, y = 0.5 * k.pitch_length, target * BESIDE_POST * 0.5 * k.pitch_goal_width
    else:
        x, y = max(WING[0] * 0.5 * k.pitch_length, sight.ball_x), target * WING[1] * 0.5 * k.pitch_width
    x, y = x - sight.ball_x, y - sight.ball_y
    away = max(length(x, y), 1e-6)
    return x / away, y / away, 1.0 if kind == SHOOT else 0.0, AIMED


# All robots of many matches


@compiled
def write_skill_commands(beliefs, tracks, memory, noise, commands, choices, learns, constants, settings, first, last):
    """Write the commands (M, R) of the robots that learn (R,) by their choices (M, R, 1), in a slice of matches."""
    owned, k = scratch_records(1, SIGHT), constants[0]
    work, play = borrow_arrays(owned), settings[k.drive_kind]
    beliefs, tracks, memory, noise, commands = borrow_arrays((beliefs, tracks, memory, noise, commands))
    for m in range(first, last):
        for r in range(len(learns)):
            if learns[r] == 1:
                play_skill(
                    int(choices[m, r, 0]), beliefs[m, r], tracks[m, r], memory[m, r], noise[m, r], commands[m, r],
                    k, play, work[0],
                )  # fmt: skip
    keep_alive(owned)


@compiled
def mask_skills(beliefs, tracks, memory, constants, settings, masks):
    """Fill masks (M, R, n): 1 for each of the n SKILLS that applies now."""
    owned, k = scratch_records(1, SIGHT), constants[0]
    work, play = borrow_arrays(owned), settings[k.drive_kind]
    sight = work[0]
    for m in range(masks.shape[0]):
        for r in range(masks.shape[1]):
            fill_sight(sight, beliefs[m, r], tracks[m, r], k)
            for choice in range(masks.shape[2]):
                masks[m, r, choice] = applies(choice, beliefs[m, r], sight, memory[m, r], k, play)
    keep_alive(owned)
