"""The protocol of a team, and the class of compiled teams.

A team decides from beliefs alone. It is a protocol: anything with `name`, `memory_dtype` and `act` plays. The shipped
teams also offer a compiled `kernel`, which a match runs without Python between its steps (`kernels.py`).
"""

from collections.abc import Callable
from dataclasses import MISSING, dataclass, fields
from typing import Any, Protocol, runtime_checkable

import numpy as np

from soccer_env.guards.names import Made, reduce_by_names
from soccer_env.leagues.constants import constants_of
from soccer_env.leagues.league import League
from soccer_env.leagues.options import Options
from soccer_env.random_numbers import mix_bits
from soccer_env.types import RobotStream

TEAM_STREAM = int(RobotStream.TEAM)


@dataclass(frozen=True)
class View:
    """The information that the P players of a team get in M matches: beliefs (M, P) and tracks (M, P, slots)."""

    league: League  # that they play
    beliefs: np.ndarray  # (M, P) of `BELIEF`
    tracks: np.ndarray  # (M, P, slots) of `TRACK`

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
        """Return each player's knowledge of the match (M, P): phase, score, time, numbers."""
        return self.beliefs["situation"]

    def stand(self) -> np.ndarray:
        """Return commands (M, P, 7) with which all players stand still: forward, left, turn, kick, head, pan, tilt."""
        commands = np.zeros((*self.beliefs.shape, 7))
        commands[..., 4] = -1.0  # the head tracks the ball by itself
        return commands


class TeamRandom:
    """Random numbers for a team's players, from streams that the match saves and hashes."""

    def __init__(self, states: np.ndarray, players: np.ndarray) -> None:
        self._states, self._players = states, players

    def uniform(self, low: float = 0.0, high: float = 1.0) -> np.ndarray:
        """Draw one number from [low, high) for each player (M, P)."""
        from soccer_env.random_numbers import GOLDEN, TO_UNIT

        states = self._states[:, self._players, TEAM_STREAM] + GOLDEN
        self._states[:, self._players, TEAM_STREAM] = states
        python = getattr(mix_bits, "py_func", mix_bits)
        with np.errstate(over="ignore"):
            mixed: np.ndarray = python(states)
        return low + (high - low) * ((mixed >> np.uint64(11)).astype(np.float64) * TO_UNIT)


@runtime_checkable
class Team(Protocol):
    """The protocol of a team: `act` gets its players' view and returns commands (M, P, 4 or 7) in [-1, 1]."""

    @property
    def name(self) -> str:
        """Return the name of the team."""
        ...

    @property
    def memory_dtype(self) -> np.dtype:
        """Return the dtype of a player's memory, which is saved and hashed with the match."""
        ...

    def act(self, view: View, memory: np.ndarray, rng: TeamRandom) -> np.ndarray:
        """Return the commands of all players; the team may change memory (M, P), of `memory_dtype`."""
        ...


@dataclass(frozen=True, repr=False)
class CompiledTeam:
    """A team with a compiled kernel that decides for all its players in a slice of matches.

    kernel(beliefs, tracks, memory, noise, commands, players, constants, settings, first, last), all arrays of the
    whole match; `settings` is the team's own (1,) record.
    """

    name: str  # in lists, infos and results
    kernel: Callable[..., None]  # as above
    memory_dtype: np.dtype  # of what a player keeps from step to step
    settings: np.ndarray  # (1,) record that the kernel reads
    families: tuple[str, ...] = ()  # of leagues that it plays (`League.family`); empty: all
    options: Options | None = None  # the team's settings by name, for lists
    blind: bool = False  # True: it reads no belief, so that nothing has to be sensed for it
    fit: Callable[[np.ndarray, League], np.ndarray] | None = None  # the settings for a league; None: the same in all
    explains: str = ""  # "MODULE:NAME" of what it tells people who watch, see explaining.py

    def __repr__(self) -> str:
        """Return the name and all settings that differ from their defaults."""
        given: dict[str, Any] = {}
        if "strength" in (self.settings.dtype.names or ()) and self.settings["strength"][0] != 1.0:
            given["strength"] = float(self.settings["strength"][0])
        if self.options is not None:
            held = type(self.options).__dataclass_fields__.values()  # type: ignore[attr-defined]
            given |= {item.name: getattr(self.options, item.name) for item in held if item.default is not MISSING}
            given = {name: value for name, value in given.items() if value != getattr(type(self.options), name, value)}
        given |= {"observe": self.observe} if isinstance(self, ObservingTeam) else {}
        return f"{type(self).__name__}({', '.join([repr(self.name), *(f'{k}={v!r}' for k, v in given.items())])})"

    def __reduce__(self) -> Made:
        """Pickle the kernel by its name in the team's module."""
        return reduce_by_names(self, {item.name: getattr(self, item.name) for item in fields(self)})

    def check_league(self, league: League) -> None:
        """Raise ValueError if the team cannot play in this league."""
        league.require_family(self.families, f"team {self.name!r}")

    def settings_in(self, league: League) -> np.ndarray:
        """Return the team's settings in the form that the kernel reads in a league."""
        return self.settings if self.fit is None else self.fit(self.settings, league)

    def act(self, view: View, memory: np.ndarray, rng: TeamRandom) -> np.ndarray:
        """Run the kernel, as a match does, and return the commands (M, P, 7) of all players."""
        from soccer_env.types import COMMAND

        players = np.arange(view.beliefs.shape[1])
        commands = np.zeros(view.beliefs.shape, COMMAND)
        noise = np.ascontiguousarray(rng._states[:, rng._players])
        k, settings = constants_of(view.league), self.settings_in(view.league)
        self.kernel(view.beliefs, view.tracks, memory, noise, commands, players, k, settings, 0, len(commands))
        rng._states[:, rng._players] = noise
        return np.stack([commands[name] for name in COMMAND.names or ()], axis=-1)


@dataclass(frozen=True, repr=False)
class ObservingTeam(CompiledTeam):
    """A compiled team that decides from learners' observations instead of beliefs, as learned policies do.

    kernel(observations, memory, commands, players, constants, settings, first, last): observations (M, R, n) float32
    are written for its players by the code that writes a learner's, in steps in which the field "wait" of the memory,
    the control steps until the next decision, is 0 for one of them. A `skilled` team carries out skills by its beliefs:
    kernel(observations, beliefs, tracks, memory, noise, commands, players, constants, settings, first, last).
    """

    observe: str = "belief"  # built from "truth" (with ideal senses only), "percepts" (with sensors only) or "belief"
    skilled: bool = False

    def act(self, view: View, memory: np.ndarray, rng: TeamRandom) -> np.ndarray:
        """Raise ValueError: this team needs readings that no view holds, so that it plays only inside a match."""
        raise ValueError(
            f"team {self.name!r} plays inside a match only: give it as controllers, opponents or teammates"
        )
