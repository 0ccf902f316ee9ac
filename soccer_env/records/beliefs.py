"""Records of a robot's beliefs: its own pose, the ball, the match and the other players, with unit and frame.

Filled from percepts by `belief/` or, with ideal senses, from the truth. Frames are those of `types`.
"""

from soccer_env.compiled import compiled
from soccer_env.guards.ranges import AMOUNT, CONFIDENCE, COUNT, ENDLESS, FLAG, NUMBER, UNIT, Range, ranged_record
from soccer_env.records.ball_words import FARTHEST, SILENT
from soccer_env.types import MAX_TEAM, PHASE, PLAYER, PLAYERS

UNKNOWN = -1  # number of a player who has not been identified
PLAYER_OR_UNKNOWN = Range(UNKNOWN, MAX_TEAM - 1)
WORDS = Range(SILENT, FARTHEST)

SITUATION = ranged_record(
    [  # what a player may know of the match
        ("phase", "i2", PHASE),  # a Phase
        ("placing", "i2", FLAG),  # 1 while robots are driven to their places
        ("number", "i2", PLAYER),  # own number
        ("keeper", "i2", FLAG),  # 1: I am the goalkeeper
        ("active", "i2", FLAG),  # 0: I am sent off
        ("teammates", "i2", PLAYERS),  # active team-mates, without me
        ("opponents", "i4", PLAYERS),  # active opponents
        ("goals_for", "i4", COUNT),
        ("goals_against", "i4", COUNT),
        ("ours", "f8", UNIT),  # +1 our restart, -1 theirs, 0 neither
        ("phase_clock", "f8", NUMBER),  # [s] since the phase began
        ("seconds_left", "f8", ENDLESS),  # [s] of play to the final whistle; inf without an end
        ("penalty", "f8", NUMBER),  # [s] left of my penalty
    ]
)

OWN_POSE = ranged_record(
    [
        ("x", "f8", NUMBER),  # [m] team frame
        ("y", "f8", NUMBER),  # [m] team frame
        ("heading", "f8", NUMBER),  # [rad] team frame
        ("forward", "f8", NUMBER),  # [m/s] robot frame
        ("left", "f8", NUMBER),  # [m/s] robot frame
        ("turn", "f8", NUMBER),  # [rad/s]
        ("confidence", "f8", CONFIDENCE),  # [0, 100]
    ]
)

BALL_BELIEF = ranged_record(
    [
        ("distance", "f8", AMOUNT),  # [m] latest (raw) estimate
        ("bearing", "f8", NUMBER),  # [rad] robot frame
        ("filtered_distance", "f8", AMOUNT),  # [m]
        ("filtered_bearing", "f8", NUMBER),  # [rad]
        ("x", "f8", NUMBER),  # [m] robot frame, best estimate
        ("y", "f8", NUMBER),  # [m] robot frame
        ("vx", "f8", NUMBER),  # [m/s] velocity over the ground, in the axes of the robot frame
        ("vy", "f8", NUMBER),  # [m/s]
        ("radial", "f8", NUMBER),  # [m/s] rate of the distance as the moving robot sees it
        ("angular", "f8", NUMBER),  # [rad/s] rate of the bearing as the moving, turning robot sees it
        ("confidence", "f8", CONFIDENCE),  # [0, 100]; 0: its place is unknown
        ("age", "f8", ENDLESS),  # [s] since it was seen; inf: not since the robot was put down
        ("held", "i8", FLAG),  # 1: it lies in my pocket or at my kicker
    ]
)

TRACK = ranged_record(
    [  # what a robot believes about one other player; slots of team-mates come first, then opponents
        ("present", "i2", FLAG),  # 1: the slot is in use
        ("teammate", "i2", FLAG),  # 1 team-mate, 0 opponent
        ("keeper", "i2", FLAG),  # 1: the goalkeeper of its team
        ("number", "i2", PLAYER_OR_UNKNOWN),  # the player's number, -1 unknown
        ("distance", "f8", AMOUNT),  # [m]
        ("bearing", "f8", NUMBER),  # [rad] robot frame
        ("x", "f8", NUMBER),  # [m] robot frame
        ("y", "f8", NUMBER),  # [m] robot frame
        ("vx", "f8", NUMBER),  # [m/s] velocity over the ground, in the axes of the robot frame
        ("vy", "f8", NUMBER),  # [m/s]
        ("heading", "f8", NUMBER),  # [rad] robot frame
        ("confidence", "f8", CONFIDENCE),  # [0, 100]
        ("age", "f8", AMOUNT),  # [s] since it was seen
    ]
)

HEARD = ranged_record(
    [  # what team-mates say of the ball; the team-mate nearest to it counts
        ("word", "i8", WORDS),  # 1 ... 15: range of its distance to the ball, see ball_words.py; 0: nobody says
        ("distance", "f8", ENDLESS),  # [m] its distance to the ball; inf if nobody says
        ("age", "f8", ENDLESS),  # [s] since it said so; inf if nobody says
    ]
)

OBSTACLE = ranged_record(
    [  # a robot that the infrared ranger meets and the picture does not show; only legged robots with sensors
        ("distance", "f4", AMOUNT),  # [m] to the middle of its body; 0: there is none
        ("bearing", "f4", NUMBER),  # [rad] robot frame
    ]
)

BELIEF = ranged_record(
    [("own", OWN_POSE), ("ball", BALL_BELIEF), ("situation", SITUATION), ("heard", HEARD), ("obstacle", OBSTACLE)]
)


# Slots for other players


@compiled
def clear_slots(tracks, first, last):
    """Mark the slots `first` to `last` - 1 of the tracks as unused."""
    for slot in range(first, last):
        forget(tracks[slot])


@compiled
def forget(track):
    """Reset a track to an empty TRACK, so that its slot is unused."""
    track.present = track.teammate = track.keeper = 0
    track.number = UNKNOWN
    track.distance = track.bearing = track.x = track.y = track.vx = track.vy = track.heading = 0.0
    track.confidence = track.age = 0.0
