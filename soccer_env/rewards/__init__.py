"""Reward terms: each is a row of TERMS, which defines its weight, function, infos, lists and training settings.

    table.py    the terms, their weights and presets
    terms.py    the function of each term
    paying.py   kernels that add up the rewards

    potential   function(match, ball, robots, k, team) -> the potential of a team
    event       function(match, ball, robots, events, robot_events, k, r, weight) -> reward of robot r in this step
    cost        function with the arguments of an event -> cost of robot r in this step

A term that goes on, such as `effort`, pays a rate: its weight is a second's, and its function multiplies by `k.dt`.

Shaping is potential-based [Ng, Harada, Russell 1999]: gamma * phi(s') - phi(s), with s' the state that the next
observation shows (after a restart, if there was one) and phi = 0 once the episode has terminated; a truncation leaves
phi, for a learner that bootstraps. Shaping sums to zero over a loop, so that it cannot be farmed; a goal therefore also
takes back the potential that led to it. If an action lasts several control steps, s and s' are the states before the
first and after the last.
"""

from soccer_env.rewards.paying import make_reward_kernel, measure_potentials, reward_robots
from soccer_env.rewards.table import (
    COUNT,
    KINDS,
    KINDS_OF_PLAYERS,
    NAMES,
    POTENTIALS,
    PRESETS,
    TERMS,
    WEIGHTS,
    OwnTerm,
    Rewards,
    Term,
    earnings,
    find_rewards,
)

__all__ = [
    "COUNT", "KINDS", "KINDS_OF_PLAYERS", "NAMES", "POTENTIALS", "PRESETS", "TERMS", "WEIGHTS", "OwnTerm", "Rewards",
    "Term", "earnings", "find_rewards", "make_reward_kernel", "measure_potentials", "reward_robots",
]  # fmt: skip
