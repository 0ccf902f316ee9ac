"""Records of percepts: the readings of a robot's sensors in one frame, and nothing else.

Percepts are named from the robot's own side: own goal, team-mates. A robot knows its jersey and the half that it
defends, so colours need no names. Pixels are whole numbers, everything else is single precision: a percept is as fine
as the sensor, and small. A sensor's hidden state, such as its own error, lies in a record of perception/ that no other
code receives.

    legged        LEGGED_PERCEPT: blobs in the image of a camera on a moving head, an infrared ranger on its axis
    middle size   OMNI_PERCEPT: bearings and distances from an omnidirectional camera, white lines, a light barrier
"""

from soccer_env.guards.ranges import AMOUNT, FLAG, NUMBER, STEP, UNIT, Range, ranged_record
from soccer_env.types import MAX_TEAM

BLOBS = 4  # largest blobs of a colour that the vision delivers, Sacks 2001, 2  MS04
LANDMARKS = 6  # of the legged field: own left, own right, halfway left, right, opponents' left, right corner
LINES = 32  # room for directions in which white lines are looked for
OTHERS = 2 * MAX_TEAM - 1  # room for every other player

NO_POSE = 0
POSE_SENSED = 1  # the noisy pose of perception/body.py
POSE_TOLD = 2  # the robot was put somewhere and told where

PIXEL = Range(-10000, 10000)  # [px] from the middle of a picture
PIXELS = Range(0, 32767)

BLOB = ranged_record(
    [  # box round a blob [px] from the image's centre, left and up positive; the vision counts whole pixels
        ("left", "i2", PIXEL),
        ("right", "i2", PIXEL),  # right <= left
        ("high", "i2", PIXEL),
        ("low", "i2", PIXEL),
        ("area", "i2", PIXELS),  # [px] coloured pixels; 0: no blob
    ]
)

BODY_PERCEPT = ranged_record(
    [  # what every robot feels of itself
        ("frame", "i4", STEP),  # frames since the reset
        ("handedness", "f4", UNIT),  # +1; -1 mirrors each lateral noise draw (for symmetry tests)
        ("forward", "f4", NUMBER),  # [m] odometry: own displacement since the last frame, in the last frame's axes
        ("left", "f4", NUMBER),  # [m]
        ("turn", "f4", NUMBER),  # [rad]
        ("upright", "i1", FLAG),  # 0: the accelerometer says that the robot lies on its side  MS06
        ("held", "i1", FLAG),  # 1: the light barrier at the kicker is broken (middle size)
        ("kicked", "i1", FLAG),  # 1: the kicker fired in this frame
        ("pose", "i1", Range(NO_POSE, POSE_TOLD)),  # NO_POSE, POSE_SENSED or POSE_TOLD
        ("active", "i1", FLAG),  # 0: sent off
        ("x", "f4", NUMBER),  # [m] team frame, if there is a pose
        ("y", "f4", NUMBER),  # [m] team frame
        ("heading", "f4", NUMBER),  # [rad] team frame
    ]
)

TOUCH = ranged_record(
    [  # switches of a legged robot  [Sacks 2001, 1]  MS06
        ("head", "i1", FLAG),  # 1: the one on the head is pressed
        ("chin", "i1", FLAG),  # 1: the one under the chin
        ("back", "i1", FLAG),  # 1: the one on the back
        ("feet", "i1", Range(0, 4)),  # how many of the four under the paws are pressed: one for each paw that stands
    ]
)

LEGGED_PERCEPT = ranged_record(
    [
        ("body", BODY_PERCEPT),
        ("touch", TOUCH),
        ("pan", "f4", NUMBER),  # [rad] joint angles at the moment of the picture, left positive
        ("tilt", "f4", NUMBER),  # [rad] up positive
        ("infrared", "f4", AMOUNT),  # [m] range along the camera's axis; 0: no valid reading  MS05
        ("ball", BLOB, (BLOBS,)),  # orange, largest first
        ("teammates", BLOB, (BLOBS,)),  # own jersey colour
        ("opponents", BLOB, (BLOBS,)),  # their jersey colour
        ("own_goal", BLOB, (BLOBS,)),
        ("opponent_goal", BLOB, (BLOBS,)),
        ("landmarks", BLOB, (LANDMARKS,)),
    ]
)

SIGHTING = ranged_record(
    [  # a thing in the picture of the omnidirectional camera
        ("distance", "f4", AMOUNT),  # [m] along the ground, by the mirror's curve
        ("bearing", "f4", NUMBER),  # [rad] robot frame
        ("seen", "i1", FLAG),  # 1: in the picture; else the numbers are 0
        ("teammate", "i1", FLAG),  # of a player: 1 by its marker's colour
    ]
)

OMNI_PERCEPT = ranged_record(
    [
        ("body", BODY_PERCEPT),
        ("age", "f4", AMOUNT),  # [s] since the exposure of this picture
        ("ball", SIGHTING),
        ("searched", "i1", FLAG),  # 1: this picture was searched for goals and lines; else they are of an earlier one
        ("own_goal", SIGHTING),  # middle of the part that is seen
        ("opponent_goal", SIGHTING),
        ("players", SIGHTING, (OTHERS,)),  # nearest first
        ("lines", "f4", AMOUNT, (LINES,)),  # [m] distance of the first white line in direction i of s.lines, from the
        # front counter-clockwise, each in the middle of its sector; 0: none seen
        ("light", "f4", NUMBER),  # [1] brightness of the picture, which the camera can measure
    ]
)
