"""Every record of a match: its fields with unit and frame.

A match is plain data. Each dtype here is declared once and is fixed: team size lives in the axes of the arrays, never
in a dtype (a dtype that grows would compile every kernel again). Frames are those of the package:

* field frame: origin at the centre spot, x towards the goal that away defends in the first half, y to the left,
  heading counter-clockwise in (-pi, pi];
* team frame: the field frame turned so that the team's own goal lies at -x and the opponent's at +x;
* robot frame: x forward, y left; a bearing is an angle in it, 0 straight ahead.

SI units and radians everywhere. Integers are used for flags and codes; fields of eight bytes lie at multiples of eight.
"""

from __future__ import annotations

from enum import IntEnum

import numpy as np

MAX_TEAM = 11  # players a side that a match has room for, at most
MAX_DELAY_STEPS = 12  # control steps of actuation delay that a robot record has room for
NOISE_STREAMS = 16  # room for named noise streams in each match and robot record
NO_TEAM = -1
HOME = 0
AWAY = 1


class Phase(IntEnum):
    """Phases of play; a restart phase lasts until the ball is in play again."""

    PLAY = 0
    KICK_OFF = 1
    THROW_IN = 2
    GOAL_KICK = 3
    CORNER_KICK = 4
    DROP_BALL = 5
    FREE_KICK = 6
    PENALTY_KICK = 7  # of a penalty shoot-out
    OVER = 8


class Foul(IntEnum):
    """What a referee whistles for; see `referee/fouls`."""

    NONE = 0
    PUSHING = 1
    KEEPER_PUSHING = 2
    HOLDING = 3
    ILLEGAL_DEFENDER = 4
    ILLEGAL_ATTACKER = 5
    LEFT_FIELD = 6
    FALLEN = 7
    GAME_STUCK = 8
    SECOND_TOUCH = 9
    CHARGING = 10
    KEEPER_CHARGE = 11
    HANDLING = 12
    DRIBBLE = 13
    GOAL_AREA = 14
    PENALTY_AREA = 15
    DISTANCE = 16


class MatchStream(IntEnum):
    """Named noise streams of a match record: a new one takes a free number and never shifts the others."""

    SCENE = 2  # where drills put ball and robots
    KICK_OFF = 3  # who kicks off first


class RobotStream(IntEnum):
    """Named noise streams of a robot record."""

    SLIP = 0
    KICK = 1
    TEAM = 2
    PLACEMENT = 3
    CAMERA = 4  # dither, missed blobs
    FALSE_BLOBS = 5
    INFRARED = 6
    ODOMETRY = 7
    POSE = 8  # the noisy pose, and the pose that a robot is told when it is placed
    PARTICLES = 9
    RADIO = 10  # loss of messages
    LIGHT = 11
    BARRIER = 12  # errors of the light barrier
    FALL = 13  # robots that are pushed over


COMMAND = np.dtype(
    [
        ("forward", "f8"),  # [-1, 1] of the league's top speed ahead
        ("left", "f8"),  # [-1, 1] of the league's top speed to the left
        ("turn", "f8"),  # [-1, 1] of the league's top turn rate, counter-clockwise
        ("kick", "f8"),  # (0, 1] strength of a kick; 0 or less: no kick
        ("head", "f8"),  # below 0: the head tracks the ball by itself; else pan and tilt below are obeyed
        ("pan", "f8"),  # [-1, 1] of the pan limit, left positive
        ("tilt", "f8"),  # [-1, 1]: -1 the lowest, 1 the highest tilt
    ]
)

WALK = np.dtype(
    [
        ("forward", "f8"),  # [m/s] robot frame
        ("left", "f8"),  # [m/s] robot frame
        ("turn", "f8"),  # [rad/s]
    ]
)

GAZE = np.dtype(
    [
        ("pan", "f8"),  # [rad] where the head would look by itself, left positive
        ("tilt", "f8"),  # [rad] up positive
    ]
)

