"""The table of reward terms, and their weights."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, fields, make_dataclass
from typing import Any

import numpy as np

from soccer_env.guards.checking import SHARE, Range, check_choice, check_finite_number, check_names, raise_not_allowed
from soccer_env.guards.names import object_in_module
from soccer_env.rewards.terms import approach, cover, crowding, effort, foul, guard, progress, score, shot, strength

KINDS = ("potential", "event", "cost")
WEIGHT = Range(-1e9, 1e9)  # of a term: larger weights could make rewards infinite


@dataclass(frozen=True)
class Term:
    """A built-in reward term."""

    name: str
    text: str  # its meaning, for lists
    function: Callable[..., Any]  # a kernel with the arguments of its kind, see rewards/__init__.py
    kind: str  # "potential", "event" or "cost"
    weight: float  # default


@dataclass(frozen=True)
class OwnTerm:
    """A user's own reward term: a function of the Match that returns (M, R) numbers, a kind and a weight."""

    function: Callable[[Any], Any]  # of the Match, returns (M, R) numbers
    kind: str = "event"  # "event" and "cost" pay and charge the numbers, "potential" shapes by them
    weight: float = 1.0  # by which the numbers are multiplied

    def __post_init__(self) -> None:
        if not callable(self.function):
            raise_not_allowed("OwnTerm.function", "a function of the Match", self.function)
        check_choice("OwnTerm.kind", self.kind, KINDS)
        check_finite_number("OwnTerm.weight", self.weight, WEIGHT)


TERMS = (
    Term("goal", "+1 when the own team scores, -1 when the opponents do", score, "event", 1.0),
    Term(
        "progress",
        "how much nearer the ball is to the opponents' goal than to the own, divided by twice the pitch's length",
        progress, "potential", 0.5,
    ),
    Term(
        "approach",
        "minus the distance of the team's nearest active robot from the ball, over the diagonal",
        approach, "potential", 0.1,
    ),
    Term(
        "effort", "minus the mean square of forward, left and turn of the robot's command, each second",
        effort, "cost", 0.0005,
    ),
    Term(
        "cover",
        "minus the distance of the nearest mate from halfway between ball and own goal, over the diagonal",
        cover, "potential", 0.0,
    ),
    Term("crowding", "minus how near the ball a second robot of the team is", crowding, "potential", 0.0),
    Term(
        "guard", "minus the angle between the own posts that the goalkeeper leaves open to the ball, over pi",
        guard, "potential", 0.0,
    ),
    Term("strength", "minus the share of the team that serves a penalty", strength, "potential", 0.0),
    Term("shot", "+1 for a kick of the robot that would roll between the opponents' posts", shot, "event", 0.0),
    Term("foul", "minus one for a foul that is whistled against the robot", foul, "cost", 0.0),
)  # fmt: skip

# What follows from the table

NAMES = tuple(term.name for term in TERMS)
COUNT = len(TERMS)
POTENTIALS = (2, sum(term.kind == "potential" for term in TERMS))  # shape (teams, potentials)
WEIGHTS = np.dtype([("term", "f8", (COUNT,)), ("gamma", "f8")])
Weights: Any = make_dataclass(
    "Weights", [(term.name, float, term.weight) for term in TERMS], frozen=True, kw_only=True
)  # the weights of the terms, by name


@dataclass(frozen=True, kw_only=True)
class Rewards(Weights):  # type: ignore[misc]  # its fields follow from the table
    """Weights of the reward terms by name, such as Rewards(progress=0.0); `soccer list rewards` shows all."""

    gamma: float = 0.99  # [1] discount of the shaping, for one action
    extra: dict[str, OwnTerm | Callable[[Any], Any]] = field(default_factory=dict)
    """A user's own terms by name: an OwnTerm, or a function, which becomes an event of weight 1."""

    def __new__(cls, **values: Any) -> Rewards:
        """Create the weights; raise ValueError for an unknown term."""
        check_names("reward term", values, [item.name for item in fields(cls)])
        made: Rewards = super().__new__(cls)
        return made

    def __post_init__(self) -> None:
        for name in NAMES:
            check_finite_number(f"Rewards.{name}", getattr(self, name), WEIGHT)
        check_finite_number("Rewards.gamma", self.gamma, SHARE)
        own = {}
        for name, term in self.extra.items():
            if not (callable(term) or isinstance(term, OwnTerm)) or name in NAMES:
                raise ValueError(f"Rewards.extra[{name!r}] must be a function or OwnTerm under a name of its own")
            own[name] = term if isinstance(term, OwnTerm) else OwnTerm(term)
        object.__setattr__(self, "extra", own)

    @staticmethod
    def only(**values: Any) -> Rewards:
        """Return rewards with the given weights, and weight 0 for all other terms."""
        return Rewards(**{**dict.fromkeys(NAMES, 0.0), **values})

    def weights(self) -> np.ndarray:
        """Return the weights as a record (1,) for compiled code."""
        return np.array([(tuple(float(getattr(self, name)) for name in NAMES), self.gamma)], WEIGHTS)


PRESETS = {
    "default": Rewards(),
    "sparse": Rewards.only(**{term.name: term.weight for term in TERMS if term.kind == "event"}),
    # Of `soccer train`. A goal takes back half of `progress`: with goal=1.0 it would cost 1.5.
    "training": Rewards(
        goal=5.0,
        progress=5.0,
        approach=2.0,
        effort=0.0,
        cover=0.2,
        crowding=0.1,
        guard=1.0,
        strength=0.3,
        shot=1.0,
        foul=2.0,
    ),
}

KINDS_OF_PLAYERS: dict[str, dict[str, float]] = {  # amounts a minute of the terms of weight 1
    "stands": {},
    "walks": {"effort": -60.0 / 3.0},  # straight ahead at top speed: a third of the mean square
    "wins": {"effort": -60.0 / 3.0, "goal": 0.2, "shot": 0.2},  # by a goal of its own in five minutes, assumed
}


def earnings(rewards: Rewards, player: str) -> dict[str, float]:
    """Return what a player of KINDS_OF_PLAYERS earns a minute, by event and cost term, and their "sum"."""
    amounts = KINDS_OF_PLAYERS[player]
    names = [term.name for term in TERMS if term.kind != "potential"]
    paid = {name: getattr(rewards, name) * amounts.get(name, 0.0) + 0.0 for name in names}  # no -0
    return {**paid, "sum": sum(paid.values())}


def find_rewards(rewards: str | Rewards) -> Rewards:
    """Return the rewards of a preset or MODULE:NAME, or a given Rewards unchanged; ValueError lists the presets."""
    rewards = object_in_module("rewards", rewards, Rewards) or rewards
    if isinstance(rewards, Rewards):
        return rewards
    if callable(rewards):
        name = getattr(rewards, "__name__", "mine")
        term = "mine" if name in (*NAMES, "<lambda>") else name
        raise ValueError(f"a function is one term of the rewards: give Rewards(extra={{{term!r}: {name}}})")
    check_names("rewards", [rewards], PRESETS, more="MODULE:NAME, or a Rewards object")
    return PRESETS[rewards]
