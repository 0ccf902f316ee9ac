"""Decisions to shoot, the target of a shot, and the receiver of a pass.  [Sacks 2001, 4, 5]  MS26, MS53

"Our strategy had essentially been to get to the ball, orbit to face the opponent's goal, and then shoot": without
avoidance the team still does so, whoever stands in the way. Dribbling came in to get "around other players": while
one of them repels (MS41) the robot dribbles, else it orbits and shoots as before. The paper gives no other rule for a
dribbler's shots; `choose_shots` is ours.

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.baselines.sacks_2001.steering import direction_to_goal, force_of_players
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, length, wrap
from soccer_env.skills.moves import choose_shot, lane_room, rotate_vector, shot_room

NEAREST_PASS, FARTHEST_PASS = 0.4, 1.4  # [m] a soft kick rolls about a metre, assumed
WIDEST_PASS = 1.2  # [rad] beside straight ahead, assumed


@compiled
def choose_target(sight, k, play):
    """Return the unit vector from the ball to the middle of the goal, or with `choose_shots` to its open part."""
    if play.choose_shots == 1:
        ux, uy, room = choose_shot(sight, k)
        if room > play.shot_room:
            return ux, uy
    x, y = 0.5 * k.pitch_length + k.ball_radius - sight.ball_x, -sight.ball_y
    away = max(length(x, y), 1e-6)
    return x / away, y / away


@compiled
def may_shoot(belief, tracks, sight, memory, k, play):
    """Tell whether the robot may shoot once it faces the goal, because no player is in its way.  MS26"""
    if play.shoots == 0:
        return False
    if play.choose_shots == 1:
        return memory.foiled <= 0.0 and is_shot_open(sight, memory, k, play)
    return play.avoidance == 0 or not is_somebody_in_way(belief, tracks, k, play)


@compiled
def is_somebody_in_way(belief, tracks, k, play):
    """Tell whether the force of any other player repels the robot on its way to the goal.  MS26, MS41"""
    goal_x, goal_y = direction_to_goal(belief.own, k)
    x, y = force_of_players(belief, tracks, goal_x, goal_y, k, play)
    return x != 0.0 or y != 0.0


@compiled
def is_shot_open(sight, memory, k, play):
    """Tell whether a kick straight ahead would score: between the posts, past the opponents, within range."""
    x = 0.5 * k.pitch_length - sight.ball_x
    if length(x, sight.ball_y) > play.shot_range:
        return False
    ux, uy = rotate_vector(sight.now_cosine, sight.now_sine, memory.aim_error)
    return shot_room(sight, k, ux, uy) > play.shot_room


@compiled
def find_pass(sight, k, play):
    """Return the index in `sight` of the team-mate to pass to: the most advanced within reach, -1 for none."""
    _, _, room = choose_shot(sight, k)
    if room > play.shot_room:
        return -1
    best, farthest = -1, sight.ball_x
    for i in range(sight.others):
        x, y = sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y
        away = max(length(x, y), 1e-6)
        if sight.mate[i] == 0 or not NEAREST_PASS < away < FARTHEST_PASS:
            continue
        if abs(wrap(atan2(y, x) - sight.heading)) > WIDEST_PASS or lane_room(sight, k, x / away, y / away, away) <= 0.0:
            continue
        if sight.other_x[i] > farthest:
            best, farthest = i, sight.other_x[i]
    return best
