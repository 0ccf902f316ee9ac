"""The obstacle that a legged robot infers from a reading of its infrared ranger.  [Sacks 2001, 4.3.3]  MS49

The black head of a player that looks down hides its jersey: the player seems much farther than it is, or is not seen at
all. A reading significantly closer than every player in memory, both from the camera to the surface of a body, reveals
a player that the picture does not show:

    distance, bearing    to the middle of that body, as if the beam met its chest (MS35); 0, 0: there is none

It holds for the frame of the reading. Unlike the paper, which takes any reading, this module takes a reading only if it
lies higher than ball and boards, since these and the carpet would be obstacles too, and within the ranger's reliable
range: beyond it a reading may be half a metre too short. The walls of a goal are higher and count as a player.

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from math import inf, sin

import numpy as np

from soccer_env.belief.legged.players import range_by_infrared
from soccer_env.belief.legged.surface import chest_to_middle
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, from_polar, length
from soccer_env.optics.head_camera import camera_place


@compiled
def believe_obstacle(percept, belief, tracks, k, s, w):
    """Update the obstacle of a BELIEF from the percept of a frame, after the tracks (slots,) were updated.  MS49

    A robot that lies on its side or is sent off does not look.
    """
    obstacle, body = belief.obstacle, percept.body
    obstacle.distance = obstacle.bearing = 0.0
    if w.obstacle == 1 and body.active == 1 and body.upright == 1 and beam_meets_player(percept, k, s, w):
        reading = range_by_infrared(percept, np.float64(percept.tilt), k) - chest_to_middle(k)
        if reading < w.obstacle_share * nearest_player_distance(percept, tracks, k, s):
            x, y = player_position_in_beam(percept, k, s)
            obstacle.distance, obstacle.bearing = length(x, y), atan2(y, x)


@compiled
def beam_meets_player(percept, k, s, w):
    """Tell whether the beam meets a near object that is higher than the carpet, the ball and the boards.  MS49"""
    if not 0.0 < percept.infrared < w.player_infrared_far:
        return False
    tilt = np.float64(percept.tilt)
    _, _, height = camera_place(0.0, tilt, s)
    lowest = max(2.0 * k.ball_radius, s.board_height) + w.obstacle_margin
    return height + percept.infrared * sin(tilt) > lowest


@compiled
def player_position_in_beam(percept, k, s):
    """Return the position x, y [m], robot frame, of the player whose chest the ranger's beam meets."""
    pan, tilt = np.float64(percept.pan), np.float64(percept.tilt)
    ahead, left, _ = camera_place(pan, tilt, s)
    away = range_by_infrared(percept, tilt, k)
    x, y = from_polar(away, pan)
    return ahead + x, left + y


@compiled
def nearest_player_distance(percept, tracks, k, s):
    """Return the distance [m] from the camera to the surface of the nearest player in memory; inf without any.  MS49"""
    ahead, left, _ = camera_place(np.float64(percept.pan), np.float64(percept.tilt), s)
    nearest = inf
    for slot in range(k.teammate_slots + k.opponent_slots):
        if tracks[slot].present == 1:
            away = length(tracks[slot].x - ahead, tracks[slot].y - left)
            nearest = min(nearest, max(away - chest_to_middle(k), 0.0))
    return nearest
