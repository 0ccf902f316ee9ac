"""A policy: a trained network, and all properties that must agree with a match before the policy may play in it.

    observation (inputs,) in [-1, 1]                                       names in `inputs`, in this order
      -> normalised, if `normalise` is set                                 normalising.py
      -> with a memory: its state appended                                 recurrent.py
      -> weights[0] x + biases[0] -> activation                            hidden layers, 0 to 7
      -> ...
      -> weights[-1] x + biases[-1]                                        no activation
      -> mean of the actions (4,) or (7,), clipped to [-1, 1] when played  `actions.BOX` or `actions.FULL`
         or squashed by tanh; or a value for each of `actions.DISCRETE`, of which the largest is played, or for
         each choice of the parts of "multi", of which the largest of each part is played, or for each of
         the skills in `choices.SKILLS`, of which the skill with the largest value among those that apply is played,
         or one drawn by exp(value / temperature)

Every policy is checked when it is made: a checked policy can neither overflow nor give NaN.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from soccer_env.actions import BOX, FULL, PARTS
from soccer_env.agents.array_checks import check_array, check_below_limit
from soccer_env.agents.normalising import check_normalise
from soccer_env.agents.recurrent import check_memory, check_memory_overflow, memory_units
from soccer_env.agents.rules_known import check_rules_table, recorded, tell_of_rules
from soccer_env.agents.trained_with import check_trained_with
from soccer_env.guards.checking import check_choice, raise_not_allowed, short_repr
from soccer_env.leagues.checks import check_family
from soccer_env.leagues.league import MAX_RATE, League
from soccer_env.observations import OBSERVE, Entry, entries_named, entry_names
from soccer_env.observations.reflection import observation_signs
from soccer_env.skills.choices import SKILLS

CHOICES = {**{kind: sum(parts) for kind, parts in PARTS.items()}, "skills": len(SKILLS)}  # a value for each
ACTIONS = {"box": len(BOX), "full": len(FULL), **CHOICES}  # numbers of outputs
ACTIVATIONS = ("tanh", "relu")
MAX_REPEAT = 1000  # [control steps]
MAX_TEMPERATURE = 100.0
MAX_INPUTS = 4096
MAX_LAYERS = 8
MAX_UNITS = 1024
MAX_NUMBERS = 3_900_000  # of all layers together, so that a policy file stays below its 16 MiB
MAX_MADE = 64  # entries
MAX_TEXT = 2000  # characters of one entry
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9 ._+-]{0,63}")  # safe in a table, in a command line and as a file's name
INPUT = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,63}")


@dataclass(frozen=True, eq=False, repr=False)
class Policy:
    """A trained network, and all properties that must agree with a match before the policy may play in it.

    ValueError names a wrong field. The arrays are read-only copies. Two policies are equal if `policy_file.dump` gives
    the same bytes.
    """

    name: str  # of the team
    league: str  # name of the league it was trained in
    family: str  # of that league: it plays every league of the family with its inputs and control rate
    control_rate: int  # [1/s] of that league
    observe: str  # "truth", "percepts" or "belief"
    inputs: tuple[str, ...]  # names of the entries that it reads, in order; an observation may have more
    actions: str  # "box" (4 numbers), "full" (7), "discrete", "multi" or "skills" (a value for each choice)
    action_repeat: int  # [control steps] for which an action is kept, 1 to 1000
    activation: str  # "tanh" or "relu", behind every layer but the last
    mirror: bool  # True: the output is the mean of the network and of its left-right mirror image
    weights: tuple[np.ndarray, ...]  # (out, in) float32 of each layer
    biases: tuple[np.ndarray, ...]  # (out,) float32 of each layer
    made: Mapping[str, str]  # where it comes from: command, date, commit, seed, versions ... plain text
    rules: Mapping[str, Any] = field(default_factory=dict)  # of the training, by name; {}: unknown
    squash: bool = False  # True: tanh of the outputs instead of clipping them
    at_once: bool = False  # True: its first decision is in the first step of an episode, as in the APIs
    normalise: Mapping[str, Any] = field(default_factory=dict)  # table of `normalising`; {}: not normalised
    senses: str = ""  # of the training, "sensors" or "ideal"; "": unknown, see `trained_with`
    pose: str = ""  # of the training, "percept" or "particles"; "": unknown
    temperature: float = 0.0  # of the draw of a skill; 0: the one with the largest value
    memory: tuple[np.ndarray, ...] = ()  # float32, as `recurrent.TENSORS` names them; (): no memory

    def __post_init__(self) -> None:
        _check_text("name", self.name, NAME)
        _check_text("league", self.league, NAME)
        check_family("family", self.family)
        _check_whole_number("control_rate", self.control_rate, MAX_RATE)
        check_choice("observe", self.observe, OBSERVE)
        check_choice("actions", self.actions, tuple(ACTIONS))
        check_choice("activation", self.activation, ACTIVATIONS)
        for name in ("mirror", "squash", "at_once"):
            if type(getattr(self, name)) is not bool:
                raise ValueError(f"{name} must be True or False, got {short_repr(getattr(self, name))}")
        _check_choosing(self)
        if self.mirror and self.observe == "percepts":
            raise ValueError("mirror must be False where percepts are observed: turning signs round mirrors no picture")
        _check_whole_number("action_repeat", self.action_repeat, MAX_REPEAT)
        _check_inputs(self.inputs)
        _check_origin(self.made)
        check_rules_table(self.rules)
        check_trained_with(self)
        if self.mirror:
            observation_signs(self.entries)
        inputs = len(self.inputs) + check_memory(self.memory, len(self.inputs))
        numbers = sum(array.size for array in self.memory)
        _check_layers(self.weights, self.biases, inputs, ACTIONS[self.actions], numbers)
        largest = check_normalise(self.normalise, len(self.inputs))
        check_memory_overflow(self.memory, largest)
        _check_unit_overflow(self.weights, self.biases, self.activation, largest)
        for name in ("weights", "biases", "memory"):
            object.__setattr__(self, name, tuple(_read_only_copy(array) for array in getattr(self, name)))
        for name in ("made", "rules", "normalise"):
            object.__setattr__(self, name, dict(getattr(self, name)))

    def __repr__(self) -> str:
        """Return name, league and shape of the policy, without its numbers."""
        sizes = ", ".join(str(len(bias)) for bias in self.biases)
        sizes += f", memory of {memory_units(self.memory)}" if self.memory else ""
        shape = f"{len(self.inputs)} inputs, layers of {sizes}"
        return f"Policy({self.name!r}, {self.league!r}, observe={self.observe!r}, actions={self.actions!r}: {shape})"

    @property
    def entries(self) -> list[Entry]:
        """Return the entry (meaning) of each input, as far as known from its name."""
        return entries_named(self.observe, self.inputs)

    def warn_of_other_rules(self, league: League) -> None:
        """Warn, once per process, if a league's rules differ from the rules of the training."""
        tell_of_rules(self.name, self.rules, league.rules)

    def check_plays(self, league: League) -> None:
        """Raise ValueError unless family and control rate of a league agree, and it has every entry that is read.

        Name and numbers of the league do not matter: a policy may play variants.
        """
        for what, own, other in (
            ("family", self.family, league.family),
            ("control rate", self.control_rate, league.control_rate),
        ):
            if own != other:
                raise ValueError(
                    f"policy {self.name!r} was trained in {self.league!r} of {what} {own}, "
                    f"{league.name!r} is of {what} {other}"
                )
        self.columns(league)

    def columns(self, league: League) -> list[int]:
        """Return the place of each input in a league's observation; ValueError names a missing entry."""
        places = {name: place for place, name in enumerate(entry_names(league, self.observe))}
        for name in self.inputs:
            if name not in places:
                raise ValueError(
                    f"policy {self.name!r} reads the entry {name!r}, which {self.observe!r} of {league.name!r} lacks"
                )
        return [places[name] for name in self.inputs]


