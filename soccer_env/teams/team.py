"""What a team is, and the registry of named teams.

A team decides from beliefs alone. It is a protocol: anything with `name`, `memory_dtype` and `act` plays. The shipped
teams also offer a compiled `kernel`, which a match runs without Python between its steps (`team_kernels.py`).

A package of one's own ships teams by name with the entry point group `soccer_env.teams`; in its pyproject.toml:

    [project.entry-points."soccer_env.teams"]
    lions = "my_package.lions:team"

What an entry point names is a factory, not a team: it takes `strength` (0 to 1, what follows the @ of lions@0.5) and,
by name, whatever settings the team has (lions:brave=True), and returns the team.

    def team(strength: float = 1.0, brave: bool = False) -> Team: ...
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from importlib import import_module
from importlib.metadata import entry_points
from inspect import signature
from pathlib import Path
from typing import Any, Protocol, runtime_checkable

import numpy as np

from soccer_env.leagues.constants import constants_of
from soccer_env.leagues.league import League
from soccer_env.leagues.options import Options
from soccer_env.names import Made, by_names, unknown
from soccer_env.random_numbers import mix
from soccer_env.types import RobotStream

NAMES = {  # strings only: resolved at first use
    "still": "soccer_env.baselines.still:team",
    "random": "soccer_env.baselines.random:team",
    "walker": "soccer_env.baselines.walker:team",
    "chaser": "soccer_env.baselines.chaser:team",
    "sacks-2001": "soccer_env.baselines.sacks_2001:team",
    "sacks-2001-tuned": "soccer_env.baselines.sacks_2001:tuned",
    "sacks-2001-future": "soccer_env.baselines.sacks_2001:future",
    "heinemann-2006": "soccer_env.baselines.heinemann_2006:team",
    "weigel-2001": "soccer_env.baselines.heinemann_2006:weigel",
    "learned": "soccer_env.agents.learned:team",
}
FILES = {  # by the ending of a file that is named as a team
    ".safetensors": "soccer_env.agents.learned:from_file",
    ".zip": "soccer_env.agents.learned:from_zip",
}
ENTRY_POINTS = "soccer_env.teams"
TEAM_STREAM = int(RobotStream.TEAM)


@dataclass(frozen=True)
class View:
    """What the P players of a team may know, in M matches: beliefs (M, P), tracks (M, P, slots), see `types`."""

    league: League
    beliefs: np.ndarray
    tracks: np.ndarray

    @property
    def ball(self) -> np.ndarray:
        """Return each player's belief about the ball (M, P), robot frame."""
        return self.beliefs["ball"]

    @property
    def own(self) -> np.ndarray:
        """Return each player's belief about its own pose (M, P), team frame: own goal at -x."""
        return self.beliefs["own"]

    @property
    def situation(self) -> np.ndarray:
        """Return what each player may know of the match (M, P): phase, score, time, numbers."""
        return self.beliefs["situation"]

    def stand(self) -> np.ndarray:
        """Return commands (M, P, 7) that let every player stand: forward, left, turn, kick, head, pan, tilt."""
        commands = np.zeros((*self.beliefs.shape, 7))
        commands[..., 4] = -1.0  # the head tracks the ball by itself
        return commands


class TeamRandom:
    """Random numbers of a team's players, out of streams that the match owns, saves and hashes."""

    def __init__(self, states: np.ndarray, players: np.ndarray) -> None:
        self._states, self._players = states, players

    def uniform(self, low: float = 0.0, high: float = 1.0) -> np.ndarray:
        """Draw one number from [low, high) for each player (M, P)."""
        from soccer_env.random_numbers import GOLDEN, TO_UNIT

        states = self._states[:, self._players, TEAM_STREAM] + GOLDEN
        self._states[:, self._players, TEAM_STREAM] = states
        return low + (high - low) * ((mix_array(states) >> np.uint64(11)).astype(np.float64) * TO_UNIT)


