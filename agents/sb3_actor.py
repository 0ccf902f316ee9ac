"""The parameters of the actor in a stable-baselines3 policy, for each supported algorithm with MlpPolicy.

PPO, A2C     mlp_extractor.policy_net.0, .2 ..., action_net      mean, or values of discrete actions; tanh
SAC          actor.latent_pi.0, .2 ..., actor.mu                 mean, squashed by tanh; relu
TD3, DDPG    actor.mu.0, .2 ...                                  action, squashed by tanh; relu
DQN          q_net.q_net.0, .2 ...                               values of discrete actions; relu

Other parameters, such as critics, do not affect the play.
"""

import re
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from soccer_env.agents.policy import MAX_INPUTS
from soccer_env.guards.checking import short_repr

Layers = tuple[np.ndarray, ...]
NAMES = "PPO, A2C, SAC, TD3, DDPG and DQN"


class Algorithm(NamedTuple):
    """The names of an algorithm's actor parameters, and the meaning of the actor's outputs."""

    hidden: str  # prefix of a layer's number
    last: str  # the layer after the hidden layers, "" if there is none
    activation: str  # unless the zip names another
    squash: bool
    discrete: bool | None  # None: discrete unless there is a `log_std`
    unused: re.Pattern[str]  # parameters that do not affect the play


VALUES = r"value_net\.(weight|bias)|mlp_extractor\.value_net\.[0-9]{1,3}\.(weight|bias)"
CRITICS = r"critic(_target)?\.[a-z0-9_.]{1,60}"
ALGORITHMS = (
    Algorithm("mlp_extractor.policy_net.", "action_net", "tanh", False, None, re.compile(rf"log_std|{VALUES}")),
    Algorithm(
        "actor.latent_pi.", "actor.mu", "relu", True, False, re.compile(rf"actor\.log_std\.(weight|bias)|{CRITICS}")
    ),
    Algorithm("actor.mu.", "", "relu", True, False, re.compile(rf"actor_target\.mu\.[a-z0-9.]{{1,20}}|{CRITICS}")),
    Algorithm("q_net.q_net.", "", "relu", False, True, re.compile(r"q_net_target\.q_net\.[a-z0-9.]{1,20}")),
)


def algorithm_of(state: Mapping[str, np.ndarray]) -> Algorithm:
    """Return the algorithm that saved these parameters; ValueError names the first parameter that does not fit."""
    for one in ALGORITHMS:
        if f"{one.last or one.hidden + '0'}.weight" in state:
            for key in state:
                layer = f"{re.escape(one.hidden)}[0-9]{{1,3}}" + (f"|{re.escape(one.last)}" if one.last else "")
                if not (re.fullmatch(rf"({layer})\.(weight|bias)", key) or one.unused.fullmatch(key)):
                    raise ValueError(f"has the parameter {short_repr(key)}: only MlpPolicy of {NAMES} is supported")
            return one
    first = short_repr(next(iter(state), None))
    raise ValueError(f"has the parameter {first} and no actor: only MlpPolicy of {NAMES} is supported")


def is_discrete(algorithm: Algorithm, state: Mapping[str, np.ndarray]) -> bool:
    """Tell whether the actor's outputs are values of discrete actions."""
    return "log_std" not in state if algorithm.discrete is None else algorithm.discrete


def layers_of(algorithm: Algorithm, state: Mapping[str, np.ndarray]) -> tuple[Layers, Layers]:
    """Return the weights and the biases of the actor's layers."""
    indices = [
        key.removeprefix(algorithm.hidden).partition(".")[0] for key in state if key.startswith(algorithm.hidden)
    ]
    numbers = sorted({int(number) for number in indices})
    if numbers != list(range(0, 2 * len(numbers), 2)):
        raise ValueError(f"layers of {algorithm.hidden[:-1]} must be 0, 2, 4 ..., got {short_repr(numbers)}")
    names = [f"{algorithm.hidden}{number}" for number in numbers] + [algorithm.last] * bool(algorithm.last)
    for name in names:
        weight, bias = (state.get(f"{name}.{part}") for part in ("weight", "bias"))
        if weight is None or bias is None:
            raise ValueError(f"{name} must have a weight and a bias")
        if weight.ndim != 2 or bias.ndim != 1 or not all(0 < size <= MAX_INPUTS for size in weight.shape + bias.shape):
            raise ValueError(f"{name} must have a weight of two axes and a bias, got {weight.shape} and {bias.shape}")
    return tuple(state[f"{name}.weight"] for name in names), tuple(state[f"{name}.bias"] for name in names)
