"""The "extended logical actuators" (XLAs): commands to legs and head.  [Sacks 2001, 2]  MS01, MS21

Each function writes a command. A walk command takes effect when the gait's present step ends.

`k`: the league's constants; `play`: the team's settings.
"""

from math import pi

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, from_polar, into_frame, length
from soccer_env.optics.head_camera import share_of_tilt
from soccer_env.skills.moves import avoid_others, push, turn_by
from soccer_env.skills.sight import predict_ball, side_of

GLANCE_TILT = -12.0 * pi / 180.0  # [rad] at which a dribbler sees players near and far, assumed
GLANCE_PAN = 40.0 * pi / 180.0  # [rad] to both sides, in turn, assumed
POCKET_TILT = -75.0 * pi / 180.0  # [rad] at which the ball between the paws is seen, from the camera's geometry
FAR_TILT, NEAR_TILT = -20.0 * pi / 180.0, -68.0 * pi / 180.0  # [rad] of a search over the field, at the feet, assumed
SWEEP = 1.6  # [s] of a sweep of the searching head, assumed
SWEEP_SHARE = 0.8  # [1] of the pan's range that a sweep covers, assumed
SEARCH_TURN = 0.7  # [1] of the top turn rate in search, assumed
LEAST_DELAY = 0.1  # [s] by which the ball is led at least, assumed
TOUCHING = 0.15  # [1] of the top speed ahead with which an orbiting robot keeps the ball at its chest, assumed


@compiled
def walk_to_ball(command, sight, k, play, speed):
    """Walk at `speed` [m/s] to the point where the player can meet a rolling ball, turning to that point."""
    gap = max(sight.distance - sight.touch, 0.0)
    x, y = predict_ball(sight, k, clip(gap / max(speed, 1e-3), LEAST_DELAY, play.lead))
    dx, dy = x - sight.x, y - sight.y
    away = max(length(dx, dy), 1e-6)
    dx, dy = dx / away, dy / away
    if play.avoid_chasing == 1:
        dx, dy = avoid_others(sight, k, dx, dy, away)
    ahead, left = into_frame(dx, dy, sight.cosine, sight.sine)
    turn_by(command, sight, k, play, atan2(left, ahead))
    if ahead > 0.0:
        push(command, sight, k, ahead * ahead, left * ahead, speed)


@compiled
def walk_back(command, sight):
    """Command steps backwards.  MS23"""
    command.forward = -sight.pace


@compiled
def sidestep(command, sight, side):
    """Command steps to the left (side +1) or to the right (-1).  MS24"""
    command.left = side * sight.pace


@compiled
def rotate(command, sight, k, play, angle):
    """Turn on the spot by an angle [rad].  MS25"""
    turn_by(command, sight, k, play, angle)


@compiled
def orbit(command, sight, k, play, angle, side):
    """Walk round the ball, keeping it at the chest, to turn by an angle [rad]; `side` +1 turns left.  MS26"""
    rate = play.orbit_share * k.drive_sideways / sight.touch
    rate = min(rate, abs(angle) / play.settle)
    command.turn = side * sight.pace * min(rate / k.drive_turn, 1.0)
    command.left = -side * sight.pace * min(rate * sight.touch / max(k.drive_sideways, 1e-6), 1.0)
    command.forward = TOUCHING * sight.pace


@compiled
def turn_with_ball(command, sight, k, play, angle):
    """Turn by an angle [rad] on the spot while pressing against the ball, where there is no room to orbit."""
    turn_by(command, sight, k, play, angle)
    command.forward = sight.pace


@compiled
def step_with_ball(command, sight, k, play, off, speed, turn):
    """Push the ball at a speed [m/s] in a direction `off` [rad] from straight ahead, turning by `turn` [rad].  MS45"""
    ahead, left = from_polar(speed, off)
    command.forward = sight.pace * min(ahead / (k.drive_forward if ahead > 0.0 else k.drive_backward), 1.0)
    command.left = sight.pace * clip(left / max(k.drive_sideways, 1e-6), -1.0, 1.0)
    command.turn = sight.pace * clip(turn / (play.settle * k.drive_turn), -play.dribble_turn, play.dribble_turn)


@compiled
def point_head(command, k, pan, tilt):
    """Command a pan and tilt [rad] of the head, which replace its automatic gaze."""
    if k.head_pan_limit <= 0.0:
        return
    command.head, command.pan = 1.0, pan / k.head_pan_limit
    command.tilt = share_of_tilt(tilt, k.head_tilt_low, k.head_tilt_high)


@compiled
def look_down(command, k):
    """Point the head at the ball between the paws."""
    point_head(command, k, 0.0, POCKET_TILT)


@compiled
def look_ahead(command, k):
    """Point the head straight ahead, up the field."""
    point_head(command, k, 0.0, GLANCE_TILT)


@compiled
def glance(command, memory, own, k, play, off, elapsed):
    """While dribbling, look up from the ball for a moment, alternately left and right of the path, then down again.

    The look lasts longer if the robot is unsure of its own pose.
    """
    memory.glance += elapsed
    longer = max(play.unsure_glance - play.glance_time, 0.0) if own.confidence < play.unsure else 0.0
    period = play.glance_period + longer
    if memory.glance >= 2.0 * period:
        memory.glance = 0.0
    first = memory.glance < period
    phase = memory.glance if first else memory.glance - period
    if phase >= play.glance_time + longer or k.head_pan_limit <= 0.0:
        return
    side = memory.way_side if first else -memory.way_side
    memory.glances = 1
    point_head(command, k, clip(off + 0.5 * GLANCE_PAN * side, -GLANCE_PAN, GLANCE_PAN), GLANCE_TILT)


@compiled
def look_around(command, memory, k, bearing, elapsed):
    """Sweep the head over the edge of the field to find landmarks, starting on the side of the ball."""
    if memory.side == 0.0:
        memory.side = side_of(bearing)
    memory.scan += elapsed
    if memory.scan >= 2.0 * SWEEP:
        memory.scan = 0.0
    share = memory.scan / SWEEP
    pan = 2.0 * share - 1.0 if share < 1.0 else 3.0 - 2.0 * share
    point_head(command, k, memory.side * pan * k.head_pan_limit * SWEEP_SHARE, GLANCE_TILT)


@compiled
def search_for_ball(command, sight, memory, k, play, bearing, elapsed):
    """Turn on the spot to the side where the ball was last seen, sweeping the head over field and feet."""
    if memory.clock == 0.0 or memory.side == 0.0:
        memory.side = side_of(bearing)
    command.turn = SEARCH_TURN * memory.side * sight.pace
    memory.turned += abs(command.turn) * k.drive_turn * elapsed
    memory.scan += elapsed
    if memory.scan >= 3.0 * SWEEP:
        memory.scan = 0.0
    sweep = 0 if memory.scan < SWEEP else (1 if memory.scan < 2.0 * SWEEP else 2)
    share = memory.scan / SWEEP - sweep
    way = memory.side if sweep == 1 else -memory.side
    pan = way * k.head_pan_limit * SWEEP_SHARE * (2.0 * share - 1.0)
    point_head(command, k, pan, NEAR_TILT if sweep == 2 else FAR_TILT)
