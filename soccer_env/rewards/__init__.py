"""Reward terms: one row of TERMS each, from which weights, sums, infos, lists and training settings follow.

    table.py    the terms, their weights and presets
    terms.py    what each of them measures
    paying.py   kernels that pay robots

    potential   function(match, ball, robots, k, team) -> the potential of a team
    event       function(match, ball, robots, events, robot_events, k, r, weight) -> what robot r gets in this step
    cost        the same, and robot r pays it

Shaping is potential-based [Ng, Harada, Russell 1999]: gamma * phi(s') - phi(s), with s' the state that the next
observation shows (after a restart, if one was carried out) and phi = 0 once the episode has ended. It sums to zero
over a loop and cannot be farmed; a goal therefore also pays back the potential that led to it. Where an action is kept
for several control steps, s and s' are the states before and after all of them.
"""

from soccer_env.rewards.paying import make_pay, measure_potentials, reward_robots
from soccer_env.rewards.table import (
    COUNT,
    KINDS,
    NAMES,
    POTENTIALS,
    PRESETS,
    TERMS,
    WEIGHTS,
    OwnTerm,
    Rewards,
    Term,
    find_rewards,
)

__all__ = [
    "COUNT", "KINDS", "NAMES", "POTENTIALS", "PRESETS", "TERMS", "WEIGHTS", "OwnTerm", "Rewards", "Term",
    "find_rewards", "make_pay", "measure_potentials", "reward_robots",
]  # fmt: skip
