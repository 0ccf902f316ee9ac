"""The sight of a scripted player: its belief about the match in the team frame, own goal at -x, the opponents' at +x.

Beliefs and tracks are relative to the robot; `fill_sight` converts them once a decision into one flat record, so that
skills can be written for a team that attacks +x. Everything here is exact under a left-right mirror: cosine terms are
even, sine terms odd.

`k`: the league's constants.
"""

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, cosine_and_sine, into_frame, length, out_of_frame, point_of_frame, wrap
from soccer_env.leagues.league import AHEAD_OF_RAMP
from soccer_env.types import MAX_TEAM

OTHERS = 2 * MAX_TEAM  # room for every other player

SIGHT = np.dtype(
    [
        ("x", "f8"),  # [m] own pose, team frame
        ("y", "f8"),  # [m]
        ("heading", "f8"),  # [rad]
        ("cosine", "f8"),  # of the heading
        ("sine", "f8"),
        ("now_cosine", "f8"),  # of the heading before the delay: a kick obeys at once
        ("now_sine", "f8"),
        ("vx", "f8"),  # [m/s] own velocity, team frame
        ("vy", "f8"),  # [m/s]
        ("ball_x", "f8"),  # [m] team frame
        ("ball_y", "f8"),  # [m]
        ("ball_vx", "f8"),  # [m/s] team frame
        ("ball_vy", "f8"),  # [m/s]
        ("distance", "f8"),  # [m] to the ball
        ("bearing", "f8"),  # [rad] of the ball, robot frame
        ("ahead", "f8"),  # [m] ball, robot frame
        ("left", "f8"),  # [m] ball, robot frame
        ("now_ahead", "f8"),  # [m] ball, robot frame, before the delay
        ("now_left", "f8"),  # [m]
        ("held", "i8"),  # 1: the ball lies in my pocket or at my kicker
        ("touch", "f8"),  # [m] distance from my origin to a ball that rests on my front
        ("pace", "f8"),  # [1] share of the top speeds that the team may use
        ("elapsed", "f8"),  # [s] since the last decision
        ("others", "i8"),  # players seen
        ("other_x", "f8", (OTHERS,)),  # [m] team frame
        ("other_y", "f8", (OTHERS,)),  # [m]
        ("other_vx", "f8", (OTHERS,)),  # [m/s] team frame
        ("other_vy", "f8", (OTHERS,)),  # [m/s]
        ("mate", "i8", (OTHERS,)),  # 1: a team-mate
        ("field", "i8", (OTHERS,)),  # 1: not a goalkeeper
        ("number", "i8", (OTHERS,)),
    ]
)


@compiled
def fill_sight(sight, belief, tracks, k):
    """Fill one robot's sight from its belief and tracks (slots,), predicted for when its command takes effect."""
    own, ball = belief.own, belief.ball
    delay = k.dt * (k.delay_steps + 0.5 * (k.gait_steps - 1.0))
    cosine, sine = cosine_and_sine(own.heading)
    sight.now_cosine, sight.now_sine = cosine, sine
    sight.now_ahead = ball.x
    sight.now_left = ball.y
    sight.held = ball.held
    sight.vx, sight.vy = out_of_frame(own.forward, own.left, cosine, sine)
    sight.ball_vx, sight.ball_vy = out_of_frame(ball.vx, ball.vy, cosine, sine)
    add_other_players(sight, own, tracks, delay)
    sight.ball_x, sight.ball_y = point_of_frame(own.x, own.y, ball.x, ball.y, cosine, sine)
    sight.ball_x, sight.ball_y = predict_ball(sight, k, delay)
    sight.x, sight.y = own.x + delay * sight.vx, own.y + delay * sight.vy
    sight.heading = wrap(own.heading + delay * own.turn)
    sight.cosine, sight.sine = cosine_and_sine(sight.heading)
    x, y = sight.ball_x - sight.x, sight.ball_y - sight.y
    sight.ahead, sight.left = into_frame(x, y, sight.cosine, sight.sine)
    sight.distance, sight.bearing = length(x, y), atan2(sight.left, sight.ahead)
    sight.touch = k.body_front + k.ball_radius


@compiled
def add_other_players(sight, own, tracks, delay):
    """Add all players with a track to the sight, in the order of their slots."""
    count = 0
    cosine, sine = sight.now_cosine, sight.now_sine
    for slot in range(min(tracks.shape[0], OTHERS)):
        track = tracks[slot]
        if track.present == 0:
            continue
        x, y = track.x + delay * track.vx, track.y + delay * track.vy
        sight.other_x[count], sight.other_y[count] = point_of_frame(own.x, own.y, x, y, cosine, sine)
        sight.other_vx[count], sight.other_vy[count] = out_of_frame(track.vx, track.vy, cosine, sine)
        sight.mate[count], sight.field[count] = track.teammate, 1 - track.keeper
        sight.number[count] = track.number
        count += 1
    sight.others = count


@compiled
def side_of(value):
    """Return +1 for the left (and for 0), -1 for the right."""
    return 1.0 if value >= 0.0 else -1.0


@compiled
def is_opponent_near(sight, x, y, near):
    """Tell whether an opponent is nearer than `near` [m] to a place."""
    for i in range(sight.others):
        if sight.mate[i] == 0 and length(sight.other_x[i] - x, sight.other_y[i] - y) < near:
            return True
    return False


@compiled
def ball_room(k):
    """Return the least distance [m] from a board to the centre of a ball at rest, which has rolled off the ramp."""
    return max(k.pitch_ramp + AHEAD_OF_RAMP * k.ball_radius, k.ball_radius)


@compiled
def predict_ball(sight, k, seconds):
    """Return the ball's place [m, m] after `seconds`, team frame, held inside the boards of a walled pitch."""
    speed = length(sight.ball_vx, sight.ball_vy)
    if speed < 1e-6:
        return sight.ball_x, sight.ball_y
    rolling = min(seconds, speed / k.ball_rolling)
    share = rolling * (1.0 - 0.5 * k.ball_rolling * rolling / speed)
    x, y = sight.ball_x + share * sight.ball_vx, sight.ball_y + share * sight.ball_vy
    if k.walled == 1:
        edge_x, edge_y = 0.5 * k.pitch_length - ball_room(k), 0.5 * k.pitch_width - ball_room(k)
        in_mouth = abs(y) < 0.5 * k.pitch_goal_width
        edge_x = 0.5 * k.pitch_length - k.ball_radius if in_mouth else edge_x
        x = clip(x, -edge_x, edge_x)
        y = clip(y, -edge_y, edge_y)
    return x, y
