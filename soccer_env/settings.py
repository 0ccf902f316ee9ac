"""The settings of a match, checked: every name resolved, every number in range."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, is_dataclass, replace
from inspect import signature
from math import inf, isfinite
from typing import Any

import numpy as np

from soccer_env.actions import ActionKind
from soccer_env.known_names import unknown
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.leagues.league import NEVER, PLACEMENTS, League, Rules
from soccer_env.observations import OBSERVE
from soccer_env.rewards import Rewards, find_rewards
from soccer_env.scenes import SUCCESS, Scene, find_scene
from soccer_env.types import MAX_TEAM

EPISODES = ("match", "goal", "drill")
AUTORESETS = ("next_step", "same_step", "off")
FREE = (
    "observe",
    "autoreset",
    "actions",
    "rewards",
    "action_repeat",
    "max_cycles",
)  # settings on which the future of a match does not depend
SENSES = ("ideal", "sensors")
POSES = ("percept", "particles")


@dataclass(frozen=True)
class Settings:
    """What a Match follows from, beside its seeds and actions."""

    league: League
    home: int
    away: int
    max_players: int  # room for players a side in `state()`
    padded: bool  # True: both teams have max_players rows, those too many inactive
    observe: Any
    senses: tuple[str, str]  # of home, of away
    pose: str  # how a robot that uses its sensors knows where it is
    actions: ActionKind
    scene: Scene
    episode: str
    rewards: Rewards
    placement: str
    keeper: int
    minutes: float | None
    action_repeat: int
    max_cycles: int | None
    autoreset: str

    @property
    def rows(self) -> tuple[int, int]:
        """Return how many rows the robots of home and of away take."""
        return (self.max_players, self.max_players) if self.padded else (self.home, self.away)

    @property
    def agents(self) -> list[str]:
        """Return the names of the robots, a row each, home first."""
        return [f"{side}_{i}" for side, size in zip(("home", "away"), self.rows, strict=True) for i in range(size)]

    @property
    def half_length(self) -> float:
        """Return the length of a half [s]; inf where no clock ends the episode."""
        if self.minutes is not None:
            return 30.0 * self.minutes
        return 60.0 * self.league.rules.half_minutes if self.episode == "match" else inf

    @property
    def limit(self) -> int:
        """Return the control steps after which an episode is truncated."""
        return np.iinfo(np.int64).max if self.max_cycles is None else self.max_cycles * self.action_repeat

    def constants(self) -> np.ndarray:
        """Return the (1,) record of numbers for compiled code."""
        record = constants_of(self.league)
        record["placement_by_driving"] = self.placement == "drive"
        record["end_at_goal"] = self.episode == "goal"
        if self.episode == "drill":
            record["drill"], record["drill_time"] = SUCCESS[self.scene.success], self.scene.time_limit
            if self.scene.patient:
                record["rules_stuck_time"] = record["rules_contact_time"] = NEVER
        return record

    def describe(self) -> dict[str, Any]:
        """Return the settings as plain values, for reports and files."""
        return {name: plain(getattr(self, name)) for name in self.__dataclass_fields__}

    def fingerprint(self) -> str:
        """Return a hash of everything that a match's future depends on."""
        relevant = {name: value for name, value in self.describe().items() if name not in FREE} | {"limit": self.limit}
        return hashlib.sha256(json.dumps(relevant, sort_keys=True).encode()).hexdigest()[:16]


def plain(value: Any) -> Any:
    """Return a value as something that JSON can hold."""
    if is_dataclass(value) and not isinstance(value, type):
        return {name: plain(part) for name, part in vars(value).items()}
    if isinstance(value, Mapping):
        return {str(name): plain(part) for name, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(part) for part in value]
    if value is None or isinstance(value, (bool, int, float, str)):
        return value if not (isinstance(value, float) and not isfinite(value)) else str(value)
    return f"{getattr(value, '__module__', '')}.{getattr(value, '__qualname__', type(value).__qualname__)}"


def whole_number(name: str, value: Any, low: int, high: int) -> int:
    """Return a whole number in a range; ValueError names it and the range."""
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not low <= value <= high:
        raise ValueError(f"{name} must be {low} to {high}, got {value!r}")
    return int(value)


def one_of(name: str, value: Any, choices: tuple[str, ...]) -> str:
    """Return one of the choices; ValueError names them."""
    if not isinstance(value, str) or value not in choices:
        raise ValueError(f"{name} must be one of {', '.join(choices)}, got {value!r}")
    return value


def check_senses(senses: Any) -> tuple[str, str]:
    """Return how the beliefs of home and of away are filled; in a mapping by team, what is left out is "sensors"."""
    if isinstance(senses, Mapping):
        if not set(senses) <= {"home", "away"}:
            raise ValueError(f"senses by team must have the keys home and away, got {sorted(map(str, senses))}")
        both = (senses.get("home", "sensors"), senses.get("away", "sensors"))
    elif isinstance(senses, tuple) and len(senses) == 2:
        both = senses
    else:
        both = (senses, senses)
    return one_of("senses", both[0], SENSES), one_of("senses", both[1], SENSES)


