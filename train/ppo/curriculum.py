"""The choice of opponents among scripted teams, policy files and past selves; even match-ups are the most frequent.

Each opponent has the learner's recent share of points against it, and a rating (OpenSkill's Plackett-Luce model); both
follow from the results of episodes and are kept with the run's checkpoints.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from openskill.models import PlackettLuce

from soccer_env.agents.learned import team_from_policy
from soccer_env.agents.perceptron import pack_policy
from soccer_env.agents.policy import Policy
from soccer_env.teams import Lineup

MEMORY = 0.95  # weight of the earlier share of points after a result
LEAST = 0.1  # share of the episodes of an opponent against which the learner always or never wins
LEARNER = "learner"


@dataclass
class OpponentStanding:
    """The learner's results and rating against one opponent."""

    points: float = 0.5  # recent share of points that the learner won
    episodes: int = 0
    mu: float = 25.0  # rating of the opponent
    sigma: float = 25.0 / 3.0


class Curriculum:
    """The opponents of a run, with their weights; `lineup` draws one opponent for each episode by these weights."""

    def __init__(self, names: Sequence[str], past: int, first: Policy) -> None:
        self.past_names = [f"past-{index}" for index in range(past)]
        self.names = [*names, *self.past_names]
        self._past = [team_from_policy(first) for _ in self.past_names]
        self.filled = [0] * past  # the step at which each past self was taken, 0: not yet
        self.leaving = dict.fromkeys(self.past_names, 0)  # running episodes against a replaced past self
        self.standings = {name: OpponentStanding() for name in (LEARNER, *self.names)}
        self.lineup = Lineup([*names, *self._past], names=self.names)
        self.model = PlackettLuce()
        self.met = tuple(names)  # opponents of the present stage, besides past selves
        self._update_weights()

    def begin_stage(self, names: Sequence[str]) -> None:
        """Meet only these opponents and past selves from the next episodes on."""
        self.met = tuple(names)
        self._update_weights()

    def take(self, results: Iterable[Any]) -> None:
        """Update the opponents' standings and weights by the results of finished episodes."""
        for result in results:
            if self.leaving.get(result.opponent, 0) > 0:
                self.leaving[result.opponent] -= 1
                continue
            opponent, learner = self.standings[result.opponent], self.standings[LEARNER]
            opponent.points = MEMORY * opponent.points + (1.0 - MEMORY) * result.points
            opponent.episodes += 1
            learner.episodes += 1
            ranks = [1.0 - result.points, result.points]
            sides = [[self.model.rating(mu=side.mu, sigma=side.sigma)] for side in (learner, opponent)]
            for side, (rated,) in zip((learner, opponent), self.model.rate(sides, ranks=ranks), strict=True):
                side.mu, side.sigma = rated.mu, rated.sigma
        self._update_weights()

    def add_past(self, policy: Policy, step: int, playing: Sequence[str] = ()) -> None:
        """Replace the oldest past self by `policy`, the present learner, even in running episodes.

        `playing` names the opponents of the running episodes: results against the replaced self will not count.
        """
        if self._past:
            oldest = int(np.argmin(self.filled))
            self._past[oldest].settings[:] = pack_policy(policy)
            self.filled[oldest] = step
            self.leaving[self.past_names[oldest]] = sum(name == self.past_names[oldest] for name in playing)
            learner = self.standings[LEARNER]
            self.standings[self.past_names[oldest]] = OpponentStanding(mu=learner.mu, sigma=learner.sigma)
            self._update_weights()

    def state(self) -> dict[str, Any]:
        """Return the standings and the past selves, for a checkpoint."""
        standings = {name: vars(standing).copy() for name, standing in self.standings.items()}
        numbers = [team.settings.copy() for team in self._past]
        return {"standings": standings, "filled": list(self.filled), "past": numbers, "leaving": dict(self.leaving)}

    def restore(self, state: dict[str, Any]) -> None:
        """Restore the standings and the past selves from a checkpoint (a result of `state`)."""
        self.standings = {name: OpponentStanding(**values) for name, values in state["standings"].items()}
        self.filled, self.leaving = list(state["filled"]), dict(state["leaving"])
        for team, numbers in zip(self._past, state["past"], strict=True):
            team.settings[:] = numbers
        self._update_weights()

    def _update_weights(self) -> None:
        """Set the opponents' shares: LEAST each, the rest in proportion to p (1 - p); p: the learner's share of points.

        Past selves share one such part.
        """
        selves = [name for name, step in zip(self.past_names, self.filled, strict=True) if step]
        parts = [[name] for name in self.met] + [selves] * bool(selves)
        points = [np.mean([self.standings[name].points for name in part]) for part in parts]
        even = np.array([share * (1.0 - share) + 1e-6 for share in points])
        least = min(LEAST, 1.0 / len(parts))
        shares = least + (1.0 - least * len(parts)) * even / even.sum()
        self.lineup.weights[:] = 0.0
        for part, share in zip(parts, shares, strict=True):
            self.lineup.weights[[self.names.index(name) for name in part]] = share / len(part)
