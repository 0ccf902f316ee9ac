"""Reward terms: one row of TERMS each, from which weights, sums, infos, lists and training settings follow.

    potential   function(match, ball, robots, k, team) -> the potential of a team
    event       function(match, ball, robots, events, robot_events, k, r, weight) -> what robot r gets in this step
    cost        the same, and robot r pays it

Shaping is potential-based [Ng, Harada, Russell 1999]: gamma * phi(s') - phi(s), with s' the state that the next
observation shows (after a restart, if one was carried out) and phi = 0 once the episode has ended. It sums to zero
over a loop and cannot be farmed; a goal therefore also pays back the potential that led to it. Where an action is kept
for several control steps, s and s' are the states before and after all of them.

`k`: the league's constants.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, fields, make_dataclass
from math import inf, sqrt
from typing import Any

import numpy as np

from soccer_env.checking import SHARE, check_names, number, one_of, refuse
from soccer_env.compiled import compiled
from soccer_env.geometry import direction_of, length
from soccer_env.types import NO_TEAM

KINDS = ("potential", "event", "cost")


@dataclass(frozen=True)
class Term:
    """A reward term of every match."""

    name: str
    text: str  # what it pays, for lists
    function: Callable[..., Any]  # a kernel as its kind asks for, see above
    kind: str  # "potential", "event" or "cost"
    weight: float  # unless Rewards say otherwise


@dataclass(frozen=True)
class OwnTerm:
    """A user's own reward term: a function of the Match that returns (M, R) numbers, and how they are paid."""

    function: Callable[[Any], Any]
    kind: str = "event"  # "event" and "cost" pay and charge the numbers, "potential" shapes by them
    weight: float = 1.0

    def __post_init__(self) -> None:
        if not callable(self.function):
            refuse("OwnTerm.function", "a function of the Match", self.function)
        one_of("OwnTerm.kind", self.kind, KINDS)
        number("OwnTerm.weight", self.weight)


@compiled
def score(match, ball, robots, events, robot_events, k, r, weight):
    """Return the weight for an own goal scored, minus the weight for one of the opponents."""
    if events.goal == NO_TEAM:
        return 0.0
    return weight if events.goal == robots[r].team else -weight


@compiled
def progress(match, ball, robots, k, team):
    """Return how much nearer the ball is to the opponents' goal than to the own, over twice the pitch's length."""
    half = 0.5 * k.pitch_length
    left, right = length(ball.x + half, ball.y), length(ball.x - half, ball.y)
    return direction_of(match, team) * (left - right) / (2.0 * k.pitch_length)


@compiled
def approach(match, ball, robots, k, team):
    """Return minus the distance of the team's nearest active robot from the ball, over the pitch's diagonal."""
    diagonal = sqrt(k.pitch_length * k.pitch_length + k.pitch_width * k.pitch_width)
    square = nearest_square(ball, robots, team)
    return -(0.0 if square == inf else sqrt(square)) / diagonal


@compiled
def nearest_square(ball, robots, team):
    """Return the square of the distance [m2] of a team's nearest active robot from the ball, inf if it has none."""
    least = inf
    for r in range(robots.shape[0]):
        if robots[r].team == team and robots[r].active == 1:
            x, y = robots[r].x - ball.x, robots[r].y - ball.y
            least = min(least, x * x + y * y)
    return least


@compiled
def effort(match, ball, robots, events, robot_events, k, r, weight):
    """Return the weighted mean square of the walk that a robot asks for; the referee's steering costs it nothing."""
    if match.placing == 1:
        return 0.0
    command = robots[r].command
    square = command.forward * command.forward + command.left * command.left + command.turn * command.turn
    return weight * square / 3.0


TERMS = (
    Term("goal", "+1 when the own team scores, -1 when the opponents do", score, "event", 1.0),
    Term(
        "progress",
        "how much nearer the ball is to the opponent's goal than to the own, over twice the length",
        progress, "potential", 0.5,
    ),
    Term(
        "approach",
        "minus the distance of the team's nearest active robot from the ball, over the diagonal",
        approach, "potential", 0.1,
    ),
    Term(
        "effort", "minus the mean square of forward, left and turn of the robot's command, at each step",
        effort, "cost", 0.001,
    ),
)  # fmt: skip

# What follows from the table

NAMES = tuple(term.name for term in TERMS)
COUNT = len(TERMS)
POTENTIALS = (2, sum(term.kind == "potential" for term in TERMS))  # shape (teams, potentials) of what is measured
WEIGHTS = np.dtype([("term", "f8", (COUNT,)), ("gamma", "f8")])
Weights: Any = make_dataclass(
    "Weights", [(term.name, float, term.weight) for term in TERMS], frozen=True, kw_only=True
)  # the weights of the terms, by name


