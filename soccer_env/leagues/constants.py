"""The numbers of a league as one flat record, which compiled kernels call `k`.

A number of a league's part is in the record as part_field: k.ball_radius is league.ball.radius. The record holds all
float fields of the parts, except those declared with `field(metadata=PYTHON_ONLY)`.
"""

from collections.abc import Callable
from dataclasses import fields, is_dataclass
from functools import partial
from typing import get_type_hints

import numpy as np

from soccer_env.guards.checking import field_type_name
from soccer_env.leagues.checks import PYTHON_ONLY
from soccer_env.leagues.league import League
from soccer_env.leagues.robot import DRIVE_KINDS, MOST_CORNERS
from soccer_env.leagues.rules import SWITCHES


def has_ranger(league: League) -> bool:
    """Tell whether the robots of a league have an infrared ranger."""
    return bool(getattr(league.sensors, "HAS_RANGER", False))


def rule_value(league: League, name: str) -> int:
    """Return the rule `name` of a league as a whole number; for a switch 1 (on) or 0 (off)."""
    return int(getattr(league.rules, name))


NUMBERS = {
    f"{part}_{field.name}": (part, field.name)
    for part, kind in get_type_hints(League).items()
    if is_dataclass(kind)
    for field in fields(kind)
    if field_type_name(field) == "float" and field.metadata != PYTHON_ONLY
}
WHOLE_NUMBERS: dict[str, Callable[[League], int]] = {
    "corners": lambda league: len(league.body.corners),  # corners of the hull
    "legs": lambda league: league.body.legs,  # 1: posts swing with the gait
    "walled": lambda league: league.pitch.walled,  # 1: boards on the lines
    "ranger": has_ranger,  # 1: robots have an infrared ranger
    "drive_kind": lambda league: DRIVE_KINDS[league.drive.kind],
    "gait_steps": lambda league: league.drive.gait_steps,
    "slip_steps": lambda league: max(1, round(league.drive.slip_time * league.control_rate)),  # of one drawn slip
    "delay_steps": lambda league: league.delay_steps,
    "keeper_kicks": lambda league: league.kicker.keeper_kicks,
    "substeps_least": lambda league: league.substeps.least,
    "substeps_close": lambda league: league.substeps.close,
    "substeps_most": lambda league: league.substeps.most,
    "teammate_slots": lambda league: league.slots.teammates,
    "opponent_slots": lambda league: league.slots.opponents,
    **{f"rules_{name}": partial(rule_value, name=name) for name in SWITCHES},  # 1: the rule is called
}
OF_THE_MATCH = [  # settings of a match, filled in by `Settings.constants`
    ("placement_by_driving", "i8"),  # 1: robots drive to their places at a restart; 0: the referee puts them there
    ("end_at_goal", "i8"),  # 1: the episode ends at the first goal
    ("drill", "i8"),  # the success test of the drill, 0: no drill; see scenes/judging.py
    ("drill_time", "f8"),  # [s] limit of the drill
]
CONSTANTS = np.dtype(
    [("dt", "f8")]  # [s] a control step
    + [(name, "f8") for name in NUMBERS]
    + [(name, "f8", (MOST_CORNERS,)) for name in ("corner_x", "corner_y")]  # [m] robot frame
    + [(name, "i8") for name in WHOLE_NUMBERS]
    + OF_THE_MATCH
)


def constants_of(league: League) -> np.ndarray:
    """Return the (1,) record of a league's numbers, set to instant placement at restarts and to no drill."""
    record = np.zeros(1, CONSTANTS)
    record["dt"] = league.dt
    for name, (part, field) in NUMBERS.items():
        record[name] = getattr(getattr(league, part), field)
    for index, (x, y) in enumerate(league.body.corners):
        record["corner_x"][0, index], record["corner_y"][0, index] = x, y
    for name, of in WHOLE_NUMBERS.items():
        record[name] = of(league)
    return record
