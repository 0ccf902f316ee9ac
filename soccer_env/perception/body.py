"""What a robot feels of itself: odometry, the accelerometer, its kicker, and a pose that it is given.  MS06

Nobody feels contacts: a legged robot's touch sensors are elsewhere (legged/touch.py), and Heinemann et al. 2006 tell of
none.

`k`: the league's constants; `s`: settings of the sensors.
"""

from soccer_env.compiled import compiled
from soccer_env.perception.pose import follow_pose, no_pose, tell_pose
from soccer_env.random_numbers import normal, uniform
from soccer_env.types import RobotStream

ODOMETRY = int(RobotStream.ODOMETRY)
BARRIER = int(RobotStream.BARRIER)


@compiled
def sense_body(match, robot, events, body, pose_error, k, s, pose_sensed):
    """Fill in a BODY_PERCEPT of either league, but for the light barrier.  [Sacks 2001, 1]  MS06

    `pose_sensed` 1 gives the noisy pose in every frame, and `pose_error` keeps what it is off by; a robot that was
    carried is told where it stands, always.
    """
    first = body.handedness == 0.0  # a percept that was never filled in
    body.frame = match.step
    body.handedness = match.handedness
    body.active = robot.active
    body.upright = 0 if robot.fallen > 0.0 else 1
    body.kicked = events.kick
    body.held = 0
    count_steps(robot, body, k, s)
    if pose_sensed == 1:
        follow_pose(match, robot, body, pose_error, k, s, first)
    else:
        no_pose(body)
    if robot.placed == 1:
        tell_pose(match, robot, body, s)


@compiled
def count_steps(robot, body, k, s):
    """Fill in the odometry: what the legs or wheels did in this frame, whatever the ground made of it.  MS06

    Neither slip nor pushing is felt, so that a robot that is stuck believes that it walks. The body keeps its direction
    over the ground during a step, so that the walk is the displacement in the axes of the last frame. Errors are in
    proportion to what is measured; factors look the same in a mirror, so that handedness has no part in them.
    """
    body.forward = measured(robot.walk.forward * k.dt, robot.noise, s)
    body.left = measured(robot.walk.left * k.dt, robot.noise, s)
    body.turn = measured(robot.walk.turn * k.dt, robot.noise, s)


@compiled
def measured(step, noise, s):
    """Return a step as the encoders of legs or wheels measure it; standing still is measured without error."""
    return 0.0 if step == 0.0 else step * (1.0 + s.odometry_noise * normal(noise, ODOMETRY))


@compiled
def light_barrier(robot, body, s):
    """Fill in whether the light barrier at the kicker is broken; it errs either way in a share of the frames."""
    wrong = uniform(robot.noise, BARRIER) < s.barrier_miss
    body.held = 1 if (robot.has_ball == 1) != wrong else 0
