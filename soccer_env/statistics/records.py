"""The record of a match's statistics; `figures.py` defines each statistic.

Fields of shape (2,) belong to home and away. Steps are control steps since the reset.
"""

from enum import IntEnum

import numpy as np

from soccer_env.guards.ranges import ANY, COUNT, FLAG, LATELY, NUMBER, ROW, ROW_OR_NONE, SUM, Range, ranged_record
from soccer_env.types import MAX_TEAM, PHASE, TEAM, Foul, Phase

ROWS = 2 * MAX_TEAM  # robots of the record
BINS = 40  # for the lengths of spells
SHORTEST, BINS_PER_OCTAVE = 0.02, 3.0  # [s] lower end of the first bin; the last one has no upper end
NOBODY = 1e5  # [m2]
LONG_AGO = -(1 << 30)  # [steps]
CELLS_LONG, CELLS_WIDE = 24, 16  # of a heat map, along and across the pitch
LOOK = 4  # control steps between two entries in the heat maps, a power of two
SHOTS = 64  # recorded shots of a match; `shots` counts all


class GoalKind(IntEnum):
    """The kind of a goal; each goal is of one kind."""

    CLEAN_KICK = 0
    DEFLECTED_KICK = 1
    CLEAN_DRIBBLE = 2
    PUSHED_IN = 3
    SCRUM = 4
    OWN_GOAL = 5


class Aim(IntEnum):
    """The region into which a played ball would roll, relative to the goal."""

    ELSEWHERE = 0
    AT_GOAL = 1
    ON_TARGET = 2


class Outcome(IntEnum):
    """The outcome of a shot."""

    OFF_TARGET = 0
    GOAL = 1
    SAVED = 2
    BLOCKED = 3


PLAYER = ranged_record(
    [  # memory of a robot
        ("held_since", "i4", LATELY),  # first step of its spell with the ball, 0 without one
        ("held_last", "i4", LATELY),  # last step of its latest spell with the ball
        ("held_steps", "i4", LATELY),  # length of its last finished spell
        ("touched", "i4", LATELY),  # last step in which it touched the ball in play
        ("contact", "i8", LATELY),  # last step in which it touched an opponent
        ("locked", "f8", NUMBER),  # [s] its time in contact after the last step, see `separation.watch_contacts`
        ("seen", "i8", LATELY),  # last step on the pitch with the ball in play
        ("x", "f8", NUMBER),  # [m] field frame: its place then
        ("y", "f8", NUMBER),  # [m] field frame
        ("stuck_since", "i4", LATELY),  # step in which its time stuck began
        ("stuck_last", "i4", LATELY),  # last step in which it was stopped
        ("stuck_steps", "i4", LATELY),  # steps of its time stuck that are counted
        ("spare", "i4", ANY),  # padding to eight bytes
    ]
)

TRAIL = ranged_record(
    [  # memory of the play
        ("kind", "i8", PHASE),  # Phase of the last restart
        ("in_play", "i8", LATELY),  # step in which the ball came into play after it
        ("separated", "i8", LATELY),  # step of the last separation
        ("crowded", "i8", LATELY),  # last step with a scrum
        ("keeper_pushed", "i8", LATELY, (2,)),  # last step in which a team's goalkeeper had been in contact for long
        ("player", "i8", ROW_OR_NONE),  # row of the last robot to touch the ball since the restart, or -1
        ("player_team", "i8", TEAM),  # its team
        ("touched", "i8", LATELY),  # step of that touch
        ("played_x", "f8", NUMBER),  # [m] field frame: the ball at that touch
        ("played_y", "f8", NUMBER),  # [m] field frame
        (
            "since_restart",
            "i8",
            Range(0, (1 << ROWS) - 1),
            (2,),
        ),  # bit r: robot r has touched the ball since the restart
        ("flight", "i8", ROW_OR_NONE),  # row of the robot that kicked or pushed the ball in flight, or -1
        ("flight_team", "i8", TEAM),  # its team
        ("flight_step", "i8", LATELY),  # step of that kick or push
        ("aim", "i8", Range(0, max(Aim))),  # Aim of that kick or push
        ("deflected", "i8", LATELY),  # step in which another robot first touched it in flight, or LONG_AGO
        ("saved", "i8", FLAG),  # 1: the goalkeeper touched a shot on target first
        ("shot", "i8", Range(-1, SHOTS - 1)),  # its index among the recorded shots, or -1
        ("players", PLAYER, (ROWS,)),
        # Collected within one control step, robot by robot
        ("crowd", "i8", COUNT),  # robots about the ball
        ("has_ball", "i8", Range(0, 3)),  # 1: home has it, 2: away has it, 3: both
        ("kicker", "i8", ROW_OR_NONE),  # row of a robot that kicked, or -1
        ("kicker_team", "i8", TEAM),
        ("nearest", "f8", SUM, (2,)),  # [m2] squared distance of a team's nearest robot from the ball
        ("nearest_counts", "i8", Range(0, 2), (2,)),  # 2: it is a field player and idle, 1: a field player, 0: neither
    ]
)