MATCH = np.dtype(
    [
        ("seed", "u8"),  # from which the whole match follows
        ("episode", "i8"),  # episodes begun with this seed, the first is 0
        ("step", "i8"),  # control steps since the reset
        ("clock", "f8"),  # [s] of play in this half
        ("half_length", "f8"),  # [s] of a half; inf: the match has no end of its own
        ("half", "i8"),  # 0 first, 1 second
        ("over", "i8"),  # 1 once the episode has ended
        ("phase", "i8"),  # a Phase
        ("phase_clock", "f8"),  # [s] since the phase began
        ("placing", "i8"),  # 1 while robots drive to their places and the ball is held
        ("restart_team", "i8"),  # who takes the restart: HOME, AWAY or NO_TEAM
        ("restart_x", "f8"),  # [m] field frame: where the ball was put at the last restart
        ("restart_y", "f8"),  # [m] field frame
        ("kick_off_team", "i8"),  # who took the first kick-off
        ("home_direction", "f8"),  # +1: home attacks +x, -1: home attacks -x
        ("score", "i8", (2,)),  # goals of home, of away
        ("last_touch_team", "i8"),  # HOME, AWAY or NO_TEAM
        ("last_touch_robot", "i8"),  # row of the robot that touched the ball last, or -1
        ("still_clock", "f8"),  # [s] that the ball has stayed near the still point
        ("still_x", "f8"),  # [m] field frame: the still point
        ("still_y", "f8"),  # [m] field frame
        ("taker", "i8"),  # row of the robot that took the restart, until somebody else touches the ball, or -1
        ("taker_clock", "f8"),  # [s] since the taker touched the ball
        ("indirect", "i8"),  # 1: nobody but the taker has touched the ball since a restart that allows no direct goal
        ("idle_clock", "f8"),  # [s] since somebody touched the ball
        ("local_clock", "f8"),  # [s] since play moved on
        ("local_x", "f8"),  # [m] field frame: where play has been since
        ("local_y", "f8"),  # [m] field frame
        ("whistled", "i8"),  # the team whose attack was whistled a moment ago, or NO_TEAM
        ("whistled_clock", "f8"),  # [s] since
        ("kick_off_shot", "i8"),  # the team that cannot score before it touches its kick-off again, or NO_TEAM
        ("shoot_out", "i8"),  # penalty kicks taken; 0 outside a shoot-out
        ("shoot_out_score", "i8", (2,)),  # goals of home, of away in it
        ("drill_clock", "f8"),  # [s] for which a drill's dribbler has been far from the ball
        ("handedness", "f8"),  # +1; -1 mirrors each lateral noise draw (for symmetry tests)
        ("noise", "u8", (NOISE_STREAMS,)),  # state of each MatchStream
    ]
)

BALL = np.dtype(
    [
        ("x", "f8"),  # [m] field frame
        ("y", "f8"),  # [m] field frame
        ("vx", "f8"),  # [m/s] field frame
        ("vy", "f8"),  # [m/s] field frame
        ("roll_x", "f8"),  # [m/s] field frame: speed at which the ball would roll without sliding
        ("roll_y", "f8"),  # [m/s] field frame
        ("angle", "f8"),  # [rad] about the vertical, for the physics alone
        ("spin", "f8"),  # [rad/s] about the vertical
    ]
)

