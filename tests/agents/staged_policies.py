"""Policies with random weights for tests: what they play is nonsense, but lively and always the same."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.agents.learned import LearnedTeam, from_file
from soccer_env.agents.perceptron import act, memory_size, pack_policy, widest_layer
from soccer_env.agents.policy import ACTIONS, Policy, training_fields
from soccer_env.agents.policy_file import dump
from soccer_env.agents.recurrent import memory_shapes
from soccer_env.leagues import find_league
from soccer_env.observations import entry_names


def random_policy(
    *hidden: int, observe: str = "belief", league: str = "legged-2001", seed: int = 1, **changes: Any
) -> Policy:
    """Return a policy with these hidden layers, whose actions fill [-1, 1] and depend on the whole observation."""
    trained = find_league(league)
    names = changes.get("inputs", tuple(entry_names(trained, observe)))
    outputs = ACTIONS[changes.get("actions", "box")]
    sizes, rng = [len(names), *(hidden or (16,)), outputs], np.random.default_rng(seed)
    fields: dict[str, Any] = {
        "name": "lively", **training_fields(trained), "observe": observe, "inputs": names, "actions": "box",
        "action_repeat": 1, "activation": "tanh", "mirror": False, "made": {},
        "weights": tuple(rng.normal(0.0, 1.5 / a**0.5, (b, a)).astype(np.float32) for a, b in zip(sizes, sizes[1:])),
        "biases": tuple(rng.normal(0.0, 0.3, b).astype(np.float32) for b in sizes[1:]),
    }  # fmt: skip
    return Policy(**{**fields, **changes})


def random_recurrent_policy(*hidden: int, units: int = 8, seed: int = 1, **changes: Any) -> Policy:
    """Return the like with a memory of some units."""
    plain = random_policy(*hidden, seed=seed, **changes)
    first, rng = plain.weights[0], np.random.default_rng(seed)
    shapes = memory_shapes(units, first.shape[1])
    memory = tuple(rng.normal(0.0, 2.0 / shape[-1] ** 0.5, shape).astype(np.float32) for shape in shapes)
    states = rng.normal(0.0, 2.0, (len(first), units)).astype(np.float32)
    return replace(plain, memory=memory, weights=(np.hstack([first, states]), *plain.weights[1:]))


def team_from_disk(policy: Policy, folder: Path) -> LearnedTeam:
    """Return the team of a policy, by way of a file."""
    file = folder / "lively.safetensors"
    file.write_bytes(dump(policy))
    return from_file(file)


def decide(policy: Policy, rows: np.ndarray) -> np.ndarray:
    """Return the actions (n, 4 or 7) for observations (n, inputs), one row after the other in the same memory."""
    numbers = pack_policy(policy)
    actions, scratch = np.zeros((len(rows), ACTIONS[policy.actions])), np.zeros((3, widest_layer(numbers)))
    states = np.zeros((2, memory_size(numbers) + 1))[:, :-1]  # strided, as in a match
    for row, action in zip(np.ascontiguousarray(rows, np.float32), actions):
        act(numbers, row, action, states, scratch)
    return actions
