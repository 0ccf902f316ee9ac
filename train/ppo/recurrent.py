"""The memory of an actor in training: a GRU before the actor's layers, by the equations of `agents.recurrent`.

The critic, which may see the truth, has none. T decisions of N rows (robots); with a mirror the memory has two images,
of the observations and of their mirror images, otherwise one.
"""

from collections.abc import Sequence

import torch
from torch import nn

from soccer_env.agents.recurrent import ACTIVE
from soccer_env.observations import Entry


class Memory(nn.Module):
    """A GRU over sequences of decisions, whose state is 0 where an episode begins and while a robot is sent off."""

    def __init__(self, entries: Sequence[Entry], features: int, units: int) -> None:
        super().__init__()
        self.units = units
        self.cell = nn.GRUCell(features, units)
        self.active = next((index for index, entry in enumerate(entries) if entry.name == ACTIVE), None)

    def forward(
        self, read: torch.Tensor, states: torch.Tensor, observations: torch.Tensor, begins: torch.Tensor | None
    ) -> tuple[torch.Tensor, torch.Tensor]:
        """Return what is read (images x T x N, f) followed by the states (..., f + units), and the last states.

        states: (images, N, units) before the first decision; observations: (T, N, n or more); begins: (T, N) flags of
        decisions that begin an episode, None for none.
        """
        forget = torch.zeros_like(observations[..., 0], dtype=torch.bool) if begins is None else begins
        if self.active is not None:
            forget = forget | (observations[..., self.active] < 0.0)
        by_step = read.view(len(states), *forget.shape, -1)
        kept = []
        for step in range(len(forget)):
            states = states.masked_fill(forget[step][None, :, None], 0.0)
            states = self.cell(by_step[:, step].flatten(0, 1), states.flatten(0, 1)).view_as(states)
            kept.append(states)
        return torch.cat([read, torch.stack(kept, dim=1).flatten(0, 2)], dim=1), states

    def tensors(self) -> list[torch.Tensor]:
        """Return the parameters, in the order of `agents.recurrent.TENSORS`."""
        return [self.cell.weight_ih, self.cell.bias_ih, self.cell.weight_hh, self.cell.bias_hh]
