"""The other robots in view of a camera: their places, and the boxes with which they hide things behind them.

A body is two upright boxes: the trunk over the rectangle round its hull, from the belly to the back, and a cube for the
head, which turns and moves with pan and tilt. Legs are left out: the camera sees through under the belly.

`k`: the league's constants; `s`: settings of the sensors.
"""

from math import inf

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import into_frame, length, point_of_frame
from soccer_env.optics.head_camera import tilt_point
from soccer_env.perception.legged.camera import from_camera, in_view, update_pose_angles
from soccer_env.perception.legged.infrared import hull_edges
from soccer_env.perception.legged.outlines import (
    CORNERS,
    LENS,
    add_lower,
    add_upper,
    begin_outline,
    end_outline,
    project_box,
    put_corner,
    set_convex_hull,
)

TRUNK, HEAD = 0, 1  # boxes of a body
LOW = 4  # added to the number of an upper corner: that of the corner below it

BOX = np.dtype(
    [  # an upright box, in the level axes of the camera
        ("ahead", "f8"),  # [m] its middle
        ("left", "f8"),  # [m]
        ("cosine", "f8"),  # of the direction of its length
        ("sine", "f8"),
        ("half_length", "f8"),  # [m]
        ("half_width", "f8"),  # [m]
        ("low", "f8"),  # [m] over the ground
        ("high", "f8"),  # [m]
        ("radius", "f8"),  # [m] of the circle round it, seen from above
        ("distance", "f8"),  # [m] of its middle from the camera, over the ground
        ("shown", "i8"),  # 1: some of it may be in the picture
        ("traced", "i8"),  # 1: its outline is up to date
    ]
)
BODY = np.dtype(
    [
        ("teammate", "i8"),
        ("tilt", "f8"),  # [rad] of its head, up positive
        ("crown", "f8"),  # [m] height of the head stickers' middle
        ("crown_ahead", "f8"),  # [m] how far these stickers are ahead of the head's middle
        ("boxes", BOX, (2,)),
        ("first", "i8"),  # index of the first sticker of its jersey among the pieces of its team's colour
        ("pieces", "i8"),  # how many stickers of its jersey follow each other there
    ]
)
RECTANGLE = np.dtype(
    [
        ("back", "f8"),  # [m] of the hull, robot frame
        ("front", "f8"),  # [m]
        ("half_width", "f8"),  # [m]
        ("trunk_radius", "f8"),  # [m] of the circle round the trunk, seen from above
        ("trunk_extent", "f8"),  # [m] radius of the sphere round the trunk
        ("head_radius", "f8"),  # [m] of the circle round the head, seen from above
        ("head_extent", "f8"),  # [m] radius of the sphere round the head
        ("extent", "f8"),  # [m] radius of a sphere that holds trunk and head, at any pan and tilt
        ("middle", "f8"),  # [m] height of its middle
    ]
)


@compiled
def measure_hull(rectangle, k, s):
    """Compute constants of the robots' hull: the rectangle round it, and spheres round trunk, head and whole robot."""
    rectangle.back, rectangle.front, rectangle.half_width = hull_edges(k)
    half = 0.5 * s.head_size
    swing = length(s.camera_ahead - half, s.camera_up)  # of the head's middle about the neck
    rectangle.trunk_radius = length(0.5 * (rectangle.front - rectangle.back), rectangle.half_width)
    rectangle.trunk_extent = length(rectangle.trunk_radius, 0.5 * (s.trunk_height - s.trunk_low))
    rectangle.head_radius = length(half, half)
    rectangle.head_extent = length(rectangle.head_radius, half)
    reach = s.neck_ahead + swing + rectangle.head_radius
    around = length(max(rectangle.front, -rectangle.back), rectangle.half_width)
    rectangle.middle = 0.5 * max(s.neck_height + swing + half, s.trunk_height)
    rectangle.extent = length(max(reach, around), rectangle.middle)


@compiled
def find_bodies(camera, robots, r, poses, rectangle, s, bodies):
    """List the bodies of the robots that may be in the picture of robot r; return the number of bodies.

    Team-mates come first, then opponents, each by number: the same order on both sides of the field.
    """
    count = 0
    for teammate in (1, 0):
        for other in range(robots.shape[0]):
            robot = robots[other]
            if other == r or robot.active == 0 or (robot.team == robots[r].team) != (teammate == 1):
                continue
            ahead, left = from_camera(camera, robot.x, robot.y)
            if in_view(camera, ahead, left, rectangle.middle, rectangle.extent):
                update_pose_angles(poses[other], robot, camera.handedness)
                bodies[count].teammate = teammate
                place_trunk(camera, ahead, left, poses[other], rectangle, s, bodies[count].boxes[TRUNK])
                place_head(camera, ahead, left, poses[other], rectangle, s, bodies[count])
                count += 1
    return count


