"""What a policy draws its actions from: normal distributions of numbers, or the chances of skills.

B decisions, a numbers in an action, n skills.
"""

from __future__ import annotations

from math import e, log, pi
from typing import Any, NamedTuple

import torch

NEVER = -1e8  # output of a skill that does not apply


class Normal(NamedTuple):
    """Independent normal distributions of the numbers of an action."""

    means: torch.Tensor  # (B, a)
    std: torch.Tensor  # (a,)

    def draw(self) -> torch.Tensor:
        """Return actions (B, a) drawn at random."""
        return self.means + self.std * torch.randn_like(self.means)

    def log_prob(self, actions: torch.Tensor) -> torch.Tensor:
        """Return the logarithm of the density of actions (B, a), without the constant that all policies share: (B,)."""
        density: torch.Tensor = -0.5 * ((actions - self.means) / self.std) ** 2 - self.std.log()
        return density.sum(1)

    def entropy(self) -> torch.Tensor:
        """Return the entropy of an action in nats."""
        return (self.std.log() + 0.5 * log(2.0 * pi * e)).sum()

    def divergence(self, old: Any) -> torch.Tensor:
        """Return the Kullback-Leibler divergence of this policy from an old one, KL(old | this), mean of all rows."""
        with torch.no_grad():
            square = old.std**2 + (old.means - self.means) ** 2
            found: torch.Tensor = ((self.std / old.std).log() + 0.5 * square / self.std**2 - 0.5).sum(1).mean()
            return found


class Skills(NamedTuple):
    """The chances of skills, as the logarithms of numbers that they are proportional to; NEVER where none applies."""

    outputs: torch.Tensor  # (B, n)

    def draw(self) -> torch.Tensor:
        """Return skills (B, 1) drawn at random, as numbers."""
        return torch.multinomial(self.outputs.softmax(1), 1).float()

    def log_prob(self, actions: torch.Tensor) -> torch.Tensor:
        """Return the logarithm of the chance of skills (B, 1): (B,)."""
        return self.outputs.log_softmax(1).gather(1, actions.long())[:, 0]

    def entropy(self) -> torch.Tensor:
        """Return the entropy of a choice in nats, mean of all rows."""
        logs = self.outputs.log_softmax(1)
        return -(logs.exp() * logs).sum(1).mean()

    def divergence(self, old: Any) -> torch.Tensor:
        """Return the Kullback-Leibler divergence of this policy from an old one, KL(old | this), mean of all rows."""
        with torch.no_grad():
            logs = old.outputs.log_softmax(1)
            found: torch.Tensor = (logs.exp() * (logs - self.outputs.log_softmax(1))).sum(1).mean()
            return found


def policy_of(outputs: torch.Tensor, log_std: torch.Tensor, masks: torch.Tensor | None) -> Normal | Skills:
    """Return what the outputs (B, a or n) of an actor stand for; masks (B, n): 1 for skills that apply."""
    if masks is None:
        return Normal(outputs, log_std.exp())
    return Skills(outputs.masked_fill(masks == 0, NEVER))
