"""White lines in the picture of the omnidirectional camera: the first line in each direction.  MH02, MH08

Direction i of s.lines lies 2 pi i / s.lines to the left of straight ahead; i and s.lines - i are mirror images.

`k`: the league's constants; `s`: settings of the sensors; `mirror`: the result of `mirror_parameters`.
"""

from math import ceil, cos, floor, inf, pi, sin, sqrt

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import cosine_and_sine, out_of_frame
from soccer_env.optics.mirror_camera import ground_distance, image_radius
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
        # scratch, for each direction
        ("free", "f8", (LINES,)),  # [m] how far the view goes
        ("first", "f8", (LINES,)),  # [m] to the first line, or as `free`
        ("per_x", "f8", (LINES,)),  # [1] length of the ray for a metre along the pitch, inf for a ray across it
        ("slope", "f8", (LINES,)),  # [1] metres across the pitch for a metre along it
        ("per_y", "f8", (LINES,)),  # [1] the same, with along and across exchanged
        ("lean", "f8", (LINES,)),  # [1]
        ("middle", "f8", (LINES,)),  # [m] to the point of the ray that is nearest to the centre spot
        ("half", "f8", (LINES,)),  # [m] from there to the centre circle, inf for a ray that passes it
        ("radius", "f8", (LINES,)),  # [px] of the line in the image
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
def find_lines(robot, lines, around, count, map, mirror, k, s, noise, handedness, colour):
    """Measure the distance of the first white line in each direction, 0 for none.

    MH02, MH07, MH08. Steps run over all directions, one after the other, so that the processor takes several at once.
    """
    fill_view_lengths(map.free, around, count, k, s)
    turn_directions(robot, map, k.pitch_circle, s.lines)
    meet_lines(robot.x, robot.y, map, s.hidden_radius, s.lines)
    for i in range(s.lines):
        map.radius[i] = image_radius(mirror, map.first[i])
    chance = (1.0 - s.line_miss) * colour
    for step in range(s.lines):  # to the left or, in a mirrored match, to the right, for the same draws
        i = step if handedness > 0.0 else (s.lines - step) % s.lines
        # the line is seen if the draw is below `chance`; within that range the draw is even and gives the noise
        draw = draw_uniform(noise, CAMERA) if map.first[i] < map.free[i] else chance
        if draw < chance:
            map.radius[i] = max(to_pixel(map.radius[i] + s.pixel_noise * SPAN * (draw / chance - 0.5)), 0.0)
        else:
            map.radius[i] = 0.0
    for i in range(s.lines):
        lines[i] = ground_distance(mirror, map.radius[i])


@compiled
def count_lines(lines, s):
    """Return the number of directions in which a line was seen."""
    seen = 0
    for i in range(s.lines):
        seen += 1 if lines[i] > 0.0 else 0
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
def turn_directions(robot, map, circle, lines):
    """Compute for each direction, turned with the robot, what the search for lines needs to know of the ray."""
    cosine, sine = cosine_and_sine(robot.heading)
    x, y = robot.x, robot.y
    for i in range(lines):
        dx, dy = out_of_frame(map.cosine[i], map.sine[i], cosine, sine)
        map.per_x[i], map.slope[i] = 1.0 / dx if abs(dx) > PARALLEL else inf, dy / dx
        map.per_y[i], map.lean[i] = 1.0 / dy if abs(dy) > PARALLEL else inf, dx / dy
        beside = x * dy - y * dx
        square = circle * circle - beside * beside
        map.middle[i] = -(x * dx + y * dy)
        map.half[i] = sqrt(square) if square > 0.0 else inf


@compiled
def meet_lines(x, y, map, nearest, lines):
    """Compute the distances `map.first` [m] at which rays first meet a line beyond `nearest`, at most `map.free`."""
    first = map.first
    first[:] = map.free
    for line in range(4):
        for side in (-1.0, 1.0):
            ahead = side * map.across[line] - x
            meet_line(first, map.per_x, map.slope, ahead, y, 0.0, map.across_to[line], nearest, lines)
    for line in range(3):
        for side in (-1.0, 1.0):
            aside = side * map.along[line] - y
            meet_line(first, map.per_y, map.lean, aside, x, map.along_from[line], map.end, nearest, lines)
    for side in (-1.0, 1.0):
        for i in range(lines):
            distance = map.middle[i] + side * map.half[i]
            first[i] = distance if nearest < distance < first[i] else first[i]


@compiled
def meet_line(first, per, slope, away, place, least, most, nearest, lines):
    """Shorten the rays that meet a straight line, `away` [m] off, which runs from `least` to `most` [m] to both sides.

    place: position of the robot along the line [m], from the line's middle.
    """
    for i in range(lines):
        distance, at = away * per[i], abs(place + away * slope[i])
        first[i] = distance if nearest < distance < first[i] and least <= at <= most else first[i]
