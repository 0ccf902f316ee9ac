"""Every record of a match: its fields with unit and frame.

A match is plain data. Each dtype here is declared once and is fixed: team size lives in the axes of the arrays, never
in a dtype (a dtype that grows would compile every kernel again). Frames are those of the package:

* field frame: origin at the centre spot, x towards the goal that away defends in the first half, y to the left,
  heading counter-clockwise in (-pi, pi];
* team frame: the field frame turned so that the team's own goal lies at -x and the opponent's at +x;
* robot frame: x forward, y left; a bearing is an angle in it, 0 straight ahead.

SI units and radians everywhere. Integers are used for flags and codes; fields of eight bytes lie at multiples of eight.
Beside each field stands its range, of `guards/ranges.py`: what a save or a replay may bring in.
"""

from enum import IntEnum
from math import inf

import numpy as np

from soccer_env.guards.ranges import (
    AMOUNT,
    ANGLE,
    ANY,
    COUNT,
    FLAG,
    NUMBER,
    ROW_FROM_ONE,
    ROW_OR_NONE,
    SHARE,
    SIGN,
    STEP,
    UNIT,
    Range,
    ranged_record,
)

MAX_TEAM = 11  # players a side that a match has room for, at most
MAX_DELAY_STEPS = 12  # control steps of actuation delay that a robot record has room for
NOISE_STREAMS = 16  # room for named noise streams in each match and robot record
NO_TEAM = -1
WORLD = 4  # raised when physics, referee or sensors change: saves, replays and results belong to one world
OTHER_WORLD = "load it with the version of soccer_env that made it"  # in errors
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
    """The fouls that a referee calls; see `referee/fouls`."""

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
    """Named noise streams of a match record: a new stream takes a free number and never shifts the others."""

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


TEAM = Range(HOME, AWAY)
TEAM_OR_NONE = Range(NO_TEAM, AWAY)
PLAYER = Range(0, MAX_TEAM - 1)  # its number
PLAYERS = Range(0, MAX_TEAM)  # how many
PHASE = Range(0, max(Phase))
FOUL = Range(0, max(Foul))
EPISODE = Range(0, (1 << 40) - 1)  # branches that draw anew count on from its end
HALF_LENGTH = Range(1e-6, inf)  # [s]

COMMAND = ranged_record(
    [
        ("forward", "f8", UNIT),  # [-1, 1] of the league's top speed ahead
        ("left", "f8", UNIT),  # [-1, 1] of the league's top speed to the left
        ("turn", "f8", UNIT),  # [-1, 1] of the league's top turn rate, counter-clockwise
        ("kick", "f8", UNIT),  # (0, 1] strength of a kick; 0 or less: no kick
        ("head", "f8", UNIT),  # below 0: the head tracks the ball by itself; else pan and tilt below are obeyed
        ("pan", "f8", UNIT),  # [-1, 1] of the pan limit, left positive
        ("tilt", "f8", UNIT),  # [-1, 1]: -1 the lowest, 1 the highest tilt
    ]
)

WALK = ranged_record(
    [
        ("forward", "f8", NUMBER),  # [m/s] robot frame
        ("left", "f8", NUMBER),  # [m/s] robot frame
        ("turn", "f8", NUMBER),  # [rad/s]
    ]
)

GAZE = ranged_record(
    [
        ("pan", "f8", NUMBER),  # [rad] where the head would look by itself, left positive
        ("tilt", "f8", NUMBER),  # [rad] up positive
    ]
)