def training_fields(league: League) -> dict[str, Any]:
    """Return the fields of a policy that record the league and the rules of its training."""
    return {**league_fields(league), "rules": recorded(league.rules)}


def league_fields(league: League) -> dict[str, Any]:
    """Return the fields of a policy that record its league."""
    return {"league": league.name, "family": league.family, "control_rate": league.control_rate}


def _check_choosing(policy: Policy) -> None:
    """Raise ValueError for a field that does not go with the kind of the policy's actions."""
    actions, temperature = policy.actions, policy.temperature
    if actions in CHOICES and (policy.squash or (policy.mirror and actions != "skills")):
        raise ValueError(f"mirror and squash must be False where actions are {actions!r}")
    if type(temperature) is not float or not 0.0 <= temperature <= MAX_TEMPERATURE:
        raise_not_allowed("temperature", f"0.0 to {MAX_TEMPERATURE}", temperature)
    if temperature and actions != "skills":
        raise ValueError(f"temperature must be 0.0 where actions are {actions!r}: only skills are drawn")
    if actions == "skills" and policy.memory:
        raise ValueError("a policy that chooses skills can have no memory of its own")


def _check_text(what: str, value: object, pattern: re.Pattern[str]) -> None:
    """Raise ValueError unless a value is a short plain text that matches `pattern`."""
    if not isinstance(value, str) or not pattern.fullmatch(value):
        kinds = "letters, digits and _" if pattern is INPUT else "letters, digits, spaces and . _ + -"
        raise_not_allowed(what, f"1 to 64 characters ({kinds})", value)


