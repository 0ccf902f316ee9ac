"""Places of the robots at a restart, for any number of players, written for the team that attacks +x.

`k`: the league's constants.
"""

from math import pi

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, attack_direction, clip, length, wrap
from soccer_env.random_numbers import draw_uniform
from soccer_env.referee.set_pieces import defender_place, has_to_pass, move_out_of_area, receiver_place, way_to_receiver
from soccer_env.types import NO_TEAM, Phase, RobotStream

KICK_OFF, PENALTY_KICK = int(Phase.KICK_OFF), int(Phase.PENALTY_KICK)
PLACEMENT = int(RobotStream.PLACEMENT)
DEFENDERS = 4  # opponents with places of their own at a restart whose taker has to pass
ROW = 4  # field players side by side
DEPTH = 0.14  # [1] of the pitch's length between rows, assumed
SPREAD = 0.7  # [1] of the pitch's width over which a row is spread, assumed
FOLLOW = 0.5  # [1] share of the ball's x by which a formation follows it, assumed
GAP = 0.06  # [m] between the taker of a restart and the ball, assumed; in a smaller gap jitter puts a paw on the ball
JITTER = 0.02  # [m] greatest deviation of a robot from its place, assumed
JITTER_TURN = 5.0 * pi / 180.0  # [rad] greatest deviation of a robot's heading, assumed


@compiled
def choose_places(match, robots, k):
    """Set the place of each active robot for the match's current restart; handedness -1 mirrors the formation."""
    for r in range(robots.shape[0]):
        if robots[r].active == 0:
            continue
        side = attack_direction(match, robots[r].team)
        across = side * match.handedness
        spot_x, spot_y = side * match.restart_x, across * match.restart_y
        index, count = rank_in_team(robots, r)
        if robots[r].keeper == 1:
            x, y, heading = keeper_place(k, spot_x, spot_y)
        elif has_to_pass(match, k) and match.restart_team != NO_TEAM:
            ours = robots[r].team == match.restart_team
            x, y, heading = set_piece_place(match, k, ours, index, count, spot_x, spot_y)
        elif robots[r].team == match.restart_team and index == count - 1:
            x, y, heading = taker_place(k, spot_x, spot_y, 0.5 * k.pitch_length - spot_x, -spot_y)
        else:
            x, y, heading = field_place(match, k, index, count, spot_x, spot_y)
        x += JITTER * (2.0 * draw_uniform(robots[r].noise, PLACEMENT) - 1.0)
        y += JITTER * (2.0 * draw_uniform(robots[r].noise, PLACEMENT) - 1.0)
        heading = match.handedness * (heading + JITTER_TURN * (2.0 * draw_uniform(robots[r].noise, PLACEMENT) - 1.0))
        robots[r].place_x, robots[r].place_y = side * x, across * y
        robots[r].place_heading = wrap(heading if side > 0.0 else heading + pi)


@compiled
def rank_in_team(robots, r):
    """Return the rank of robot r by number among its team's active field players, and their count."""
    index = count = 0
    for other in range(robots.shape[0]):
        if robots[other].team == robots[r].team and robots[other].active == 1 and robots[other].keeper == 0:
            count += 1
            if robots[other].number < robots[r].number:
                index += 1
    return index, count


@compiled
def is_taker(match, robots, r):
    """Tell whether robot r takes the match's current restart."""
    if match.restart_team == NO_TEAM or robots[r].team != match.restart_team or robots[r].keeper == 1:
        return False
    index, count = rank_in_team(robots, r)
    return index == count - 1


@compiled
def is_onlooker(match, robots, r):
    """Tell whether robot r neither takes the current penalty kick nor keeps the goal."""
    if is_taker(match, robots, r) or r == match.taker:
        return False
    return robots[r].keeper == 0 or robots[r].x * (match.restart_x) < 0.0


@compiled
def keeper_place(k, spot_x, spot_y):
    """Return the goalkeeper's place [m, m, rad]: in its goal, on the ball's side."""
    x = -0.5 * k.pitch_length + k.body_reach + 0.05
    y = clip(0.3 * spot_y, -0.35 * k.pitch_goal_width, 0.35 * k.pitch_goal_width)
    return x, y, atan2(spot_y - y, spot_x - x)


@compiled
def set_piece_place(match, k, ours, index, count, spot_x, spot_y):
    """Return the place of a field player at a restart whose taker has to pass; the last player takes it."""
    if ours and index == count - 1:
        ahead, aside = way_to_receiver(k, spot_x, spot_y)
        return taker_place(k, spot_x, spot_y, ahead, aside)
    if ours and index == count - 2:
        return receiver_place(k, spot_x, spot_y)
    if not ours and count - 1 - index < DEFENDERS:
        return defender_place(k, count - 1 - index, spot_x, spot_y)
    x, y, _ = field_place(match, k, index, count, spot_x, spot_y)
    return move_out_of_area(k, x, y, spot_x, spot_y)


@compiled
def taker_place(k, spot_x, spot_y, ahead, aside):
    """Return the taker's place behind the ball, facing in a direction (ahead, aside)."""
    away = length(ahead, aside)
    back = (k.body_front + k.ball_radius + GAP) / away
    return spot_x - back * ahead, spot_y - back * aside, atan2(aside, ahead)


@compiled
def field_place(match, k, index, count, spot_x, spot_y):
    """Return the place of the index-th of count field players: rows across the own half that follow the ball.

    The rows follow the ball only as far as the rearmost row stays on the pitch.
    """
    if match.phase == PENALTY_KICK:  # both teams wait beyond the halfway line
        return onlooker_place(k, index, count, spot_x, spot_y)
    row = index // ROW
    columns = min(ROW, count - ROW * row)
    step = DEPTH * k.pitch_length
    least = step * ((count + ROW - 1) // ROW) - 0.5 * k.pitch_length + k.body_reach + JITTER
    x = max(FOLLOW * spot_x, least) - step * (row + 1)
    y = SPREAD * k.pitch_width * ((index - ROW * row + 0.5) / columns - 0.5)
    if match.phase == KICK_OFF:
        x = min(x, -k.body_reach - JITTER)
    return x, y, atan2(spot_y - y, spot_x - x)


@compiled
def onlooker_place(k, index, count, spot_x, spot_y):
    """Return the place of a field player without a part in a penalty kick: in a row beyond the halfway line."""
    team_row = 1.0 if spot_x > 0.0 else 2.0
    x = -team_row * DEPTH * k.pitch_length * (1.0 if spot_x > 0.0 else -1.0)
    y = SPREAD * k.pitch_width * ((index + 0.5) / count - 0.5)
    return x, y, atan2(spot_y - y, spot_x - x)
