"""The ranges of a training run's numeric settings, and the names of the optional logs."""

from typing import Any

from soccer_env.agents.recurrent import MAX_MEMORY
from soccer_env.guards.checking import FROM_ZERO, Range
from soccer_env.rewards import NAMES

LOGS = ("csv", "tensorboard", "wandb")  # further logs, each in a folder of that name
MAX_SEED = 2**32 - 1  # of numpy's global generator, with which stable-baselines3 shuffles
SHARE = Range(0.0, 1.0, above=True)
MINUTES = Range(0.0, 10_000.0, above=True, below=True)
SECONDS = Range(0.0, 86_400.0, above=True)
MOST = 65_536
BOUNDS: dict[str, tuple[Any, ...]] = {
    **dict.fromkeys(("action_repeat", "batch", "epochs", "evaluate_every", "past_every", "stage_steps"), Range(1)),
    **dict.fromkeys(("rollout", "matches"), Range(1, MOST)),
    **dict.fromkeys(("steps", "past", "teacher_steps", "teacher_epochs", "rounds", "critic_first"), FROM_ZERO),
    **dict.fromkeys(("learning_rate", "target_kl", "stage_share"), SHARE),
    **dict.fromkeys(("discount_half_life", "advantage_half_life"), SECONDS),
    **dict.fromkeys(("minutes", "evaluate_minutes"), MINUTES),
    **dict.fromkeys(NAMES, Range(0.0, 1e9)),
    "evaluate_matches": Range(1),
    "memory": Range(0, MAX_MEMORY),
    "torch_threads": Range(1, 256),
    "noise": Range(0.0, 10.0, above=True),
    **dict.fromkeys(("ideal_share",), Range(0.0, 1.0)),
    "seed": Range(0, MAX_SEED),
}
