"""What a robot feels of itself: odometry, touch, the accelerometer, and the pose that it is told or given.  MS06"""

from __future__ import annotations

from soccer_env.compiled import compiled


@compiled
def sense_body(match, robot, events, body, k, s, pose_sensed):
    """Fill in a BODY_PERCEPT; the odometry is what the legs or wheels did, whatever the ground made of it."""
    body.frame = match.step
    body.handedness = match.handedness
    body.forward, body.left, body.turn = robot.walk.forward * k.dt, robot.walk.left * k.dt, robot.walk.turn * k.dt
