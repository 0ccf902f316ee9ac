"""The camera of a legged robot: its position, its direction, and a test whether things are in view.  MS08

Everything is seen in the camera's level axes: `ahead` and `left` over the ground from the point below the camera, along
and across the direction in which it looks; heights from the ground. The picture has u [px] to the left and v [px] up
from its centre, as in optics/head_camera.py.

In a match with handedness -1 these axes are mirrored, left for right, and so is everything drawn in them: a mirrored
match makes the same picture bit for bit, and only the blobs made from it are mirrored back.

`s`: settings of the sensors.
"""

from math import sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import cosine_and_sine, into_frame, out_of_frame
from soccer_env.optics.head_camera import focal_x, focal_y, image_height, image_width, tilt_point

POSE = np.dtype(
    [  # directions of a robot and its head, computed once a step for all robots; mirrored with the handedness
        ("heading", "f8"),  # [rad] the pose for which the cosines and sines below were computed
        ("pan", "f8"),  # [rad] of that pose
        ("tilt", "f8"),  # [rad] of that pose
        ("cosine", "f8"),  # of the heading
        ("sine", "f8"),
        ("gaze_cosine", "f8"),  # of the direction of the head over the ground
        ("gaze_sine", "f8"),
        ("level", "f8"),  # cosine of the tilt
        ("steep", "f8"),  # sine of the tilt
    ]
)
CAMERA = np.dtype(
    [
        ("handedness", "f8"),  # +1; -1: left and right are exchanged
        ("x", "f8"),  # [m] field frame, mirrored with the handedness
        ("y", "f8"),  # [m]
        ("height", "f8"),  # [m]
        ("cosine", "f8"),  # of its direction over the ground
        ("sine", "f8"),
        ("level", "f8"),  # cosine of its tilt
        ("steep", "f8"),  # sine of its tilt
        ("focal_x", "f8"),  # [px]
        ("focal_y", "f8"),  # [px]
        ("half_width", "f8"),  # [px] of the picture
        ("half_height", "f8"),  # [px]
        ("least_area", "f8"),  # [px] of the smallest region that its vision delivers
        ("side_cosine", "f8"),  # of half the viewing angle
        ("side_sine", "f8"),
        ("top_cosine", "f8"),
        ("top_sine", "f8"),
    ]
)


@compiled
def open_camera(camera, s):
    """Compute the constants of a camera: focal lengths, size of the picture, edges of the view."""
    camera.focal_x, camera.focal_y = focal_x(s), focal_y(s)
    camera.half_width, camera.half_height = 0.5 * image_width(s), 0.5 * image_height(s)
    camera.least_area = 0.25 * s.least_area * (1 << (2 * s.resolution))  # the setting is given at 88x72
    camera.side_cosine, camera.side_sine = cosine_and_sine(0.5 * s.view_width)
    camera.top_cosine, camera.top_sine = cosine_and_sine(0.5 * s.view_height)


@compiled
def face_ahead(pose):
    """Set a cached pose to that of a robot that looks straight ahead along the field."""
    pose.heading = pose.pan = pose.tilt = 0.0
    pose.cosine = pose.gaze_cosine = pose.level = 1.0
    pose.sine = pose.gaze_sine = pose.steep = 0.0


@compiled
def update_pose_angles(pose, robot, handedness):
    """Compute sines and cosines of a robot's angles in its cached pose, if the angles have changed."""
    heading, pan = handedness * robot.heading, handedness * robot.pan
    if pose.heading == heading and pose.pan == pan and pose.tilt == robot.tilt:
        return
    pose.heading, pose.pan, pose.tilt = heading, pan, robot.tilt
    pose.cosine, pose.sine = cosine_and_sine(heading)
    along, across = cosine_and_sine(pan)
    pose.gaze_cosine, pose.gaze_sine = out_of_frame(along, across, pose.cosine, pose.sine)
    pose.level, pose.steep = cosine_and_sine(pose.tilt)


@compiled
def point_camera(camera, robot, pose, handedness, s):
    """Set position and axes of the camera in a robot's head, in the field frame.  MS08"""
    forward, rise = tilt_point(s.camera_ahead, s.camera_up, pose.level, pose.steep, 0.0)
    camera.handedness, camera.height = handedness, s.neck_height + rise
    camera.x = robot.x + s.neck_ahead * pose.cosine + forward * pose.gaze_cosine
    camera.y = handedness * robot.y + s.neck_ahead * pose.sine + forward * pose.gaze_sine
    camera.cosine, camera.sine = pose.gaze_cosine, pose.gaze_sine
    camera.level, camera.steep = pose.level, pose.steep


@compiled
def from_camera(camera, x, y):
    """Convert a point from the field frame to distances ahead and to the left of the camera [m]."""
    x, y = x - camera.x, camera.handedness * y - camera.y
    return into_frame(x, y, camera.cosine, camera.sine)


@compiled
def to_camera_axes(camera, ahead, left, height):
    """Convert a point to its depth along the optical axis, and its distances to the left of and above that axis [m]."""
    up = height - camera.height
    return ahead * camera.level + up * camera.steep, left, up * camera.level - ahead * camera.steep


@compiled
def in_view(camera, ahead, left, height, radius):
    """Tell whether any part of a sphere may be in the picture: within the four planes of the view, before the lens."""
    depth, left, above = to_camera_axes(camera, ahead, left, height)
    return (
        depth > -radius
        and abs(left) * camera.side_cosine - depth * camera.side_sine < radius
        and abs(above) * camera.top_cosine - depth * camera.top_sine < radius
    )


@compiled
def sphere_box(camera, depth, left, above, radius):
    """Return the bounding box (left, right, high, low) [px] of a sphere in the picture, wholly in front of the lens.

    Its edges are the planes through the lens, along an axis of the picture, that touch the sphere: exact everywhere.
    """
    beside = depth * depth - radius * radius  # above 0: the sphere lies before the lens
    across = radius * sqrt(beside + left * left)
    upward = radius * sqrt(beside + above * above)
    u, v = depth * left, depth * above
    return (
        camera.focal_x * (u + across) / beside,
        camera.focal_x * (u - across) / beside,
        camera.focal_y * (v + upward) / beside,
        camera.focal_y * (v - upward) / beside,
    )
