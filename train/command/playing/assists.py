"""What a robot does by itself while the person holds a key: carry the ball, shoot, pass.

Each is a compiled team for one robot, put together from the chaser's skills: get behind the ball, turn with it, kick
once the robot faces the aim. It decides from the robot's own belief, and searches for a ball that the robot has lost.

`k`: the league's constants; `play`: the chaser's settings.
"""

from collections.abc import Callable
from dataclasses import replace
from math import cos

from soccer_env.baselines import chaser
from soccer_env.compiled import compiled
from soccer_env.geometry import length
from soccer_env.skills.approaching import MEET, approach
from soccer_env.skills.attacking import choose_aim
from soccer_env.skills.carrying import turn_to_goal
from soccer_env.skills.kicking import is_at_kicker
from soccer_env.skills.moves import TURN_COST, choose_shot, faces, lane_room, misalignment, stand
from soccer_env.skills.searching import LOST, end_search, search_for_ball
from soccer_env.skills.set_pieces import ARRIVAL, kick_strength_for
from soccer_env.skills.sight import SIGHT, fill_sight
from soccer_env.teams import CompiledTeam
from soccer_env.teams.kernels import per_player
from soccer_env.train.command.playing.controls import CARRY, PASS, SHOOT

AIMED = cos(0.12)  # cosine of the angle off its aim within which a robot kicks, 7 degrees, assumed
ALONE = 1.0  # [m] of a pass without a team-mate in sight, assumed


@compiled
def look(belief, tracks, memory, command, k, play, sight):
    """Fill the sight of a robot that stands; return whether it knows the ball, else let it search."""
    stand(command)
    sight.pace, sight.elapsed = 1.0, k.dt
    fill_sight(sight, belief, tracks, k)
    if belief.situation.active == 0:
        return False
    if belief.ball.age > LOST:
        search_for_ball(belief, command, sight, memory, k, play)
        return False
    end_search(memory)
    return True


@compiled
def play_ball(command, sight, memory, k, play, ux, uy, strength):
    """Bring the ball into the direction (ux, uy), and kick it that way with a strength; 0: carry it on."""
    if sight.held == 1:
        turn_to_goal(command, sight, memory, k, play, ux, uy)
    else:
        approach(command, sight, memory, k, play, ux, uy, MEET)
    ready = sight.held == 1 or k.kicker_wind_up <= 0.0
    if ready and is_at_kicker(sight, play) and faces(sight, ux, uy, AIMED):
        command.kick = strength


@compiled
def carry(belief, tracks, memory, noise, command, k, play, sight):
    """Go for the ball and carry it towards the goal, past opponents."""
    if look(belief, tracks, memory, command, k, play, sight):
        ux, uy = choose_aim(sight, k, play)
        play_ball(command, sight, memory, k, play, ux, uy, 0.0)


@compiled
def shoot(belief, tracks, memory, noise, command, k, play, sight):
    """Go for the ball and shoot it at the freest spot between the posts."""
    if look(belief, tracks, memory, command, k, play, sight):
        ux, uy, _ = choose_shot(sight, k)
        play_ball(command, sight, memory, k, play, ux, uy, 1.0)


@compiled
def pass_ball(belief, tracks, memory, noise, command, k, play, sight):
    """Go for the ball and pass it to the team-mate whose way is the freest and the least to turn for."""
    if look(belief, tracks, memory, command, k, play, sight):
        ux, uy, far = choose_mate(sight, k)
        play_ball(command, sight, memory, k, play, ux, uy, kick_strength_for(k, far, ARRIVAL))


@compiled
def choose_mate(sight, k):
    """Return the unit vector from the ball to the best team-mate for a pass, and the distance [m]."""
    best, best_x, best_y, far = -1e9, sight.now_cosine, sight.now_sine, ALONE
    for i in range(sight.others):
        x, y = sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y
        away = max(length(x, y), 1e-6)
        worth = lane_room(sight, k, x / away, y / away, away) - TURN_COST * misalignment(sight, x / away, y / away)
        if sight.mate[i] == 1 and worth > best:
            best, best_x, best_y, far = worth, x / away, y / away, away
    return best_x, best_y, far


def assist(name: str, act: Callable[..., None]) -> CompiledTeam:
    """Return a team of one robot that does one thing, with the chaser's memory and settings."""
    return replace(chaser.team(), name=name, kernel=per_player(act, SIGHT))


ASSISTS = {CARRY: assist(CARRY, carry), SHOOT: assist(SHOOT, shoot), PASS: assist(PASS, pass_ball)}
