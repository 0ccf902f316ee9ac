"""Lessons by imitation: a scripted teacher's decisions are recorded, and the actor is fitted to them before rewards.

The teacher plays home with the learner's senses. At each decision of the learner, its observation is recorded with the
teacher's walk at this moment, and the teacher's strongest kick until the next decision.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
import torch

from soccer_env.agents.learned import first_decision_step
from soccer_env.match import Match
from soccer_env.observations.entry import OWN_COMMAND, Entry
from soccer_env.train.ppo.networks import SoccerPolicy

Rows = tuple[np.ndarray, np.ndarray]  # observations (n, entries), actions (n, 4); of episodes (steps, rows, ...)
WALK = ("forward", "left", "turn")
BACK = 64  # steps through which the error of a fit flows back in a memory
NO_KICK = -0.4  # near enough to a kick (0.3) for a learner's noise to find one; with -1 it never did


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
    steps = len(observations) if network.memory else 1
    seen, wanted = (torch.as_tensor(part).reshape(steps, -1, part.shape[-1]) for part in (observations, actions))
    optimizer = torch.optim.Adam(network.actor_parameters()[:-1], lr=rate)
    generator = torch.Generator().manual_seed(seed)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, epochs, eta_min=0.05 * rate)
    errors = []
    for _ in range(epochs):
        count, total = 0, 0.0
        for answered, asked in answers(network, seen, wanted, batch, generator):
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


def answers(
    network: SoccerPolicy, observations: torch.Tensor, asked: torch.Tensor, batch: int, generator: torch.Generator
) -> Iterator[tuple[torch.Tensor, torch.Tensor]]:
    """Yield the actor's and the asked actions (n, 4) of about `batch` decisions at a time, of rows in a random order.

    observations: (steps, rows, entries); asked: (steps, rows, 4), NaN where nothing is asked. Of a memory the error
    flows back through BACK steps; the state goes on from one such piece of an episode to the next [truncated
    backpropagation through time: Williams, Peng 1990].
    """
    order = torch.randperm(observations.shape[1], generator=generator)
    for rows in torch.split(order, max(1, batch // BACK) if network.memory else batch):
        states = network.no_states(len(rows))
        for first in range(0, len(observations), BACK):
            seen, wanted = (part[first : first + BACK, rows].to(network.device) for part in (observations, asked))
            actions, states = network.mean_actions(seen, states.detach())
            played = wanted[..., 0].isfinite()
            if played.any():
                yield actions[played], wanted[played]


def permute_own_commands(observations: np.ndarray, entries: Sequence[Entry], seed: int) -> None:
    """Shuffle the entries for the robot's last command over all rows, in place, to remove their information.

    A teacher decides at every control step, so its last command nearly determines the next, and a pupil that sees it
    learns to repeat it [the copycat problem: de Haan, Jayaraman, Levine 2019].
    """
    columns = [index for index, entry in enumerate(entries) if entry.group == OWN_COMMAND]
    order = np.random.default_rng(seed).permutation(len(observations))
    observations[:, columns] = observations[order][:, columns]
