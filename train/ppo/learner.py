"""The learner of a training run: PPO of stable-baselines3 in single steps, with its state for checkpoints."""

import warnings
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.callbacks import ConvertCallback
from stable_baselines3.common.logger import Logger

from soccer_env.observations import Entry, layout
from soccer_env.train.ppo.networks import SoccerPolicy
from soccer_env.train.ppo.recurrent import RecurrentPolicy, SequenceBuffer, connect_memory
from soccer_env.train.ppo.settings import TrainSettings
from soccer_env.train.ppo.vec_env import SoccerVecEnv

LEAST_RATE = 0.05  # [1] of the learning rate that is left at the end
RECENT = 100  # episodes whose results stable-baselines3 keeps, of which nothing here makes use


class Learner:
    """Actor, critic, and the PPO algorithm that trains them in matches.

    It calls the two halves of stable-baselines3's `learn` separately, so that `train` can act between them. Names
    beginning with _ are private to that library, which is pinned below its next version: the start of a rollout
    (`_last_obs`, `_last_episode_starts`), the number of updates (`_n_updates`) and the remaining share of the run, on
    which the learning rate depends, have no public names.
    """

    def __init__(self, settings: TrainSettings, matches: SoccerVecEnv) -> None:
        torch.set_num_threads(settings.torch_threads)
        self.settings, self.league = settings, settings.played
        self.matches = matches
        self.model = make_model(settings, matches, layout(self.league, settings.observe))
        self.model.ep_info_buffer = deque(maxlen=RECENT)
        self.model.ep_success_buffer = deque(maxlen=RECENT)

    @property
    def steps(self) -> int:
        """Return the number of decisions so far, summed over all robots."""
        return self.model.num_timesteps

    @property
    def network(self) -> SoccerPolicy:
        """Return the policy object with actor and critic."""
        assert isinstance(self.model.policy, SoccerPolicy)
        return self.model.policy

    def reset_matches(self) -> None:
        """Begin new episodes in all matches, for the first rollout."""
        self._set_rollout_start(self.matches.reset(), np.ones(self.model.n_envs, bool))

    def collect_rollout(self, each_step: Callable[[], None]) -> None:
        """Collect a rollout by the policy with exploration noise; `each_step` is called after each step."""
        model = self.model

        def stepped(*_: Any) -> bool:
            each_step()
            return True

        callback = ConvertCallback(stepped)
        callback.init_callback(model)
        with self._explain_nan_errors():
            model.collect_rollouts(self.matches, callback, model.rollout_buffer, n_rollout_steps=model.n_steps)

    def update(self, actor: bool = True) -> None:
        """Update actor and critic by PPO on the rollout; without `actor` only the critic."""
        for parameter in self.network.actor_parameters():
            parameter.requires_grad_(actor)
        self.model._update_current_progress_remaining(self.steps, self.settings.steps)
        with self._explain_nan_errors():
            self.model.train()
        check_weights(self.model)

    def noted(self) -> dict[str, Any]:
        """Return stable-baselines3's statistics of the last update, under its own names."""
        return dict(self.model.logger.name_to_value)

    def close(self) -> None:
        """End the matches and their threads."""
        self.matches.close()

    def state(self) -> dict[str, Any]:
        """Return the learner's state for a checkpoint, as plain values and arrays."""
        return {
            "network": self.network.state_dict(),
            "optimizer": self.network.optimizer.state_dict(),
            "step": self.steps,
            "updates": self.model._n_updates,
            "starts": np.asarray(self.model._last_episode_starts),
            "states": self.network.states,
        }

    def restore(self, saved: dict[str, Any], observations: np.ndarray) -> None:
        """Resume from a checkpoint (a result of `state`); the next rollout begins with these observations."""
        self.network.load_state_dict(saved["network"])
        self.network.optimizer.load_state_dict(saved["optimizer"])
        self.model.num_timesteps, self.model._n_updates = saved["step"], saved["updates"]
        self.network.states = saved["states"]
        self._set_rollout_start(observations, saved["starts"])

    def _set_rollout_start(self, observations: np.ndarray, starts: np.ndarray) -> None:
        """Set the observations (rows, n) at which the next rollout begins; `starts` (rows,): an episode begins."""
        self.model._last_obs, self.model._last_episode_starts = observations, starts

    @contextmanager
    def _explain_nan_errors(self) -> Iterator[None]:
        """Replace torch's long error message about NaN by the one line of `check_weights`, in a `with` block."""
        try:
            yield
        except ValueError:
            check_weights(self.model)
            raise


def make_model(settings: TrainSettings, matches: SoccerVecEnv, entries: list[Entry]) -> PPO:
    """Return stable-baselines3's PPO, set up to train on `matches`."""
    shape = {
        "entries": entries, "kind": settings.kind, "hidden": settings.hidden_sizes, "critic": settings.critic_sizes,
        "activation": settings.activation, "mirror": settings.mirror, "memory": settings.memory,
        "log_std_init": float(np.log(settings.noise)),
    }  # fmt: skip

    def rate(left: float) -> float:
        return settings.learning_rate * (LEAST_RATE + (1.0 - LEAST_RATE) * max(left, 0.0) if settings.decay else 1.0)

    policy, buffer = (RecurrentPolicy, SequenceBuffer) if settings.memory else (SoccerPolicy, None)
    with warnings.catch_warnings():  # of a last part that is a little smaller, and of GPUs being slow for small nets
        warnings.filterwarnings("ignore", category=UserWarning, module="stable_baselines3")
        model = PPO(
            policy, matches, learning_rate=rate, n_steps=settings.rollout, rollout_buffer_class=buffer,
            batch_size=minibatch_size(settings.rollout * matches.num_envs, settings.batch),
            n_epochs=settings.epochs, gamma=settings.gamma, gae_lambda=settings.gae_lambda, clip_range=settings.clip,
            ent_coef=settings.entropy, policy_kwargs=shape, seed=settings.seed, device=settings.device,
        )  # fmt: skip
    connect_memory(model)
    model.set_logger(Logger(folder=None, output_formats=[]))
    return model


def check_device(device: str) -> None:
    """Raise ValueError if `device` is "cuda" without a GPU, since stable-baselines3 would silently use the CPU."""
    if device == "cuda" and not torch.cuda.is_available():
        raise ValueError("device='cuda' needs a GPU that torch can use; device='auto' takes one if there is one")


def check_weights(model: PPO) -> None:
    """Raise ValueError if any weight is NaN or infinite, or the exploration noise is invalid: training has failed."""
    noise: Any = model.policy.log_std
    if not all(bool(torch.isfinite(part).all()) for part in (*model.policy.parameters(), noise.exp(), (-noise).exp())):
        raise ValueError(
            f"weights became NaN or infinite by step {model.num_timesteps}: a smaller learning_rate may help"
        )


def minibatch_size(decisions: int, batch: int) -> int:
    """Return a batch size near `batch` that divides a rollout's decisions into nearly equal parts."""
    parts = max(1, round(decisions / batch))
    return -(-decisions // parts)
