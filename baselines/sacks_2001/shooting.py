"""Where to shoot, whether a shot is open, and whom to pass to.  [Sacks 2001, 4, 5]  MS26, MS53

`k`: the league's constants; `play`: the team's settings.
"""

from __future__ import annotations

from math import atan2

from soccer_env.baselines.skills import choose_shot, goal_room, lane_room, shot_room, turned
from soccer_env.compiled import compiled
from soccer_env.geometry import length, wrap

NEAREST_PASS, FARTHEST_PASS = 0.4, 1.4  # [m] a soft kick rolls about a metre, assumed
WIDEST_PASS = 1.2  # [rad] beside straight ahead, assumed


@compiled
def choose_target(sight, k, play):
    """Return the unit vector from the ball to where the goal is open, or to its middle."""
    ux, uy, room = choose_shot(sight, k)
    if room > play.shot_room:
        return ux, uy
    x, y = 0.5 * k.pitch_length + k.ball_radius - sight.ball_x, -sight.ball_y
    away = max(length(x, y), 1e-6)
    return x / away, y / away


@compiled
def is_open(sight, memory, k, play):
    """Tell whether a kick straight ahead would go in between the posts, from not too far, past the opponents."""
    x = 0.5 * k.pitch_length - sight.ball_x
    if length(x, sight.ball_y) > play.shot_range:
        return False
    ux, uy = turned(sight.now_cosine, sight.now_sine, memory.aim_error)
    room = goal_room(sight, k, ux, uy) if play.blind_shots == 1 else shot_room(sight, k, ux, uy)
    return room > play.shot_room


@compiled
def find_pass(sight, k, play):
    """Return which of the others in sight to pass to, -1 for nobody: the team-mate farthest up the field in reach."""
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