def _check_whole_number(what: str, value: object, most: int) -> None:
    """Raise ValueError unless a value is a whole number from 1 to `most`."""
    if type(value) is not int or not 1 <= value <= most:
        raise_not_allowed(what, f"1 to {most}", value)


def _check_inputs(inputs: object) -> None:
    """Raise ValueError unless the inputs are 1 to MAX_INPUTS different names."""
    if not isinstance(inputs, tuple) or not 1 <= len(inputs) <= MAX_INPUTS:
        size = len(inputs) if isinstance(inputs, tuple) else short_repr(inputs)
        raise ValueError(f"inputs must be a tuple of 1 to {MAX_INPUTS} names, got {size}")
    seen: set[str] = set()
    for number, name in enumerate(inputs):
        _check_text(f"input {number}", name, INPUT)
        if name in seen:
            raise ValueError(f"input {number} must have a name of its own, {name!r} is used before")
        seen.add(name)


def _check_origin(made: object) -> None:
    """Raise ValueError unless `made`, the origin of a policy, is a small table of plain texts."""
    if not isinstance(made, Mapping) or len(made) > MAX_MADE:
        got = len(made) if isinstance(made, Mapping) else short_repr(made)
        raise ValueError(f"made must be a mapping of at most {MAX_MADE} texts, got {got}")
    for key, text in made.items():
        _check_text("a key of made", key, NAME)
        if not isinstance(text, str) or len(text) > MAX_TEXT:
            size = f"{len(text)} characters" if isinstance(text, str) else short_repr(text)
            raise ValueError(f"made[{key!r}] must be a text of at most {MAX_TEXT} characters, got {size}")
        if not text.replace("\n", "").replace("\t", "").isprintable():
            raise_not_allowed(f"made[{key!r}]", "plain text", text)


def _check_layers(weights: object, biases: object, inputs: int, outputs: int, numbers: int) -> None:
    """Raise ValueError unless the layers connect inputs to outputs, within the limits and with finite numbers."""
    if not (isinstance(weights, tuple) and isinstance(biases, tuple) and len(weights) == len(biases)):
        raise ValueError("weights and biases must be tuples of the same length, one array for each layer")
    if not 1 <= len(weights) <= MAX_LAYERS:
        raise ValueError(f"a policy must have 1 to {MAX_LAYERS} layers, got {len(weights)}")
    width, last = inputs, len(weights) - 1
    for number, (weight, bias) in enumerate(zip(weights, biases)):
        for what, array in (("weight", weight), ("bias", bias)):
            check_array(f"layer{number}.{what}", array)
        out = outputs if number == last else len(bias) if bias.ndim == 1 else 0
        if not 1 <= out <= MAX_UNITS:
            raise ValueError(f"layer{number}.bias must have the shape (1 to {MAX_UNITS},), got {bias.shape}")
        if weight.shape != (out, width) or bias.shape != (out,):
            raise ValueError(
                f"layer{number} must have a weight {(out, width)} and a bias {(out,)}, got {weight.shape}, {bias.shape}"
            )
        width, numbers = out, numbers + weight.size + bias.size
        if numbers > MAX_NUMBERS:
            raise ValueError(f"a policy must have at most {MAX_NUMBERS} weights and biases, layer{number} is too much")
        if not (np.isfinite(weight).all() and np.isfinite(bias).all()):
            raise ValueError(f"layer{number} must be finite, it holds NaN or infinity")


def _check_unit_overflow(
    weights: tuple[np.ndarray, ...], biases: tuple[np.ndarray, ...], activation: str, largest: float
) -> None:
    """Raise ValueError if inputs up to `largest` could make a unit of the network overflow."""
    for number, (weight, bias) in enumerate(zip(weights, biases)):
        reached = np.abs(weight).sum(axis=1, dtype=np.float64) * largest + np.abs(bias)
        check_below_limit(f"layer{number}", reached.max())
        largest = 1.0 if activation == "tanh" else float(reached.max())


def _read_only_copy(array: np.ndarray) -> np.ndarray:
    """Return a read-only copy of an array as float32."""
    copy = np.array(array, dtype=np.float32, order="C", subok=False)
    copy.setflags(write=False)
    return copy
