"""The attacker: drive behind the ball round other players, dribble, shoot where the goal is open.  MH04, MH14, MH22

`k`: the league's constants; `play`: the team's settings.
"""

from math import inf

from soccer_env.baselines.heinemann_2006.dribbling import dribble, way_round
from soccer_env.baselines.heinemann_2006.driving import drive_to
from soccer_env.baselines.heinemann_2006.intercepting import meeting_time
from soccer_env.baselines.heinemann_2006.passing import choose_pass, pass_strength
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, length
from soccer_env.skills.approaching import approach
from soccer_env.skills.attacking import (
    DEFENDED,
    ball_comes_to_me,
    choose_aim,
    free_stuck_ball,
    receive_ball,
    wants_to_shoot,
)
from soccer_env.skills.carrying import is_pressed
from soccer_env.skills.kicking import is_at_kicker
from soccer_env.skills.moves import rotate_vector, shot_room
from soccer_env.skills.set_pieces import kick_strength_for
from soccer_env.skills.sight import predict_ball

BEHIND = 0.3  # [m] more than touching it that the place behind the ball lies from it, assumed


@compiled
def attack(command, memory, k, play, scratch):
    """Bring the ball to the goal by the first applicable skill: free, dribble, receive, approach; then kick."""
    sight, skill, skills = scratch.sight, memory.skill, play.skills
    ux, uy = choose_aim(sight, k, skills)
    passes, far = False, 0.0
    if skill.wriggle == 0.0 and (sight.held == 1 or is_at_kicker(sight, skills)):
        passes, ux, uy, far = choose_pass_or_shot(sight, k, play, ux, uy)
    if sight.held == 1 and not passes and should_dribble(sight, k, play, ux, uy):
        ux, uy = way_round(k, play, scratch)
    ux, uy = rotate_vector(ux, uy, skill.aim_error)
    if skill.wriggle > 0.0:
        free_stuck_ball(command, sight, skill, k, skills)
    elif sight.held == 1:
        dribble(command, sight, memory, k, play, ux, uy)
    elif play.intercepts == 1 and ball_comes_to_me(sight, k):
        receive_ball(command, sight, k, skills)
    elif sight.distance > play.close:
        drive_behind_ball(command, memory, k, play, scratch, ux, uy)
    else:
        approach(command, sight, skill, k, skills, ux, uy, play.run_in)
    if wants_to_shoot(sight, skill, k, skills):
        goal = length(0.5 * k.pitch_length - sight.ball_x, sight.ball_y)
        command.kick = kick_strength_for(k, goal, skills.arrival)
    elif passes and is_at_kicker(sight, skills) and sight.now_cosine * ux + sight.now_sine * uy > play.pass_cosine:
        command.kick = pass_strength(k, play, far)


@compiled
def choose_pass_or_shot(sight, k, play, ux, uy):
    """Return whether to pass, the unit vector along which to play the ball, and the distance to the mate [m].

    An open shot comes first; a pressed player also passes back.
    """
    reach = 0.5 * k.pitch_length - sight.ball_x < play.skills.shot_range
    if reach and shot_room(sight, k, ux, uy) > play.skills.room:
        return False, ux, uy, 0.0
    pass_x, pass_y, far, worth = choose_pass(sight, k, play, is_pressed(sight))
    if worth == -inf:
        return False, ux, uy, 0.0
    return True, pass_x, pass_y, far


@compiled
def should_dribble(sight, k, play, ux, uy):
    """Tell whether to dribble past other players: no shot along (ux, uy) is free, and the own goal is far."""
    if play.dribbles_round == 0 or length(sight.ball_x + 0.5 * k.pitch_length, sight.ball_y) < DEFENDED:
        return False
    reach = 0.5 * k.pitch_length - sight.ball_x < play.skills.shot_range
    return not reach or shot_room(sight, k, ux, uy) <= play.skills.room


@compiled
def drive_behind_ball(command, memory, k, play, scratch, ux, uy):
    """Drive to the point behind the ball's predicted position from which to push along (ux, uy), facing the ball."""
    sight = scratch.sight
    seconds = meeting_time(sight, sight.x, sight.y, sight.vx, sight.vy, play.lead, k) if play.intercepts == 1 else 0.0
    x, y = predict_ball(sight, k, seconds)
    far = sight.touch + BEHIND
    facing = atan2(y - sight.y, x - sight.x)
    edge_x, edge_y = 0.5 * k.pitch_length, 0.5 * k.pitch_width
    to_x, to_y = clip(x - far * ux, -edge_x, edge_x), clip(y - far * uy, -edge_y, edge_y)
    drive_to(command, memory, k, play, scratch, to_x, to_y, facing, min(play.run_in, k.drive_forward))
