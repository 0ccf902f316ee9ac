"""The rules of a league: which are called (switches) and their numbers, and the sets `league`, `simple` and `none`.

    league   the whole rule book of the league
    simple   goals, restarts and dropped balls: nobody is whistled, nobody is pulled apart
    none     goals alone: the ball is never out, never stuck

A set is changed by name: "league:pushing=False,holding_time=5".
"""

from dataclasses import dataclass, field, fields, replace
from typing import Any

from soccer_env.guards.checking import ABOVE_ZERO, Range, check_names, type_of
from soccer_env.leagues.checks import PYTHON_ONLY, Part
from soccer_env.leagues.legged_rules import LeggedFouls
from soccer_env.leagues.middle_size_rules import MiddleSizeFouls

NEVER = 1e9  # [s]
MINUTES = Range(0.0, 1e12, above=True)  # [min] of a half, and of the match that `minutes` asks for


@dataclass(frozen=True)
class CommonRules(Part):
    """What all leagues call: goals, restarts and what keeps play going."""

    BOUNDS = {
        "half_minutes": MINUTES,
        **dict.fromkeys(("stuck_radius", "restart_time", "stuck_time", "contact_time"), ABOVE_ZERO),
    }

    half_minutes: float = field(metadata=PYTHON_ONLY)  # [min] length of a half
    kick_off_distance: float  # [m] opponents' distance from the ball at a kick-off
    restart_distance: float  # [m] opponents' distance from the ball at the other restarts
    restart_time: float  # [s] after which the ball is in play although nobody took the restart
    in_play_distance: float  # [m] that the ball must move to be in play
    placing_time: float  # [s] that robots have to drive to their places
    stuck_time: float  # [s] that the ball may stay near one point
    stuck_radius: float  # [m] that counts as near
    separation: float  # [m] to which robots are pulled away from a dropped ball, and opponents from each other
    corner_offset: float  # [m] of the ball from the corner, along both lines
    goal_kick_x: float  # [m] of the ball from the goal line at a goal kick
    goal_kick_y: float  # [m] of the ball from the middle at a goal kick
    drop_way: float  # [m] that a dropped ball is taken out from boards, at most
    contact_time: float = NEVER  # [s] in contact after which opponents are pulled apart

    # What keeps play going
    out_of_play: bool = True  # a ball beyond the lines of a pitch without boards
    dropped_ball: bool = True  # a ball that stays near one point for `stuck_time`

    # What a goal may follow from: False, and it has to be touched by somebody but the taker first
    direct_kick_off: bool = True  # a goal straight from a kick-off counts
    direct_throw_in: bool = True  # the same of a throw-in
    direct_goal_kick: bool = True  # the same of a goal kick
    direct_corner_kick: bool = True  # the same of a corner kick
    direct_free_kick: bool = True  # the same of a free kick


@dataclass(frozen=True)
class Rules(MiddleSizeFouls, LeggedFouls, CommonRules):  # a dataclass takes the fields of its last base first
    """The rules of a league: what is called, and the numbers of it. A switch that is off costs nothing."""

    name: str = field(default="league", metadata=PYTHON_ONLY)  # what reports call this set


SWITCHES = tuple(item.name for item in fields(Rules) if type_of(item) == "bool")
RESTARTS = tuple(name for name in SWITCHES if name in ("out_of_play", "dropped_ball") or name.startswith("direct_"))
SETS = ("league", "simple", "none")


def simple_of(rules: Rules) -> Rules:
    """Return a league's rules without fouls: goals, restarts and dropped balls."""
    switches = {name: name in RESTARTS for name in SWITCHES}
    return replace(rules, **switches, contact_time=NEVER, name="simple")


def none_of(rules: Rules) -> Rules:
    """Return a league's rules with goals alone, each followed by a kick-off."""
    return replace(simple_of(rules), out_of_play=False, dropped_ball=False, name="none")


def rule_set(rules: Rules, text: str) -> Rules:
    """Return a rule set of a league by name, changed by name: SET or SET:switch=value,...

    ValueError for an unknown set or rule says what exists.
    """
    name, colon, changes = text.partition(":")
    check_names("rules", [name], SETS, more="SET:rule=value,... or a Rules object")
    found = {"league": rules, "simple": simple_of(rules), "none": none_of(rules)}[name]
    if not colon:
        return found
    changed = dict(parse_rule(text, part) for part in changes.split(","))
    check_names("rule", changed, [item.name for item in fields(Rules) if item.name != "name"])
    return replace(found, **changed, name=text)


def parse_rule(text: str, part: str) -> tuple[str, Any]:
    """Split rule=value of a set's text; True, False and numbers become Python's own."""
    name, equals, value = part.partition("=")
    if not (name.isidentifier() and equals and value):
        raise ValueError(f"rules {text!r} must be written as SET:rule=value,rule=value, got {part!r}")
    if value in ("True", "False"):
        return name, value == "True"
    try:
        return name, float(value)
    except ValueError:
        return name, value
