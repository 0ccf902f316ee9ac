"""Kernels that measure the potentials of both teams and add up the weighted terms of each robot.

`k`: the league's constants.
"""

from collections.abc import Callable

from soccer_env.compiled import compiled, inlined
from soccer_env.rewards.table import COUNT, TERMS, Term

# Each kernel calls the kernel of the terms before its own. All are inlined: passing seven arrays would cost more than
# the work. A term of weight 0 costs one comparison.


def make_potential_kernel(terms: tuple[Term, ...]) -> Callable[..., None]:
    """Return a kernel that writes a team's row of the potentials (2, potentials), one column for each term."""

    @inlined
    def measure(match, ball, robots, k, team, weights, potentials):
        pass

    potential = [(column, term) for column, term in enumerate(terms) if term.kind == "potential"]
    for index, (column, term) in enumerate(potential):
        measure = add_potential(measure, column, index, term.function)
    return measure


def add_potential(measure_others, column, index, function):
    """Extend the kernel `measure_others` by one potential; the potential is 0 if its weight is 0."""

    @inlined
    def measure(match, ball, robots, k, team, weights, potentials):
        measure_others(match, ball, robots, k, team, weights, potentials)
        weighs = weights.term[column] != 0.0
        potentials[team, index] = function(match, ball, robots, k, team) if weighs else 0.0

    return measure


def make_reward_kernel(terms: tuple[Term, ...]) -> Callable[..., None]:
    """Return a kernel that adds each robot's reward terms to an array (R, terms or more), one column for each term."""

    @inlined
    def pay(match, ball, robots, events, robot_events, k, before, after, weights, paid):
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
    """Extend the kernel `pay_others` by the shaping reward of one potential, for each robot."""

    @inlined
    def pay(match, ball, robots, events, robot_events, k, before, after, weights, paid):
        pay_others(match, ball, robots, events, robot_events, k, before, after, weights, paid)
        weight = weights.term[column]
        if weight == 0.0:
            return
        for r in range(robots.shape[0]):
            team = robots[r].team
            paid[r, column] += weight * (weights.gamma * after[team, index] - before[team, index])

    return pay


def add_event(pay_others, column, function, sign):
    """Extend the kernel `pay_others` by an event term (sign 1) or a cost term (sign -1), for each robot."""

    @inlined
    def pay(match, ball, robots, events, robot_events, k, before, after, weights, paid):
        pay_others(match, ball, robots, events, robot_events, k, before, after, weights, paid)
        weight = weights.term[column]
        if weight == 0.0:
            return
        for r in range(robots.shape[0]):
            paid[r, column] += sign * function(match, ball, robots, events, robot_events, k, r, weight)

    return pay


measure_team = make_potential_kernel(TERMS)
pay_robots = make_reward_kernel(TERMS)


@compiled
def measure_potentials(match, ball, robots, k, weights, potentials):
    """Write the potentials of both teams into an array of shape POTENTIALS."""
    for team in range(2):
        measure_team(match, ball, robots, k, team, weights, potentials)


@compiled
def reward_robots(match, ball, robots, events, robot_events, k, before, after, weights, terms, rewards):
    """Add the weighted terms of each robot to terms (R, COUNT or more), and write their sums into rewards (R,)."""
    pay_robots(match, ball, robots, events, robot_events, k, before, after, weights, terms)
    for r in range(robots.shape[0]):
        total = 0.0
        for column in range(COUNT):
            total += terms[r, column]
        rewards[r] = total
