"""Pay robots: kernels that measure the potentials of both teams and add up the weighted terms of each robot.

`k`: the league's constants.
"""

from __future__ import annotations

from collections.abc import Callable

from soccer_env.compiled import compiled
from soccer_env.rewards.table import COUNT, TERMS, Term

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
