"""What our part of Chipmunk's solver works on: one SOLVER record for each match, filled before a step.  MS51, MH01"""

from __future__ import annotations

import numpy as np

from soccer_env.types import MAX_TEAM

MOST_ROBOTS = 2 * MAX_TEAM
OVERLAP_LEFT = 1e-12  # [1] share of an overlap left after 1 s, assumed; Chipmunk's 0.0018 buries a ball in a scrum
POSTS = 4  # of a robot that there is room for: left fore, right fore, left hind, right hind
MOST_CONTACTS = 8  # of the ball that are treated; more do not fit round it
POST_CONTACTS = 4  # for each body of a match that there is room for: twice as many as scrums of 11 a side have

POST = np.dtype(
    [  # a leg, or a tip of a guide
        ("stand_x", "f8"),  # [m] robot frame, where it stands, in the middle of its stroke
        ("stand_y", "f8"),  # [m] robot frame
        ("x", "f8"),  # [m] robot frame, where it is at the beginning of the control step
        ("y", "f8"),  # [m] robot frame
        ("vx", "f8"),  # [m/s] over the robot's body, in its frame
        ("vy", "f8"),  # [m/s]
        ("field_x", "f8"),  # [m] field frame, where it stands in this substep
        ("field_y", "f8"),  # [m] field frame
        ("root_x", "f8"),  # [m] field frame, the other end of a leg that is spread for a block; else the same place
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
        ("grip", "f8"),  # [m/s2] the same across its heading; another number only where wheels do not roll sideways
        ("turn_traction", "f8"),  # [rad/s2] the same for its torque
        ("given_x", "f8"),  # [m/s] field frame: what the ground has added to its velocity in this substep
        ("given_y", "f8"),  # [m/s]
        ("given_turn", "f8"),  # [rad/s]
        ("active", "i8"),  # 0: parked off the pitch, where its posts touch nothing
        ("led", "i8"),  # 1: it touches nothing, and the ground has given all that it gives in this control step
        ("placed", "i8"),  # 1: where its posts stand in this substep is known
        ("meets", "i8"),  # 1: its posts touch something in this substep
        ("caught_by", "i8"),  # as in the robot's record
        ("caught_leg", "i8"),
        ("caught_gap", "i8"),
        ("spread", "f8"),  # [1] of its forelegs in a block, at the beginning of the control step
        ("spread_rate", "f8"),  # [1/s] at which they spread
        ("posts", POST, (POSTS,)),
    ]
)
BALL_CONTACT = np.dtype(
    [
        ("arbiter", "u8"),  # address
        ("friction", "f8"),  # [1] of the pair
    ]
)
POST_CONTACT = np.dtype(
    [  # a post of robot A that touches B; the normal points from A to B
        ("key", "i8"),  # the same in the next substep, if the same two touch again
        ("a", "u8"),  # address of A's body
        ("b", "u8"),  # address of B's: a robot, the ball, or the static body
        ("nx", "f8"),  # [1] field frame
        ("ny", "f8"),  # [1]
        ("ax", "f8"),  # [m] field frame: where they touch, from A's centre
        ("ay", "f8"),  # [m]
        ("bx", "f8"),  # [m] field frame: the same from B's centre
        ("by", "f8"),  # [m]
        ("surface_x", "f8"),  # [m/s] field frame: velocity of B's surface on its body less that of A's
        ("surface_y", "f8"),  # [m/s]
        ("mass_along", "f8"),  # [kg] that resists an impulse along the normal
        ("mass_across", "f8"),  # [kg] and across it
        ("skew", "f8"),  # [1/kg] velocity across that a unit of impulse along brings about
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
LAST_CONTACT = np.dtype([("key", "i8"), ("push", "f8"), ("rub", "f8")])  # what the next substep begins with
SOLVER = np.dtype(
    [
        ("robots", "i8"),  # how many there are
        ("posts", "i8"),  # of a robot that this part of the solver lets touch things
        ("space", "u8"),  # address of the match's cpSpace
        ("rounds", "i8"),  # of impulses in a substep
        ("jam_rounds", "i8"),  # the same while the ball touches two things or more, or legs hold each other
        ("holds", "i8"),  # of legs, in this substep
        ("constants", "u8"),  # address of the league's constants
        ("handedness", "f8"),  # -1 in a mirrored match, whose legs are numbered the other way round
        ("time", "f8"),  # [s] since the beginning of the control step
        ("slop", "f8"),  # [m] overlap that is left alone
        ("repair", "f8"),  # [1/s] share of the rest that is undone in a substep, over its length
        ("ground", "u8"),  # address of the static body
        ("ball", "u8"),  # address of its body
        ("ball_lightness", "f8"),  # [1/kg] one over its mass
        ("ball_ease", "f8"),  # [1/(kg m2)] one over its moment of inertia about the vertical
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
        ("contact_room", "i8"),  # how many fit
        ("touching", "i8", (MOST_ROBOTS,)),  # rows of those that touch something in this substep
        ("touching_count", "i8"),
    ]
)