ROBOT = np.dtype(
    [
        ("x", "f8"),  # [m] field frame
        ("y", "f8"),  # [m] field frame
        ("heading", "f8"),  # [rad] field frame, (-pi, pi]
        ("vx", "f8"),  # [m/s] field frame
        ("vy", "f8"),  # [m/s] field frame
        ("omega", "f8"),  # [rad/s]
        ("team", "i8"),  # HOME or AWAY
        ("number", "i8"),  # 0 ... within the team
        ("keeper", "i8"),  # 1 for the goalkeeper
        ("active", "i8"),  # 0: sent off or padding, parked off the field
        ("command", COMMAND),  # what was asked in this step, clipped
        ("delayed", WALK, (MAX_DELAY_STEPS,)),  # [m/s, rad/s] walk requests on their way to the legs or wheels
        ("target", WALK),  # [m/s, rad/s] robot frame: the walk that the gait or the wheels now aim at
        ("walk", WALK),  # [m/s, rad/s] robot frame: the walk after acceleration limits, before slip
        ("slip", WALK),  # [1] factors on the walk during this gait step
        ("gait_phase", "i8"),  # control steps since the gait step began
        ("pan", "f8"),  # [rad] head, left positive
        ("tilt", "f8"),  # [rad] head, up positive
        ("senses", "i8"),  # 1: it uses its sensors, `gaze` comes from its belief; 0: the head follows the true ball
        ("gaze", GAZE),  # [rad] where the head looks unless the command says otherwise
        ("kick_clock", "f8"),  # [s] left of a wind-up or a block (negative: left of the recharge, as -s); 0 ready
        ("kick_strength", "f8"),  # (0, 1] of the kick being wound up; 0: what goes on is a block
        ("has_ball", "i8"),  # 1: the ball lies in the pocket or at the kicker
        ("stands", "i8"),  # 1: it has come to rest and holds with all paws or wheels; 0: it walks, drives or brakes
        ("caught_by", "i8"),  # 1 + row of the robot between whose legs one of its own is caught; 0: none is
        ("caught_leg", "i8"),  # which of its own: 0 left fore, 1 right fore, 2 left hind, 3 right hind
        ("caught_gap", "i8"),  # between which of the other's: 0 the fore ones, 1 the hind ones, 2 the left, 3 the right
        ("fallen", "f8"),  # [s] left on the ground; 0 upright
        ("penalty", "f8"),  # [s] left of a penalty; 0 none
        ("banned", "i8"),  # 1: out for good
        ("yellow", "i8"),  # cards
        ("fouls", "i8"),  # that count for cards
        ("charging", "f8"),  # [s] that it has driven into an opponent off the ball
        ("handling", "f8"),  # [s] that the ball has lain too far within its hull
        ("backed", "f8"),  # [m] that it has gone back with the ball
        ("dribbled", "f8"),  # [m] that it has gone with the ball
        ("area_clock", "f8"),  # [s] in a goal area
        ("crowd_clock", "f8"),  # [s] in its own penalty area beside another field player
        ("near_clock", "f8"),  # [s] too near to the opponents' restart
        ("pushing", "f8"),  # [s] that it has pushed an opponent
        ("keeper_pushing", "f8"),  # [s] that it has pushed a goalkeeper in its area
        ("holding", "f8"),  # [s] that it has held a trapped ball
        ("carry_x", "f8"),  # [m] field frame: where it took up the ball that it carries
        ("carry_y", "f8"),  # [m] field frame
        ("trespass", "f8"),  # [s] in an area in which it may not stay; below 0: it has that long to walk out
        ("beyond", "f8"),  # [s] beyond a line that it may not leave
        ("locked", "f8"),  # [s] in contact with an opponent, less the time out of it, never below 0
        ("place_x", "f8"),  # [m] field frame: its place at the current restart
        ("place_y", "f8"),  # [m] field frame
        ("place_heading", "f8"),  # [rad] field frame
        ("placed", "i8"),  # 1: it was put somewhere in this step, and was told where
        ("noise", "u8", (NOISE_STREAMS,)),  # state of each RobotStream
    ]
)

EVENTS = np.dtype(
    [  # what happened to a match in this step
        ("goal", "i8"),  # the team that scored, or NO_TEAM
        ("scorer", "i8"),  # row of the robot that touched the ball last before the goal, or -1
        ("out", "i8"),  # 1: the whole ball left the field of play
        ("restart", "i8"),  # the Phase of a restart called in this step, or 0
        ("restart_team", "i8"),  # who takes it, or NO_TEAM
        ("in_play", "i8"),  # 1: a restart was taken or its time ran out
        ("stuck", "i8"),  # 1: the referee called a stuck ball
        ("separated", "i8"),  # 1: the referee pulled opponents apart
        ("foul", "i8"),  # the Foul that was whistled, or 0; of several the first
        ("foul_team", "i8"),  # the team that committed it, or NO_TEAM
        ("penalty", "i8"),  # a kick of a shoot-out: 1 scored, 2 missed, 0 none
        ("annulled", "i8"),  # 1: the ball went in and the goal does not count
        ("half_time", "i8"),  # 1: the first half ended
        ("final_whistle", "i8"),  # 1: the match ended
        ("touch_team", "i8"),  # who touched the ball in this step, or NO_TEAM; both: the nearer
        ("ball_x", "f8"),  # [m] field frame: the ball before any restart moved it
        ("ball_y", "f8"),  # [m] field frame
        ("drill", "i8"),  # +1 the drill succeeded, -1 it failed, 0 undecided
    ]
)
QUIET = np.zeros((), EVENTS)  # the events of a step in which nothing happened
for _name in ("goal", "scorer", "restart_team", "touch_team", "foul_team"):
    QUIET[_name] = NO_TEAM

ROBOT_EVENTS = np.dtype(
    [  # what happened to a robot in this step
        ("touch", "i2"),  # 1: touched the ball
        ("kick", "i2"),  # 1: a kick reached the ball
        ("possession", "i2"),  # 1: the ball lay in its pocket or at its kicker
        ("collision", "i2"),  # 1: touched another robot
        ("pushes", "i2"),  # it walks into an opponent: 1 any, 2 a goalkeeper in its own area; 0: it does not
        ("pushed", "i2"),  # 1: an opponent walks into it
        ("foul", "i2"),  # the Foul that was whistled against it, or 0
        ("card", "i2"),  # 1 yellow, 2 the second one: out
        ("returned", "i2"),  # 1: it came back from a penalty
    ]
)