@dataclass(frozen=True, kw_only=True)
class Rewards(Weights):  # type: ignore[misc]  # its fields follow from the table
    """Weights of the reward terms by name, such as Rewards(progress=0.0); `soccer list rewards` shows all."""

    gamma: float = 0.99  # [1] discount of the shaping, for one action
    extra: dict[str, OwnTerm | Callable[[Any], Any]] = field(default_factory=dict)
    """Terms of one's own by name: an OwnTerm, or just its function, which then is an event of weight 1."""

    def __new__(cls, **values: Any) -> Rewards:
        """Raise ValueError for a term that does not exist."""
        check_names("reward term", values, [item.name for item in fields(cls)])
        made: Rewards = super().__new__(cls)
        return made

    def __post_init__(self) -> None:
        for name in NAMES:
            number(f"Rewards.{name}", getattr(self, name))
        number("Rewards.gamma", self.gamma, SHARE)
        own = {}
        for name, term in self.extra.items():
            if not (callable(term) or isinstance(term, OwnTerm)) or name in NAMES:
                raise ValueError(f"Rewards.extra[{name!r}] must be a function or OwnTerm under a name of its own")
            own[name] = term if isinstance(term, OwnTerm) else OwnTerm(term)
        object.__setattr__(self, "extra", own)

    @staticmethod
    def only(**values: Any) -> Rewards:
        """Return rewards in which the terms that are not named weigh nothing."""
        return Rewards(**{**dict.fromkeys(NAMES, 0.0), **values})

    def weights(self) -> np.ndarray:
        """Return the (1,) record of weights for compiled code."""
        return np.array([(tuple(float(getattr(self, name)) for name in NAMES), self.gamma)], WEIGHTS)


PRESETS = {
    "default": Rewards(),
    "sparse": Rewards.only(**{term.name: term.weight for term in TERMS if term.kind == "event"}),
    "training": Rewards(progress=2.0, approach=0.2),  # of `soccer train`
}


def find_rewards(rewards: str | Rewards) -> Rewards:
    """Return the reward preset of that name, or the object itself; ValueError says which names exist."""
    if isinstance(rewards, Rewards):
        return rewards
    check_names("rewards", [rewards], PRESETS, more="a Rewards object")
    return PRESETS[rewards]


# A link of a chain has no loop and takes whole arrays: it then is inlined, and counts no references to views of rows.


def make_measure(terms: tuple[Term, ...]) -> Callable[..., None]:
    """Return a kernel that writes the potentials of a team into its row of (2, potentials), one column a term."""

    @compiled
    def measure(match, ball, robots, k, team, potentials):
        pass

    for index, term in enumerate(term for term in terms if term.kind == "potential"):
        measure = add_potential(measure, index, term.function)
    return measure


def add_potential(measure_others, index, function):
    """Return a kernel that writes the potentials of other terms, and that of one more."""

    @compiled
    def measure(match, ball, robots, k, team, potentials):
        measure_others(match, ball, robots, k, team, potentials)
        potentials[team, index] = function(match, ball, robots, k, team)

    return measure


def make_pay(terms: tuple[Term, ...]) -> Callable[..., None]:
    """Return a kernel that adds what a robot gets to its row of (R, terms or more), one column a term."""

    @compiled
    def pay(match, ball, robots, events, robot_events, k, r, before, after, weights, paid):
        pass

    potentials = 0
    for column, term in enumerate(terms):
        if term.kind == "potential":
            pay = add_shaping(pay, column, potentials)
            potentials += 1
        else:
            pay = add_event(pay, column, term.function, -1.0 if term.kind == "cost" else 1.0)
    return pay


def add_shaping(pay_others, column, index):
    """Return a kernel that pays other terms, and the shaping of one potential."""

    @compiled
    def pay(match, ball, robots, events, robot_events, k, r, before, after, weights, paid):
        pay_others(match, ball, robots, events, robot_events, k, r, before, after, weights, paid)
        team = robots[r].team
        paid[r, column] += weights.term[column] * (weights.gamma * after[team, index] - before[team, index])

    return pay


def add_event(pay_others, column, function, sign):
    """Return a kernel that pays other terms, and an event (sign 1) or a cost (sign -1)."""

    @compiled
    def pay(match, ball, robots, events, robot_events, k, r, before, after, weights, paid):
        pay_others(match, ball, robots, events, robot_events, k, r, before, after, weights, paid)
        paid[r, column] += sign * function(match, ball, robots, events, robot_events, k, r, weights.term[column])

    return pay


measure_team = make_measure(TERMS)
pay_robot = make_pay(TERMS)


@compiled
def measure_potentials(match, ball, robots, k, potentials):
    """Write the potentials of both teams into an array of the shape POTENTIALS; all 0 once the episode has ended."""
    if match.over == 1:
        potentials[:] = 0.0
        return
    for team in range(2):
        measure_team(match, ball, robots, k, team, potentials)


@compiled
def reward_robots(match, ball, robots, events, robot_events, k, before, after, weights, terms, rewards):
    """Add the weighted terms of each robot to terms (R, COUNT or more), and write their sum into rewards (R,)."""
    for r in range(robots.shape[0]):
        pay_robot(match, ball, robots, events, robot_events, k, r, before, after, weights, terms)
        total = 0.0
        for column in range(COUNT):
            total += terms[r, column]
        rewards[r] = total