def mix_array(states: np.ndarray) -> np.ndarray:
    """Return `random_numbers.mix` of each of an array of states."""
    python = getattr(mix, "py_func", mix)
    with np.errstate(over="ignore"):
        mixed: np.ndarray = python(states)
    return mixed


@runtime_checkable
class Team(Protocol):
    """A team. `act` sees the view of its own players and returns commands (M, P, 4) or (M, P, 7) in [-1, 1]."""

    @property
    def name(self) -> str:
        """Return what the team is called."""
        ...

    @property
    def memory_dtype(self) -> np.dtype:
        """Return the record of what a player must remember; saved and hashed with the match."""
        ...

    def act(self, view: View, memory: np.ndarray, rng: TeamRandom) -> np.ndarray:
        """Return the commands of all players; memory (M, P) of `memory_dtype` is the team's to change."""
        ...


@dataclass(frozen=True)
class CompiledTeam:
    """A shipped team: a kernel that decides for all its players in a slice of matches.

    kernel(beliefs, tracks, memory, noise, commands, players, constants, settings, first, last), all arrays of the
    whole match; `settings` is the team's own (1,) record.
    """

    name: str
    kernel: Callable[..., None]
    memory_dtype: np.dtype
    settings: np.ndarray
    families: tuple[str, ...] = ()  # of leagues that it plays (`League.family`); empty: all
    options: Options | None = None  # the team's settings by name, for lists
    blind: bool = False  # True: it reads no belief, so that nothing has to be sensed for it

    def __reduce__(self) -> Made:
        """Copy with the kernel that stands in the team's module."""
        return by_names(self, {item.name: getattr(self, item.name) for item in fields(self)})

    def check_league(self, league: League) -> None:
        """Raise ValueError if the team does not play this league."""
        league.must_be_of(self.families, f"team {self.name!r}")

    def act(self, view: View, memory: np.ndarray, rng: TeamRandom) -> np.ndarray:
        """Return the commands (M, P, 7) of all players, as the match would have the kernel make them."""
        from soccer_env.types import COMMAND

        players = np.arange(view.beliefs.shape[1])
        commands = np.zeros(view.beliefs.shape, COMMAND)
        noise = np.ascontiguousarray(rng._states[:, rng._players])
        self.kernel(
            view.beliefs,
            view.tracks,
            memory,
            noise,
            commands,
            players,
            constants_of(view.league),
            self.settings,
            0,
            len(commands),
        )
        rng._states[:, rng._players] = noise
        return np.stack([commands[name] for name in COMMAND.names or ()], axis=-1)


@dataclass(frozen=True)
class ObservingTeam(CompiledTeam):
    """A compiled team that decides from the observations that learners get, as learned policies do.

    kernel(observations, memory, commands, players, constants, settings, first, last): observations (M, R, n) float32
    are written for its players, by the code that writes those of a learner, while the field "wait" of its memory, the
    control steps until its next decision, is 0 for one of them.
    """

    observe: str = "belief"  # built from "truth" (with ideal senses only), "percepts" (with sensors only) or "belief"

    def act(self, view: View, memory: np.ndarray, rng: TeamRandom) -> np.ndarray:
        """Raise ValueError: this team needs what a body feels, which no view holds: it plays only inside a match."""
        raise ValueError(
            f"team {self.name!r} plays inside a match only: give it as controllers, opponents or teammates"
        )


def registered() -> dict[str, str]:
    """Return the names of all known teams and where they are made, those of installed packages included."""
    found = {point.name: point.value for point in entry_points(group=ENTRY_POINTS)}
    return {**found, **NAMES}


