"""Pass to a team-mate, no harder than it can receive, and stand free for a pass.  MH04, MH22

    "the robot can control the kicking strength of this device in real-time, in order to pass the ball to a team-mate
    instead of kicking it at full strength"    [Heinemann 2006, 2]

A pass goes to the mate's predicted place, arrives at a speed that a guide can receive, and is worth the distance that
it gains towards the goal. The places of mates come from their reports by radio, or from the camera.

`k`: the league's constants; `play`: the team's settings.
"""

from math import inf

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, length
from soccer_env.skills.moves import lane_room, misalignment
from soccer_env.skills.set_pieces import kick_strength_for
from soccer_env.skills.sight import is_opponent_near

LED = 0.4  # [s] of a mate's motion by which a pass is led, assumed
TURN_COST = 0.8  # [m] towards the goal that a pass may lose for a quarter turn less, assumed
LANE_WORTH = 10.0  # [m/rad] towards the goal that room beside a pass is worth, assumed
OPEN_SPOTS = ((2.5, 1.5), (2.0, 2.2), (1.0, 2.6))  # [m, m] ahead of the ball and aside of it, assumed
EDGE = 0.5  # [m] from the lines that a supporter keeps, assumed
STAY = 0.3  # [1] metres towards the goal that a metre less to drive is worth, assumed


@compiled
def choose_pass(sight, k, play, pressed):
    """Return the unit vector to the best mate for a pass, its distance [m], and the pass's value [m]; -inf for none."""
    best, best_x, best_y, best_far = -inf, 1.0, 0.0, 0.0
    if play.passes == 0:
        return best_x, best_y, best_far, best
    least = -play.pass_back if pressed else play.pass_gain
    for i in range(sight.others):
        if sight.mate[i] == 0 or sight.field[i] == 0:
            continue
        x, y = predict_pass_target(sight, k, i)
        dx, dy = x - sight.ball_x, y - sight.ball_y
        far = max(length(dx, dy), 1e-6)
        gain = goal_distance(k, sight.ball_x, sight.ball_y) - goal_distance(k, x, y)
        if far < play.pass_near or far > play.pass_far or gain < least:
            continue
        ux, uy = dx / far, dy / far
        room = lane_room(sight, k, ux, uy, far + k.body_reach)
        if room < play.pass_room or is_opponent_near(sight, x, y, play.pass_free):
            continue
        worth = gain + LANE_WORTH * room - TURN_COST * misalignment(sight, ux, uy)
        if worth > best:
            best, best_x, best_y, best_far = worth, ux, uy, far
    return best_x, best_y, best_far, best


@compiled
def predict_pass_target(sight, k, i):
    """Return the predicted position [m, m] of player i when a pass would arrive, kept inside the pitch."""
    edge_x, edge_y = 0.5 * k.pitch_length - EDGE, 0.5 * k.pitch_width - EDGE
    x, y = sight.other_x[i] + LED * sight.other_vx[i], sight.other_y[i] + LED * sight.other_vy[i]
    return clip(x, -edge_x, edge_x), clip(y, -edge_y, edge_y)


@compiled
def goal_distance(k, x, y):
    """Return the distance [m] from a place to the middle of the opponents' goal."""
    return length(0.5 * k.pitch_length - x, y)


@compiled
def pass_strength(k, play, far):
    """Return the strength [1] of a pass over a distance [m]: enough to arrive at `pass_arrival`, at most 1.  MH04"""
    return kick_strength_for(k, far, play.pass_arrival) if play.pass_strength == 1 else 1.0


@compiled
def own_team_is_nearer(sight):
    """Tell whether the own team is nearer to the ball than the opponents."""
    own, other = sight.distance, inf
    for i in range(sight.others):
        away = length(sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y)
        if sight.mate[i] == 1:
            own = min(own, away)
        else:
            other = min(other, away)
    return own < other


@compiled
def open_place(sight, skill, k):
    """Return the position [m, m] where a supporter is free for a pass: ahead of the ball, with a clear lane."""
    side = skill.side if skill.rank % 2 == 0 else -skill.side
    edge_x, edge_y = 0.5 * k.pitch_length - 2.0 * EDGE, 0.5 * k.pitch_width - EDGE
    best, best_x, best_y = -inf, sight.x, sight.y
    for ahead, aside in OPEN_SPOTS:
        x = clip(sight.ball_x + ahead, -edge_x, edge_x)
        y = clip(sight.ball_y + side * aside, -edge_y, edge_y)
        far = max(length(x - sight.ball_x, y - sight.ball_y), 1e-6)
        room = lane_room(sight, k, (x - sight.ball_x) / far, (y - sight.ball_y) / far, far)
        worth = LANE_WORTH * room - goal_distance(k, x, y) - STAY * length(x - sight.x, y - sight.y)
        if worth > best:
            best, best_x, best_y = worth, x, y
    return best_x, best_y
