"""The own pose of a legged robot, by particles weighed by the landmarks and goals that the robot sees.  MH08

A landmark gives a bearing and, by its known height, a range. A goal gives the bearings of its two ends, unless the
image's border or a robot cuts it: the visible part must lie between the posts, and most likely ends at them.

         opponents' goal
    4 ------+=====+------ 5      landmarks in the order of `percept.landmarks`, +x up and +y to the left:
    |                     |      own left, own right, halfway left, right, opponents' left, right corner
    2                     3
    |                     |      a mirror swaps each pair, so the handedness says in which order they are added up:
    0 ------+=====+------ 1      mirrored matches get the same sums, to the last bit
            own goal

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from math import sqrt, tan

import numpy as np

from soccer_env.belief.own_pose import (
    estimate_and_resample,
    move_without_measurements,
    particles_are_due,
    take_summed_motion,
)
from soccer_env.belief.particles import (
    BLOCK,
    OUTLIER,
    ROWS,
    bounded_cost,
    draw_from_sighting,
    move_block,
    store_block,
)
from soccer_env.compiled import compiled, scratch_records
from soccer_env.geometry import cosine_and_sine, into_frame, point_of_frame
from soccer_env.optics.head_camera import camera_place, direction_of_pixel, image_height, image_width
from soccer_env.random_numbers import draw_uniform
from soccer_env.records.percepts import BLOBS, LANDMARKS
from soccer_env.types import RobotStream

PARTICLES = int(RobotStream.PARTICLES)
HIDDEN = 2.0  # [sd2] like OUTLIER, for an end of a goal that lies between its posts: the rest may be hidden, assumed

SIGHT = np.dtype(
    [  # a landmark that is seen
        ("x", "f8"),  # [m] team frame, where it stands
        ("y", "f8"),  # [m]
        ("ahead", "f8"),  # [1] robot frame, unit vector towards it
        ("left", "f8"),  # [1]
        ("far", "f8"),  # [m] range along the ground; 0: unknown
    ]
)

GOAL_SIGHT = np.dtype(
    [  # the visible part of a goal
        ("seen", "i8"),
        ("side", "f8"),  # -1 own goal, +1 the opponents'
        ("left_ahead", "f8"),  # [1] robot frame, unit vector towards its left end
        ("left_left", "f8"),  # [1]
        ("left_cut", "i8"),  # 1: that end is at the image's border
        ("right_ahead", "f8"),  # [1]
        ("right_left", "f8"),  # [1]
        ("right_cut", "i8"),
    ]
)

LANDMARK_VIEW = np.dtype(
    [
        ("camera_x", "f8"),  # [m] robot frame
        ("camera_y", "f8"),  # [m]
        ("count", "i8"),  # landmarks seen
        ("sights", SIGHT, (LANDMARKS,)),
        ("goals", GOAL_SIGHT, (2,)),
    ]
)


@compiled
def believe_pose_legged(percept, own, crowded, memory, particles, noise, k, s, w):
    """Update the own pose of a legged robot from the percept, by particles, landmarks and goals.  MH08"""
    if not particles_are_due(percept.body, own, crowded, memory, particles, noise, k, s, w):
        return
    view = scratch_records(1, LANDMARK_VIEW)[0]
    seen = measure_landmarks(percept, view, k, s, w)
    hand = np.float64(percept.body.handedness)
    if seen == 0:
        move_without_measurements(own, memory, particles, noise, hand, k, w)
        return
    motion = take_summed_motion(memory, k, w)
    weigh_particles_by_landmarks(particles, view, motion, noise, hand, k, w)
    if estimate_and_resample(own, memory, particles, seen, noise, w):
        for i in range(particles.shape[0]):
            if particles[i].weight == 0.0:
                draw_from_landmark(particles[i], view, noise, hand, k, w)


@compiled
def measure_landmarks(percept, view, k, s, w):
    """Measure the landmarks and goals in view; return the number of measurements.

    A robot that lies on its side gets none. A landmark cut off at a side of the image is left out; a landmark cut off
    above or below gives no range.
    """
    view.count = 0
    view.goals[0].seen = view.goals[1].seen = 0
    if percept.body.upright == 0:
        return 0
    pan, tilt = np.float64(percept.pan), np.float64(percept.tilt)
    view.camera_x, view.camera_y, _ = camera_place(pan, tilt, s)
    edge, top = 0.5 * image_width(s), 0.5 * image_height(s)  # a blob that is cut ends there
    numbers = 0
    for i in range(LANDMARKS):
        which = i if percept.body.handedness >= 0.0 else i ^ 1
        blob = percept.landmarks[which]
        if blob.area > 0 and blob.left < edge and blob.right > -edge:
            sight = view.sights[view.count]
            sight.x, sight.y = landmark_position(which, k, s)
            numbers += measure_landmark(blob, sight, blob.high < top and blob.low > -top, pan, tilt, s)
            view.count += 1
    numbers += read_goal(percept.own_goal, view.goals[0], -1.0, edge, pan, tilt, s)
    numbers += read_goal(percept.opponent_goal, view.goals[1], 1.0, edge, pan, tilt, s)
    return numbers


@compiled
def landmark_position(which, k, s):
    """Return the position of a landmark's middle [m], team frame: just outside the field."""
    x = 0.5 * k.pitch_length + k.pitch_band_end + s.landmark_radius
    y = 0.5 * k.pitch_width + k.pitch_band_side + s.landmark_radius
    return x * (which // 2 - 1), y * (1 - 2 * (which % 2))


@compiled
def measure_landmark(blob, sight, whole, pan, tilt, s):
    """Compute the direction and range of a landmark from its blob; return the number of measurements.

    The range is that at which the landmark's known height fills the angle between the blob's upper and lower edge.
    """
    middle = 0.5 * (blob.left + blob.right)
    bearing, high = direction_of_pixel(middle, np.float64(blob.high), pan, tilt, s)
    _, low = direction_of_pixel(middle, np.float64(blob.low), pan, tilt, s)
    sight.ahead, sight.left = cosine_and_sine(bearing)
    sight.far = 0.0
    rise = tan(high) - tan(low)
    if not whole or rise < 1e-6:
        return 1
    sight.far = (s.landmark_high - s.landmark_low) / rise
    return 2


@compiled
def read_goal(blobs, goal, side, edge, pan, tilt, s):
    """Compute the directions of the two ends of a goal's visible part, one blob or more; return the number of ends."""
    left = -10_000
    right = 10_000
    height = 0.0
    for i in range(BLOBS):
        blob = blobs[i]
        if blob.area > 0:
            if blob.left > left:
                left = int(blob.left)
            if blob.right < right:
                right = int(blob.right)
            if goal.seen == 0:  # the largest comes first
                height = 0.5 * (blob.high + blob.low)
            goal.seen = 1
    if goal.seen == 0:
        return 0
    goal.side = side
    goal.left_cut, goal.right_cut = left >= edge, right <= -edge
    bearing, _ = direction_of_pixel(np.float64(left), height, pan, tilt, s)
    goal.left_ahead, goal.left_left = cosine_and_sine(bearing)
    bearing, _ = direction_of_pixel(np.float64(right), height, pan, tilt, s)
    goal.right_ahead, goal.right_left = cosine_and_sine(bearing)
    return 2


@compiled
def weigh_particles_by_landmarks(particles, view, motion, noise, hand, k, w):
    """Move all particles, and store in each weight the cost of the measurements for the particle's pose.  MH08"""
    half_length, half_width = 0.5 * k.pitch_length, 0.5 * k.pitch_width
    block = scratch_records(1, BLOCK)[0]
    for first in range(0, particles.shape[0], ROWS):
        count = move_block(block, particles, first, motion, half_length, half_width, noise, hand)
        for i in range(view.count):
            add_landmark_costs(block, view.sights[i], view.camera_x, view.camera_y, w)
        for i in range(2):
            if view.goals[i].seen == 1:
                add_goal_costs(block, view.goals[i], view.camera_x, view.camera_y, hand, k, w)
        store_block(block, particles, first, count)


@compiled
def add_landmark_costs(block, sight, camera_x, camera_y, w):
    """Add for each pose of a BLOCK the cost of a landmark that the camera sees; camera: in the robot frame [m]."""
    for j in range(ROWS):
        cosine, sine = block.cosine[j], block.sine[j]
        x, y = point_of_frame(block.x[j], block.y[j], camera_x, camera_y, cosine, sine)
        block.cost[j] += landmark_cost(sight, x, y, cosine, sine, w)


@compiled
def add_goal_costs(block, goal, camera_x, camera_y, hand, k, w):
    """Add for each pose of a BLOCK the cost of a goal that the camera sees; camera: in the robot frame [m]."""
    for j in range(ROWS):
        cosine, sine = block.cosine[j], block.sine[j]
        x, y = point_of_frame(block.x[j], block.y[j], camera_x, camera_y, cosine, sine)
        block.cost[j] += goal_cost(goal, x, y, cosine, sine, hand, k, w)


@compiled
def landmark_cost(sight, x, y, cosine, sine, w):
    """Return the cost of a landmark's measured bearing and range for a camera at x, y and a heading (cosine, sine)."""
    ahead, left, far = direction_in_frame(sight.x - x, sight.y - y, cosine, sine)
    miss = 2.0 - 2.0 * (ahead * sight.ahead + left * sight.left)  # square of the chord [rad2]
    cost = bounded_cost(max(miss, 0.0) / (w.pose_bearing_noise * w.pose_bearing_noise), OUTLIER)
    if sight.far > 0.0:
        miss = (sight.far / far - 1.0) / w.pose_range_noise
        cost += bounded_cost(miss * miss, OUTLIER)
    return cost


@compiled
def goal_cost(goal, x, y, cosine, sine, hand, k, w):
    """Return the cost of a goal's two measured ends for a camera at x, y and a heading (cosine, sine)."""
    across = goal.side * 0.5 * k.pitch_goal_width  # the left post as seen from the field
    along = goal.side * 0.5 * k.pitch_length - x
    ahead, left, _ = direction_in_frame(along, across - y, cosine, sine)
    at_left = goal_end_cost(ahead, left, goal.left_ahead, goal.left_left, goal.left_cut, 1.0, w)
    ahead, left, _ = direction_in_frame(along, -across - y, cosine, sine)
    at_right = goal_end_cost(ahead, left, goal.right_ahead, goal.right_left, goal.right_cut, -1.0, w)
    return at_left + at_right


@compiled
def goal_end_cost(post_ahead, post_left, ahead, left, cut, outward, w):
    """Return the cost of a goal end seen in direction (ahead, left) for a post in direction (post_ahead, post_left).

    Beyond the post, to the left for `outward` 1, nothing of the goal can be seen. Before the post an end costs little,
    since something may hide the rest, and nothing if the image's border cuts the goal off there.
    """
    along = post_ahead * ahead + post_left * left
    aside = outward * (post_ahead * left - post_left * ahead)
    square = max(2.0 - 2.0 * along, 0.0) / (w.pose_bearing_noise * w.pose_bearing_noise)
    if aside > 0.0 or along < 0.0:
        return bounded_cost(square, OUTLIER)
    return 0.0 if cut == 1 else bounded_cost(square, HIDDEN)


@compiled
def direction_in_frame(x, y, cosine, sine):
    """Return the unit vector towards (x, y) [m] in the frame with a heading (cosine, sine), and the distance [m]."""
    far = max(sqrt(x * x + y * y), 1e-3)
    ahead, left = into_frame(x, y, cosine, sine)
    return ahead / far, left / far, far


@compiled
def draw_from_landmark(particle, view, noise, hand, k, w):
    """Draw a new pose for a particle from one of the landmarks or goals in view.  MH08"""
    things = view.count + view.goals[0].seen + view.goals[1].seen
    which = int(things * draw_uniform(noise, PARTICLES))
    if which < view.count:
        one = view.sights[which]
        sight = (one.x, one.y, one.ahead, one.left, one.far, w.pose_range_noise, view.camera_x, view.camera_y)
    else:
        goal = view.goals[0] if view.goals[0].seen == 1 and which == view.count else view.goals[1]
        ahead, left = goal.left_ahead + goal.right_ahead, goal.left_left + goal.right_left
        x = 0.5 * goal.side * k.pitch_length
        sight = (x, 0.0, ahead, left, 0.0, 0.0, view.camera_x, view.camera_y)
    draw_from_sighting(particle, sight, 0.5 * k.pitch_length, 0.5 * k.pitch_width, noise, hand)
