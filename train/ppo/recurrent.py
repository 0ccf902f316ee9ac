"""An actor with a recurrent memory: its rollouts are learned from as sequences, not as single decisions.

The memory is a GRU between what the actor reads and its layers (`agents.recurrent`). The critic, which may see the
truth, has none. A minibatch of PPO has all decisions that some rows of a rollout took, one after the other, from the
states with which the rollout began; where an episode begins, or while a robot is sent off, the state is 0. In a fit to
advice the error flows back through BACK decisions, and the state goes on from one such piece of an episode to the next
[truncated backpropagation through time: Williams, Peng 1990].
"""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.buffers import RolloutBuffer
from stable_baselines3.common.type_aliases import RolloutBufferSamples

from soccer_env.agents.recurrent import ACTIVE
from soccer_env.train.ppo.networks import SoccerPolicy

BACK = 64  # decisions through which the error of a fit flows back


class Sequences(NamedTuple):
    """Decisions of rows, one after the other."""

    observations: torch.Tensor  # (steps, rows, n), or more entries than the actor reads
    begins: torch.Tensor  # (steps, rows) flags: an episode begins
    states: torch.Tensor  # (images, rows, units) before the first; with a mirror two images


class RecurrentPolicy(SoccerPolicy):
    """`SoccerPolicy` with a memory, which goes on with every call of `forward` and with sequences elsewhere."""

    model: PPO  # whose rollout it plays: an episode begins in its rows `_last_episode_starts`

    def states_of(self, rows: int) -> torch.Tensor:
        """Return the present states (images, rows, units), 0 before the first decision."""
        if self.states is None or self.states.shape[1] != rows:
            return torch.zeros(1 + self.mirror, rows, self.memory, device=self.device)
        return self.states

    def remember(self, given: Sequences) -> tuple[torch.Tensor, torch.Tensor]:
        """Return the last hidden layer (images x steps x rows, h) of the actor, and the states after the last step."""
        actor, (steps, rows, _), states = self.mlp_extractor, given.observations.shape, given.states
        read = actor.read(given.observations.flatten(0, 1))
        by_step = read.view(len(states), steps, rows, -1)
        names = [entry.name for entry in self.entries]
        anew = given.begins
        if ACTIVE in names:
            anew = anew | (given.observations[..., names.index(ACTIVE)] < 0.0)
        kept = []
        for step in range(steps):
            states = states.masked_fill(anew[step][None, :, None], 0.0)
            states = actor.memory(by_step[:, step].flatten(0, 1), states.flatten(0, 1)).view_as(states)
            kept.append(states)
        remembered = torch.stack(kept, dim=1).flatten(0, 2)
        return actor.policy_net(torch.cat([read, remembered], dim=1)), states

    def forward(
        self, obs: torch.Tensor, deterministic: bool = False
    ) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
        """Return actions (rows, a), values and log-probabilities for one more decision of all rows (rows, n)."""
        begins = torch.as_tensor(np.asarray(self.model._last_episode_starts, bool), device=obs.device)
        latent, self.states = self.remember(Sequences(obs[None], begins[None], self.states_of(len(obs))))
        chances = self._get_action_dist_from_latent(latent)
        actions = chances.get_actions(deterministic=deterministic)
        return actions, self.value_net(self.mlp_extractor.forward_critic(obs)), chances.log_prob(actions)

    def evaluate_actions(self, obs: Any, actions: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor, Any]:
        """Return values, log-probabilities and entropies (steps x rows,) of the actions in `Sequences`."""
        latent, _ = self.remember(obs)
        chances = self._get_action_dist_from_latent(latent)
        values = self.value_net(self.mlp_extractor.forward_critic(obs.observations.flatten(0, 1)))
        return values, chances.log_prob(actions), chances.entropy()

    def answers(
        self, observations: torch.Tensor, asked: torch.Tensor, batch: int, generator: torch.Generator
    ) -> Iterator[tuple[torch.Tensor, torch.Tensor]]:
        """Yield (mean actions, asked actions) of about `batch` decisions of episodes (steps, rows, ...) after another.

        Episodes come in a random order, their pieces in their own; nothing is asked where `asked` is NaN.
        """
        order = torch.randperm(observations.shape[1], generator=generator)
        for rows in torch.split(order, max(1, batch // BACK)):
            states = torch.zeros(1 + self.mirror, len(rows), self.memory, device=self.device)
            for first in range(0, len(observations), BACK):
                seen, wanted = (part[first : first + BACK, rows].to(self.device) for part in (observations, asked))
                begins = torch.zeros(seen.shape[:2], dtype=torch.bool, device=self.device)
                latent, states = self.remember(Sequences(seen, begins, states.detach()))
                played = wanted[..., 0].isfinite()
                if played.any():
                    actions = self.action_net(latent)
                    yield actions.view_as(wanted)[played], wanted[played]


class SequenceBuffer(RolloutBuffer):
    """A rollout whose minibatches are all decisions of some of its rows, as `Sequences`."""

    network: RecurrentPolicy | None = None

    def reset(self) -> None:
        """Empty the buffer, and note the states with which the next rollout begins."""
        super().reset()
        self.first = None if self.network is None else self.network.states_of(self.n_envs)

    def get(self, batch_size: int | None = None) -> Iterator[RolloutBufferSamples]:  # type: ignore[override]
        """Yield minibatches of about `batch_size` decisions, in a random order of the rows."""
        whole = self.buffer_size * self.n_envs
        count = min(self.n_envs, max(1, round(whole / (batch_size or whole))))
        for rows in np.array_split(np.random.permutation(self.n_envs), count):
            yield self._samples_of(rows)

    def _samples_of(self, rows: np.ndarray) -> RolloutBufferSamples:
        """Return the samples of some rows, step after step."""
        assert self.first is not None

        def part(array: np.ndarray) -> torch.Tensor:
            return self.to_torch(array[:, rows])

        numbers = (self.actions, self.values, self.log_probs, self.advantages, self.returns)
        given: Any = Sequences(part(self.observations), part(self.episode_starts) > 0.0, self.first[:, rows])
        return RolloutBufferSamples(given, *(part(array).flatten(0, 1) for array in numbers))


def connect_memory(model: PPO) -> None:
    """Let a policy with a memory know where episodes begin in its rollouts, and the rollouts its states."""
    if isinstance(model.policy, RecurrentPolicy) and isinstance(model.rollout_buffer, SequenceBuffer):
        object.__setattr__(model.policy, "model", model)
        model.rollout_buffer.network = model.policy
