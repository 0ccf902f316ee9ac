"""The recurrent memory of a policy: a gated recurrent unit (GRU) before the layers.

    r  = sigmoid(W_r x + b_r + U_r h + c_r)          (units,)  reset gate, x: features, h: the state so far
    z  = sigmoid(W_z x + b_z + U_z h + c_z)          (units,)  update gate
    n  = tanh(W_n x + b_n + r * (U_n h + c_n))       (units,)  [Cho et al. 2014], with r as in torch's GRUCell
    h' = (1 - z) n + z h                             (units,)  the new state, which follows x in the first layer's input

x are the inputs. The state is one of the numbers that a player's memory holds: in [-1, 1], saved and hashed with the
match. It is 0 at the first decision of an episode, and of a robot that was sent off. A policy with `mirror` keeps a
second state, of the mirror image.
"""

from math import tanh

import numpy as np

from soccer_env.agents.array_checks import check_array, check_below_limit, check_tensors
from soccer_env.compiled import compiled

TENSORS = tuple(f"memory.{part}_{kind}" for part in ("input", "state") for kind in ("weight", "bias"))  # W, b, U, c
GATES = 3  # r, z, n, in this order in all tensors
MAX_MEMORY = 128  # units
ACTIVE = "active"  # the entry that is below 0 while a robot is sent off


def memory_shapes(units: int, features: int) -> tuple[tuple[int, ...], ...]:
    """Return the shape of each tensor (TENSORS) of a memory of `units` that reads `features`."""
    out = GATES * units
    return (out, features), (out,), (out, units), (out,)


def memory_units(tensors: tuple[np.ndarray, ...]) -> int:
    """Return the number of units of a memory with these tensors; 0 without."""
    return len(tensors[1]) // GATES if tensors else 0


def check_memory(memory: object, features: int) -> int:
    """Return the units of the memory, 0 without; ValueError unless its tensors fit the features that it reads."""
    if not isinstance(memory, tuple) or len(memory) not in (0, len(TENSORS)):
        size = f"{len(memory)} arrays" if isinstance(memory, tuple) else type(memory).__name__
        raise ValueError(f"memory must be an empty tuple or one of {', '.join(TENSORS)}, got {size}")
    for name, array in zip(TENSORS, memory):
        check_array(name, array)
    if not memory:
        return 0
    units = memory_units(memory) if memory[1].ndim == 1 else 0
    if not 1 <= units <= MAX_MEMORY:
        allowed = f"({GATES} times 1 to {MAX_MEMORY},)"
        raise ValueError(f"{TENSORS[1]} must have the shape {allowed}, got {memory[1].shape}")
    check_tensors(TENSORS, memory, memory_shapes(units, features))
    return units


def check_memory_overflow(memory: tuple[np.ndarray, ...], largest: float) -> None:
    """Raise ValueError if features up to `largest`, with a state in [-1, 1], could make a gate overflow."""
    if memory:
        inputs, states = (np.abs(weight).sum(axis=1, dtype=np.float64) for weight in memory[::2])
        reached = inputs * largest + states + np.abs(memory[1]) + np.abs(memory[3])
        check_below_limit("memory", reached.max())


@compiled
def remember(numbers, start, features, units, state, scratch):
    """Update the state (units,) and append it to the features in scratch[2]; return the next unread index of `numbers`.

    scratch[0] and scratch[1], at least 3 x units wide, are working space.
    """
    out = GATES * units
    at = multiply(numbers, start, features, out, scratch[2], scratch[0])
    at = multiply(numbers, at, units, out, state, scratch[1])
    for j in range(units):
        reset = sigmoid(scratch[0, j] + scratch[1, j])
        update = sigmoid(scratch[0, units + j] + scratch[1, units + j])
        new = tanh(scratch[0, 2 * units + j] + reset * scratch[1, 2 * units + j])
        state[j] = (1.0 - update) * new + update * state[j]
        scratch[2, features + j] = state[j]
    return at


@compiled
def multiply(numbers, at, wide, out, values, sums):
    """Write weights (out, wide) times values (wide,) plus biases into `sums`; return the next unread index.

    Column by column: no sum is reordered, and the inner loop uses vector instructions.
    """
    bias = at + wide * out
    for j in range(out):
        sums[j] = numbers[bias + j]
    for i in range(wide):
        value = values[i]
        for j in range(out):
            sums[j] += value * numbers[at + i * out + j]
    return bias + out


@compiled
def sigmoid(x):
    """Return 1 / (1 + exp(-x)), which no x overflows."""
    return 0.5 + 0.5 * tanh(0.5 * x)
