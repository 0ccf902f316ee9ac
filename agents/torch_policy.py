"""Write the policies that any torch library has trained as policy files: `save_policy`.

The layers read from a module are compared with the module itself on the same observations, and no file is written
unless they agree.
"""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.actions import PARTS, ActionKind
from soccer_env.agents.normalising import normaliser_table
from soccer_env.agents.perceptron import act, action_size, pack_policy, widest_layer
from soccer_env.agents.policy import ACTIONS, Policy, training_fields
from soccer_env.agents.policy_file import dump
from soccer_env.agents.rules_known import league_with_rules
from soccer_env.agents.torch_layers import Network, apply_module, network_of
from soccer_env.agents.trained_with import known_senses, warn_if_observing_truth
from soccer_env.guards.checking import check_choice
from soccer_env.guards.whole_files import write_atomically
from soccer_env.leagues import League
from soccer_env.match.arguments import version
from soccer_env.observations import OBSERVE, entry_names

ENDING = ".safetensors"
PROBES = 256  # observations of the comparison
TOLERANCE = 1e-4  # of an output, relative to the largest; float32 sums in another order differ by about 1e-6
CLOSE = 1e-3  # difference of two values of discrete actions, relative to the largest: either may be chosen


def save_policy(
    module: Any, path: str | os.PathLike[str], *, league: str | League, observe: str, action_repeat: int = 1,
    rules: str = "league", squash: bool = False, normalise: Any = None, activation: str | None = None,
    outputs: Callable[[Any], Any] | None = None, at_once: bool = True, name: str | None = None,
    pose: str | None = None, senses: str | None = None,
) -> Policy:  # fmt: skip
    """Write a learner's actor as a policy file and return the Policy; ValueError, and no file, if it does not fit.

    module: a torch module, or several in a row: Linear layers with Tanh or ReLU between. 4 or 7 outputs are the mean of
    the actions, twice as many are mean and deviation (left out), 12 are values of the discrete actions, 20 of the
    choices of "multi", 26 of skills. league, observe, action_repeat, rules: of the training. squash: actions are the
    tanh of the outputs, as in SAC or with a Tanh at the end. normalise: see `normalising.normaliser_table`.
    activation: "tanh" or "relu" if `forward` applies it and no module does. outputs: a function of observations (B, n)
    for the comparison, default the module itself. at_once: episodes began with a decision, as in the APIs; False: as in
    `SoccerVecEnv`. name: default the file's name. pose, senses: of the training, for evaluations; None: unknown. An
    existing file is overwritten.
    """
    if Path(path).suffix != ENDING:
        raise ValueError(f"a policy file must end in {ENDING}, got {os.fspath(path)!r}")
    preset = league_with_rules(league, rules)
    inputs = tuple(entry_names(preset, check_choice("observe", observe, OBSERVE)))
    network = network_of(module, activation)
    if (taken := network.weights[0].shape[1]) != len(inputs):
        raise ValueError(f"the module takes {taken} inputs, {observe!r} of {preset.name!r} has {len(inputs)}")
    policy = Policy(
        name=Path(path).stem if name is None else name, **training_fields(preset), observe=observe, inputs=inputs,
        actions=action_kind(network), action_repeat=action_repeat, activation=network.activation,
        mirror=False, weights=network.weights, biases=network.biases, made=policy_origin(module), at_once=at_once,
        squash=squash or network.squash, normalise=normaliser_table(normalise), **known_senses(senses, pose),
    )  # fmt: skip
    function = module if outputs is None else outputs
    compare_outputs(policy, network.squash, lambda rows: apply_module(function, rows, module))
    write_atomically(Path(path), dump(policy))
    warn_if_observing_truth(policy)
    return policy


def action_kind(network: Network) -> str:
    """Return the kind of actions that a network outputs; ValueError names the allowed numbers of outputs."""
    size = len(network.biases[-1])
    for kind, numbers in ACTIONS.items():
        if size == numbers:
            return kind
    raise ValueError(f"the module must have {', '.join(map(str, ACTIONS.values()))} outputs, or 8 or 14, got {size}")