SHOT = ranged_record(
    [  # places are in the frame of the team that shoots: it attacks +x
        ("step", "i4", LATELY),  # step of the kick or push
        ("row", "i2", ROW),  # of the robot that kicked or pushed it
        ("team", "i1", TEAM),  # its team
        ("outcome", "i1", Range(0, max(Outcome))),  # an Outcome
        ("place", "f4", NUMBER, (2,)),  # [m] the ball as it was played
    ]
)

MAPS = ranged_record(
    [  # maps of play; each team's places are in the frame in which it attacks +x
        ("heat", "i4", COUNT, (3, CELLS_WIDE, CELLS_LONG)),  # entries for home, away, and the ball in home's frame
        ("places", "f8", SUM, (ROWS, 3)),  # [m s, m s, s] of each robot: sums of x dt, y dt and dt
        ("passes", "i2", COUNT, (ROWS, ROWS)),  # balls played by one row and touched by another, see `passes_tried`
        ("shots_kept", "i8", Range(0, SHOTS)),
        ("shots", SHOT, (SHOTS,)),
    ]
)

STATISTICS = ranged_record(
    [
        ("played", "f8", SUM),  # [s]
        ("in_play", "f8", SUM),  # [s]
        ("both", "f8", SUM),  # [s]
        ("still", "f8", SUM),  # [s]
        ("at_boards", "f8", SUM),  # [s]
        ("in_corner", "f8", SUM),  # [s]
        ("scrum", "f8", SUM),  # [s]
        ("separations", "i8", COUNT),
        ("drops", "i8", COUNT),
        ("carried", "f8", SUM),  # [m]
        ("possession", "f8", SUM, (2,)),  # [s]
        ("spells", "i8", COUNT, (2,)),
        ("spell_time", "f8", SUM, (2,)),  # [s]
        ("longest_spell", "f8", SUM, (2,)),  # [s]
        ("spell_lengths", "i4", COUNT, (2, BINS)),
        ("touches", "i8", COUNT, (2,)),
        ("kicks", "i8", COUNT, (2,)),
        ("shots", "i8", COUNT, (2,)),
        ("on_target", "i8", COUNT, (2,)),
        ("saves", "i8", COUNT, (2,)),
        ("passes_tried", "i8", COUNT, (2,)),
        ("passes", "i8", COUNT, (2,)),
        ("interceptions", "i8", COUNT, (2,)),
        ("annulled", "i8", COUNT, (2,)),
        ("out", "f8", SUM, (2,)),  # [s]
        ("keeper_away", "f8", SUM, (2,)),  # [s]
        ("keeper_in_goal", "f8", SUM, (2,)),  # [s]
        ("mates", "f8", SUM, (2,)),  # [s]
        ("idle", "f8", SUM, (2,)),  # [s]
        ("present", "f8", SUM, (2,)),  # [s]
        ("stuck", "f8", SUM, (2,)),  # [s]
        ("distance", "f8", SUM, (2,)),  # [m]
        ("goals", "i8", COUNT, (2, len(GoalKind))),
        ("after_separation", "i8", COUNT, (2,)),
        ("after_pushed_keeper", "i8", COUNT, (2,)),
        ("solo", "i8", COUNT, (2,)),
        ("after_restart", "i8", COUNT, (2, len(Phase))),
        ("restarts", "i8", COUNT, (2, len(Phase))),
        ("fouls", "i8", COUNT, (2, len(Foul))),
        ("trail", TRAIL),
        ("maps", MAPS),  # last, since a step touches few bytes of it
    ]
)
OFTEN = STATISTICS.itemsize - MAPS.itemsize  # [bytes] at the start of the record, which most steps touch

FRESH = np.zeros((), STATISTICS)  # of a new match
for _name in ("in_play", "separated", "crowded", "touched", "deflected", "keeper_pushed"):
    FRESH["trail"][_name] = LONG_AGO
for _name in ("held_last", "touched", "contact", "seen", "stuck_last"):
    FRESH["trail"]["players"][_name] = LONG_AGO
for _name in ("player", "flight", "kicker", "shot"):
    FRESH["trail"][_name] = -1
FRESH["trail"]["nearest"] = NOBODY
