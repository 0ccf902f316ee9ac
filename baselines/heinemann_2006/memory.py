"""The memory of a player of heinemann-2006 between two decisions, and the scratch arrays of a decision."""

import numpy as np

from soccer_env.baselines.weigel_2001.planner.records import MOST_OBSTACLES, OBSTACLE, PLAN, POINT
from soccer_env.baselines.weigel_2001.planner.records import SCRATCH as PLANNING
from soccer_env.baselines.weigel_2001.planner.settings import PlannerSettings
from soccer_env.guards.ranges import COUNT, FLAG, NUMBER, UNIT, Range, ranged_record
from soccer_env.records.beliefs import SITUATION
from soccer_env.skills.settings import MEMORY as SKILL_MEMORY
from soccer_env.skills.sight import SIGHT
from soccer_env.types import PHASE

KEEPER, ATTACKER, DEFENDER, SUPPORTER = range(4)
ROLES = ("goalkeeper", "attacker", "defender", "supporter")

CALL = ranged_record(
    [  # what the referee box says by radio
        ("phase", "i8", PHASE),  # Phase
        ("placing", "i8", FLAG),  # 1 while robots are driven to their places
        ("ours", "f8", UNIT),  # +1 our restart, -1 theirs, 0 neither
        ("clock", "f8", NUMBER),  # [s] since the phase began
    ]
)

MEMORY = ranged_record(
    [
        ("begun", "i8", FLAG),  # 0 before the first decision
        ("role", "i8", Range(0, len(ROLES) - 1)),  # ROLES
        ("role_age", "f8", NUMBER),  # [s] for which another role has been right
        ("listens", "i8", FLAG),  # 0 before the first word
        ("heard", CALL),  # the call that has come
        ("said", CALL),  # the latest one, which is on its way or has come
        ("said_age", "f8", NUMBER),  # [s] since it was made
        ("drove", "i8", COUNT),  # decisions for which the velocity below is known; 0: it is not
        ("drive_x", "f8", NUMBER),  # [m/s] velocity asked for, team frame
        ("drive_y", "f8", NUMBER),  # [m/s]
        ("arrived", "i8", FLAG),  # 1: it is at the place that it last wanted to be at
        ("stood", "f8", NUMBER),  # [s] for which it has stood though it is not
        ("stands_x", "f8", NUMBER),  # [m] team frame: where
        ("stands_y", "f8", NUMBER),  # [m]
        ("detour", "f8", NUMBER),  # [s] left of going round the ball
        ("detour_side", "f8", UNIT),  # +1 counter-clockwise, -1 clockwise, 0 not chosen yet
        ("skill", SKILL_MEMORY),  # what the skills that are shared with the chaser remember; rank 0 the attacker
    ]
)

SCRATCH = np.dtype(
    [
        ("sight", SIGHT),
        ("told", SITUATION),  # the match as the referee box has told it
        ("count", "i8"),  # obstacles
        ("crowd", OBSTACLE, (MOST_OBSTACLES,)),
        ("ways", PlannerSettings().record().dtype, (1,)),  # the planner's settings in this league
        ("work", PLANNING, (1,)),
        ("plan", PLAN, (1,)),
        ("place", POINT, (1,)),
    ]
)
