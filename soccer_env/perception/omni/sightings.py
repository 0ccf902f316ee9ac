"""Objects that the omnidirectional camera finds in its picture: ball, players, goals.  [Heinemann et al. 2006, 2]  MH02

A thing is measured where it touches the ground, so that the mirror's curve tells its distance. Its place in the picture
is a whole pixel: bearings are good everywhere, errors of distances grow with the square of the distance.

Unlike the pitches of 2006 this one has no corner poles: four more landmarks would make sensing and belief a tenth
slower, and lines and goals give the own place to centimetres.

`k`: the league's constants; `s`: settings of the sensors; `mirror`: the result of `mirror_parameters`.
"""

from math import exp, floor, inf, pi

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, attack_direction, clip, cosine_and_sine, into_frame, length, wrap
from soccer_env.optics.mirror_camera import ground_distance, image_radius
from soccer_env.perception.omni.around import body_radius, half_angle, visible_part
from soccer_env.random_numbers import draw_normal, draw_uniform
from soccer_env.types import RobotStream

CAMERA = int(RobotStream.CAMERA)
FALSE_BLOBS = int(RobotStream.FALSE_BLOBS)
GOAL_HEIGHT = 1.0  # [m] Tribots 2005
UNCOLOURED = 0.5  # [1] share of the frames with an orange ball that also show a ball without colour, assumed
UNCOLOURED_FALSE = 0.04  # [1/frame] further wrong balls when the ball has no colour, assumed
STEEPEST = 40.0  # [1] exponent beyond which a logistic is flat
FOOT = 0.0  # [m] height of what is read where it touches the ground


@compiled
def to_pixel(place):
    """Round a place in the image [px] to the nearest whole pixel, symmetrically about the centre."""
    return 1.0 * floor(place + 0.5) if place >= 0.0 else -1.0 * floor(0.5 - place)


@compiled
def clear_sighting(sighting):
    """Mark a sighting as absent: the object was not seen."""
    sighting.seen = sighting.teammate = 0
    sighting.distance = sighting.bearing = 0.0


@compiled
def measure_sighting(sighting, distance, bearing, farthest, mirror, s, noise, handedness):
    """Measure an object at a noisy whole pixel of the picture; return whether it is within `farthest` [px].  MH02"""
    radius = image_radius(mirror, distance)
    cosine, sine = cosine_and_sine(bearing)
    ahead = to_pixel(radius * cosine + s.pixel_noise * draw_normal(noise, CAMERA))
    # Straight behind is half a turn to either side: to the left, or in a mirrored match to the right.
    left = handedness * to_pixel(handedness * radius * sine + s.pixel_noise * draw_normal(noise, CAMERA))
    radius = length(ahead, left)
    if radius > farthest:
        return False
    sighting.distance, sighting.bearing = ground_distance(mirror, radius), atan2(left, ahead)
    sighting.seen = 1
    return True


@compiled
def sighting_probability(distance, reach, miss, s):
    """Return the probability that a frame shows an object [1]: 1 - `miss` nearby, half of that at `reach` [m]."""
    return (1.0 - miss) / (1.0 + exp(clip((distance - reach) / s.detection_width, -STEEPEST, STEEPEST)))


@compiled
def find_ball(ball, robot, percept, around, count, mirror, k, s, noise, handedness, colour):
    """Measure the ball's sighting; `colour` [1]: share of pixels that the colour table recognises.  MH02, MH07, MH24

    The own body hides everything within `hidden_radius`, other robots everything behind them. A blob that has lost its
    rim seems farther. A ball without colour is found by its shape, more rarely, in any light.
    """
    sighting = percept.ball
    clear_sighting(sighting)
    cosine, sine = cosine_and_sine(robot.heading)
    x, y = ball.x - robot.x, ball.y - robot.y
    ahead, left = into_frame(x, y, cosine, sine)
    distance, bearing = length(x, y), atan2(left, ahead)
    kept = colour if s.ball_coloured == 1 else 1.0
    if distance >= s.hidden_radius:
        half = half_angle(k.ball_radius, distance)
        aside, share = visible_part(around, count, bearing, half, distance, FOOT, k, s, handedness)
        recognised = kept if s.ball_coloured == 1 else UNCOLOURED
        shown = share * recognised * sighting_probability(distance, s.ball_range, s.ball_miss, s)
        if share > 0.0 and draw_uniform(noise, CAMERA) < shown:
            seems = distance + (1.0 - kept) * k.ball_radius
            measure_sighting(sighting, seems, bearing + aside, 0.5 * s.image, mirror, s, noise, handedness)
    add_false_ball(sighting, mirror, s, noise, handedness)


