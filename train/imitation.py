"""Learn from a scripted teacher before learning from rewards: its decisions are recorded and the actor fitted to them.

The teacher plays home, by the same senses as the learner will; what is recorded at each of the learner's decisions is
the learner's observation and the walk that the teacher asked for at that moment, with the strongest kick of the time
until the next decision.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import torch

from soccer_env.agents.learned import first_decision
from soccer_env.match import Match
from soccer_env.train.networks import SoccerPolicy

WALK = ("forward", "left", "turn")
NO_KICK = -1.0


def record(
    teacher: Any, opponents: Any, players: tuple[int, int], decisions: int, repeat: int, **settings: Any
) -> tuple[np.ndarray, np.ndarray]:
    """Return observations (n, entries) and actions (n, 4) of a teacher's home robots; settings are those of `Match`."""
    home, away = players
    match = Match(
        home=home, away=away, controllers={"home": teacher, "away": opponents}, autoreset="same_step", **settings
    )
    for _ in range(first_decision(match.league.delay_steps, repeat)):
        match.step()
    observations, actions = [], []
    for _ in range(decisions):
        observations.append(match.observations[:, :home].copy())
        for step in range(repeat):
            match.step()
            command = match.robots["command"][:, :home]
            if step == 0:
                asked = np.stack([command[name] for name in WALK] + [np.full(command.shape, NO_KICK)], axis=-1)
            kicks = np.where(command["kick"] > 0.0, command["kick"], NO_KICK)
            asked[..., 3] = np.maximum(asked[..., 3], kicks)
        actions.append(asked)
    match.close()
    width = observations[0].shape[-1]
    return np.concatenate(observations).reshape(-1, width), np.concatenate(actions).reshape(-1, 4).astype(np.float32)


def fit(
    network: SoccerPolicy, observations: np.ndarray, actions: np.ndarray, epochs: int, seed: int,
    advance: Callable[[float], None] = lambda share: None, rate: float = 1e-3, batch: int = 4096,
) -> list[float]:  # fmt: skip
    """Fit the actor to recorded decisions by least squares; return the mean square error of each epoch."""
    rows = torch.as_tensor(observations), torch.as_tensor(actions)
    optimizer = torch.optim.Adam(network.actor_parameters()[:-1], lr=rate)
    generator = torch.Generator().manual_seed(seed)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, epochs, eta_min=0.05 * rate)
    errors = []
    for _ in range(epochs):
        order, total = torch.randperm(len(observations), generator=generator), 0.0
        for first in range(0, len(order), batch):
            chosen = order[first : first + batch]
            error = ((network.mean_actions(rows[0][chosen]) - rows[1][chosen]) ** 2).mean()
            optimizer.zero_grad()
            error.backward()
            optimizer.step()
            total += float(error.detach()) * len(chosen)
        schedule.step()
        errors.append(total / len(order))
        advance(1.0 / epochs)
    return errors


def gather(parts: Sequence[tuple[np.ndarray, np.ndarray]]) -> tuple[np.ndarray, np.ndarray]:
    """Return several recordings as one."""
    return np.concatenate([part[0] for part in parts]), np.concatenate([part[1] for part in parts])
