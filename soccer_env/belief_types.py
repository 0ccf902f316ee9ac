"""What a robot believes: the records of its own pose, the ball, the match and the other players, with unit and frame.

Filled from percepts by `belief/` or, with ideal senses, from the truth. Frames are those of `types`.
"""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled

UNKNOWN = -1  # number of a player who has not been identified

SITUATION = np.dtype(
    [  # what a player may know of the match
        ("phase", "i2"),  # a Phase
        ("placing", "i2"),  # 1 while robots are driven to their places
        ("number", "i2"),  # own number
        ("keeper", "i2"),  # 1: I am the goalkeeper
        ("active", "i2"),  # 0: I am sent off
        ("teammates", "i2"),  # active team-mates, without me
        ("opponents", "i4"),  # active opponents
        ("goals_for", "i4"),
        ("goals_against", "i4"),
        ("ours", "f8"),  # +1 our restart, -1 theirs, 0 neither
        ("phase_clock", "f8"),  # [s] since the phase began
        ("seconds_left", "f8"),  # [s] of play to the final whistle; inf without an end
        ("penalty", "f8"),  # [s] left of my penalty
    ]
)

OWN_POSE = np.dtype(
    [
        ("x", "f8"),  # [m] team frame
        ("y", "f8"),  # [m] team frame
        ("heading", "f8"),  # [rad] team frame
        ("forward", "f8"),  # [m/s] robot frame
        ("left", "f8"),  # [m/s] robot frame
        ("turn", "f8"),  # [rad/s]
        ("confidence", "f8"),  # [0, 100]
    ]
)

BALL_BELIEF = np.dtype(
    [
        ("distance", "f8"),  # [m] latest (raw) estimate
        ("bearing", "f8"),  # [rad] robot frame
        ("filtered_distance", "f8"),  # [m]
        ("filtered_bearing", "f8"),  # [rad]
        ("x", "f8"),  # [m] robot frame, best estimate
        ("y", "f8"),  # [m] robot frame
        ("vx", "f8"),  # [m/s] velocity over the ground, in the axes of the robot frame
        ("vy", "f8"),  # [m/s]
        ("radial", "f8"),  # [m/s] rate of the distance as the moving robot sees it
        ("angular", "f8"),  # [rad/s] rate of the bearing as the moving, turning robot sees it
        ("confidence", "f8"),  # [0, 100]; 0: it is not known where it is
        ("age", "f8"),  # [s] since it was seen; inf: not since the robot was put down
        ("held", "i8"),  # 1: it lies in my pocket or at my kicker
    ]
)

TRACK = np.dtype(
    [  # what a robot believes about one other player; slots of team-mates come first, then opponents
        ("present", "i2"),  # 1: the slot is in use
        ("teammate", "i2"),  # 1 team-mate, 0 opponent
        ("keeper", "i2"),  # 1: the goalkeeper of its team
        ("number", "i2"),  # the player's number, -1 unknown
        ("distance", "f8"),  # [m]
        ("bearing", "f8"),  # [rad] robot frame
        ("x", "f8"),  # [m] robot frame
        ("y", "f8"),  # [m] robot frame
        ("vx", "f8"),  # [m/s] velocity over the ground, in the axes of the robot frame
        ("vy", "f8"),  # [m/s]
        ("heading", "f8"),  # [rad] robot frame
        ("confidence", "f8"),  # [0, 100]
        ("age", "f8"),  # [s] since it was seen
    ]
)

HEARD = np.dtype(
    [  # what team-mates say of the ball; the one that is nearest to it counts
        ("word", "i8"),  # 1 ... 15: range of its distance to the ball, see ball_words.py; 0: nobody says
        ("distance", "f8"),  # [m] its distance to the ball; inf if nobody says
        ("age", "f8"),  # [s] since it said so; inf if nobody says
    ]
)

OBSTACLE = np.dtype(
    [  # a robot that the infrared ranger meets and the picture does not show; only legged robots with sensors
        ("distance", "f4"),  # [m] to the middle of its body; 0: there is none
        ("bearing", "f4"),  # [rad] robot frame
    ]
)

BELIEF = np.dtype(
    [
        ("own", OWN_POSE),
        ("ball", BALL_BELIEF),
        ("situation", SITUATION),
        ("heard", HEARD),
        ("obstacle", OBSTACLE),
    ]
)


# Slots for other players: how one is emptied, whoever fills it


@compiled
def clear_slots(tracks, first, last):
    """Mark slots from `first` to before `last` as unused."""
    for slot in range(first, last):
        forget(tracks[slot])


@compiled
def forget(track):
    """Empty a slot: a TRACK of nobody."""
    track.present = track.teammate = track.keeper = 0
    track.number = UNKNOWN
    track.distance = track.bearing = track.x = track.y = track.vx = track.vy = track.heading = 0.0
    track.confidence = track.age = 0.0
