"""The chaser: a complete small scripted team for both leagues and any number of players.

Each player decides from its own belief and tracks. One ladder of skills for each role, from soccer_env/skills/:

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

from soccer_env.compiled import compiled
from soccer_env.guards.checking import check_finite_number, check_names
from soccer_env.skills.attacking import attack, time_stuck_ball
from soccer_env.skills.deciding import PLAY, apply_strength, keep_decision, must_decide, required_ball_distance
from soccer_env.skills.glancing import PHANTOM, look_up
from soccer_env.skills.goalkeeping import keep_goal
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
from soccer_env.skills.settings import MEMORY, fitted, settings_rows
from soccer_env.skills.settings import NUMBERS as SKILL_NUMBERS
from soccer_env.skills.sight import SIGHT, fill_sight
from soccer_env.skills.supporting import choose_rank, support
from soccer_env.teams import CompiledTeam
from soccer_env.teams.kernels import per_player

NUMBERS = {  # all assumed; for a gait, an omnidirectional and a differential base
    **SKILL_NUMBERS,
    "slowest": (0.7, 0.8, 0.8),  # [1] pace at strength 0
    "laziest": (0.5, 0.1, 0.1),  # [s] between decisions at strength 0
    "crookedest": (0.3, 0.1, 0.1),  # [rad] deviation of the aim at strength 0
    "softest": (0.7, 0.7, 0.7),  # [1] strength of a kick at strength 0
}


def team(strength: float = 1.0, **changes: float) -> CompiledTeam:
    """Return the chaser; `changes` replace settings (NUMBERS) by name, for all kinds of base.

    `settings` has a row for each kind of base, in the order of `DRIVE_KINDS`. ValueError for an unknown name.
    """
    check_names("setting of chaser", changes, NUMBERS)
    given = {name: 3 * (check_finite_number(f"{name} of chaser", value),) for name, value in changes.items()}
    settings = settings_rows({"strength": 3 * (strength,), **NUMBERS, **given})
    return CompiledTeam("chaser", CHASER, MEMORY, settings, fit=fitted)


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


CHASER = per_player(decide_or_repeat, SIGHT)
