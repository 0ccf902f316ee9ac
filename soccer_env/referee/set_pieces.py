"""Places at a restart whose taker has to pass, for any number of players, the taker's team attacking +x.

    goal  K |        c              ball <- taker, behind it, facing its mate
            |     c      m  receiver        m marks the receiver, w stands in the way to the goal,
          K |         w                     c wait outside their penalty area

All other robots stand in the rows of `formation`. Assumed: teams line up like this.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, length
from soccer_env.types import Phase

KICK_OFF, PENALTY_KICK = int(Phase.KICK_OFF), int(Phase.PENALTY_KICK)
PASS = 2.0  # [m] from the ball to the receiver of the pass, assumed
UPFIELD = 3.0  # [m] behind the halfway line; from farther back the pass goes forward, assumed
WING = 2.2  # [m] from the middle, the aim of a forward pass, assumed
MARK = 1.5  # [m] from the receiver towards the goal to the opponent that marks it, assumed
WALL = 0.1  # [m] beyond the rules' distance to the opponent in the way to the goal, assumed
COVER_Y = 1.0  # [m] distance of the waiting defenders from the middle, assumed
OFF_AREA = 0.4  # [m] distance of the waiting defenders from their penalty area, assumed


@compiled
def has_to_pass(match, k):
    """Tell whether the taker of the current restart may not touch the ball again before another robot does."""
    return k.rules_second_touch == 1 and match.phase != KICK_OFF and match.phase != PENALTY_KICK


@compiled
def way_to_receiver(k, spot_x, spot_y):
    """Return the unit vector from the ball to the receiver: inwards, but outwards near the own goal."""
    if spot_x < -UPFIELD:
        x, y = 3.0, (WING if spot_y > 0.0 else -WING) - spot_y
    else:
        x, y = -0.5 * spot_x - 1.5, -0.7 * spot_y
        y += 1.0 if abs(spot_y) < 0.5 else 0.0
    away = length(x, y)
    return x / away, y / away


@compiled
def receiver_place(k, spot_x, spot_y):
    """Return the place of the receiver, facing the ball [m, m, rad]."""
    x, y = way_to_receiver(k, spot_x, spot_y)
    return spot_x + PASS * x, spot_y + PASS * y, atan2(-y, -x)


@compiled
def defender_place(k, index, spot_x, spot_y):
    """Return the place of one of four defenders, in their own frame: their goal at -x, the ball at the spot."""
    home_x, home_y = -0.5 * k.pitch_length - spot_x, -spot_y
    away = max(length(home_x, home_y), 1e-6)
    if index == 0:
        far = k.rules_restart_distance + k.body_reach + WALL
        return spot_x + far * home_x / away, spot_y + far * home_y / away, atan2(-home_y, -home_x)
    if index == 1:
        ahead, aside = way_to_receiver(k, -spot_x, -spot_y)
        x, y = spot_x - PASS * ahead, spot_y - PASS * aside
        home_x, home_y = -0.5 * k.pitch_length - x, -y
        away = max(length(home_x, home_y), 1e-6)
        x, y = x + MARK * home_x / away, y + MARK * home_y / away
    else:
        x = max(0.5 * spot_x - 2.5, OFF_AREA + k.pitch_penalty_depth - 0.5 * k.pitch_length)
        y = (COVER_Y if index == 2 else -COVER_Y) + 0.2 * spot_y
    return move_out_of_area(k, x, y, spot_x, spot_y)


@compiled
def move_out_of_area(k, x, y, spot_x, spot_y):
    """Return a place moved out of the own penalty area, facing the ball [m, m, rad].

    A place that then lies too near the ball is moved aside.
    """
    if abs(y) < 0.5 * k.pitch_penalty_width + OFF_AREA:
        x = max(x, OFF_AREA + k.pitch_penalty_depth - 0.5 * k.pitch_length)
    far = k.rules_restart_distance + 2.0 * k.body_reach
    if length(x - spot_x, y - spot_y) < far:
        y = spot_y + (far if y > spot_y else -far)
    return x, y, atan2(spot_y - y, spot_x - x)