MATCH = ranged_record(
    [
        ("seed", "u8", ANY),  # from which the whole match follows
        ("episode", "i8", EPISODE),  # episodes begun with this seed, the first is 0
        ("step", "i8", STEP),  # control steps since the reset
        ("clock", "f8", AMOUNT),  # [s] of play in this half
        ("half_length", "f8", HALF_LENGTH),  # [s] of a half; inf: the match has no end of its own
        ("half", "i8", FLAG),  # 0 first, 1 second
        ("over", "i8", FLAG),  # 1 once the episode has ended
        ("phase", "i8", PHASE),  # a Phase
        ("phase_clock", "f8", NUMBER),  # [s] since the phase began
        ("placing", "i8", FLAG),  # 1 while robots drive to their places and the ball is held
        ("restart_team", "i8", TEAM_OR_NONE),  # who takes the restart: HOME, AWAY or NO_TEAM
        ("restart_x", "f8", NUMBER),  # [m] field frame: where the ball was put at the last restart
        ("restart_y", "f8", NUMBER),  # [m] field frame
        ("kick_off_team", "i8", TEAM),  # who took the first kick-off
        ("home_direction", "f8", SIGN),  # +1: home attacks +x, -1: home attacks -x
        ("score", "i8", COUNT, (2,)),  # goals of home, of away
        ("last_touch_team", "i8", TEAM_OR_NONE),  # HOME, AWAY or NO_TEAM
        ("last_touch_robot", "i8", ROW_OR_NONE),  # row of the robot that touched the ball last, or -1
        ("still_clock", "f8", NUMBER),  # [s] that the ball has stayed near the still point
        ("still_x", "f8", NUMBER),  # [m] field frame: the still point
        ("still_y", "f8", NUMBER),  # [m] field frame
        ("taker", "i8", ROW_OR_NONE),  # row of the robot that took the restart, until another touches the ball, or -1
        ("taker_clock", "f8", NUMBER),  # [s] since the taker touched the ball
        ("indirect", "i8", FLAG),  # 1: only the taker has touched the ball since a restart that allows no direct goal
        ("idle_clock", "f8", NUMBER),  # [s] since somebody touched the ball
        ("local_clock", "f8", NUMBER),  # [s] since play moved on
        ("local_x", "f8", NUMBER),  # [m] field frame: where play has been since
        ("local_y", "f8", NUMBER),  # [m] field frame
        ("whistled", "i8", TEAM_OR_NONE),  # the team whose attack was whistled a moment ago, or NO_TEAM
        ("whistled_clock", "f8", NUMBER),  # [s] since
        ("kick_off_shot", "i8", TEAM_OR_NONE),  # the team that cannot score before it touches it again, or NO_TEAM
        ("shoot_out", "i8", COUNT),  # penalty kicks taken; 0 outside a shoot-out
        ("shoot_out_score", "i8", COUNT, (2,)),  # goals of home, of away in it
        ("drill_clock", "f8", NUMBER),  # [s] for which a drill's dribbler has been far from the ball
        ("handedness", "f8", SIGN),  # +1; -1 mirrors each lateral noise draw (for symmetry tests)
        ("noise", "u8", ANY, (NOISE_STREAMS,)),  # state of each MatchStream
    ]
)

BALL = ranged_record(
    [
        ("x", "f8", NUMBER),  # [m] field frame
        ("y", "f8", NUMBER),  # [m] field frame
        ("vx", "f8", NUMBER),  # [m/s] field frame
        ("vy", "f8", NUMBER),  # [m/s] field frame
        ("roll_x", "f8", NUMBER),  # [m/s] field frame: speed at which the ball would roll without sliding
        ("roll_y", "f8", NUMBER),  # [m/s] field frame
        ("angle", "f8", NUMBER),  # [rad] about the vertical, for the physics alone
        ("spin", "f8", NUMBER),  # [rad/s] about the vertical
    ]
)

ROBOT = ranged_record(
    [
        ("x", "f8", NUMBER),  # [m] field frame
        ("y", "f8", NUMBER),  # [m] field frame
        ("heading", "f8", NUMBER),  # [rad] field frame, (-pi, pi]
        ("vx", "f8", NUMBER),  # [m/s] field frame
        ("vy", "f8", NUMBER),  # [m/s] field frame
        ("omega", "f8", NUMBER),  # [rad/s]
        ("team", "i8", TEAM),  # HOME or AWAY
        ("number", "i8", PLAYER),  # 0 ... within the team
        ("keeper", "i8", FLAG),  # 1 for the goalkeeper
        ("active", "i8", FLAG),  # 0: sent off or padding, parked off the field
        ("command", COMMAND),  # the command of this step, clipped
        ("delayed", WALK, (MAX_DELAY_STEPS,)),  # [m/s, rad/s] walk requests on their way to the legs or wheels
        ("target", WALK),  # [m/s, rad/s] robot frame: the walk that the gait or the wheels now aim at
        ("walk", WALK),  # [m/s, rad/s] robot frame: the walk after acceleration limits, before slip
        ("slip", WALK),  # [1] factors on the walk during this gait step
        ("gait_phase", "i8", COUNT),  # control steps since the gait step began
        ("pan", "f8", ANGLE),  # [rad] head, left positive
        ("tilt", "f8", ANGLE),  # [rad] head, up positive
        ("senses", "i8", FLAG),  # 1: it uses its sensors, `gaze` comes from its belief; 0: its head follows the ball
        ("gaze", GAZE),  # [rad] where the head looks unless the command says otherwise
        ("kick_clock", "f8", NUMBER),  # [s] left of a wind-up or a block (negative: of the recharge, as -s); 0 ready
        ("kick_side", "f8", Range(-1.0, 1.0)),  # of the kick being wound up: 0 ahead, 1 aside to the left, -1 right
        ("kick_strength", "f8", SHARE),  # (0, 1] of the kick being wound up; 0: it is a block
        ("has_ball", "i8", FLAG),  # 1: the ball lies in the pocket or at the kicker
        ("stands", "i8", FLAG),  # 1: it rests and holds with all paws or wheels; 0: it walks, drives or brakes
        ("caught_by", "i8", ROW_FROM_ONE),  # 1 + row of the robot between whose legs one of its own is caught; 0: none
        ("caught_leg", "i8", Range(0, 3)),  # which of its own: 0 left fore, 1 right fore, 2 left hind, 3 right hind
        ("caught_gap", "i8", Range(0, 3)),  # between the other's: 0 the fore, 1 the hind, 2 the left, 3 the right
        ("fallen", "f8", NUMBER),  # [s] left on the ground; 0 upright
        ("penalty", "f8", NUMBER),  # [s] left of a penalty; 0 none
        ("banned", "i8", FLAG),  # 1: out for good
        ("yellow", "i8", COUNT),  # cards
        ("fouls", "i8", COUNT),  # that count for cards
        ("charging", "f8", NUMBER),  # [s] for which the robot has driven into an opponent off the ball
        ("handling", "f8", NUMBER),  # [s] that the ball has lain too far within its hull
        ("backed", "f8", NUMBER),  # [m] way that the robot has gone back with the ball
        ("dribbled", "f8", NUMBER),  # [m] way that the robot has gone with the ball
        ("area_clock", "f8", NUMBER),  # [s] in a goal area
        ("crowd_clock", "f8", NUMBER),  # [s] in its own penalty area beside another field player
        ("near_clock", "f8", NUMBER),  # [s] too near to the opponents' restart
        ("pushing", "f8", NUMBER),  # [s] for which the robot has pushed an opponent
        ("keeper_pushing", "f8", NUMBER),  # [s] for which the robot has pushed a goalkeeper in the goalkeeper's area
        ("holding", "f8", NUMBER),  # [s] for which the robot has held a trapped ball
        ("carry_x", "f8", NUMBER),  # [m] field frame: where it took up the ball that it carries
        ("carry_y", "f8", NUMBER),  # [m] field frame
        ("trespass", "f8", NUMBER),  # [s] in an area in which it may not stay; below 0: it has that long to walk out
        ("beyond", "f8", NUMBER),  # [s] beyond a line that it may not leave
        ("locked", "f8", NUMBER),  # [s] in contact with an opponent, less the time out of it, never below 0
        ("place_x", "f8", NUMBER),  # [m] field frame: its place at the current restart
        ("place_y", "f8", NUMBER),  # [m] field frame
        ("place_heading", "f8", NUMBER),  # [rad] field frame
        ("placed", "i8", FLAG),  # 1: it was put somewhere in this step, and was told where
        ("noise", "u8", ANY, (NOISE_STREAMS,)),  # state of each RobotStream
    ]
)

