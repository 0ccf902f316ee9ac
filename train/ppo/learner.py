"""The learner of a training run: actor, critic and optimiser, and their state for checkpoints."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import torch

from soccer_env.agents.policy_file import load
from soccer_env.observations import layout
from soccer_env.train.ppo.checkpoints import read_checkpoint
from soccer_env.train.ppo.networks import SoccerPolicy, copy_actor
from soccer_env.train.ppo.settings import TrainSettings
from soccer_env.train.ppo.updating.matches import Matches
from soccer_env.train.ppo.updating.rollout import Rollout, Start, collect
from soccer_env.train.ppo.updating.update import make_optimizer, update


class Learner:
    """Actor and critic, which PPO trains in matches: `collect_rollout`, then `update`, again and again."""

    def __init__(self, settings: TrainSettings, matches: Matches) -> None:
        check_device(settings.device)
        torch.manual_seed(settings.seed)  # of weights, noise, and the order of a rollout's parts
        self.settings, self.league = settings, settings.played
        self.matches = matches
        (features,) = matches.observation_space.shape or (0,)
        self.network = SoccerPolicy(
            layout(self.league, settings.observe), features, settings.actions, hidden=settings.hidden_sizes,
            critic=settings.critic_sizes, activation=settings.activation, mirror=settings.mirror,
            noise=settings.noise, memory=settings.memory,
        ).to(device_of(settings.device))  # fmt: skip
        self.optimizer = make_optimizer(self.network, settings.learning_rate)
        self.steps = 0  # decisions so far, summed over all robots
        self.noted: dict[str, float] = {}  # statistics of the last update
        self.seconds = 0.0  # that the matches of the last rollout took
        self._start = self._episode_start(np.zeros((0, 0), np.float32))  # of the next rollout
        self._rollout: Rollout | None = None

    def begin_matches(self, matches: Matches | None = None) -> None:
        """Begin new episodes in all matches, or in other matches, for the next rollout."""
        if matches is not None:
            self.matches.close()
            self.matches = matches
        self._start = self._episode_start(self.matches.reset())

    def _episode_start(self, seen: np.ndarray) -> Start:
        """Return the start of a rollout in which all rows begin an episode with these observations (N, n)."""
        return Start(seen, self.network.no_states(len(seen)))

    def collect_rollout(self, each_step: Callable[[], None]) -> None:
        """Collect a rollout by the policy with exploration noise; `each_step` is called after each decision."""

        def count() -> None:
            self.steps += self.matches.num_envs
            each_step()

        settings = self.settings
        self._rollout, self._start = collect(
            self.network, self.matches, self._start, settings.rollout, settings.gamma, settings.gae_lambda, count,
            settings.torch_threads,
        )  # fmt: skip
        self.seconds = self._rollout.seconds

    def update(self, actor: bool = True) -> None:
        """Update actor and critic by PPO on the rollout; without `actor` only the critic."""
        assert self._rollout is not None
        self.noted = update(self.network, self.optimizer, self._rollout, self.settings, actor)
        self._rollout = None
        check_weights(self.network, self.steps)

    def close(self) -> None:
        """End the matches and their threads."""
        self.matches.close()

    def state(self) -> dict[str, Any]:
        """Return the learner's state for a checkpoint, as plain values and arrays."""
        return {
            "network": self.network.state_dict(), "optimizer": self.optimizer.state_dict(), "step": self.steps,
            "states": self._start.states,
        }  # fmt: skip

    def restore(self, saved: dict[str, Any], observations: np.ndarray) -> None:
        """Resume from a checkpoint (a result of `state`); the next rollout begins with these observations."""
        self.network.load_state_dict(saved["network"])
        self.optimizer.load_state_dict(saved["optimizer"])
        self.steps, self._start = saved["step"], Start(observations, saved["states"].to(self.network.device))


def begin_networks(network: SoccerPolicy, settings: TrainSettings) -> None:
    """Let actor and critic begin as `settings.start` says, a policy file or another run; "" leaves them untrained."""
    if settings.start_file is None:
        return
    if Path(settings.start).is_dir():
        run = Path(settings.start)
        saved = read_checkpoint(run)
        try:
            network.load_state_dict((saved or {})["network"])
        except (KeyError, RuntimeError) as error:
            raise ValueError(f"start: the networks of the run in {run} are not those of this run ({error})") from error
    else:
        copy_actor(network, load(settings.start_file))


def device_of(name: str) -> torch.device:
    """Return the device that a setting names; "auto" is a GPU if there is one."""
    return torch.device(("cuda" if torch.cuda.is_available() else "cpu") if name == "auto" else name)


def check_device(device: str) -> None:
    """Raise ValueError if `device` is "cuda" without a GPU."""
    if device == "cuda" and not torch.cuda.is_available():
        raise ValueError("device='cuda' needs a GPU that torch can use; device='auto' takes one if there is one")


def check_weights(network: SoccerPolicy, step: int) -> None:
    """Raise ValueError if any weight is NaN or infinite, or the exploration noise is invalid: training has failed."""
    noise = network.log_std.detach()
    if not all(bool(torch.isfinite(part).all()) for part in (*network.parameters(), noise.exp(), (-noise).exp())):
        raise ValueError(f"weights became NaN or infinite by step {step}: a smaller learning_rate may help")
