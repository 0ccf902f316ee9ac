"""The search for a lost ball: a player turns all the way round, then looks from another place.

A head that can turn sweeps over the pitch meanwhile. A goalkeeper looks up the pitch from its goal first.

`k`: the league's constants; `play`: the team's settings.
"""

from math import pi

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, length, wrap
from soccer_env.optics.head_camera import share_of_tilt
from soccer_env.skills.moves import go, leave_boards, step_to
from soccer_env.skills.sight import side_of

LOST = 2.0  # [s] unseen after which the ball is searched for, assumed
SEARCH = 0.9  # [1] of the top turn rate while searching, assumed: the camera still has each place in many pictures
FULL_TURN = 6.3  # [rad]
LONGEST_WALK = 10.0  # [s] to the next place to look from, assumed
LOOKOUT = 0.25  # [pitch lengths] of a field player's lookouts from the centre, assumed
WATCH = 5.0  # [s] for which a goalkeeper looks up the pitch before it turns round, assumed
FAR_TILT, NEAR_TILT = -24.0 * pi / 180.0, -68.0 * pi / 180.0  # [rad] over the pitch, and over the ground at the feet,
# as the head's own search (belief/legged/head.py)
NEAR_BALL = 0.25  # [m] a ball believed nearer is looked for at the feet first, assumed
THERE = 2.0  # [body reaches] from a lookout at which the search on the spot begins anew, assumed


@compiled
def search_for_ball(belief, command, sight, memory, k, play):
    """Turn a full circle, always to one side; then walk to a lookout and turn again.

    A camera on a head sees little more than the field before the robot; a robot that sees all round walks at once.
    """
    if memory.search_side == 0.0:
        begin_search(belief, sight, memory, k)
    if belief.situation.keeper == 1 and play.sweeps > 0.0 and memory.search_clock < WATCH:
        watch_pitch(command, sight, memory, k, play)
        return
    if memory.turned < FULL_TURN and k.head_pan_limit > 0.0:
        command.turn = SEARCH * memory.search_side * sight.pace
        memory.turned += abs(command.turn) * k.drive_turn * sight.elapsed
        leave_boards(command, sight, k)
        return
    if memory.search_clock == 0.0:
        memory.lookout = -side_of(sight.x) * LOOKOUT * k.pitch_length
    memory.search_clock += sight.elapsed
    x = memory.lookout
    if belief.situation.keeper == 1:
        x = -0.5 * k.pitch_length + play.keeper_line * k.body_reach
    go(command, sight, k, play, x, 0.0, 0.0 if belief.situation.keeper == 1 else atan2(-sight.y, x - sight.x), 0.0)
    if memory.search_clock > LONGEST_WALK or length(x - sight.x, sight.y) < THERE * k.body_reach:
        memory.search_clock = memory.turned = 0.0


@compiled
def watch_pitch(command, sight, memory, k, play):
    """Step back to the middle of the own goal and face up the pitch, where the ball must be."""
    memory.search_clock += sight.elapsed
    step_to(command, sight, k, play, -0.5 * k.pitch_length + play.keeper_line * k.body_reach, 0.0, 0.0)


@compiled
def sweep_head(belief, command, memory, k, play):
    """Sweep the head over the pitch, then over the ground at the feet, until the ball is seen; call this in every step.

    The first sweep begins on the side where the ball was last, at the feet if the ball was there.
    """
    ball = belief.ball
    if memory.look_side == 0.0:
        memory.look_side = side_of(ball.bearing)
        memory.look_clock = play.sweeps if ball.confidence > 0.0 and ball.distance < NEAR_BALL else 0.0
    far = memory.look_clock < play.sweeps
    share = memory.look_clock / play.sweeps - (0.0 if far else 1.0)
    pan = memory.look_side * k.head_pan_limit * (1.0 - 2.0 * share) * (1.0 if far else -1.0)
    point_head(command, k, pan, FAR_TILT if far else NEAR_TILT)
    memory.look_clock += k.dt
    if memory.look_clock >= 2.0 * play.sweeps:
        memory.look_clock = 0.0


@compiled
def point_head(command, k, pan, tilt):
    """Command a pan and tilt [rad] of the head, which replace its automatic gaze."""
    command.head, command.pan = 1.0, clip(pan / k.head_pan_limit, -1.0, 1.0)
    command.tilt = share_of_tilt(tilt, k.head_tilt_low, k.head_tilt_high)


@compiled
def begin_search(belief, sight, memory, k):
    """Choose the side to turn to: where the ball was last, or towards the centre spot if it was never seen."""
    bearing = sight.bearing
    if belief.ball.confidence <= 0.0:
        bearing = wrap(atan2(-sight.y, -sight.x) - sight.heading)
    memory.search_side = side_of(bearing)
    memory.turned = memory.search_clock = 0.0


@compiled
def end_search(memory):
    """Note that the ball is found."""
    memory.search_side = 0.0
