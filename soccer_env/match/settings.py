"""The settings of a match, checked: every name resolved, every number in range."""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from math import ceil, inf, isfinite
from typing import TYPE_CHECKING, Any, get_args

import numpy as np

from soccer_env.actions import ActionKind
from soccer_env.guards.checking import check_choice, check_whole_number, raise_not_allowed
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.leagues.league import League
from soccer_env.leagues.robot import Faults
from soccer_env.leagues.rules import Rules, rule_set
from soccer_env.match.arguments import FREE, MatchSettings, Senses, select_fields
from soccer_env.match.variation import Variation, find_variation
from soccer_env.observations import layout
from soccer_env.observations.own import SideObservations, check_observe
from soccer_env.rewards import Rewards, find_rewards
from soccer_env.scenes import SUCCESS, Scene, find_scene
from soccer_env.types import MAX_TEAM

SENSES = get_args(Senses)
CLOCKS = ("time_left", "clock")  # entries that show the clock: of observations, and of the state; all of ours have one


@dataclass(frozen=True, kw_only=True)
class Settings(MatchSettings):
    """The settings of a Match with every name resolved; with seeds and actions they determine the whole match."""

    if TYPE_CHECKING:  # the types of resolved settings
        league: League
        home: int
        away: int
        max_players: int  # room for players a side in `state()`
        senses: tuple[str, str]  # of home, of away
        actions: ActionKind
        scene: Scene
        variation: Variation | None
        rewards: Rewards
    padded: bool  # True: both teams have max_players rows, and the spare rows are inactive

    @property
    def rows(self) -> tuple[int, int]:
        """Return the number of array rows for the robots of home and of away."""
        return (self.max_players, self.max_players) if self.padded else (self.home, self.away)

    @property
    def agents(self) -> list[str]:
        """Return the agent names of the robots in the order of rows, home first."""
        return [f"{side}_{i}" for side, size in zip(("home", "away"), self.rows, strict=True) for i in range(size)]

    @property
    def observes(self) -> tuple[Any, Any]:
        """Return the kind of observation of home and of away."""
        return (
            (self.observe.home, self.observe.away)
            if isinstance(self.observe, SideObservations)
            else (self.observe,) * 2
        )

    @property
    def half_length(self) -> float:
        """Return the length of a half [s]; inf if no clock ends the episode."""
        if self.minutes is not None:
            return 30.0 * self.minutes
        return 60.0 * self.league.rules.half_minutes if self.episode == "match" else inf

    @property
    def observes_clock(self) -> bool:
        """Tell whether every observation shows the clock, so that the final whistle is an end like others."""
        return all(
            isinstance(observe, str) or any(entry.name in CLOCKS for entry in layout(self.league, observe))
            for observe in self.observes
        )

    @property
    def limit(self) -> int:
        """Return the number of control steps after which an episode is truncated."""
        return np.iinfo(np.int64).max if self.max_cycles is None else self.max_cycles * self.action_repeat

    @property
    def episode_limit(self) -> int | None:
        """Return the longest possible episode, in steps of `action_repeat` control steps; None: no limit."""
        rate = self.league.control_rate
        limits = [float(self.limit)] if self.max_cycles is not None else []
        if self.episode == "drill":
            limits.append(ceil(self.scene.time_limit * rate) if isfinite(self.scene.time_limit) else inf)
        if isfinite(self.half_length) and not self.league.rules.shoot_out:
            limits.append(2.0 * ceil(self.half_length * rate))
        least = min(limits, default=inf)
        return ceil(least / self.action_repeat) if isfinite(least) else None

    def constants(self, league: League | None = None) -> np.ndarray:
        """Return the constants (1,) of the league, or of a variation of it, as a record for compiled code."""
        record = constants_of(self.league if league is None else league)
        record["placement_by_driving"] = self.placement == "drive"
        record["end_at_goal"] = self.episode == "goal"
        if self.episode == "drill" and isinstance(self.scene.success, str):  # `user_code` calls success functions
            record["drill"], record["drill_time"] = SUCCESS[self.scene.success], self.scene.time_limit
        return record

    def describe(self) -> dict[str, Any]:
        """Return the settings as plain values, for reports and files."""
        return {
            item.name: to_plain_types(getattr(self, item.name))
            for item in fields(self)
            if not item.metadata.get("part")
        }

    def fingerprint(self) -> str:
        """Return a hash of all settings that determine a match's future."""
        relevant = {name: value for name, value in self.describe().items() if name not in FREE} | {"limit": self.limit}
        if self.variation is None:
            relevant.pop("variation", None)  # as before there were variations
        if self.league.faults == Faults():
            relevant["league"].pop("faults")  # as before there were faults
        if self.actions.name == "skills":  # whose memory the future depends on
            relevant["actions"] = self.actions.name
        return hashlib.sha256(json.dumps(relevant, sort_keys=True).encode()).hexdigest()[:16]


