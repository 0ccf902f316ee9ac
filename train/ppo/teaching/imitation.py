"""Lessons by imitation: a scripted teacher's decisions are recorded, and the actor is fitted to them before rewards.

The teacher plays home with the learner's senses. At each decision of the learner, its observation is recorded with the
teacher's walk at this moment, and the teacher's strongest kick until the next decision.
"""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import torch

from soccer_env.agents.learned import first_decision_step
from soccer_env.match import Match
from soccer_env.observations.entry import OWN_COMMAND, Entry
from soccer_env.train.ppo.networks import SoccerPolicy
from soccer_env.train.ppo.settings import TrainSettings

Rows = tuple[np.ndarray, np.ndarray]  # observations (n, entries), actions (n, 4)
WALK = ("forward", "left", "turn")
NO_KICK = -0.4  # near enough to a kick (0.3) for a learner's noise to find one; with -1 it never did
HOLD_RATE = 1e-4  # learning rate of the fits between updates at the start, HOLD_PARTS of HOLD_PART rows each time
HOLD_PARTS, HOLD_PART = 8, 4096


def record(
    teacher: Any, opponents: Any, players: tuple[int, int], decisions: int, repeat: int, **settings: Any
) -> tuple[np.ndarray, np.ndarray]:
    """Record observations (n, entries) and actions (n, 4) of a teacher's home robots; `settings` go to `Match`."""
    home, away = players
    match = Match(
        home=home, away=away, controllers={"home": teacher, "away": opponents}, autoreset="same_step", **settings
    )
    for _ in range(first_decision_step(match.league.delay_steps, repeat)):
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


def mean_square(actions: torch.Tensor, asked: torch.Tensor) -> torch.Tensor:
    """Return the mean square error of actions (n, 4) against the teacher's actions `asked`."""
    return ((actions - asked) ** 2).mean()


def fit(
    network: SoccerPolicy, observations: np.ndarray, actions: np.ndarray, epochs: int, seed: int,
    advance: Callable[[float], None] = lambda share: None, rate: float = 1e-3, batch: int = 4096,
    error: Callable[[torch.Tensor, torch.Tensor], torch.Tensor] = mean_square,
) -> list[float]:  # fmt: skip
    """Fit the actor to recorded decisions, or with a memory to whole episodes; return the mean error of each epoch."""
    rows = torch.as_tensor(observations), torch.as_tensor(actions)
    optimizer = torch.optim.Adam(network.actor_parameters()[:-1], lr=rate)
    generator = torch.Generator().manual_seed(seed)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, epochs, eta_min=0.05 * rate)
    errors = []
    for _ in range(epochs):
        count, total = 0, 0.0
        for answered, asked in network.answers(*rows, batch, generator):
            missed = error(answered, asked)
            optimizer.zero_grad()
            missed.backward()  # type: ignore[no-untyped-call]  # torch gives it no return type
            optimizer.step()
            total += float(missed.detach()) * len(asked)
            count += len(asked)
        schedule.step()
        errors.append(total / count)
        advance(1.0 / epochs)
    return errors


def imitation_weight(settings: TrainSettings, step: int) -> float:
    """Return the weight of the imitation loss after `step` steps: it falls linearly from 1 to 0."""
    last = settings.teacher_until * settings.steps
    return max(1.0 - step / last, 0.0) if settings.teacher and last > 0.0 else 0.0


def fit_a_little(network: SoccerPolicy, rows: Rows, strength: float, seed: int) -> None:
    """Take a few gradient steps towards the recorded decisions, so that the actor does not forget rare kicks.

    The optimiser is made anew each time, so that checkpoints need not keep it.
    """
    optimizer = torch.optim.Adam(network.actor_parameters()[:-1], lr=HOLD_RATE * strength)
    chosen = np.random.default_rng(seed).integers(0, len(rows[0]), (HOLD_PARTS, HOLD_PART))
    for part in chosen:
        seen, asked = (torch.as_tensor(kept[part]).to(network.device) for kept in rows)
        error = ((network.mean_actions(seen) - asked) ** 2).mean()
        optimizer.zero_grad()
        error.backward()  # type: ignore[no-untyped-call]  # torch gives it no return type
        optimizer.step()


def permute_own_commands(observations: np.ndarray, entries: Sequence[Entry], seed: int) -> None:
    """Shuffle the entries for the robot's last command over all rows, in place, to remove their information.

    A teacher decides at every control step, so its last command nearly determines the next, and a pupil that sees it
    learns to repeat it [the copycat problem: de Haan, Jayaraman, Levine 2019].
    """
    columns = [index for index, entry in enumerate(entries) if entry.group == OWN_COMMAND]
    order = np.random.default_rng(seed).permutation(len(observations))
    observations[:, columns] = observations[order][:, columns]
