"""The update of PPO: several passes over a rollout in gradient steps [Schulman et al. 2017].

Advantages have mean 0 and deviation 1 at each team size, and the errors of the critic are divided by the deviation of
the returns at their team size, so that sizes with few goals count as much as those with many. The actor's learning
rate follows the divergence of the policy, as in rsl_rl [Rudin et al. 2022].

A gradient step takes single decisions; with a memory it takes all decisions of some rows (robots), one after another,
and the error flows back through the whole rollout.
"""

from __future__ import annotations

import numpy as np
import torch
from torch import nn

from soccer_env.train.ppo.networks import SoccerPolicy
from soccer_env.train.ppo.settings import TrainSettings
from soccer_env.train.ppo.updating.distributions import NEVER, policy_of
from soccer_env.train.ppo.updating.rollout import Rollout, normalised, scales

CLIP = 0.2  # [1] range of the probability ratio around 1
MAX_NORM = 0.5  # of the gradient of the actor, and of that of the critic
EPSILON = 1e-5  # of Adam, as in most implementations of PPO
LEAST_SCALE = 0.05  # of the returns' deviation at a team size, assumed
RATES = (1e-5, 3e-3)  # the actor's learning rate stays within
ENTROPY = 0.002  # weight of the entropy of a choice among skills, assumed; numbers have noise of their own
STEP = 1.5  # factor by which it changes
Parts = tuple[torch.Tensor, ...]


def make_optimizer(network: SoccerPolicy, rate: float) -> torch.optim.Adam:
    """Return Adam over three groups of parameters: those of the actor, its noise, and those of the critic.

    The rate of the last two stays: at the rate that the actor's divergence allows, the noise would be gone too early.
    """
    *actor, noise = network.actor_parameters()
    groups = [actor, [noise], list(network.critic_net.parameters())]
    return torch.optim.Adam([{"params": group} for group in groups], lr=rate, eps=EPSILON)


def update(
    network: SoccerPolicy, optimizer: torch.optim.Adam, rollout: Rollout, settings: TrainSettings, actor: bool
) -> dict[str, float]:
    """Update actor and critic, without `actor` only the critic; return the statistics of the update by name."""
    parts = as_sequences(rollout, network)
    steps, count = parts[0].shape[:2]
    log_std = network.log_std.detach().clone()
    size = minibatch_size(count, settings.batch / steps)
    noted: list[tuple[float, ...]] = []  # value loss, divergence, clipped share of each gradient step
    for _ in range(settings.epochs):
        for chosen in torch.randperm(count).to(network.device).split(size):  # type: ignore[no-untyped-call]
            chosen_parts = [part[:, chosen] for part in parts]
            loss, kl, clipped = critic_loss(network, chosen_parts), torch.zeros(()), torch.zeros(())
            value_loss = loss.detach()
            if actor:
                states = rollout.states[:, chosen] if network.memory else None
                gain, kl, clipped = actor_gain(network, chosen_parts, states, log_std)
                loss = loss - gain
                follow_divergence(optimizer, float(kl), settings.target_kl)
            optimizer.zero_grad()
            loss.backward()  # type: ignore[no-untyped-call]  # torch gives it no return type
            for group in optimizer.param_groups:
                nn.utils.clip_grad_norm_(group["params"], MAX_NORM)
            optimizer.step()
            noted.append(tuple(float(number.detach()) for number in (value_loss, kl, clipped)))
    means, returns = np.mean(noted, axis=0).tolist(), rollout.returns
    return {
        **dict(zip(("value_loss", "kl", "clipped"), means, strict=True)),
        "explained": 1.0 - float(np.var(returns - rollout.values)) / max(float(np.var(returns)), 1e-12),
        "entropy": entropy_of(network, rollout), "noise": float(log_std.exp().mean()),
        "learning_rate": optimizer.param_groups[0]["lr"],
    }  # fmt: skip


def critic_loss(network: SoccerPolicy, parts: list[torch.Tensor]) -> torch.Tensor:
    """Return the mean square error of the critic, in deviations of the returns, on parts of `as_sequences`."""
    seen, _, _, _, _, returns, scale = (part.flatten(0, 1) for part in parts)
    return (((network.values(seen) - returns) / scale) ** 2).mean()


def actor_gain(
    network: SoccerPolicy, parts: list[torch.Tensor], states: torch.Tensor | None, log_std: torch.Tensor
) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
    """Return the clipped gain of the actor on parts of `as_sequences`, its divergence, and the share that is clipped.

    states: of its memory before the first decisions.
    """
    _, _, outputs, actions, gains, _, _ = (part.flatten(0, 1) for part in parts)
    played, _ = network.outputs(parts[0], states, parts[1])
    masks = outputs > 0.5 * NEVER if network.chooses_skills else None
    old, new = policy_of(outputs, log_std, masks), policy_of(played.flatten(0, 1), network.log_std, masks)
    ratio = (new.log_prob(actions) - old.log_prob(actions)).exp()
    clamped = ratio.clamp(1.0 - CLIP, 1.0 + CLIP)
    gain = torch.min(ratio * gains, clamped * gains).mean()
    if network.chooses_skills:
        gain = gain + ENTROPY * new.entropy()
    return gain, new.divergence(old), (ratio != clamped).float().mean()


def as_sequences(rollout: Rollout, network: SoccerPolicy) -> Parts:
    """Return observations, begins, means, actions, advantages, returns and their scales as tensors (steps, rows, ...).

    begins: flags of decisions that begin an episode. Without a memory every decision is a row of one step.
    """
    shape = rollout.dones.shape if network.memory else (1, -1)
    begins = np.concatenate([np.zeros_like(rollout.dones[:1]), rollout.dones[:-1]])
    scale = scales(rollout.returns, rollout.groups, LEAST_SCALE)
    arrays = (
        rollout.observations, begins, rollout.outputs, rollout.actions, normalised(rollout.advantages, rollout.groups),
        rollout.returns, np.broadcast_to(scale, rollout.returns.shape),
    )  # fmt: skip
    return tuple(
        torch.as_tensor(np.ascontiguousarray(array).reshape(*shape, *array.shape[2:]), device=network.device)
        for array in arrays
    )


def entropy_of(network: SoccerPolicy, rollout: Rollout) -> float:
    """Return the mean entropy of the actions of a rollout."""
    outputs = torch.as_tensor(rollout.outputs).flatten(0, 1)
    masks = outputs > 0.5 * NEVER if network.chooses_skills else None
    return float(policy_of(outputs, network.log_std.detach().cpu(), masks).entropy())


def follow_divergence(optimizer: torch.optim.Adam, kl: float, target: float) -> None:
    """Change the actor's learning rate by a factor where the divergence is far from its target."""
    group, (least, most) = optimizer.param_groups[0], RATES
    if kl > 2.0 * target:
        group["lr"] = max(group["lr"] / STEP, least)
    elif 0.0 < kl < 0.5 * target:
        group["lr"] = min(group["lr"] * STEP, most)


def minibatch_size(rows: int, batch: float) -> int:
    """Return a batch size near `batch` that divides the rows of a rollout into nearly equal parts."""
    parts = max(1, round(rows / batch))
    return -(-rows // parts)