def parse_team(text: str) -> tuple[str, float, dict[str, Any]]:
    """Split NAME, NAME@STRENGTH or NAME@STRENGTH:switch=value,... into name, strength and settings.

    ValueError for a strength outside 0 to 1 and for settings that are not written so.
    """
    if Path(text).is_file():
        return text, 1.0, {}
    spec, colon, switches = text.partition(":")
    name, _, strength = spec.partition("@")
    try:
        number = float(strength) if "@" in spec else 1.0
    except ValueError:
        number = -1.0
    if not 0.0 <= number <= 1.0:
        raise ValueError(f"strength of team {text!r} must be a number from 0 to 1, got {strength!r}")
    return name, number, dict(parse_switch(text, part) for part in switches.split(",")) if colon else {}


def parse_switch(text: str, part: str) -> tuple[str, Any]:
    """Split switch=value of a team's text; True, False and numbers become Python's own."""
    name, equals, value = part.partition("=")
    if not (name.isidentifier() and equals and value):
        raise ValueError(f"settings of team {text!r} must be written as name=value,name=value, got {part!r}")
    if value in ("True", "False"):
        return name, value == "True"
    for kind in (int, float):
        try:
            return name, kind(value)
        except ValueError:
            continue
    return name, value


def make_team(team: str | Team, strength: float | None = None, **settings: Any) -> Team:
    """Return the team of a name (NAME, NAME@STRENGTH, NAME@STRENGTH:switch=value,...), or the team itself.

    A name may be the path of a policy file, or of a zip of stable-baselines3 (FILE.zip:observe=belief,action_repeat=8).
    ValueError says which names and settings exist.
    """
    if not isinstance(team, str):
        if isinstance(team, type):
            raise ValueError(f"a team is an object: give {team.__name__}(), not the class")
        if not (callable(getattr(team, "act", None)) and hasattr(team, "memory_dtype")):
            raise ValueError(f"a team needs name, memory_dtype and act, got {team!r}")
        return team
    name, from_name, changes = parse_team(team)
    strength = changes.pop("strength", strength)  # NAME:strength=0.5 is NAME@0.5
    if strength is not None:
        from_name = parse_team(f"{name}@{strength}")[1]
    ending, known = Path(name).suffix, registered()
    if ending in FILES and name not in known:
        if from_name != 1.0:
            raise ValueError(f"a policy has no strength, got {from_name:g} for {name!r}")
        return team_of_file(name, FILES[ending], {**changes, **settings})
    if name not in known:
        raise ValueError(unknown("team", name, known, more=f"a policy file ({', '.join(FILES)})"))
    factory = found(known[name])
    changes = {**changes, **settings}
    check_factory(name, known[name], factory)
    check_accepted(name, factory, changes)
    made: Team = factory(strength=from_name, **changes)
    return make_team(made)


def team_of_file(path: str, where: str, settings: dict[str, Any]) -> Team:
    """Return the team of a policy file; ValueError says what is wrong with it."""
    factory = found(where)
    check_accepted(path, factory, settings)
    made: Team = factory(path, **settings)
    return made


def found(where: str) -> Callable[..., Any]:
    """Return what MODULE:NAME names."""
    module, _, attribute = where.partition(":")
    factory: Callable[..., Any] = getattr(import_module(module), attribute)
    return factory


def check_factory(name: str, where: str, factory: Any) -> None:
    """Raise ValueError unless what a named team stands for is a factory that takes a strength."""
    accepted = signature(factory).parameters.values() if callable(factory) else ()
    if not any(one.name == "strength" or one.kind is one.VAR_KEYWORD for one in accepted):
        raise ValueError(f"team {name!r} must be a function that takes strength=, {where} is {factory!r}")


def check_accepted(name: str, factory: Callable[..., Any], settings: dict[str, Any]) -> None:
    """Raise ValueError for settings that a team's factory does not take."""
    accepted = signature(factory).parameters
    if not any(parameter.kind is parameter.VAR_KEYWORD for parameter in accepted.values()):
        for unknown in settings.keys() - accepted.keys():
            raise ValueError(f"team {name!r} has no setting {unknown!r}; it has: {', '.join(accepted)}")
