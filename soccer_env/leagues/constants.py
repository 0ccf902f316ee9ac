"""The numbers of a league as one flat record, for compiled kernels."""

from __future__ import annotations

import numpy as np

from soccer_env.leagues.league import League
from soccer_env.leagues.legged_sensors import LeggedSensors
from soccer_env.leagues.robot import DRIVE_KINDS

GROUPS = {  # what of each part of a league goes into the record, as part_field
    "pitch": "length width goal_width goal_depth penalty_depth penalty_width goal_area_depth goal_area_width circle "
    "band_side band_end post_radius",
    "ball": "radius mass rolling sliding shell top_speed",
    "body": "mass disc_radius disc_x tip_x tip_y tip_radius front reach height",
    "drive": "forward backward sideways turn acceleration turn_acceleration traction turn_traction slip fall fall_time "
    "leg_disturbance",
    "kicker": "slowest fastest least wind_up recharge spread reach half_width",
    "head": "pan_limit tilt_low tilt_high pan_speed tilt_speed camera_height camera_ahead",
    "rules": "kick_off_distance restart_distance restart_time in_play_distance placing_time stuck_time stuck_radius "
    "separation contact_time corner_offset goal_kick_x goal_kick_y drop_x drop_y",
    "substeps": "travel",
}
NUMBERS = [f"{part}_{name}" for part, names in GROUPS.items() for name in names.split()]
OUTLINE = 8  # corners of a hull that fit

CONSTANTS = np.dtype(
    [("dt", "f8")]
    + [(name, "f8") for name in NUMBERS]
    + [
        ("corner_x", "f8", (OUTLINE,)),  # [m] robot frame
        ("corner_y", "f8", (OUTLINE,)),  # [m] robot frame
        ("corners", "i8"),  # how many
        ("walled", "i8"),  # 1: boards on the lines
        ("ranger", "i8"),  # 1: robots have an infrared ranger
        ("drive_kind", "i8"),
        ("gait_steps", "i8"),
        ("slip_steps", "i8"),  # control steps for which a drawn slip holds
        ("delay_steps", "i8"),
        ("keeper_kicks", "i8"),
        ("substeps_least", "i8"),
        ("substeps_most", "i8"),
        ("teammate_slots", "i8"),
        ("opponent_slots", "i8"),
        ("drive_placement", "i8"),  # 1: robots drive to their places; 0: they are put there
        ("end_at_goal", "i8"),  # 1: the episode ends at the first goal
        ("drill", "i8"),  # how the drill of the scene is judged, 0 none; see scenes/judging.py
        ("drill_time", "f8"),  # [s] limit of the drill
    ]
)


def has_ranger(league: League) -> bool:
    """Tell whether the robots of a league have an infrared ranger."""
    return isinstance(league.sensors, LeggedSensors)


def constants_of(league: League) -> np.ndarray:
    """Return the (1,) record of a league's numbers, with instant placement and no drill."""
    record = np.zeros(1, CONSTANTS)
    record["dt"] = league.dt
    for part, names in GROUPS.items():
        for name in names.split():
            record[f"{part}_{name}"] = getattr(getattr(league, part), name)
    for index, (x, y) in enumerate(league.body.corners):
        record["corner_x"][0, index], record["corner_y"][0, index] = x, y
    record["corners"] = len(league.body.corners)
    record["walled"], record["ranger"] = league.pitch.walled, has_ranger(league)
    record["drive_kind"] = DRIVE_KINDS[league.drive.kind]
    record["gait_steps"] = league.drive.gait_steps
    record["slip_steps"] = max(1, round(league.drive.slip_time * league.control_rate))
    record["delay_steps"] = league.delay_steps
    record["keeper_kicks"] = league.kicker.keeper_kicks
    record["substeps_least"], record["substeps_most"] = league.substeps.least, league.substeps.most
    record["teammate_slots"], record["opponent_slots"] = league.slots.teammates, league.slots.opponents
    return record
