"""The direction of a dribble: the total force, limited to near the goal's direction.  [Sacks 2001, 4.3]  MS45 to MS49

forces on the robot  ->  direction  ->  at most 70 degrees off the goal (MS46, MS47)  ->  at most 45 or 55 degrees
off straight ahead (MS48)  ->  a step of 3.5 cm (MS45)

`k`: the league's constants; `play`: the team's settings.
"""

from math import cos

from soccer_env.baselines.sacks_2001.forces import as_sensed, goal_force, player_force, repulsion, wall_force
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, cosine_and_sine, from_polar, length, out_of_frame, wrap
from soccer_env.skills.sight import side_of

SAME = 0.6  # [rad] within which the ranger's obstacle is taken to be one of the players, assumed  MS49
BEHIND_LINE = 0.10  # [m] from the goal line to the point behind it at which a dribbler aims, assumed
CLEARLY_BETTER = 2.0  # [1] how much less the other side must repel a decisive robot, assumed


@compiled
def direction_to_goal(own, k):
    """Return the vector [m] from the robot to the opponents' goal, team frame."""
    return 0.5 * k.pitch_length + BEHIND_LINE - own.x, -own.y


@compiled
def choose_dribble_direction(belief, tracks, memory, k, play):
    """Choose the dribble's direction memory.way [rad], team frame, and the side of the goal's direction it lies on."""
    own = belief.own
    goal_x, goal_y = direction_to_goal(own, k)
    pull_x, pull_y = goal_force(goal_x, goal_y, play)
    push_x, push_y = force_of_players(belief, tracks, goal_x, goal_y, k, play)
    push_y += wall_force(own.y, 0.5 * k.pitch_width, play)
    off = limited(pull_x, pull_y, push_x, push_y, memory.way_side, play)
    if play.decisive == 1 and off * memory.way_side < 0.0:
        off = abs(off) * side_with_fewer_players(belief, tracks, goal_x, goal_y, memory.way_side, k, play)
    off = delay_side_change(memory, off, play)
    memory.way = wrap(atan2(goal_y, goal_x) + off)


@compiled
def force_of_players(belief, tracks, goal_x, goal_y, k, play):
    """Return the summed force of other players, team frame; the ranger's obstacle replaces its player.  MS49"""
    cosine, sine = cosine_and_sine(belief.own.heading)
    replaced = player_of_obstacle(belief.obstacle, tracks, k, play)
    push_x = push_y = 0.0
    for slot in range(tracks.shape[0]):
        track = tracks[slot]
        if track.present == 1 and track.age <= play.player_age and slot != replaced:
            x, y = as_sensed(track.x, track.y, k, play)
            dx, dy = out_of_frame(x, y, cosine, sine)
            x, y = player_force(dx, dy, goal_x, goal_y, play)
            push_x, push_y = push_x + x, push_y + y
    if play.infrared_obstacle == 1 and belief.obstacle.distance > 0.0:
        x, y = obstacle_as_sensed(belief.obstacle, k, play)
        dx, dy = out_of_frame(x, y, cosine, sine)
        x, y = player_force(dx, dy, goal_x, goal_y, play)
        push_x, push_y = push_x + x, push_y + y
    return push_x, push_y


@compiled
def obstacle_as_sensed(obstacle, k, play):
    """Return the vector [m], robot frame, to the ranger's obstacle, as long as the ranger's reading.  MS42, MS49"""
    x, y = from_polar(obstacle.distance, obstacle.bearing)
    return as_sensed(x, y, k, play)


@compiled
def player_of_obstacle(obstacle, tracks, k, play):
    """Return the slot of the tracked player that the ranger's obstacle is, the nearest in bearing, or -1.  MS49"""
    best, nearest = -1, SAME
    if play.infrared_obstacle == 1 and obstacle.distance > 0.0:
        to_x, to_y = obstacle_as_sensed(obstacle, k, play)
        for slot in range(tracks.shape[0]):
            x, y = as_sensed(tracks[slot].x, tracks[slot].y, k, play)
            aside = abs(angle_between(to_x, to_y, x, y))
            if tracks[slot].present == 1 and tracks[slot].age <= play.player_age and aside < nearest:
                best, nearest = slot, aside
    return best