def policy_origin(module: Any) -> dict[str, str]:
    """Return the origin of a policy (libraries and versions), for its file."""
    import torch

    return {"from": f"torch {type(module).__name__}"[:64], "torch": torch.__version__, "soccer_env": version()}


def compare_outputs(policy: Policy, squashed: bool, ask: Callable[[np.ndarray], np.ndarray]) -> None:
    """Raise ValueError unless the policy and the module `ask`, (B, n) -> outputs, agree.

    squashed: the module's outputs have passed through tanh.
    """
    rng, inputs = np.random.default_rng(0), len(policy.inputs)
    rows = rng.uniform(-1.0, 1.0, (PROBES, inputs)).astype(np.float32)
    rows[: PROBES // 4] = rng.integers(-1, 2, (PROBES // 4, inputs))  # many entries are flags and zeros
    theirs, ours = ask(normalise_observations(policy, rows)), outputs_of(policy, rows)
    if theirs.ndim != 2 or len(theirs) != PROBES or theirs.shape[1] not in (ours.shape[1], 2 * ours.shape[1]):
        raise ValueError(f"the module must give outputs {ours.shape}, got {theirs.shape}: give outputs=, a function")
    theirs = theirs[:, : ours.shape[1]]
    largest = max(1.0, float(np.abs(ours).max()))
    check_close("outputs", np.tanh(ours) if squashed else ours, theirs, TOLERANCE * largest)
    if policy.actions == "skills":
        return
    if policy.actions in PARTS:
        kind = ActionKind(policy.actions)
        parts = np.split(theirs, np.cumsum(kind.parts)[:-1], axis=1)
        gaps = [np.diff(np.sort(part, axis=1)[:, -2:], axis=1)[:, 0] for part in parts]
        clear = np.min(gaps, axis=0) > CLOSE * largest
        check_close("actions", compute_actions(policy, rows)[clear], kind.expand(kind.choose(theirs))[clear], 0.0)
        return
    means = np.tanh(theirs) if policy.squash and not squashed else np.clip(theirs, -1.0, 1.0)
    check_close("actions", compute_actions(policy, rows), means, TOLERANCE * largest)


def normalise_observations(policy: Policy, rows: np.ndarray) -> np.ndarray:
    """Convert observations (B, n) to inputs of a policy's network, float32."""
    table = policy.normalise
    if not table:
        return rows
    scaled = (rows.astype(np.float64) - table["mean"]) / table["deviation"]
    return np.asarray(np.clip(scaled, -table["limit"], table["limit"]), np.float32)


def outputs_of(policy: Policy, rows: np.ndarray) -> np.ndarray:
    """Return the network outputs of a policy for observations (B, n), before clipping, tanh or choice."""
    values = normalise_observations(policy, rows).astype(np.float64)
    last = len(policy.weights) - 1
    for number, (weight, bias) in enumerate(zip(policy.weights, policy.biases, strict=True)):
        values = values @ weight.T.astype(np.float64) + bias
        if number < last:
            values = np.tanh(values) if policy.activation == "tanh" else np.maximum(values, 0.0)
    return values


def compute_actions(policy: Policy, rows: np.ndarray) -> np.ndarray:
    """Return a policy's actions (B, 4 or 7) for observations (B, n), by the kernels used in matches."""
    numbers = pack_policy(policy)
    actions = np.zeros((len(rows), action_size(numbers)))
    scratch = np.zeros((3, widest_layer(numbers)))
    for row, action in zip(rows, actions, strict=True):
        act(numbers, row, action, scratch[:2, :0], scratch)
    return actions


def check_close(what: str, ours: np.ndarray, theirs: np.ndarray, tolerance: float) -> None:
    """Raise ValueError if two arrays, from the policy and the module, differ by more than a tolerance."""
    apart = np.abs(ours - theirs)
    if not (apart <= tolerance).all():  # NaN as well
        at = tuple(int(i) for i in np.unravel_index(int(np.argmax(np.nan_to_num(apart, nan=np.inf))), apart.shape))
        raise ValueError(
            f"the module computes something else than its layers in their order: {what} {ours[at]:.6g} and "
            f"{theirs[at]:.6g} for one observation; give activation= or outputs=, or let it play by team_of_function"
        )
