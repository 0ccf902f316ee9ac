"""The pose that a robot is given from outside: a noisy one in every frame, or where it was put at a restart.

Both are in the team frame, own goal behind. The noisy pose stands for a localisation that works: its error changes
slowly, as that of a filter does, and never runs away.

`k`: the league's constants; `s`: settings of the sensors.
"""

from math import exp, pi, sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import direction_of, wrap
from soccer_env.guards.ranges import NUMBER, record
from soccer_env.random_numbers import normal
from soccer_env.records.percepts import NO_POSE, POSE_SENSED, POSE_TOLD
from soccer_env.types import RobotStream

POSE = int(RobotStream.POSE)
POSE_ERROR = record(
    [  # what the noisy pose is off by: state of the sensor, which delivers the pose alone
        ("x", "f4", NUMBER),  # [m] team frame
        ("y", "f4", NUMBER),  # [m] team frame
        ("heading", "f4", NUMBER),  # [rad]
    ]
)
LEAST_TIME = 1e-9  # [s] a correlation time of zero makes independent errors


@compiled
def no_pose(body):
    """Mark the percept as one without a pose."""
    body.pose = NO_POSE
    body.x = body.y = body.heading = 0.0


@compiled
def follow_pose(match, robot, body, error, k, s, first):
    """Fill in the noisy pose: the truth plus an error (POSE_ERROR) that changes slowly.

    Each component of the error is a first-order autoregressive process e' = a e + sqrt(1 - a^2) sd n with
    a = exp(-dt / s.pose_time) and n standard normal; drawn from its stationary distribution in the first frame.
    """
    keep = 0.0 if first else exp(-k.dt / max(s.pose_time, LEAST_TIME))
    fresh = sqrt(1.0 - keep * keep)
    hand = match.handedness
    error.x = keep * np.float64(error.x) + fresh * s.pose_noise * normal(robot.noise, POSE)
    error.y = keep * np.float64(error.y) + fresh * s.pose_noise * hand * normal(robot.noise, POSE)
    error.heading = keep * np.float64(error.heading) + fresh * s.pose_turn_noise * hand * normal(robot.noise, POSE)
    body.pose = POSE_SENSED
    give_pose(match, robot, body, np.float64(error.x), np.float64(error.y), np.float64(error.heading))


@compiled
def tell_pose(match, robot, body, s):
    """Fill in where the robot was put, as it is told: it stands a hand's breadth beside that place."""
    hand = match.handedness
    x = s.place_noise * normal(robot.noise, POSE)
    y = s.place_noise * hand * normal(robot.noise, POSE)
    body.pose = POSE_TOLD
    give_pose(match, robot, body, x, y, s.place_turn_noise * hand * normal(robot.noise, POSE))


@compiled
def give_pose(match, robot, body, error_x, error_y, error_heading):
    """Fill in the true pose in the team frame [m, m, rad] plus an error in the same axes."""
    side = direction_of(match, robot.team)
    heading = robot.heading if side > 0.0 else robot.heading + pi
    body.x, body.y = side * robot.x + error_x, side * robot.y + error_y
    body.heading = wrap(heading + error_heading)