@compiled
def place_trunk(camera, ahead, left, pose, rectangle, s, trunk):
    """Place the box of a robot's trunk, for a robot whose origin is at ahead, left [m] in camera axes."""
    trunk.cosine, trunk.sine = into_frame(pose.cosine, pose.sine, camera.cosine, camera.sine)
    middle = 0.5 * (rectangle.back + rectangle.front)
    trunk.ahead, trunk.left = ahead + middle * trunk.cosine, left + middle * trunk.sine
    trunk.half_length, trunk.half_width = 0.5 * (rectangle.front - rectangle.back), rectangle.half_width
    trunk.low, trunk.high = s.trunk_low, s.trunk_height
    place_box(camera, trunk, rectangle.trunk_radius, rectangle.trunk_extent)


@compiled
def place_head(camera, ahead, left, pose, rectangle, s, body):
    """Place the box of a robot's head and its stickers, for a robot whose origin is at ahead, left [m] in camera axes.

    The head's own camera is in the middle of the face. Head and stickers move with the tilt, but stay upright.
    """
    head = body.boxes[HEAD]
    trunk = body.boxes[TRUNK]
    half = 0.5 * s.head_size
    head.cosine, head.sine = into_frame(pose.gaze_cosine, pose.gaze_sine, camera.cosine, camera.sine)
    forward, rise = tilt_point(s.camera_ahead - half, s.camera_up, pose.level, pose.steep, 0.0)
    head.ahead = ahead + s.neck_ahead * trunk.cosine + forward * head.cosine
    head.left = left + s.neck_ahead * trunk.sine + forward * head.sine
    head.half_length = head.half_width = half
    head.low, head.high = s.neck_height + rise - half, s.neck_height + rise + half
    above = s.head_sticker_middle - s.neck_height
    crown_forward, crown_rise = tilt_point(s.sticker_head_x, above, pose.level, pose.steep, 0.0)
    body.crown, body.crown_ahead = s.neck_height + crown_rise, crown_forward - forward
    body.tilt = pose.tilt
    place_box(camera, head, rectangle.head_radius, rectangle.head_extent)


@compiled
def place_box(camera, box, radius, extent):
    """Compute a box's distance, and whether it may be in the picture; a sphere of radius `extent` encloses the box."""
    box.radius = radius
    box.distance = length(box.ahead, box.left)
    box.traced = 0
    box.shown = 1 if in_view(camera, box.ahead, box.left, 0.5 * (box.low + box.high), extent) else 0


@compiled
def in_box_axes(box, ahead, left):
    """Convert a point from camera axes to the axes of a box: coordinates along its length and width [m]."""
    ahead, left = ahead - box.ahead, left - box.left
    return into_frame(ahead, left, box.cosine, box.sine)


@compiled
def trace_box(camera, box, tracing, outline):
    """Compute the outline of a box in the picture. A corner's index has the bits 1 behind, 2 right, 4 low."""
    nearest = inf
    for i in range(CORNERS):
        x = -box.half_length if i & 1 else box.half_length
        y = -box.half_width if i & 2 else box.half_width
        ahead, left = point_of_frame(box.ahead, box.left, x, y, box.cosine, box.sine)
        depth = put_corner(camera, tracing.corners[i], ahead, left, box.low if i & 4 else box.high)
        nearest = min(nearest, depth)
    box.traced = 1
    first, count = visible_faces(box)
    if nearest < LENS or count == 0:
        set_convex_hull(outline, tracing.points, project_box(camera, tracing))
    else:
        trace_visible_faces(camera, box, tracing.corners, outline, first, count)


@compiled
def visible_faces(box):
    """Return the leftmost visible side face of a box, and the number of visible side faces: 1, 2, or 0 from inside.

    Faces go round counter-clockwise, face i from corner i to corner i + 1 of the ring: left, behind, right, ahead.
    """
    x, y = in_box_axes(box, 0.0, 0.0)
    ahead, behind = x > box.half_length, x < -box.half_length
    left, right = y > box.half_width, y < -box.half_width
    if ahead:
        return (2, 2) if right else (3, 2 if left else 1)
    if behind:
        return (0, 2) if left else (1, 2 if right else 1)
    if left or right:
        return (0 if left else 2), 1
    return 0, 0


@compiled
def upper_corner_index(i):
    """Return the index of the i-th upper corner of a box, counter-clockwise from front left: 0, 1, 3, 2."""
    return (i & 3) ^ ((i & 3) >> 1)


@compiled
def trace_visible_faces(camera, box, corners, outline, first, count):
    """Trace the outline of a box in front of the lens, whose faces first, ..., first + count - 1 are visible.

    Seen from above, the far edges of the top and the near edges of the bottom bound the box; from below, the reverse.
    """
    from_above, over_belly = camera.height > box.high, camera.height > box.low
    right, left = upper_corner_index(first + count), upper_corner_index(first)
    begin_outline(outline, corners[right], corners[right + LOW])
    for i in range(1, 4 - count):  # the far corners, from right to left
        corner = upper_corner_index(first + count + i)
        if from_above:
            add_upper(outline, corners[corner])
        if not over_belly:
            add_lower(outline, corners[corner + LOW])
    if count == 2:  # the near corner
        corner = upper_corner_index(first + 1)
        if not from_above:
            add_upper(outline, corners[corner])
        if over_belly:
            add_lower(outline, corners[corner + LOW])
    end_outline(outline, corners[left], corners[left + LOW])
