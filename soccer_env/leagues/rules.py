"""The rules of a league: which are called (switches) and their numbers, and the sets `league`, `simple` and `none`.

    league   the whole rule book of the league
    simple   goals, restarts and dropped balls: nobody is whistled, nobody is pulled apart
    none     goals alone: the ball is never out, never stuck

A set is changed by name: "league:pushing=False,holding_time=5".
"""

from dataclasses import dataclass, field, fields, replace
from typing import Any

from soccer_env.guards.checking import ABOVE_ZERO, SHARE, Range, check_names, type_of
from soccer_env.leagues.checks import PYTHON_ONLY, Part

NEVER = 1e9  # [s]
MINUTES = Range(0.0, 1e12, above=True)  # [min] of a half, and of the match that `minutes` asks for


@dataclass(frozen=True)
class Rules(Part):
    """The rules of a league: what is called, and the numbers of it. A switch that is off costs nothing."""

    BOUNDS = {
        "half_minutes": MINUTES,
        **dict.fromkeys(("stuck_radius", "restart_time", "stuck_time", "contact_time"), ABOVE_ZERO),
        "handling_share": SHARE,
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

    # Fouls of the legged league: the robot is taken out and comes back at the halfway line
    removal_time: float = 30.0  # [s] that a robot is out
    pardon: bool = False  # a kick-off ends all penalties that run
    pushing: bool = False  # a robot walks into an opponent off the ball for `pushing_time`
    pushing_time: float = 3.0  # [s] in contact
    pushing_exempt: float = 0.5  # [m] the robot nearest to the ball may push for it within this distance
    keeper_pushing: bool = False  # the same into the goalkeeper in its own penalty area, even for the ball
    keeper_pushing_time: float = 1.0  # [s] in contact
    annulled_push: float = 0.5  # [s] of a push or hold that is not yet a foul, after which a goal by it does not count
    annulled_time: float = 3.0  # [s] after the whistle for which the attack cannot score
    holding: bool = False  # a robot keeps the ball from all others for `holding_time`
    holding_time: float = 3.0  # [s]
    keeper_holding_time: float = 5.0  # [s] in its own area
    carrying: bool = False  # a robot carries the ball for `carrying_distance`
    carrying_distance: float = 0.5  # [m] that a ball may be carried
    illegal_defender: bool = False  # a field player stays in its own penalty area for `illegal_defender_time`
    illegal_defender_time: float = 1.0  # [s] in its own penalty area
    illegal_attacker: bool = False  # a robot stays in the opponents' penalty area for `illegal_attacker_time`
    illegal_attacker_time: float = 10.0  # [s] in the opponents' penalty area while the ball is elsewhere
    leaving_field: bool = False  # a robot stands in a goal for `leaving_time`, but for a goalkeeper in its own
    leaving_time: float = 5.0  # [s] in a goal
    falling: bool = False  # a robot lies for `fallen_time`
    fallen_time: float = 5.0  # [s] on the ground
    kick_off_shot: bool = False  # a kick-off scores once its team touches it again, out of the centre circle
    local_stuck: bool = False  # play stays in one place for `local_stuck_time`
    local_stuck_time: float = 30.0  # [s]
    local_stuck_radius: float = 0.5  # [m] within which play does not move on
    global_stuck: bool = False  # nobody touches the ball for `global_stuck_time`
    global_stuck_time: float = 30.0  # [s] that nobody touches the ball

    # Fouls of the middle size: a free kick for the opponents
    second_touch: bool = False  # who took a restart touches the ball again before anybody else
    touch_break: float = 0.2  # [s] without contact after which the taker of a restart has left the ball
    taking_distance: float = 0.5  # [m] that the taker may push the ball from its spot in one touch
    distances: bool = False  # opponents keep off a restart until the ball is in play
    distance_time: float = 1.0  # [s] that an opponent may be too near
    distance_slack: float = 0.2  # [m] that an opponent may be too near for good
    charging: bool = False  # a robot drives into an opponent off the ball
    charging_time: float = 2.0  # [s] of driving into an opponent
    charging_speed: float = 0.3  # [m/s] at which a robot drives into another
    charging_hard: float = 2.0  # [m/s] at which a blow is a foul by itself
    charging_exempt: float = 0.6  # [m] the robot of a team nearest to the ball may fight for it within this distance
    keeper_charge: bool = False  # a robot drives into the goalkeeper in its goal area
    handling: bool = False  # a robot encloses the ball, or goes back with it
    handling_share: float = 1.0 / 3.0  # [1] of the ball's diameter that may lie within the hull of a robot
    handling_time: float = 0.5  # [s] for which more may, to stop it
    handling_back: float = 0.5  # [m] that a robot may go back with the ball
    dribble_limit: bool = False  # a robot dribbles for `dribble_distance`
    dribble_distance: float = 3.0  # [m]
    goal_area: bool = False  # a field player in its own goal area, an attacker in the opponents'
    penalty_area: bool = False  # a second field player in its own penalty area
    area_time: float = 10.0  # [s] that robots may be where they may not stay
    cards: bool = False  # fouls are counted for yellow and red cards
    card_fouls: float = 3.0  # [1] fouls for a yellow card
    timed_cards: bool = False  # two yellow cards: out for `card_time`, not for good
    card_time: float = 90.0  # [s]
    shoot_out: bool = False  # penalty kicks after a draw
    shoot_out_kicks: float = 5.0  # [1] of each team, before single pairs decide
    shoot_out_most: float = 10.0  # [1] of each team, after which it is a draw
    shoot_out_time: float = 10.0  # [s] until a kick is taken, and again until it is over
    penalty_mark: float = 2.0  # [m] from the goal line

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
