"""The rules of a league: switches and numbers, and the sets `league`, `simple` and `none`.

    league   the whole rule book of the league
    simple   goals, restarts and dropped balls: no whistles, no robots pulled apart
    none     goals alone: the ball is never out, never stuck

A set is changed by name: "league:pushing=False,holding_time=5".
"""

from dataclasses import dataclass, field, fields, replace
from typing import Any

from soccer_env.guards.checking import ABOVE_ZERO, Range, check_names, field_type_name
from soccer_env.leagues.checks import PYTHON_ONLY, LeaguePart
from soccer_env.leagues.legged_rules import LeggedFouls
from soccer_env.leagues.middle_size_rules import MiddleSizeFouls

NEVER = 1e9  # [s]
MINUTES = Range(0.0, 1e12, above=True)  # [min] of a half, and of a match with `minutes`


@dataclass(frozen=True)
class CommonRules(LeaguePart):
    """The rules of all leagues: goals, restarts, out of play and stuck balls."""

    BOUNDS = {
        "half_minutes": MINUTES,
        **dict.fromkeys(("stuck_radius", "restart_time", "stuck_time", "contact_time"), ABOVE_ZERO),
    }

    half_minutes: float = field(metadata=PYTHON_ONLY)  # [min] length of a half
    kick_off_distance: float  # [m] opponents' distance from the ball at a kick-off
    restart_distance: float  # [m] opponents' distance from the ball at the other restarts
    restart_time: float  # [s] after which the ball is in play without a taker
    in_play_distance: float  # [m] by which the ball must move to be in play
    placing_time: float  # [s] in which robots drive to their places
    stuck_time: float  # [s] for which the ball may stay near one point
    stuck_radius: float  # [m] that counts as near
    separation: float  # [m] distance of robots from a dropped ball, and of opponents after they are pulled apart
    corner_offset: float  # [m] of the ball from the corner, along both lines
    goal_kick_x: float  # [m] of the ball from the goal line at a goal kick
    goal_kick_y: float  # [m] of the ball from the middle at a goal kick
    drop_distance: float  # [m] least distance of a dropped ball from all boards
    contact_time: float = NEVER  # [s] in contact after which opponents are pulled apart

    # Restarts
    out_of_play: bool = True  # a ball beyond the lines of a pitch without boards
    dropped_ball: bool = True  # a ball that stays near one point for `stuck_time`

    # Goals straight from a restart. False: another robot than the taker must touch the ball first
    direct_kick_off: bool = True  # a goal straight from a kick-off counts
    direct_throw_in: bool = True  # a goal straight from a throw-in counts
    direct_goal_kick: bool = True  # a goal straight from a goal kick counts
    direct_corner_kick: bool = True  # a goal straight from a corner kick counts
    direct_free_kick: bool = True  # a goal straight from a free kick counts


@dataclass(frozen=True)
class Rules(MiddleSizeFouls, LeggedFouls, CommonRules):  # a dataclass takes the fields of its last base first
    """The rules of a league: switches and numbers. A switch that is off costs nothing."""

    name: str = field(default="league", metadata=PYTHON_ONLY)  # of the set, in reports


SWITCHES = tuple(item.name for item in fields(Rules) if field_type_name(item) == "bool")
RESTARTS = tuple(name for name in SWITCHES if name in ("out_of_play", "dropped_ball") or name.startswith("direct_"))
SETS = ("league", "simple", "none")


def simple_rules(rules: Rules) -> Rules:
    """Return a league's rules without fouls: goals, restarts and dropped balls."""
    switches = {name: name in RESTARTS for name in SWITCHES}
    return replace(rules, **switches, contact_time=NEVER, name="simple")


def rule_set(rules: Rules, text: str) -> Rules:
    """Return a league's rule set from a text, SET or SET:rule=value,...; ValueError lists the known names."""
    name, colon, changes = text.partition(":")
    check_names("rules", [name], SETS, more="SET:rule=value,... or a Rules object")
    simple = simple_rules(rules)
    goals_only = replace(simple, out_of_play=False, dropped_ball=False, name="none")  # each followed by a kick-off
    chosen = {"league": rules, "simple": simple, "none": goals_only}[name]
    if not colon:
        return chosen
    changed = dict(parse_rule(text, part) for part in changes.split(","))
    check_names("rule", changed, [item.name for item in fields(Rules) if item.name != "name"])
    return replace(chosen, **changed, name=text)


def parse_rule(text: str, part: str) -> tuple[str, Any]:
    """Split rule=value; the words True and False become bools, numbers become floats."""
    name, equals, value = part.partition("=")
    if not (name.isidentifier() and equals and value):
        raise ValueError(f"rules {text!r} must be written as SET:rule=value,rule=value, got {part!r}")
    if value in ("True", "False"):
        return name, value == "True"
    try:
        return name, float(value)
    except ValueError:
        return name, value
