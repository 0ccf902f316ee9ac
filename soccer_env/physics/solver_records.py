"""What our part of Chipmunk's solver works on: one SOLVER record for each match, filled before a step.  MS51, MH01"""

from __future__ import annotations

import numpy as np

from soccer_env.types import MAX_TEAM

MOST_ROBOTS = 2 * MAX_TEAM
PAWS = 4  # of a robot, in the order of `gait.py`
MOST_CONTACTS = 8  # of the ball that are treated; more do not fit round it

PAW = np.dtype(
    [
        ("shape", "u8"),  # address of the circle that the ball meets; 0: this robot has none
        ("x", "f8"),  # [m] robot frame, at the beginning of the control step
        ("y", "f8"),  # [m] robot frame
        ("vx", "f8"),  # [m/s] over the robot's body, in its frame
        ("vy", "f8"),  # [m/s]
    ]
)
STANCE = np.dtype(
    [  # a robot on the ground
        ("body", "u8"),  # address
        ("vx", "f8"),  # [m/s] field frame: the velocity that its legs or wheels want
        ("vy", "f8"),  # [m/s] field frame
        ("omega", "f8"),  # [rad/s]
        ("traction", "f8"),  # [m/s2] force that the ground bears, over mass
        ("turn_traction", "f8"),  # [rad/s2] the same for its torque
        ("given_x", "f8"),  # [m/s] field frame: what the ground has added to its velocity in this substep
        ("given_y", "f8"),  # [m/s]
        ("given_turn", "f8"),  # [rad/s]
        ("paws", PAW, (PAWS,)),
    ]
)
BALL_CONTACT = np.dtype(
    [
        ("arbiter", "u8"),  # address
        ("friction", "f8"),  # [1] of the pair
    ]
)
SOLVER = np.dtype(
    [
        ("robots", "i8"),  # how many there are
        ("stances", STANCE, (MOST_ROBOTS,)),
        ("touching", "i8", (MOST_ROBOTS,)),  # rows of those that touch something in this substep
        ("touching_count", "i8"),
        ("ball", "u8"),  # address of its body
        ("roll_x", "f8"),  # [m/s] field frame: speed at which the ball would roll without sliding
        ("roll_y", "f8"),  # [m/s] field frame
        ("spin_mass", "f8"),  # [kg] the ball's inertia over its radius squared
        ("ball_contacts", BALL_CONTACT, (MOST_CONTACTS,)),
        ("ball_contact_count", "i8"),
    ]
)
