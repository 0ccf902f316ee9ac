"""Named reward terms and their weights.

Shaping is potential-based [Ng, Harada, Russell 1999]: gamma * phi(s') - phi(s), with s' the state that the next
observation shows (after a restart, if one was carried out) and phi = 0 once the episode has ended. It sums to zero
over a loop and cannot be farmed; a goal therefore also pays back the potential that led to it. Where an action is kept
for several control steps, s and s' are the states before and after all of them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, fields
from math import inf, isfinite, sqrt
from typing import Any

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.frames import direction_of
from soccer_env.geometry import length
from soccer_env.types import NO_TEAM

TERMS = {
    "goal": "+1 when the own team scores, -1 when the opponents do",
    "progress": "potential: how much nearer the ball is to the opponent's goal than to the own, over twice the length",
    "approach": "potential: minus the distance of the team's nearest active robot from the ball, over the diagonal",
    "effort": "minus the mean square of forward, left and turn of the robot's command, at each step",
}
GOAL, PROGRESS, APPROACH, EFFORT = range(4)
WEIGHTS = np.dtype([(name, "f8") for name in TERMS] + [("gamma", "f8")])


@dataclass(frozen=True)
class Rewards:
    """Weights of the reward terms; the names are those of TERMS."""

    goal: float = 1.0
    progress: float = 0.5
    approach: float = 0.1
    effort: float = 0.001
    gamma: float = 0.99  # [1] discount of the shaping, for one action
    extra: dict[str, Callable[[Any], np.ndarray]] = field(default_factory=dict)
    """Terms of one's own: name -> function of the Match that returns (M, R) rewards, weight 1."""

    def __post_init__(self) -> None:
        for item in fields(self):
            value = getattr(self, item.name)
            if item.name != "extra" and not (isinstance(value, (int, float)) and isfinite(value)):
                raise ValueError(f"Rewards.{item.name} must be a finite number, got {value!r}")
        if not 0.0 <= self.gamma <= 1.0:
            raise ValueError(f"Rewards.gamma must be 0 to 1, got {self.gamma}")
        for name, term in self.extra.items():
            if not callable(term) or name in TERMS:
                raise ValueError(f"Rewards.extra[{name!r}] must be a function under a name of its own")

    def weights(self) -> np.ndarray:
        """Return the (1,) record of weights for compiled code."""
        return np.array([tuple(float(getattr(self, name)) for name in WEIGHTS.names or ())], WEIGHTS)


PRESETS = {"default": Rewards(), "sparse": Rewards(progress=0.0, approach=0.0, effort=0.0)}


def find_rewards(rewards: str | Rewards) -> Rewards:
    """Return the reward preset of that name, or the object itself; ValueError says which names exist."""
    if isinstance(rewards, Rewards):
        return rewards
    if not isinstance(rewards, str) or rewards not in PRESETS:
        raise ValueError(f"unknown rewards {rewards!r}; known: {', '.join(PRESETS)}, or a Rewards object")
    return PRESETS[rewards]


@compiled
def measure_potentials(match, ball, robots, k, potentials):
    """Write the potentials of both teams into potentials (2 teams, 2 terms); all 0 once the episode has ended."""
    if match.over == 1:
        for team in range(2):
            potentials[team, 0] = potentials[team, 1] = 0.0
        return
    half = 0.5 * k.pitch_length
    left, right = length(ball.x + half, ball.y), length(ball.x - half, ball.y)
    diagonal = sqrt(k.pitch_length * k.pitch_length + k.pitch_width * k.pitch_width)
    for team in range(2):
        potentials[team, 0] = direction_of(match, team) * (left - right) / (2.0 * k.pitch_length)
        potentials[team, 1] = -nearest_distance(ball, robots, team) / diagonal


@compiled
def nearest_distance(ball, robots, team):
    """Return the distance [m] of a team's nearest active robot from the ball, 0 if it has none."""
    least = inf
    for r in range(robots.shape[0]):
        if robots[r].team == team and robots[r].active == 1:
            x, y = robots[r].x - ball.x, robots[r].y - ball.y
            least = min(least, x * x + y * y)
    return 0.0 if least == inf else sqrt(least)


@compiled
def reward_robots(match, robots, events, before, after, weights, terms, rewards):
    """Write the weighted terms (R, 4) of each robot and add them to rewards (R,)."""
    for r in range(robots.shape[0]):
        team, command = robots[r].team, robots[r].command
        if events.goal != NO_TEAM:
            terms[r, GOAL] += weights.goal if events.goal == team else -weights.goal
        progress = weights.progress * (weights.gamma * after[team, 0] - before[team, 0])
        approach = weights.approach * (weights.gamma * after[team, 1] - before[team, 1])
        square = command.forward * command.forward + command.left * command.left + command.turn * command.turn
        terms[r, PROGRESS] += progress
        terms[r, APPROACH] += approach
        if match.placing == 0:  # the referee steers robots to their places, at no cost of theirs
            terms[r, EFFORT] -= weights.effort * square / 3.0
        rewards[r] = terms[r, GOAL] + terms[r, PROGRESS] + terms[r, APPROACH] + terms[r, EFFORT]
