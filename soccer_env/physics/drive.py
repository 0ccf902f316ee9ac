"""From commands to the velocities that legs or wheels want: delay, gait or wheels, acceleration and traction.

A legged robot latches its walk when a gait step ends; wheels follow at every control step. The body may move otherwise,
for instance because it pushes something; the ground then accelerates it towards the wanted velocity with limited force.
Paws swing with the gait (MS51) and spread for a block (MS53).

`k`: the league's constants.
"""

from __future__ import annotations

from math import sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, cosine_and_sine, into_frame, length, out_of_frame, step_toward
from soccer_env.leagues.robot import WHEELS_DIFFERENTIAL, WHEELS_OMNI
from soccer_env.optics.head_camera import tilt_at
from soccer_env.physics.block import foreleg_spread, paw_shift
from soccer_env.physics.gait import LEGS, TIPS, paw_offset
from soccer_env.random_numbers import draw_normal
from soccer_env.types import RobotStream

SLIP = int(RobotStream.SLIP)


@compiled
def drive_robot(robot, k, step, handedness, stance):
    """Turn a robot's command into the velocity that its legs or wheels want."""
    if k.legs == 1:
        note_paws(robot, k, stance, handedness)
    request_walk(robot, k, step)
    if robot.gait_phase % k.slip_steps == 0 and k.drive_slip > 0.0:
        draw_slip(robot, k, handedness)
    if robot.gait_phase % k.gait_steps == 0:
        latch_walk(robot, k, step)
    robot.gait_phase += 1
    if robot.gait_phase % k.slip_steps == 0 and robot.gait_phase % k.gait_steps == 0:
        robot.gait_phase = 0
    change_walk(robot, k)
    if k.legs == 1:
        aim_paws(robot, k, stance, handedness)
    set_wanted_velocity(robot, k, stance)


@compiled
def request_walk(robot, k, step):
    """Put this step's walk command into the delay line [m/s, rad/s]; (forward, left) is limited to length 1 first."""
    forward, left, turn = robot.command.forward, robot.command.left, robot.command.turn
    if k.drive_kind == WHEELS_DIFFERENTIAL:
        left = 0.0
    effort = sqrt(forward * forward + left * left)
    if effort > 1.0:
        forward, left = forward / effort, left / effort
    slot = robot.delayed[step % (k.delay_steps + 1)]
    slot.forward = forward * (k.drive_forward if forward > 0.0 else k.drive_backward)
    slot.left = left * k.drive_sideways
    slot.turn = turn * k.drive_turn


@compiled
def latch_walk(robot, k, step):
    """Take the walk that was requested one delay ago as the target."""
    walk = robot.delayed[(step + 1) % (k.delay_steps + 1)]
    robot.target.forward = walk.forward
    robot.target.left = walk.left
    robot.target.turn = walk.turn


@compiled
def draw_slip(robot, k, handedness):
    """Draw random slip factors for the next steps: actual over commanded speed, forward, sideways and in turning."""
    robot.slip.forward = 1.0 + k.drive_slip * draw_normal(robot.noise, SLIP)
    robot.slip.left = 1.0 + k.drive_slip * draw_normal(robot.noise, SLIP)
    robot.slip.turn = 1.0 + k.drive_slip * draw_normal(robot.noise, SLIP)


@compiled
def change_walk(robot, k):
    """Bring the walk towards its target as fast as gait or motors allow.  MH01

    A robot that kicks, blocks, lies on the ground or is sent off stands still.
    """
    stands = robot.kick_clock > 0.0 or robot.fallen > 0.0 or robot.active == 0
    ahead = (0.0 if stands else robot.target.forward) - robot.walk.forward
    aside = (0.0 if stands else robot.target.left) - robot.walk.left
    change = length(ahead, aside)
    most = k.drive_acceleration * k.dt
    share = 1.0 if change <= most else most / change
    robot.walk.forward += share * ahead
    robot.walk.left += share * aside
    robot.walk.turn = step_toward(
        robot.walk.turn, 0.0 if stands else robot.target.turn, k.drive_turn_acceleration * k.dt
    )


