"""Dribble with the ball in the guide, within the limits of friction.  [Heinemann 2006, 1]  MH24

    "our high-level control code was still good enough, to win the technical challenge by dribbling the ball around
    static obstacles"    [Heinemann 2006, 1]

Only the guide's edge and the carpet's friction hold the ball: a robot that brakes harder than the ball decelerates
loses it ahead, and a robot that curves more sharply than the edge can hold loses it sideways. So the product of speed
and turn rate stays below a grip, v w <= g, and the base moves sideways as it turns: it turns about the ball, not about
its own centre.

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.baselines.heinemann_2006.driving import note_crowd, plan_to
from soccer_env.baselines.weigel_2001.planner.measuring import place_along_path
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, length, wrap
from soccer_env.skills.carrying import pushing_speed

LEAST = 0.15  # [m/s] ahead while it turns, so that the ball stays at the kicker, assumed


@compiled
def dribble(command, sight, memory, k, play, ux, uy):
    """Dribble along (ux, uy), turning with the ball as fast as the guide's grip allows."""
    error = wrap(atan2(uy, ux) - sight.heading)
    now = sight.now_cosine * sight.vx + sight.now_sine * sight.vy
    wanted = clip(error / play.skills.settle, -play.dribble_turn, play.dribble_turn) * sight.pace
    most = grip_turn(play, now)
    turn = clip(wanted, -most, most)
    speed = min(play.dribble_speed * sight.pace, grip_speed(play, wanted))
    speed = min(speed, pushing_speed(sight, k, sight.now_cosine, sight.now_sine))
    speed = max(speed, min(now, play.dribble_speed) - k.ball_rolling * k.dt * (k.delay_steps + 1.0))
    command.forward = clip(speed / k.drive_forward, 0.0, 1.0)
    command.turn = turn / k.drive_turn
    if k.drive_sideways > 0.0:
        command.left = -turn * sight.touch / k.drive_sideways


@compiled
def way_round(k, play, scratch):
    """Return the unit vector in which to dribble along the planned path past players to the opponents' goal.  MH24"""
    sight, plan, place = scratch.sight, scratch.plan[0], scratch.place[0]
    note_crowd(scratch, k, play, False)
    for i in range(scratch.count):
        scratch.crowd[i].radius += play.dribble_room
    wide = 0.5 * k.pitch_goal_width
    plan_to(k, play, scratch, 0.5 * k.pitch_length, clip(sight.ball_y, -wide, wide))
    place_along_path(plan.path, plan.count, play.dribble_ahead, place)
    x, y = place.x - sight.x, place.y - sight.y
    away = length(x, y)
    return (1.0, 0.0) if away < 1e-6 else (x / away, y / away)


@compiled
def grip_speed(play, turn):
    """Return the top speed [m/s] at which the guide holds the ball at turn rate w [rad/s]: max(grip / |w|, `LEAST`)."""
    return max(play.dribble_grip / max(abs(turn), 1e-3), LEAST)


@compiled
def grip_turn(play, speed):
    """Return the top turn rate [rad/s] at which the guide holds the ball at speed v [m/s]: grip / v above `LEAST`."""
    return play.dribble_turn if speed <= LEAST else min(play.dribble_turn, play.dribble_grip / speed)