def to_plain_types(value: Any) -> Any:
    """Convert a value to plain types that JSON can hold."""
    if is_dataclass(value) and not isinstance(value, type):
        return {name: to_plain_types(part) for name, part in vars(value).items()}
    if isinstance(value, Mapping):
        return {str(name): to_plain_types(part) for name, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [to_plain_types(part) for part in value]
    if value is None or isinstance(value, (bool, int, float, str)):
        return value if not (isinstance(value, float) and not isfinite(value)) else str(value)
    return f"{getattr(value, '__module__', '')}.{getattr(value, '__qualname__', type(value).__qualname__)}"


def check_senses(senses: Any) -> tuple[str, str]:
    """Return the checked senses of home and of away; a team that a mapping leaves out gets "sensors"."""
    if isinstance(senses, Mapping):
        if not set(senses) <= {"home", "away"}:
            raise ValueError(f"senses by team must have the keys home and away, got {sorted(map(str, senses))}")
        both = (senses.get("home", "sensors"), senses.get("away", "sensors"))
    elif isinstance(senses, tuple) and len(senses) == 2:
        both = senses
    else:
        both = (senses, senses)
    return check_choice("senses", both[0], SENSES), check_choice("senses", both[1], SENSES)


def check_options(name: str, value: Any, base: Any) -> Any:
    """Return sensor or memory settings: `base` with the changes of a mapping, or a given object of its class."""
    if value is None:
        return base
    if isinstance(value, Mapping):
        changed: Any = base.changed(value)
        return changed
    if isinstance(value, type(base)):
        return value
    raise_not_allowed(name, f"a mapping of names to values or a {type(base).__name__}", value)


def with_sensors(league: League, sensors: Any, memory: Any) -> League:
    """Return the league with these sensor and memory settings."""
    if sensors is None and memory is None:
        return league
    sensors = check_options("sensors", sensors, league.sensors)
    return replace(league, sensors=sensors, memory=check_options("memory", memory, league.memory))


def find_rules(league: League, rules: Any, scene: Scene, episode: str) -> League:
    """Return the league with the given rules; None: the rules of the drill, or the league's own rules."""
    if isinstance(rules, Rules):
        return replace(league, rules=rules)
    if rules is None:
        rules = scene.rules if episode == "drill" else "league"
    return replace(league, rules=rule_set(league.rules, rules)) if rules != "league" else league


def check_keeper(keeper: Any, home: int, away: int) -> int:
    """Return the goalkeeper's number, checked; ValueError if a team of two or more robots has no such number."""
    sizes = [size for size in (home, away) if size >= 2]
    return check_whole_number("keeper", keeper, 0, min(sizes, default=MAX_TEAM) - 1)


def make_settings(arguments: MatchSettings) -> Settings:
    """Return the settings with every name resolved; ValueError names the setting, the value and the allowed values."""
    scene = find_scene(arguments.scene)
    league = find_rules(find_league(arguments.league), arguments.rules, scene, arguments.episode)
    league = with_sensors(league, arguments.sensors, arguments.memory)
    home = league.team_size if arguments.home is None else arguments.home
    away = league.team_size if arguments.away is None else arguments.away
    largest = max(home, away)
    most = largest if arguments.max_players is None else arguments.max_players
    resolved: dict[str, Any] = {
        "league": league,
        "home": home,
        "away": away,
        "max_players": check_whole_number("max_players", most, largest, MAX_TEAM),
        "padded": arguments.max_players is not None,
        "observe": check_observe(arguments.observe),
        "senses": check_senses(arguments.senses),
        "actions": arguments.actions if isinstance(arguments.actions, ActionKind) else ActionKind(arguments.actions),
        "scene": scene,
        "variation": find_variation(arguments.variation, league),
        "rewards": find_rewards(arguments.rewards),
        "keeper": check_keeper(arguments.keeper, home, away),
    }
    scene.check(league, home, away)
    check_drill(arguments, scene)
    return Settings(**{**select_fields(arguments, MatchSettings), **resolved})


def check_drill(arguments: MatchSettings, scene: Scene) -> None:
    """Raise ValueError for a drill without a success test or with two time limits."""
    if arguments.episode == "drill" and scene.success == "none":
        raise ValueError(f"episode 'drill' needs a scene with a success test, and {scene.name!r} has none")
    if arguments.episode == "drill" and arguments.minutes is not None:
        raise ValueError(
            f"minutes must be None in a drill, whose scene has its own time limit, got {arguments.minutes!r}"
        )


__all__ = ["SENSES", "Settings", "make_settings"]