@compiled
def set_wanted_velocity(robot, k, stance):
    """Set the velocity that the legs or wheels want in this control step, and the force that the ground bears.  MH01

    A standing robot holds with all paws or wheels. A moving robot has less: a trot stands on two of four paws, and
    wheels give no more than their motors, except sideways on a differential base. Wheels that others turn backwards
    brake with the full traction, so that of two robots that push each other neither is carried off. The solver
    applies the force in every substep.
    """
    forward, left = robot.walk.forward * robot.slip.forward, robot.walk.left * robot.slip.left
    stance.vx, stance.vy = out_of_frame(forward, left, *cosine_and_sine(robot.heading))
    stance.active = robot.active
    stance.omega = robot.walk.turn * robot.slip.turn
    stance.caught_by, stance.caught_leg, stance.caught_gap = robot.caught_by, robot.caught_leg, robot.caught_gap
    robot.stands = 1 if keeps_standing(robot, k) else 0
    holds = robot.stands == 1 or is_driven_back(robot, k, stance)
    stance.traction = k.drive_traction if holds else k.drive_thrust
    stance.turn_traction = k.drive_turn_traction if robot.stands == 1 else k.drive_turn_thrust
    stance.grip = k.drive_traction if k.drive_kind == WHEELS_DIFFERENTIAL else stance.traction


@compiled
def is_driven_back(robot, k, stance):
    """Tell whether a robot is pushed against its wheels' drive, faster than its motors can correct in a control step.

    Only omnidirectional bases count: a differential base turns away, and never brakes with more than its motors give.
    """
    wanted = length(stance.vx, stance.vy)
    along = stance.vx * robot.vx + stance.vy * robot.vy
    return k.drive_kind == WHEELS_OMNI and along < -wanted * k.drive_thrust * k.dt


@compiled
def keeps_standing(robot, k):
    """Tell whether a robot stands: it has come to rest, and its legs or wheels have wanted no motion since then.

    A braking robot has the thrust of its drive; a standing robot that is pushed resists with the full traction.
    """
    if robot.walk.forward != 0.0 or robot.walk.left != 0.0 or robot.walk.turn != 0.0:
        return False
    slow = length(robot.vx, robot.vy) <= k.drive_thrust * k.dt and abs(robot.omega) <= k.drive_turn_thrust * k.dt
    return robot.stands == 1 or slow


@compiled
def move_head(robot, k, ball):
    """Move the head towards the commanded pan and tilt, within its joint limits and speeds.  MS07

    Without a head command the head follows the gaze that the belief has chosen, or the true ball under ideal senses.
    """
    if k.head_pan_limit <= 0.0:
        return
    if robot.command.head >= 0.0:
        pan = robot.command.pan * k.head_pan_limit
        tilt = tilt_at(robot.command.tilt, k.head_tilt_low, k.head_tilt_high)
    elif robot.senses == 1:
        pan, tilt = robot.gaze.pan, robot.gaze.tilt
    else:
        pan, tilt = gaze_at(robot, k, ball)
    robot.pan = step_toward(robot.pan, clip(pan, -k.head_pan_limit, k.head_pan_limit), k.head_pan_speed * k.dt)
    robot.tilt = step_toward(robot.tilt, clip(tilt, k.head_tilt_low, k.head_tilt_high), k.head_tilt_speed * k.dt)


@compiled
def gaze_at(robot, k, ball):
    """Return the pan and tilt [rad] at which the camera looks at the ball."""
    cosine, sine = cosine_and_sine(robot.heading)
    x, y = ball.x - robot.x, ball.y - robot.y
    ahead, left = into_frame(x, y, cosine, sine)
    down = k.head_camera_height - k.ball_radius
    return atan2(left, ahead), -atan2(down, max(length(ahead, left) - k.head_camera_ahead, 0.0))


@compiled
def note_paws(robot, k, stance, handedness):
    """Store the positions of a robot's paws before its gait advances, and the spread of its forelegs in a block."""
    for leg in range(LEGS):
        paw = stance.posts[leg]
        ahead, left = paw_offset(robot, k, leg, handedness)
        paw.x, paw.y = paw.stand_x + ahead, handedness * paw.stand_y + left
    stance.spread = foreleg_spread(robot, k, 0.0)
    if stance.spread > 0.0:
        for leg in range(TIPS):
            paw = stance.posts[leg]
            ahead, left = paw_shift(k, leg, stance.spread, handedness)
            paw.x += ahead
            paw.y += left


@compiled
def aim_paws(robot, k, stance, handedness):
    """Set the velocity that moves each paw within a control step to its new place in the gait or block."""
    spread = foreleg_spread(robot, k, k.dt)
    stance.spread_rate = (spread - stance.spread) / k.dt
    for leg in range(LEGS):
        paw = stance.posts[leg]
        ahead, left = paw_offset(robot, k, leg, handedness)
        if spread > 0.0:
            out_x, out_y = paw_shift(k, leg, spread, handedness)
            ahead += out_x
            left += out_y
        paw.vx = (paw.stand_x + ahead - paw.x) / k.dt
        paw.vy = (handedness * paw.stand_y + left - paw.y) / k.dt
