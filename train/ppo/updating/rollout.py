"""A rollout: what the robots of all matches saw, did and were paid between two updates, and their advantages.

T decisions of N robots (rows), n numbers seen, a numbers in an action.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import torch

from soccer_env.train.ppo.networks import SoccerPolicy
from soccer_env.train.ppo.updating.distributions import policy_of
from soccer_env.train.ppo.updating.matches import Matches

CHUNK = 16_384  # rows in a pass of a network over a rollout
LEAST_SCALE = 1e-6  # of a standard deviation


class Start(NamedTuple):
    """The observations and states with which a rollout begins."""

    seen: np.ndarray  # (N, n)
    states: torch.Tensor  # (images, N, units) of the actor's memory


@dataclass
class Rollout:
    """The arrays of a rollout, of single precision."""

    observations: np.ndarray  # (T, N, n)
    outputs: np.ndarray  # (T, N, a) of the actor: means of the numbers, or NEVER for skills that do not apply
    actions: np.ndarray  # (T, N, a) drawn from them, not clipped, or (T, N, 1) numbers of skills
    values: np.ndarray  # (T, N) of the critic
    advantages: np.ndarray  # (T, N)
    groups: np.ndarray  # (N,) number of the team size
    dones: np.ndarray  # (T, N) flags: an episode ended with the decision
    states: torch.Tensor  # (images, N, units) of the actor's memory before the first decision
    seconds: float = 0.0  # that the matches took

    @property
    def returns(self) -> np.ndarray:
        """Return the values that the critic is to learn (T, N)."""
        returns: np.ndarray = self.values + self.advantages
        return returns


def collect(
    network: SoccerPolicy, matches: Matches, start: Start, length: int, gamma: float, lam: float,
    each_step: Callable[[], None], threads: int = 1,
) -> tuple[Rollout, Start]:  # fmt: skip
    """Play `length` decisions; return the rollout, and the start of the next one.

    `each_step` is called after each decision; threads: of torch, for the values of all decisions at once. A time
    limit ends an episode in the log only: the value of its last observation is added to the last reward [Pardo et al.
    2018].
    """
    (seen, states), rows, numbers = start, matches.num_envs, network.log_std.shape[0]
    observations, outputs = (np.empty((length, rows, wide), np.float32) for wide in (seen.shape[1], numbers))
    drawn = np.empty((length, rows, 1 if network.chooses_skills else numbers), np.float32)
    rewards, dones = np.empty((length, rows), np.float32), np.empty((length, rows), bool)
    cut_off, last_seen, seconds = list[tuple[int, int]](), list[np.ndarray](), 0.0
    torch.set_num_threads(1)  # an actor of few rows is slower on more
    for t in range(length):
        observations[t] = seen
        outputs[t], drawn[t], states = draw_actions(network, matches, seen, states)
        started = time.perf_counter()
        matches.step_async(drawn[t, :, 0].astype(int) if network.chooses_skills else drawn[t])
        seen, rewards[t], dones[t], infos = matches.step_wait()
        seconds += time.perf_counter() - started
        states = states.masked_fill(torch.as_tensor(dones[t], device=network.device)[None, :, None], 0.0)
        rows_cut = [row for row in np.flatnonzero(dones[t]).tolist() if infos[row]["TimeLimit.truncated"]]
        cut_off += [(t, row) for row in rows_cut]
        last_seen += [infos[row]["terminal_observation"] for row in rows_cut]
        each_step()
    torch.set_num_threads(threads)
    if cut_off:
        rewards[tuple(np.transpose(cut_off))] += gamma * values_of(network, np.array(last_seen))
    values = values_of(network, observations.reshape(length * rows, -1)).reshape(length, rows)
    gained = advantages(rewards, values, dones, values_of(network, seen), gamma, lam)
    made = Rollout(observations, outputs, drawn, values, gained, matches.size_of_row, dones, start.states, seconds)
    return made, Start(seen, states)


def draw_actions(
    network: SoccerPolicy, matches: Matches, seen: np.ndarray, states: torch.Tensor
) -> tuple[torch.Tensor, torch.Tensor, torch.Tensor]:
    """Return outputs of the actor, actions drawn by them, and the next states of a memory, of observations (N, n)."""
    with torch.no_grad():
        steps, states = network.outputs(torch.as_tensor(seen[None], device=network.device), states)
        masks = torch.as_tensor(matches.action_masks(), device=network.device) if network.chooses_skills else None
        policy = policy_of(steps[0], network.log_std, masks)
        return policy[0].cpu(), policy.draw().cpu(), states


def values_of(network: SoccerPolicy, observations: np.ndarray) -> np.ndarray:
    """Return the critic's values (B,) of observations (B, n)."""
    with torch.no_grad():
        parts = [
            network.values(torch.as_tensor(observations[first : first + CHUNK], device=network.device)).cpu()
            for first in range(0, len(observations), CHUNK)
        ]
    values: np.ndarray = torch.cat(parts).numpy()
    return values


def advantages(
    rewards: np.ndarray, values: np.ndarray, dones: np.ndarray, last_values: np.ndarray, gamma: float, lam: float
) -> np.ndarray:
    """Return generalised advantage estimates (T, N) [Schulman et al. 2016].

    rewards, values, dones: (T, N), of each decision; dones: its episode ended with it. last_values: (N,) of the
    observations after the last decision.
    """
    found, later, after = np.empty_like(rewards), np.zeros_like(last_values), last_values
    for t in reversed(range(len(rewards))):
        goes_on = ~dones[t]
        difference = rewards[t] + gamma * after * goes_on - values[t]
        later = difference + gamma * lam * later * goes_on
        found[t], after = later, values[t]
    return found


def normalised(numbers: np.ndarray, groups: np.ndarray) -> np.ndarray:
    """Return (T, N) numbers with mean 0 and deviation 1 within each group of columns; groups: (N,)."""
    result = np.empty_like(numbers)
    for group in np.unique(groups):
        part = numbers[:, groups == group]
        result[:, groups == group] = (part - part.mean()) / max(float(part.std()), LEAST_SCALE)
    return result


def scales(numbers: np.ndarray, groups: np.ndarray, least: float) -> np.ndarray:
    """Return for each column (N,) the standard deviation of the numbers (T, N) of its group, `least` at least."""
    result = np.empty(len(groups), numbers.dtype)
    for group in np.unique(groups):
        result[groups == group] = max(float(numbers[:, groups == group].std()), least)
    return result
