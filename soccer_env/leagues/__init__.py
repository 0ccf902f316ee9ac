"""The leagues: every number of pitch, robots, rules and sensors, with unit and source.

legged_2001.py        the Sony legged league of 2001
legged_sensors.py     the sensors of legged robots, and their memory
middle_size_2006.py   the middle-size league of 2006
omni_sensors.py       the sensors of middle-size robots, and their memory
league.py             League, and a map of the pitch
rules.py              the rules: switches, numbers, and sets of rules
legged_rules.py       fouls of the legged league
middle_size_rules.py  fouls of the middle size
materials.py          elasticity and friction of each pair of things that collide
robot.py              the parts of a robot: body, drive, kicker, block, head
robot_kind.py         RobotKind, and the place where each kind is declared
constants.py          the numbers of a league as one record for kernels
options.py            settings that are checked, changed by name and turned into a record
pose_memory.py        the settings of a robot's estimate of its own pose
checks.py             checks of the numbers of a league
"""

from soccer_env.guards.checking import check_names
from soccer_env.guards.names import object_in_module
from soccer_env.leagues import legged_2001, middle_size_2006
from soccer_env.leagues.league import BallModel, League, Pitch, Slots, Substeps
from soccer_env.leagues.materials import Materials, Pair
from soccer_env.leagues.robot import Block, Body, Drive, Head, Kicker
from soccer_env.leagues.rules import Rules

LEAGUES: dict[str, League] = {
    league.name: league
    for league in (
        legged_2001.LEAGUE, middle_size_2006.LEAGUE, legged_2001.UPRIGHT, legged_2001.SMOOTH, legged_2001.BLOCK,
        middle_size_2006.OLD_BASE,
    )
}  # fmt: skip
RETIRED = {
    "legged-2001-legs": "legged-2001 has legs now, legged-2001-smooth the body without them",
    "legged-2001-inner": "the floor of legged-2001, inside its ramps, is 2.8 x 1.8 m now",
}


def find_league(league: str | League) -> League:
    """Return the league with a name or MODULE:NAME; a League passes through. ValueError lists the known names."""
    league = object_in_module("league", league, League) or league
    if isinstance(league, League):
        return league
    if isinstance(league, str) and league in RETIRED:
        raise ValueError(f"there is no league {league!r} any more: {RETIRED[league]}")
    check_names("league", [league], LEAGUES)
    return LEAGUES[league]


__all__ = [
    "LEAGUES", "BallModel", "Block", "Body", "Drive", "Head", "Kicker", "League", "Materials", "Pair", "Pitch", "Rules",
    "Slots", "Substeps", "find_league",
]  # fmt: skip