def check_options(name: str, value: Any, base: Any) -> Any:
    """Return sensor or memory settings: the league's own, changed by a mapping of names, or an object of that kind."""
    if value is None:
        return base
    if isinstance(value, Mapping):
        changed: Any = base.changed(value)
        return changed
    if isinstance(value, type(base)):
        return value
    raise ValueError(f"{name} must be a mapping of names to values or a {type(base).__name__}, got {value!r}")


def with_sensors(league: League, sensors: Any, memory: Any) -> League:
    """Return the league with the sensors and the memory asked for."""
    if sensors is None and memory is None:
        return league
    return replace(
        league,
        sensors=check_options("sensors", sensors, league.sensors),
        memory=check_options("memory", memory, league.memory),
    )


def find_rules(league: League, rules: Any) -> League:
    """Return the league with the rule set asked for."""
    if isinstance(rules, Rules):
        return replace(league, rules=rules)
    if rules != "league":
        raise ValueError(f"unknown rules {rules!r}; known: league, or a Rules object")
    return league


def check_observe(observe: Any) -> Any:
    """Return what observations are built from: a name, or an object with `names` or `entries` to call with a match."""
    if callable(observe) and (hasattr(observe, "names") or hasattr(observe, "entries")):
        return observe
    if not isinstance(observe, str):
        raise ValueError(
            f"observe must be a name or an object with `names` or `entries` to call with a match, got {observe!r}"
        )
    return one_of("observe", observe, OBSERVE)


def check_minutes(minutes: float | None) -> float | None:
    """Return the minutes of play, or None for the episode's own."""
    if minutes is None:
        return None
    if isinstance(minutes, bool) or not isinstance(minutes, (int, float)) or not (isfinite(minutes) and minutes > 0):
        raise ValueError(f"minutes must be above zero, got {minutes!r}")
    return float(minutes)


def check_known(settings: Mapping[str, Any]) -> None:
    """Raise TypeError for a setting that does not exist, and say which do."""
    known = [name for name in signature(make_settings).parameters if name != "league"]
    for name in settings:
        if name not in known:
            raise TypeError(unknown("setting", name, known))


def check_keeper(keeper: Any, home: int, away: int) -> int:
    """Return the goalkeeper's number; a team of one has none, every other team must have that number."""
    sizes = [size for size in (home, away) if size >= 2]
    return whole_number("keeper", keeper, 0, min(sizes, default=MAX_TEAM) - 1)


def make_settings(
    league: str | League,
    *,
    home: int | None,
    away: int | None,
    max_players: int | None = None,
    observe: Any = "truth",
    senses: Any = "sensors",
    pose: str = "percept",
    sensors: Any = None,
    memory: Any = None,
    actions: str = "box",
    scene: str | Scene = "kick-off",
    episode: str = "match",
    rules: Any = "league",
    rewards: str | Rewards = "default",
    placement: str = "instant",
    keeper: int = 0,
    minutes: float | None = None,
    action_repeat: int = 1,
    max_cycles: int | None = None,
    autoreset: str = "off",
) -> Settings:
    """Check every setting and return them; ValueError names the setting, the value and what is allowed."""
    found = with_sensors(find_rules(find_league(league), rules), sensors, memory)
    home = whole_number("home", found.team_size if home is None else home, 1, MAX_TEAM)
    away = whole_number("away", found.team_size if away is None else away, 1, MAX_TEAM)
    largest = max(home, away)
    if max_cycles is not None:
        max_cycles = whole_number("max_cycles", max_cycles, 1, 2**40)
    found_scene = find_scene(scene)
    found_scene.check(found, home, away)
    one_of("episode", episode, EPISODES)
    if episode == "drill" and found_scene.success == "none":
        raise ValueError(f"episode 'drill' needs a scene with a success test, and {found_scene.name!r} has none")
    if episode == "drill" and minutes is not None:
        raise ValueError(f"minutes must be None in a drill, whose scene has its own time limit, got {minutes!r}")
    return Settings(
        league=found,
        home=home,
        away=away,
        max_players=whole_number("max_players", largest if max_players is None else max_players, largest, MAX_TEAM),
        padded=max_players is not None,
        observe=check_observe(observe),
        senses=check_senses(senses),
        pose=one_of("pose", pose, POSES),
        actions=ActionKind(actions),
        scene=found_scene,
        episode=episode,
        rewards=find_rewards(rewards),
        placement=one_of("placement", placement, PLACEMENTS),
        keeper=check_keeper(keeper, home, away),
        minutes=check_minutes(minutes),
        action_repeat=whole_number("action_repeat", action_repeat, 1, 1000),
        max_cycles=max_cycles,
        autoreset=one_of("autoreset", autoreset, AUTORESETS),
    )


__all__ = ["AUTORESETS", "EPISODES", "SENSES", "Settings", "make_settings"]
