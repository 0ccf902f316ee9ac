"""The records of our part of Chipmunk's solver: one SOLVER for each match, filled before a step.  MS51, MH01"""

from __future__ import annotations

import numpy as np

from soccer_env.types import MAX_TEAM

MOST_ROBOTS = 2 * MAX_TEAM
OVERLAP_LEFT = 1e-12  # [1] share of an overlap left after 1 s, assumed; Chipmunk's 0.0018 buries a ball in a scrum
POSTS = 4  # room for posts of a robot: left fore, right fore, left hind, right hind
MOST_CONTACTS = 8  # of the ball; more do not fit round it
POST_CONTACTS = 4  # room for each body of a match: twice as many as scrums of 11 a side have

POST = np.dtype(
    [  # a leg, or a tip of a guide
        ("stand_x", "f8"),  # [m] robot frame, where it stands, in the middle of its stroke
        ("stand_y", "f8"),  # [m] robot frame
        ("x", "f8"),  # [m] robot frame, its place at the start of the control step
        ("y", "f8"),  # [m] robot frame
        ("vx", "f8"),  # [m/s] over the robot's body, in its frame
        ("vy", "f8"),  # [m/s]
        ("field_x", "f8"),  # [m] field frame, where it stands in this substep
        ("field_y", "f8"),  # [m] field frame
        ("root_x", "f8"),  # [m] field frame, the upper end of a leg spread for a block; else field_x
        ("root_y", "f8"),  # [m] field frame
    ]
)
STANCE = np.dtype(
    [  # a robot on the ground
        ("body", "u8"),  # address
        ("vx", "f8"),  # [m/s] field frame: the velocity that its legs or wheels want
        ("vy", "f8"),  # [m/s] field frame
        ("omega", "f8"),  # [rad/s]
        ("traction", "f8"),  # [m/s2] force that the ground bears, over mass
        ("grip", "f8"),  # [m/s2] traction across its heading; differs only where wheels do not roll sideways
        ("turn_traction", "f8"),  # [rad/s2] torque that the ground bears, over moment of inertia
        ("given_x", "f8"),  # [m/s] field frame: velocity that the ground has added in this substep
        ("given_y", "f8"),  # [m/s]
        ("given_turn", "f8"),  # [rad/s]
        ("active", "i8"),  # 0: parked off the pitch, where its posts touch nothing
        ("led", "i8"),  # 1: it touches nothing, and the ground has acted for this control step
        ("placed", "i8"),  # 1: the places of its posts are computed in this substep
        ("meets", "i8"),  # 1: its posts touch something in this substep
        ("caught_by", "i8"),  # as in the robot's record
        ("caught_leg", "i8"),
        ("caught_gap", "i8"),
        ("spread", "f8"),  # [1] of its forelegs in a block, at the beginning of the control step
        ("spread_rate", "f8"),  # [1/s] at which they spread
        ("posts", POST, (POSTS,)),
    ]
)
BALL_CONTACT = np.dtype([("arbiter", "u8"), ("friction", "f8")])  # address; [1] of the pair
POST_CONTACT = np.dtype(
    [  # a post of robot A that touches B; the normal points from A to B
        ("key", "i8"),  # the same in the next substep, if these two parts touch again
        ("a", "u8"),  # address of A's body
        ("b", "u8"),  # address of B's: a robot, the ball, or the static body
        ("nx", "f8"),  # [1] field frame
        ("ny", "f8"),  # [1]
        ("ax", "f8"),  # [m] field frame: the point of contact, from A's centre
        ("ay", "f8"),  # [m]
        ("bx", "f8"),  # [m] field frame: the point of contact, from B's centre
        ("by", "f8"),  # [m]
        ("surface_x", "f8"),  # [m/s] field frame: velocity of B's surface on its body less that of A's
        ("surface_y", "f8"),  # [m/s]
        ("mass_along", "f8"),  # [kg] that resists an impulse along the normal
        ("mass_across", "f8"),  # [kg] that resists an impulse across the normal
        ("skew", "f8"),  # [1/kg] velocity across the normal for a unit of impulse along it
        ("target", "f8"),  # [m/s] velocity along the normal after the blow
        ("repair", "f8"),  # [m/s] at which an overlap is undone
        ("friction", "f8"),  # [1] of the pair
        ("held", "i8"),  # 1: legs hold each other here
        ("level", "f8"),  # [1] share of the friction that acts level: less than 1 at a ball that rolls
        ("ball", "i8"),  # 1: B is the ball
        ("push", "f8"),  # [N s] impulse along the normal in this substep
        ("rub", "f8"),  # [N s] impulse across it
        ("shift", "f8"),  # [N s] impulse that undoes the overlap
    ]
)
LAST_CONTACT = np.dtype([("key", "i8"), ("push", "f8"), ("rub", "f8")])  # impulses from which the next substep starts
SOLVER = np.dtype(
    [
        ("robots", "i8"),  # how many there are
        ("posts", "i8"),  # of a robot whose contacts this part of the solver finds
        ("space", "u8"),  # address of the match's cpSpace
        ("rounds", "i8"),  # of impulses in a substep
        ("jam_rounds", "i8"),  # of impulses, while the ball touches two things or more, or legs hold each other
        ("holds", "i8"),  # of legs, in this substep
        ("constants", "u8"),  # address of the league's constants
        ("handedness", "f8"),  # -1 in a mirrored match, which numbers the right legs first
        ("time", "f8"),  # [s] since the beginning of the control step
        ("slop", "f8"),  # [m] overlap that is left alone
        ("repair", "f8"),  # [1/s] share of the remaining overlap that a substep undoes, over its length
        ("ground", "u8"),  # address of the static body
        ("ball", "u8"),  # address of the ball's body
        ("ball_lightness", "f8"),  # [1/kg] one over the ball's mass
        ("ball_ease", "f8"),  # [1/(kg m2)] one over the ball's moment of inertia about the vertical
        ("roll_x", "f8"),  # [m/s] field frame: speed at which the ball would roll without sliding
        ("roll_y", "f8"),  # [m/s] field frame
        ("spin_mass", "f8"),  # [kg] the ball's inertia over its radius squared
        ("ball_contacts", BALL_CONTACT, (MOST_CONTACTS,)),
        ("ball_contact_count", "i8"),
        ("ball_elasticity", "f8"),  # [1] of ball and robot
        ("ball_friction", "f8"),  # [1]
        ("robot_elasticity", "f8"),  # [1] of two robots
        ("robot_friction", "f8"),  # [1]
        ("board_elasticity", "f8"),  # [1] of robot and board
        ("board_friction", "f8"),  # [1]
        ("stances", "u8"),  # address of the first robot's STANCE
        ("contacts", "u8"),  # address of the first POST_CONTACT of this substep
        ("contact_count", "i8"),
        ("last_contacts", "u8"),  # address of the first LAST_CONTACT, of the last substep
        ("last_count", "i8"),
        ("contact_room", "i8"),  # contacts that the array has room for
        ("touching", "i8", (MOST_ROBOTS,)),  # rows of robots that touch something in this substep
        ("touching_count", "i8"),
    ]
)
