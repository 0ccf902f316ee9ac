"""Glances from the ball up to the landmarks round the field, to correct its believed pose.

A head that follows the ball sees no landmark while the ball is near, and a robot that does not know which way it faces
plays the ball anywhere. So a player that is unsure sweeps its head over the horizon for a moment on its way to the
ball, to one side first and the next time to the other, and looks at the ball again before it would have to search for
it. A ball farther away is kept in the lower part of the picture, the horizon in the upper one.

`k`: the league's constants; `play`: the team's settings.
"""

from math import pi

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, cosine_and_sine, point_of_frame
from soccer_env.skills.searching import point_head, sweep_head
from soccer_env.skills.sight import side_of

TILT = -8.0 * pi / 180.0  # [rad] of the sweep: goals and landmarks from near to far are in the picture, assumed
SWEEP = 1.2  # [rad] to either side, assumed
SEEN = 0.2  # [s] unseen at most before a player takes its eyes off the ball, assumed
UNSEEN = 1.3  # [s] unseen after which the head searches for the ball, assumed: longer than a glance
PHANTOM = 0.5  # [s] for which something beyond the boards may be taken for the ball, assumed
FAR = 0.45  # [m] from which ball and horizon fit into one picture, assumed
ROOM = 0.3  # [m] to a ball: nearer, a player looks away from it only if it is quite lost, assumed
KEEPER_ROOM = 1.0  # [m] the same for a goalkeeper, assumed


@compiled
def look_up(belief, command, memory, k, play):
    """Sweep the head over the horizon for a moment if the player is unsure of its pose; call this in every step."""
    if k.head_pan_limit <= 0.0 or belief.situation.active == 0:
        return
    if memory.glance > 0.0:
        sweep_horizon(command, memory, k, play)
        return
    memory.glance = min(memory.glance + k.dt, 0.0)
    ball = belief.ball
    time_phantom(belief, memory, k, play)
    if play.sweeps > 0.0 and (ball.age > UNSEEN or memory.phantom > PHANTOM):
        sweep_head(belief, command, memory, k, play)
        return
    memory.look_side = 0.0
    if ball.age > SEEN:
        return
    unsure = play.unsure if may_look_away(belief) else play.lost
    if memory.glance == 0.0 and belief.own.confidence < unsure:
        memory.glance = play.glance_time
        if memory.glance_side == 0.0:
            memory.glance_side = side_of(ball.bearing)
    elif ball.distance > FAR:
        tilt = -atan2(k.head_camera_height - k.ball_radius, ball.distance - k.head_camera_ahead)
        point_head(command, k, ball.bearing, tilt + play.raised)


@compiled
def time_phantom(belief, memory, k, play):
    """Measure for how long the ball has been seen only beyond the boards, where it cannot be."""
    if play.beyond <= 0.0 or belief.ball.age > 0.0 or belief.ball.confidence <= 0.0:
        return
    own, ball = belief.own, belief.ball
    x, y = point_of_frame(own.x, own.y, ball.x, ball.y, *cosine_and_sine(own.heading))
    off = abs(x) > 0.5 * k.pitch_length + play.beyond or abs(y) > 0.5 * k.pitch_width + play.beyond
    memory.phantom = memory.phantom + k.dt if off else 0.0


@compiled
def may_look_away(belief):
    """Tell whether the ball is far enough away for the player to look elsewhere for a moment."""
    return belief.ball.distance > (KEEPER_ROOM if belief.situation.keeper == 1 else ROOM)


@compiled
def sweep_horizon(command, memory, k, play):
    """Sweep the head from one side to the other, over goals and landmarks."""
    memory.glance -= k.dt
    share = clip(memory.glance / play.glance_time, 0.0, 1.0)
    point_head(command, k, memory.glance_side * SWEEP * (2.0 * share - 1.0), TILT)
    if memory.glance <= 0.0:
        memory.glance, memory.glance_side = -play.glance_rest, -memory.glance_side
