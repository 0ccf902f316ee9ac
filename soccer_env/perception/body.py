"""Sensing of a robot's own body: odometry, accelerometer, kicker, and a pose if the settings provide one.  MS06

No robot feels contacts here: a legged robot's touch sensors are in legged/touch.py, and Heinemann et al. 2006 mention
none. A pose is in the team frame, own goal behind. The noisy pose of every frame stands for a localisation that works:
its error changes slowly, like a filter's, and never runs away.

`k`: the league's constants; `s`: settings of the sensors.
"""

from math import exp, pi, sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction, wrap
from soccer_env.guards.ranges import NUMBER, ranged_record
from soccer_env.random_numbers import draw_normal, draw_uniform
from soccer_env.records.percepts import NO_POSE, POSE_SENSED, POSE_TOLD
from soccer_env.types import RobotStream

ODOMETRY = int(RobotStream.ODOMETRY)
BARRIER = int(RobotStream.BARRIER)
POSE = int(RobotStream.POSE)
POSE_ERROR = ranged_record(
    [  # error of the noisy pose: state of the sensor, which delivers the pose alone
        ("x", "f4", NUMBER),  # [m] team frame
        ("y", "f4", NUMBER),  # [m] team frame
        ("heading", "f4", NUMBER),  # [rad]
    ]
)
LEAST_TIME = 1e-9  # [s] a correlation time of zero makes independent errors


@compiled
def sense_body(match, robot, events, body, pose_error, k, s, pose_sensed):
    """Write a robot's own readings into its percept, a BODY_PERCEPT, except the light barrier.  [Sacks 2001, 1]  MS06

    With `pose_sensed` 1 the robot gets a noisy pose in every frame, and `pose_error` holds its error. A robot that was
    just placed is always told its pose.
    """
    first = body.handedness == 0.0  # a percept that was never filled in
    body.frame = match.step
    body.handedness = match.handedness
    body.active = robot.active
    body.upright = 0 if robot.fallen > 0.0 else 1
    body.kicked = events.kick
    body.held = 0
    measure_odometry(robot, body, k, s)
    if pose_sensed == 1:
        sense_noisy_pose(match, robot, body, pose_error, k, s, first)
    else:
        mark_no_pose(body)
    if robot.placed == 1:
        write_placed_pose(match, robot, body, s)


@compiled
def measure_odometry(robot, body, k, s):
    """Measure the odometry: the motion of legs or wheels in this frame, with or without slip on the ground.  MS06

    The robot feels neither slip nor pushing: when stuck, it believes that it walks. The body keeps its direction over
    the ground during a step, so the odometry is the displacement in the axes of the last frame. Errors are factors on
    the measurement and equal in a mirrored match, so handedness plays no part.
    """
    body.forward = add_encoder_error(robot.walk.forward * k.dt, robot.noise, s)
    body.left = add_encoder_error(robot.walk.left * k.dt, robot.noise, s)
    body.turn = add_encoder_error(robot.walk.turn * k.dt, robot.noise, s)


@compiled
def add_encoder_error(step, noise, s):
    """Multiply the length of a step by a random error, as of encoders in legs or wheels; a step of 0 stays 0."""
    return 0.0 if step == 0.0 else step * (1.0 + s.odometry_noise * draw_normal(noise, ODOMETRY))


@compiled
def sense_light_barrier(robot, body, s):
    """Measure whether the ball breaks the light barrier at the kicker; a share of the readings is wrong."""
    wrong = draw_uniform(robot.noise, BARRIER) < s.barrier_miss
    body.held = 1 if (robot.has_ball == 1) != wrong else 0


@compiled
def mark_no_pose(body):
    """Mark in the percept that the robot gets no pose in this frame."""
    body.pose = NO_POSE
    body.x = body.y = body.heading = 0.0


@compiled
def sense_noisy_pose(match, robot, body, error, k, s, first):
    """Measure the robot's pose: the true pose plus an error (POSE_ERROR) that changes slowly.

    Each component of the error is a first-order autoregressive process e' = a e + sqrt(1 - a^2) sd n with
    a = exp(-dt / s.pose_time) and n standard normal; drawn from its stationary distribution in the first frame.
    """
    keep = 0.0 if first else exp(-k.dt / max(s.pose_time, LEAST_TIME))
    fresh = sqrt(1.0 - keep * keep)
    hand = match.handedness
    error.x = keep * np.float64(error.x) + fresh * s.pose_noise * draw_normal(robot.noise, POSE)
    error.y = keep * np.float64(error.y) + fresh * s.pose_noise * hand * draw_normal(robot.noise, POSE)
    error.heading = keep * np.float64(error.heading) + fresh * s.pose_turn_noise * hand * draw_normal(robot.noise, POSE)
    body.pose = POSE_SENSED
    write_pose_with_error(match, robot, body, np.float64(error.x), np.float64(error.y), np.float64(error.heading))


@compiled
def write_placed_pose(match, robot, body, s):
    """Tell a robot that was just placed its pose, which is true to about a hand's breadth."""
    hand = match.handedness
    x = s.place_noise * draw_normal(robot.noise, POSE)
    y = s.place_noise * hand * draw_normal(robot.noise, POSE)
    body.pose = POSE_TOLD
    write_pose_with_error(match, robot, body, x, y, s.place_turn_noise * hand * draw_normal(robot.noise, POSE))


@compiled
def write_pose_with_error(match, robot, body, error_x, error_y, error_heading):
    """Write the robot's true pose in the team frame [m, m, rad] plus an error into its percept."""
    side = attack_direction(match, robot.team)
    heading = robot.heading if side > 0.0 else robot.heading + pi
    body.x, body.y = side * robot.x + error_x, side * robot.y + error_y
    body.heading = wrap(heading + error_heading)
