"""The learner of a training run: PPO of stable-baselines3, and what of it has to be kept so that a run can go on."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.logger import Logger
from stable_baselines3.common.vec_env import VecNormalize

from soccer_env.train.ppo.networks import SoccerPolicy
from soccer_env.train.ppo.settings import TrainSettings
from soccer_env.train.ppo.vec_env import SoccerVecEnv

LEAST_RATE = 0.05  # [1] of the learning rate that is left at the end
SPREAD = 10.0  # [1] rewards over the deviation of the return are cut off there


def make_rewards(settings: TrainSettings, matches: SoccerVecEnv) -> VecNormalize:
    """Return the matches with rewards divided by the running deviation of the return, if that is asked for."""
    return VecNormalize(
        matches, norm_obs=False, norm_reward=settings.normalise_rewards, gamma=settings.gamma, clip_reward=SPREAD
    )


def make_model(settings: TrainSettings, matches: VecNormalize, names: list[str]) -> PPO:
    """Return the learner."""
    shape = {
        "names": names, "kind": settings.kind, "hidden": settings.hidden_sizes, "critic": settings.critic_sizes,
        "activation": settings.activation, "mirror": settings.mirror, "log_std_init": float(np.log(settings.noise)),
    }  # fmt: skip

    def rate(left: float) -> float:
        return settings.learning_rate * (LEAST_RATE + (1.0 - LEAST_RATE) * max(left, 0.0) if settings.decay else 1.0)

    with warnings.catch_warnings():  # of a last part that is a little smaller, and of GPUs being slow for small nets
        warnings.filterwarnings("ignore", category=UserWarning, module="stable_baselines3")
        model = PPO(
            SoccerPolicy, matches, learning_rate=rate, n_steps=settings.rollout,
            batch_size=part_size(settings.rollout * matches.num_envs, settings.batch),
            n_epochs=settings.epochs, gamma=settings.gamma, gae_lambda=settings.gae_lambda, clip_range=settings.clip,
            ent_coef=settings.entropy, vf_coef=settings.value_weight, max_grad_norm=settings.gradient_limit,
            target_kl=settings.target_kl or None, policy_kwargs=shape, seed=settings.seed, device=settings.device,
        )  # fmt: skip
    model.set_logger(Logger(folder=None, output_formats=[]))
    return model


def check_device(device: str) -> None:
    """Raise ValueError if there is no GPU and one is asked for; stable-baselines3 would take the CPU without a word."""
    if device == "cuda" and not torch.cuda.is_available():
        raise ValueError("device='cuda' needs a GPU that torch can use; device='auto' takes one if there is one")


def check_weights(model: PPO) -> None:
    """Raise ValueError if a weight, or the noise, is NaN, infinite or 0: nothing can be learned from there on."""
    noise: Any = model.policy.log_std
    if not all(bool(torch.isfinite(part).all()) for part in (*model.policy.parameters(), noise.exp(), (-noise).exp())):
        raise ValueError(
            f"weights became NaN or infinite by step {model.num_timesteps}: a smaller learning_rate may help"
        )


def part_size(decisions: int, batch: int) -> int:
    """Return the size of the nearly equal parts, of about `batch`, into which a rollout's decisions are cut."""
    parts = max(1, round(decisions / batch))
    return -(-decisions // parts)


# What stable-baselines3 keeps under names that are private to it: these functions alone use them


def begin(model: PPO, observations: np.ndarray) -> None:
    """Let the first rollout begin with these observations; without them `learn` would reset the matches."""
    model._last_obs = observations
    model._last_episode_starts = np.ones(model.n_envs, bool)


def learner_state(model: PPO, rewards: VecNormalize) -> dict[str, Any]:
    """Return what a checkpoint keeps of the learner, as plain values and arrays."""
    running = {} if not rewards.norm_reward else {
        "mean": float(rewards.ret_rms.mean), "var": float(rewards.ret_rms.var),
        "count": float(rewards.ret_rms.count), "returns": rewards.returns,
    }  # fmt: skip
    return {
        "network": model.policy.state_dict(),
        "optimizer": model.policy.optimizer.state_dict(),
        "step": model.num_timesteps,
        "updates": model._n_updates,
        "starts": np.asarray(model._last_episode_starts),
        "rewards": running,
    }


def restore_learner(model: PPO, rewards: VecNormalize, saved: dict[str, Any], observations: np.ndarray) -> None:
    """Go on from what `learner_state` returned, with these observations."""
    model.policy.load_state_dict(saved["network"])
    model.policy.optimizer.load_state_dict(saved["optimizer"])
    model.num_timesteps, model._n_updates = saved["step"], saved["updates"]
    model._last_obs = observations
    model._last_episode_starts = saved["starts"]
    running = saved["rewards"]
    if running:
        for name in ("mean", "var", "count"):
            setattr(rewards.ret_rms, name, np.float64(running[name]))
        rewards.returns = running["returns"]