@compiled
def add_false_ball(sighting, mirror, s, noise, handedness):
    """Add a rare false ball in a random direction; it replaces the sighting of the ball if it is nearer."""
    rate = s.false_balls + (0.0 if s.ball_coloured == 1 else UNCOLOURED_FALSE)
    if rate <= 0.0 or draw_uniform(noise, FALSE_BLOBS) >= rate:
        return
    nearest = image_radius(mirror, s.hidden_radius)
    radius = nearest + (0.5 * s.image - nearest) * draw_uniform(noise, FALSE_BLOBS)
    bearing = handedness * pi * (1.0 - 2.0 * draw_uniform(noise, FALSE_BLOBS))
    distance = ground_distance(mirror, radius)
    if sighting.seen == 0 or distance < sighting.distance:
        sighting.distance = distance
        sighting.bearing = bearing
        sighting.seen = 1


@compiled
def find_players(percept, around, count, mirror, k, s, noise, handedness, colour):
    """Measure the sightings of other robots, sorted by apparent distance, nearest first.  MH02, MH07"""
    players, seen = percept.players, 0
    for j in range(count):
        other = around[j]
        aside, share = visible_part(around, count, other.bearing, other.half, other.distance, FOOT, k, s, handedness)
        if share <= 0.0:
            continue
        if draw_uniform(noise, CAMERA) >= share * colour * sighting_probability(
            other.distance, s.player_range, s.player_miss, s
        ):
            continue
        seems = other.distance + (1.0 - colour) * body_radius(k)
        if measure_sighting(players[seen], seems, other.bearing + aside, 0.5 * s.image, mirror, s, noise, handedness):
            players[seen].teammate = other.teammate
            insert_by_distance(players, seen)
            seen += 1
    for j in range(seen, players.shape[0]):
        if players[j].seen == 0:
            break
        clear_sighting(players[j])


@compiled
def insert_by_distance(players, last):
    """Move the player at index `last` forward to its place by distance, behind players at equal distance."""
    one = players[last]
    distance = one.distance
    bearing = one.bearing
    teammate = one.teammate
    while last > 0 and players[last - 1].distance > distance:
        players[last] = players[last - 1]
        last -= 1
    one = players[last]
    one.distance = distance
    one.bearing = bearing
    one.teammate = teammate


@compiled
def find_goals(match, robot, percept, around, count, mirror, k, s, noise, handedness, colour):
    """Measure the sightings of the own goal and of the opponents' goal.  MH02"""
    end = 0.5 * attack_direction(match, robot.team) * k.pitch_length
    find_goal(percept.own_goal, robot, -end, around, count, mirror, k, s, noise, handedness, colour)
    find_goal(percept.opponent_goal, robot, end, around, count, mirror, k, s, noise, handedness, colour)


@compiled
def find_goal(sighting, robot, x, around, count, mirror, k, s, noise, handedness, colour):
    """Measure the sighting of the goal at x [m]: bearing of its visible part's middle, distance of the goal's middle.

    A goal is 1 m tall: it is visible from everywhere, over the heads of robots that are not near. Where its foot lies
    beyond the picture's edge, it is measured as if the picture went on (assumed).
    """
    clear_sighting(sighting)
    distance, middle = length(x - robot.x, -robot.y), wrap(atan2(-robot.y, x - robot.x) - robot.heading)
    one = wrap(bearing_to_point(robot, x, 0.5 * k.pitch_goal_width) - middle)
    other = wrap(bearing_to_point(robot, x, -0.5 * k.pitch_goal_width) - middle)
    half = 0.5 * abs(one - other)
    centre = middle + 0.5 * (one + other)
    aside, share = visible_part(around, count, centre, half, distance, GOAL_HEIGHT, k, s, handedness)
    if share > 0.0 and draw_uniform(noise, CAMERA) < share * colour * (1.0 - s.goal_miss):
        measure_sighting(sighting, distance, centre + aside, inf, mirror, s, noise, handedness)


@compiled
def bearing_to_point(robot, x, y):
    """Return the bearing [rad] of a point, given in the field frame, as seen from a robot."""
    return wrap(atan2(y - robot.y, x - robot.x) - robot.heading)
