"""The surroundings of a legged robot's field: goals, landmarks, and ball-coloured patches beyond the boards.

Things are drawn as seen by the robot's own team, and each pair in an order that does not change in a mirror: so both
teams, and a match and its mirror image, draw the same noise for the same thing.

`k`: the league's constants; `s`: settings of the sensors.
"""

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import length
from soccer_env.perception.legged.camera import from_camera, in_view
from soccer_env.perception.legged.sketch import LANDMARK, NOBODY, OPPONENT_GOAL, OWN_GOAL, PATCHES, draw_panel
from soccer_env.random_numbers import GOLDEN, MIX_1, MIX_2, bits_to_unit_interval, mix_bits
from soccer_env.records.percepts import LANDMARKS

PATCH_KEY = np.uint64(0xC2B2AE3D27D4EB4F)  # keeps the places of patches independent of the noise streams of a seed


@compiled
def draw_goals(sketch, side, k, s):
    """Draw the mouths of both goals into a sketch, each as a flat wall.

    The mouth stands for the coloured walls behind it, so that a robot inside a goal hides it as well.
    """
    for far, kind in ((-1.0, OWN_GOAL), (1.0, OPPONENT_GOAL)):
        camera, panel = sketch.camera, sketch.panel
        x, half = far * side * 0.5 * k.pitch_length, 0.5 * k.pitch_goal_width
        if abs(camera.x) >= abs(x) and camera.x * x > 0.0:
            continue  # the camera is in the goal itself
        panel.ahead, panel.left = from_camera(camera, x, 0.0)
        if not in_view(camera, panel.ahead, panel.left, 0.5 * s.goal_height, length(half, 0.5 * s.goal_height)):
            continue
        panel.across, panel.aside = camera.sine * half, camera.cosine * half
        panel.low, panel.high = 0.0, s.goal_height
        draw_panel(sketch, panel, kind, NOBODY, False, True)


@compiled
def draw_landmarks(sketch, side, k, s):
    """Draw the six landmarks into a sketch: coloured cylinders just outside the corners and the halfway line's ends."""
    half_length = 0.5 * k.pitch_length + k.pitch_band_end + s.landmark_radius
    half_width = 0.5 * k.pitch_width + k.pitch_band_side + s.landmark_radius
    middle, high = 0.5 * (s.landmark_low + s.landmark_high), 0.5 * (s.landmark_high - s.landmark_low)
    handedness, radius = sketch.camera.handedness, length(s.landmark_radius, high)
    for i in range(LANDMARKS):
        left = 1.0 if (i % 2 == 0) == (handedness > 0.0) else -1.0  # the first of a pair is left in the mirrored axes
        index = i - i % 2 + (0 if left > 0.0 else 1)
        sketch.landmarks[index].area = 0.0
        x, y = side * (i // 2 - 1) * half_length, side * left * half_width
        ahead, aside = from_camera(sketch.camera, x, y)
        if not in_view(sketch.camera, ahead, aside, middle, radius):
            continue
        sketch.counts[LANDMARK] = 0
        place_panel_facing_camera(sketch.panel, ahead, aside, s.landmark_radius)
        sketch.panel.low, sketch.panel.high = s.landmark_low, s.landmark_high
        draw_panel(sketch, sketch.panel, LANDMARK, NOBODY, False, True)
        store_largest_piece(sketch, index)


@compiled
def place_panel_facing_camera(panel, ahead, left, half_width):
    """Place a panel at ahead, left [m] of the camera, and turn it to face the camera."""
    distance = max(length(ahead, left), 1e-9)
    panel.ahead, panel.left = ahead, left
    panel.across, panel.aside = -left / distance * half_width, ahead / distance * half_width


@compiled
def store_largest_piece(sketch, index):
    """Store only the largest piece of a landmark, under the landmark's index."""
    for i in range(sketch.counts[LANDMARK]):
        if sketch.pieces[LANDMARK, i].area > sketch.landmarks[index].area:
            sketch.landmarks[index] = sketch.pieces[LANDMARK, i]


@compiled
def draw_patches(sketch, match, side, k, s):
    """Draw the ball-coloured patches that stand off the field in this match, behind the boards.

    Patches stand in opposite pairs, so that each team sees the same pattern from its own side.
    """
    key = mix_bits(np.uint64(match.seed) + GOLDEN * np.uint64(match.episode + 1)) ^ PATCH_KEY
    for pair in range(int(s.patches) // 2):
        x, y, height = patch_position(mix_bits(key + MIX_1 * np.uint64(pair + 1)), k, s)
        for here in (side, -side):
            draw_patch(sketch, here * x, here * y * match.handedness, height, k, s)


@compiled
def patch_position(bits, k, s):
    """Return the position of a patch [m]: x, y on a rectangle round the boards, and its height."""
    length_away = 0.5 * k.pitch_length + k.pitch_band_end + s.patch_away
    width_away = 0.5 * k.pitch_width + k.pitch_band_side + s.patch_away
    # Half of the rectangle is enough: the patches of the other half stand opposite.
    along = 2.0 * (length_away + width_away) * bits_to_unit_interval(bits)
    height = s.patch_low + (s.patch_high - s.patch_low) * bits_to_unit_interval(mix_bits(bits ^ MIX_2))
    if along < 2.0 * length_away:
        return along - length_away, width_away, height
    return length_away, along - 2.0 * length_away - width_away, height


@compiled
def draw_patch(sketch, x, y, height, k, s):
    """Draw a ball-coloured patch; the boards hide its part below the line of sight over the boards."""
    camera = sketch.camera
    panel = sketch.panel
    half = 0.5 * s.patch_size
    ahead, left = from_camera(camera, x, y)
    if not in_view(camera, ahead, left, height, length(half, half)):
        return
    place_panel_facing_camera(panel, ahead, left, half)
    panel.low, panel.high = height - half, height + half
    if k.walled == 1:
        share = fraction_inside_boards(camera.x, camera.handedness * camera.y, x, y, k)
        panel.low = max(panel.low, camera.height + (s.board_height - camera.height) / share)
    if panel.low < panel.high:
        draw_panel(sketch, panel, PATCHES, NOBODY, False, True)


@compiled
def fraction_inside_boards(x, y, to_x, to_y, k):
    """Return the fraction [1] of a line from the field to a place outside that lies inside the boards."""
    share = 1.0
    half_length = 0.5 * k.pitch_length
    half_width = 0.5 * k.pitch_width
    if abs(to_x) > half_length:
        share = min(share, fraction_before_line(x, to_x, half_length))
    if abs(to_y) > half_width:
        share = min(share, fraction_before_line(y, to_y, half_width))
    return share


@compiled
def fraction_before_line(start, end, line):
    """Return the fraction [1] of the way from start to end before it crosses a line at +-line, at least 0.001."""
    goal = line if end > 0.0 else -line
    return max((goal - start) / (end - start), 0.001) if end != start else 1.0
