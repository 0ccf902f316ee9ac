"""White lines in the picture of the omnidirectional camera: the first line in each direction.  MH02, MH08

Direction i of s.lines lies 2 pi i / s.lines to the left of straight ahead; i and s.lines - i are mirror images.

`k`: the league's constants; `s`: settings of the sensors.
"""

from math import ceil, cos, floor, pi, sin, sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import out_of_frame
from soccer_env.optics.mirror_camera import ground_distance, image_radius, mirror_parameters
from soccer_env.perception.omni.around import body_radius
from soccer_env.perception.omni.sightings import CAMERA, to_pixel
from soccer_env.random_numbers import draw_uniform
from soccer_env.records.percepts import LINES

LINE_MAP = np.dtype(
    [  # the straight lines of a quarter of a pitch; the mirror images of each at -x and -y are lines as well
        ("end", "f8"),  # [m] half the pitch's length
        ("across", "f8", (4,)),  # [m] |x| of lines across the pitch: halfway, goal line, penalty area, goal area
        ("across_to", "f8", (4,)),  # [m] |y| up to which they run
        ("along", "f8", (3,)),  # [m] |y| of lines along the pitch: touchline, penalty area, goal area
        ("along_from", "f8", (3,)),  # [m] |x| from which they run to the goal line
        ("cosine", "f8", (LINES,)),  # [1] of the directions
        ("sine", "f8", (LINES,)),
        ("free", "f8", (LINES,)),  # [m] scratch: how far the view goes in each direction
    ]
)
SPAN = sqrt(12.0)  # [1] width of an even distribution of sd 1
PARALLEL = 1e-12  # [1] below which a direction never meets a line


@compiled
def draw_map(map, k, s):
    """Fill a LINE_MAP with the lines of the pitch and the directions in which the camera looks for lines."""
    map.end = 0.5 * k.pitch_length
    map.across[0], map.across_to[0] = 0.0, 0.5 * k.pitch_width
    map.across[1], map.across_to[1] = map.end, 0.5 * k.pitch_width
    map.across[2], map.across_to[2] = map.end - k.pitch_penalty_depth, 0.5 * k.pitch_penalty_width
    map.across[3], map.across_to[3] = map.end - k.pitch_goal_area_depth, 0.5 * k.pitch_goal_area_width
    map.along[0], map.along_from[0] = 0.5 * k.pitch_width, 0.0
    map.along[1], map.along_from[1] = 0.5 * k.pitch_penalty_width, map.end - k.pitch_penalty_depth
    map.along[2], map.along_from[2] = 0.5 * k.pitch_goal_area_width, map.end - k.pitch_goal_area_depth
    map.cosine[0], map.sine[0] = 1.0, 0.0
    for i in range(1, s.lines // 2 + 1):
        angle = 2.0 * pi * i / s.lines
        map.cosine[i], map.sine[i] = cos(angle), sin(angle) if 2 * i < s.lines else 0.0
        map.cosine[s.lines - i], map.sine[s.lines - i] = map.cosine[i], -map.sine[i]


@compiled
def find_lines(robot, lines, around, count, map, k, s, noise, handedness, colour):
    """Measure the distance of the first white line in each direction, 0 for none; return the number of lines seen.

    MH02, MH07, MH08
    """
    fill_view_lengths(map.free, around, count, k, s)
    cosine, sine = cos(robot.heading), sin(robot.heading)
    chance, mirror = (1.0 - s.line_miss) * colour, mirror_parameters(s)
    seen = 0
    for step in range(s.lines):  # to the left or, in a mirrored match, to the right, for the same draws
        i = step if handedness > 0.0 else (s.lines - step) % s.lines
        dx, dy = out_of_frame(map.cosine[i], map.sine[i], cosine, sine)
        distance = first_line_distance(robot.x, robot.y, dx, dy, map, k.pitch_circle, s.hidden_radius, map.free[i])
        lines[i] = 0.0
        if distance < map.free[i]:
            # the line is seen if the draw is below `chance`; within that range the draw is even and gives the noise
            draw = draw_uniform(noise, CAMERA)
            if draw < chance:
                radius = image_radius(mirror, distance) + s.pixel_noise * SPAN * (draw / chance - 0.5)
                lines[i] = ground_distance(mirror, max(to_pixel(radius), 0.0))
                seen += 1
    return seen


@compiled
def fill_view_lengths(free, around, count, k, s):
    """Compute how far the view reaches in each direction [m]: to `line_range`, or to a robot that blocks it."""
    for i in range(s.lines):
        free[i] = s.line_range
    sector = 2.0 * pi / s.lines
    for j in range(count):
        other = around[j]
        front = max(other.distance - body_radius(k), 0.0)
        if front < s.line_range:
            first, last = ceil((other.bearing - other.half) / sector), floor((other.bearing + other.half) / sector)
            for i in range(first, last + 1):
                free[i % s.lines] = min(free[i % s.lines], front)


@compiled
def first_line_distance(x, y, dx, dy, map, circle, nearest, farthest):
    """Return the distance [m] at which a ray first meets a line beyond `nearest`, or `farthest`."""
    best = farthest
    if abs(dx) > PARALLEL:
        per_x, slope = 1.0 / dx, dy / dx
        for i in range(4):
            for side in (-1.0, 1.0):
                ahead = side * map.across[i] - x
                if nearest < ahead * per_x < best and abs(y + ahead * slope) <= map.across_to[i]:
                    best = ahead * per_x
    if abs(dy) > PARALLEL:
        per_y, slope = 1.0 / dy, dx / dy
        for i in range(3):
            for side in (-1.0, 1.0):
                aside = side * map.along[i] - y
                if nearest < aside * per_y < best and map.along_from[i] <= abs(x + aside * slope) <= map.end:
                    best = aside * per_y
    middle, beside = -(x * dx + y * dy), x * dy - y * dx  # where the ray passes the centre spot, and how far from it
    square = circle * circle - beside * beside
    if square > 0.0:
        half = sqrt(square)
        if nearest < middle - half < best:
            best = middle - half
        elif nearest < middle + half < best:
            best = middle + half
    return best
