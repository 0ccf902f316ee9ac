"""A team that a function of observations controls.

    function(observations)             (D, P, n) float32 -> actions
    function(observations, memory)     memory (D, P) or (D, P, ...), to be changed in place

D is the number of matches in which a decision is due, P the number of the team's players. Actions are numbers (D, P, 4)
or (D, P, 7) with the head, or whole numbers (D, P), the indices of discrete actions. With `flat` the function knows
neither matches nor players: it gets (D P, n) and (D P, ...), and returns a row of actions for each.
"""

from collections.abc import Callable
from dataclasses import dataclass
from inspect import signature
from typing import Any

import numpy as np

from soccer_env.actions import FULL
from soccer_env.guards.checking import check_choice, check_whole_number, raise_not_allowed
from soccer_env.guards.ranges import ANY, COUNT, FLAG, NUMBER, ranged_record
from soccer_env.observations import OBSERVE, Observation
from soccer_env.teams import TeamRandom, View
from soccer_env.teams.function_teams.answers import Who, as_actions, check_remembered

MOST = 1000  # [control steps] for which a decision is kept
PLACES: list[Any] = [
    ("begun", "i8", FLAG),  # 1 once the episode has begun
    ("wait", "i8", COUNT),  # [control steps] until the next decision
    ("action", "f8", NUMBER, (len(FULL),)),
]
OWN = "own"  # the field of the memory that is the function's


@dataclass(frozen=True, eq=False, repr=False)
class FunctionTeam:
    """A team that a function of observations controls; `team_of_function` makes it and explains the fields.

    A match asks the function before anybody moves (`asking.py`); then the team does what its memory says.
    """

    name: str
    function: Callable[..., Any]
    observe: str | Observation
    action_repeat: int
    memory: np.dtype[Any] | None
    flat: bool
    at_once: bool
    fingerprint: str

    def __repr__(self) -> str:
        """Return the team's name, its kind of observations, and all settings that differ from their defaults."""
        given: dict[str, Any] = {
            "observe": self.observe if isinstance(self.observe, str) else observation_class_name(self.observe)
        }
        given |= {"action_repeat": self.action_repeat} if self.action_repeat != 1 else {}
        given |= {"memory": str(self.memory)} if self.memory is not None else {}
        given |= {"flat": True} if self.flat else {}
        given |= {"at_once": False} if not self.at_once else {}
        return f"FunctionTeam({', '.join([repr(self.name), *(f'{name}={value!r}' for name, value in given.items())])})"

    @property
    def memory_dtype(self) -> np.dtype[Any]:
        """Return the dtype of a player's memory: decision, steps until the next decision, the function's own memory."""
        return ranged_record(PLACES if self.memory is None else [*PLACES, (OWN, self.memory, ANY)])

    @property
    def settings(self) -> np.ndarray:
        """Return the settings as bytes; a save can be loaded only if they are equal."""
        seen = self.observe if isinstance(self.observe, str) else observation_class_name(self.observe)
        text = f"{seen} {self.action_repeat} {self.at_once} {self.flat} {self.fingerprint}"
        return np.frombuffer(text.encode(), np.uint8)

    def act(self, view: View, memory: np.ndarray, rng: TeamRandom) -> np.ndarray:
        """Return the commands (M, P, 7) that a match has stored in memory; ValueError outside a match."""
        if not memory["begun"].all():
            raise ValueError(
                f"team {self.name!r} plays inside a match only: give it as controllers, opponents or teammates"
            )
        memory["wait"] = np.maximum(memory["wait"] - 1, 0)
        return memory["action"].copy()

    def decide(self, observations: np.ndarray, memory: np.ndarray, who: Who) -> np.ndarray:
        """Ask the function for actions (D, P, 7), given observations (D, P, n); changes memory (D, P).

        ValueError names the robot (`who` of a match and a player), what the function returned, and what is allowed.
        """
        matches, players = observations.shape[:2]
        axes = (matches * players,) if self.flat else (matches, players)
        given = [observations.reshape(*axes, observations.shape[2])]
        if self.memory is not None:
            own = memory[OWN]
            given.append(np.ascontiguousarray(own).reshape(*axes, *own.shape[2:]))
        expected = [(array.shape, array.dtype) for array in given]
        actions = as_actions(self.function(*given), self.name, axes, players, who)
        if self.memory is not None:
            check_remembered(given[1].reshape(own.shape), (own.shape, expected[1][1]), self.name, who)
            memory[OWN] = given[1].reshape(own.shape)
        return actions


def team_of_function(
    function: Callable[..., Any],
    *,
    observe: str | Observation = "belief",
    action_repeat: int = 1,
    memory: Any = None,
    flat: bool = False,
    at_once: bool = True,
    name: str | None = None,
    fingerprint: str = "",
) -> FunctionTeam:
    """Make a team from a function of observations; the team plays wherever a team is expected.

    observe: what the observations are built from, as in `Match`: "truth" (with ideal senses), "percepts" (with
    sensors), "belief", or an object of your own. action_repeat: control steps for which a decision is kept. memory:
    the dtype of what a player remembers, such as ("f4", (64,)); zeros when an episode begins, saved and hashed with
    the match. flat: the function takes and returns one row for each player of each match. at_once: it decides in the
    first step of an episode, as the APIs do; False: as `SoccerVecEnv` does. name: the team's name. fingerprint: a text
    that changes when the policy changes, for evaluations that go on where they stopped. ValueError names what is wrong.
    """
    if not callable(function):
        raise_not_allowed("function", "a function of observations", function)
    if not (callable(observe) and (hasattr(observe, "names") or hasattr(observe, "entries"))):
        check_choice("observe", observe, OBSERVE)
    called = getattr(function, "__name__", type(function).__name__) if name is None else name
    repeat = check_whole_number("action_repeat", action_repeat, 1, MOST)
    team = FunctionTeam(
        check_text("name", called, 1), function, observe, repeat, None if memory is None else checked_memory(memory),
        check_choice("flat", flat, (True, False)), check_choice("at_once", at_once, (True, False)),
        check_text("fingerprint", fingerprint, 0),
    )  # fmt: skip
    check_arguments(function, memory is not None)
    return team


def check_arguments(function: Callable[..., Any], remembers: bool) -> None:
    """Raise ValueError unless a function takes observations, and as a second argument the memory if it remembers."""
    try:
        found = signature(function)
    except (TypeError, ValueError):  # of some compiled functions nothing is known
        return
    try:
        found.bind(*[None] * (1 + remembers))
    except TypeError as error:
        takes = "(observations, memory)" if remembers else "(observations); a second argument is for memory="
        raise ValueError(f"the function must take {takes}, got {found}: {error}") from None


def observation_class_name(observe: Observation) -> str:
    """Return the class name of a user's observation object."""
    return type(observe).__qualname__


def check_text(what: str, text: Any, least: int) -> str:
    """Return the value if it is one line of printable text with at least `least` characters; else raise ValueError."""
    if not (isinstance(text, str) and text.isprintable() and len(text) >= least):
        raise_not_allowed(what, "a plain text", text)
    return text


def checked_memory(memory: Any) -> np.dtype[Any]:
    """Return a memory's dtype, checked to hold plain numbers; ValueError for anything else."""
    try:
        dtype: np.dtype[Any] = np.dtype(memory)
    except (TypeError, ValueError) as error:
        raise ValueError(f"memory must be a dtype of plain numbers, got {memory!r}: {error}") from error
    if dtype.hasobject or dtype.itemsize == 0:
        raise_not_allowed("memory", "a dtype of plain numbers", memory)
    return dtype