EVENTS = ranged_record(
    [  # what happened to a match in this step
        ("goal", "i8", TEAM_OR_NONE),  # the team that scored, or NO_TEAM
        ("scorer", "i8", ROW_OR_NONE),  # row of the robot that touched the ball last before the goal, or -1
        ("out", "i8", FLAG),  # 1: the whole ball left the field of play
        ("restart", "i8", PHASE),  # the Phase of a restart called in this step, or 0
        ("restart_team", "i8", TEAM_OR_NONE),  # the team that takes it, or NO_TEAM
        ("in_play", "i8", FLAG),  # 1: a restart was taken or its time ran out
        ("stuck", "i8", FLAG),  # 1: the referee called a stuck ball
        ("separated", "i8", FLAG),  # 1: the referee pulled opponents apart
        ("foul", "i8", FOUL),  # the Foul that was whistled, or 0; of several the first
        ("foul_team", "i8", TEAM_OR_NONE),  # the team that committed it, or NO_TEAM
        ("penalty", "i8", Range(0, 2)),  # a kick of a shoot-out: 1 scored, 2 missed, 0 none
        ("annulled", "i8", FLAG),  # 1: the ball went in and the goal does not count
        ("half_time", "i8", FLAG),  # 1: the first half ended
        ("final_whistle", "i8", FLAG),  # 1: the match ended
        ("touch_team", "i8", TEAM_OR_NONE),  # who touched the ball in this step, or NO_TEAM; both: the nearer
        ("ball_x", "f8", NUMBER),  # [m] field frame: the ball before any restart moved it
        ("ball_y", "f8", NUMBER),  # [m] field frame
        ("drill", "i8", UNIT),  # +1 the drill succeeded, -1 it failed, 0 undecided
    ]
)
QUIET = np.zeros((), EVENTS)  # the events of a step in which nothing happened
for _name in ("goal", "scorer", "restart_team", "touch_team", "foul_team"):
    QUIET[_name] = NO_TEAM

ROBOT_EVENTS = ranged_record(
    [  # what happened to a robot in this step
        ("touch", "i2", FLAG),  # 1: touched the ball
        ("kick", "i2", FLAG),  # 1: a kick reached the ball
        ("squirt", "i2", Range(-1, 1)),  # 1, -1: its kick lifts the ball out aside, to the left or right
        ("possession", "i2", FLAG),  # 1: the ball lay in its pocket or at its kicker
        ("collision", "i2", FLAG),  # 1: touched another robot
        ("pushes", "i2", Range(0, 2)),  # it walks into an opponent: 1 any, 2 a goalkeeper in its own area; 0: none
        ("pushed", "i2", FLAG),  # 1: an opponent walks into it
        ("foul", "i2", FOUL),  # the Foul that was whistled against it, or 0
        ("card", "i2", Range(0, 2)),  # 1 yellow, 2 the second one: out
        ("returned", "i2", FLAG),  # 1: it came back from a penalty
    ]
)
