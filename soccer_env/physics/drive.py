"""From commands to velocities: delay, gait or wheels, acceleration and traction.

A legged robot latches its walk when a gait step ends; wheels follow at every control step. What the legs or wheels
want is compared with what the body does (it may be pushing something), and the ground bears only so much force.

`k`: the league's constants.
"""

from __future__ import annotations

from math import atan2, cos, sin, sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, into_frame, length, out_of_frame, toward
from soccer_env.leagues.robot import WHEELS_DIFFERENTIAL, WHEELS_OMNI
from soccer_env.optics.head_camera import tilt_at
from soccer_env.physics.paws import aim_paws, note_paws
from soccer_env.random_numbers import normal
from soccer_env.types import RobotStream

SLIP = int(RobotStream.SLIP)


@compiled
def drive(robot, k, step, handedness, stance):
    """Turn a robot's command into what its legs or wheels want of the ground."""
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
    stand_on_ground(robot, k, stance)


@compiled
def request_walk(robot, k, step):
    """Put this step's command into the delay line [m/s, rad/s]; ahead and aside together stay within full effort."""
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
    """Take the walk that was asked for a delay ago."""
    asked = robot.delayed[(step + 1) % (k.delay_steps + 1)]
    robot.target.forward = asked.forward
    robot.target.left = asked.left
    robot.target.turn = asked.turn


@compiled
def draw_slip(robot, k, handedness):
    """Draw how far the coming steps fall short of the walk or beyond it."""
    robot.slip.forward = 1.0 + k.drive_slip * normal(robot.noise, SLIP)
    robot.slip.left = 1.0 + k.drive_slip * normal(robot.noise, SLIP)
    robot.slip.turn = 1.0 + k.drive_slip * normal(robot.noise, SLIP)


@compiled
def change_walk(robot, k):
    """Bring the walk towards its target as fast as gait or motors allow.  MH01

    A robot that kicks or blocks, lies on the ground or is out stands.
    """
    stands = robot.kick_clock > 0.0 or robot.fallen > 0.0 or robot.active == 0
    ahead = (0.0 if stands else robot.target.forward) - robot.walk.forward
    aside = (0.0 if stands else robot.target.left) - robot.walk.left
    change = length(ahead, aside)
    most = k.drive_acceleration * k.dt
    share = 1.0 if change <= most else most / change
    robot.walk.forward += share * ahead
    robot.walk.left += share * aside
    robot.walk.turn = toward(robot.walk.turn, 0.0 if stands else robot.target.turn, k.drive_turn_acceleration * k.dt)


@compiled
def stand_on_ground(robot, k, stance):
    """Say what the legs or wheels want of the ground in this control step, and how much it bears.  MH01

    Who stands holds with all paws or wheels; who walks or drives has less: a trot stands on two of four paws, and
    wheels give no more than their motors, but for those of a differential base, which do not roll sideways. The
    force itself acts in the solver, in every substep. Wheels that others turn backwards brake with all that the
    ground bears: of two that push each other none is carried off.
    """
    forward, left = robot.walk.forward * robot.slip.forward, robot.walk.left * robot.slip.left
    stance.vx, stance.vy = out_of_frame(forward, left, cos(robot.heading), sin(robot.heading))
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
    """Tell whether others push a robot against the way that its wheels drive, faster than they make good in a step.

    A differential base, which turns to go elsewhere, keeps to what its motors give.
    """
    wanted = length(stance.vx, stance.vy)
    along = stance.vx * robot.vx + stance.vy * robot.vy
    return k.drive_kind == WHEELS_OMNI and along < -wanted * k.drive_thrust * k.dt


@compiled
def keeps_standing(robot, k):
    """Tell whether a robot stands: it has come to rest, and since then its legs or wheels want nothing else.

    One that brakes has no more than its drive gives; one that stands and is pushed slides with all it has.
    """
    if robot.walk.forward != 0.0 or robot.walk.left != 0.0 or robot.walk.turn != 0.0:
        return False
    slow = length(robot.vx, robot.vy) <= k.drive_thrust * k.dt and abs(robot.omega) <= k.drive_turn_thrust * k.dt
    return robot.stands == 1 or slow


@compiled
def move_head(robot, k, ball):
    """Move the head towards what was asked, within its joint limits and speeds.  MS07

    Left to itself it follows the gaze that the robot's belief asks for, or the true ball under ideal senses.
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
    robot.pan = toward(robot.pan, clip(pan, -k.head_pan_limit, k.head_pan_limit), k.head_pan_speed * k.dt)
    robot.tilt = toward(robot.tilt, clip(tilt, k.head_tilt_low, k.head_tilt_high), k.head_tilt_speed * k.dt)


@compiled
def gaze_at(robot, k, ball):
    """Return the pan and tilt [rad] at which the camera looks at the ball."""
    cosine, sine = cos(robot.heading), sin(robot.heading)
    x, y = ball.x - robot.x, ball.y - robot.y
    ahead, left = into_frame(x, y, cosine, sine)
    down = k.head_camera_height - k.ball_radius
    return atan2(left, ahead), -atan2(down, max(length(ahead, left) - k.head_camera_ahead, 0.0))