@compiled
def limited(pull_x, pull_y, push_x, push_y, side, play):
    """Return the angle [rad], left positive, from goal direction to total force, clipped to play.goal_limit.  MS46

    MS47: where the players' force points away from the goal, by more than 135 degrees, the robot keeps its side, `side`
    (+1, -1, 0 for none).
    """
    off = angle_between(pull_x, pull_y, pull_x + push_x, pull_y + push_y)
    if play.clamp == 0 or abs(off) <= play.goal_limit:
        return off
    against = abs(angle_between(pull_x, pull_y, push_x, push_y)) > play.keep_side_angle
    if play.keep_side == 1 and side != 0.0 and against:
        return side * play.goal_limit
    return side_of(off) * play.goal_limit


@compiled
def angle_between(ax, ay, bx, by):
    """Return the angle [rad] from one vector to another, counter-clockwise."""
    return atan2(ax * by - ay * bx, ax * bx + ay * by)


@compiled
def delay_side_change(memory, off, play):
    """Return the angle to the goal's direction; its sign changes only after play.patience requests in a row.  4.3.3"""
    if off == 0.0:
        return off
    side = side_of(off)
    memory.changes = memory.changes + 1 if side == -memory.way_side else 0
    if 0 < memory.changes <= play.patience:
        return memory.way_side * abs(off)
    memory.way_side, memory.changes = side, 0
    return off


@compiled
def side_with_fewer_players(belief, tracks, goal_x, goal_y, side, k, play):
    """Return the side, +1 or -1, with fewer and farther players; the present side unless clearly worse."""
    left = right = 1e-6
    goal = atan2(goal_y, goal_x)
    for slot in range(tracks.shape[0]):
        track = tracks[slot]
        if track.present == 1 and track.age <= play.player_age:
            x, y = as_sensed(track.x, track.y, k, play)
            off = wrap(belief.own.heading + atan2(y, x) - goal)
            force = repulsion(length(x, y), play.player_gain, play.player_range, play)
            left += force * max(cos(off - play.goal_limit), 0.0)
            right += force * max(cos(off + play.goal_limit), 0.0)
    if side > 0.0:
        return -1.0 if left > CLEARLY_BETTER * right else 1.0
    return 1.0 if right > CLEARLY_BETTER * left else -1.0


@compiled
def off_ahead(belief, tracks, memory, k, play):
    """Return the direction [rad] of the next step from straight ahead, at most 45 degrees, to keep the ball.  MS48

    The limit is 55 degrees if another player stands right ahead: with less, the legs interlock.
    """
    off = wrap(memory.way - belief.own.heading)
    if play.body_clamp == 0:
        return off
    limit = play.blocked_limit if is_blocked(belief, tracks, k, play) else play.body_limit
    return clip(off, -limit, limit)


@compiled
def is_blocked(belief, tracks, k, play):
    """Tell whether another player stands directly ahead.  MS48"""
    if play.infrared_obstacle == 1 and belief.obstacle.distance > 0.0:
        x, y = obstacle_as_sensed(belief.obstacle, k, play)
        if is_right_ahead(x, y, play):
            return True
    for slot in range(tracks.shape[0]):
        track = tracks[slot]
        if track.present == 1 and track.age <= play.player_age:
            x, y = as_sensed(track.x, track.y, k, play)
            if is_right_ahead(x, y, play):
                return True
    return False


@compiled
def is_right_ahead(x, y, play):
    """Tell whether a point x, y [m], robot frame, is near and almost straight ahead.  MS48"""
    return length(x, y) < play.blocked_range and abs(atan2(y, x)) < play.blocked_angle


@compiled
def step_speed(k, play):
    """Return the speed [m/s] of steps of play.step_length, one per gait step.  MS45"""
    return play.step_length / max(k.gait_steps * k.dt, k.dt)
