"""The network of a learned team, computed row by row in compiled code.

A network lies in one flat array of numbers, so that kernels are compiled once for networks of every size:

    layers, activation, mirror, action repeat, at once | sizes of all layers | signs of a mirror | weights and biases

An action depends bit for bit on its own observation only, whatever else is played at the same time.
"""

from __future__ import annotations

from math import tanh
from typing import TYPE_CHECKING

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.observations.mirror import action_signs, observation_signs

if TYPE_CHECKING:
    from soccer_env.agents.policy import Policy

LAYERS, ACTIVATION, MIRROR, REPEAT, AT_ONCE, SIZES = range(6)  # where the head's numbers lie; SIZES: the first size
ACTIVATIONS = ("tanh", "relu")
TANH = ACTIVATIONS.index("tanh")


def pack(policy: Policy, at_once: bool = False) -> np.ndarray:
    """Return the numbers (n,) float64 of a policy's network; `at_once`: it decides at the first step of an episode."""
    sizes = [policy.weights[0].shape[1], *(len(bias) for bias in policy.biases)]
    head = [len(policy.weights), ACTIVATIONS.index(policy.activation), policy.mirror, policy.action_repeat]
    head += [at_once, *sizes]
    parts = [np.array(head, np.float64), observation_signs(policy.inputs), action_signs(sizes[-1])]
    for weight, bias in zip(policy.weights, policy.biases, strict=True):
        parts += [weight.T.astype(np.float64).ravel(), bias.astype(np.float64)]
    return np.concatenate(parts)


@compiled
def act(numbers, row, action, room):
    """Write the action (a,) for one observation (n,); room (3, widest) is to work in.

    The mean of the network and of its mirror image where the head says so, clipped to [-1, 1].
    """
    layers = int(numbers[LAYERS])
    inputs, outputs = int(numbers[SIZES]), int(numbers[SIZES + layers])
    signs = SIZES + layers + 1
    start = signs + inputs + outputs
    for i in range(inputs):
        room[2, i] = row[i]
    forward(numbers, layers, start, room)
    for i in range(outputs):
        action[i] = room[0, i]
    if numbers[MIRROR] != 0.0:
        for i in range(inputs):
            room[2, i] = numbers[signs + i] * row[i]
        forward(numbers, layers, start, room)
        for i in range(outputs):
            action[i] = 0.5 * (action[i] + numbers[signs + inputs + i] * room[0, i])
    for i in range(outputs):
        action[i] = clip(action[i], -1.0, 1.0)


@compiled
def forward(numbers, layers, start, room):
    """Compute the network for the inputs in room[2]; the outputs come to lie in room[0]."""
    at = start
    for layer in range(layers):
        wide, out = int(numbers[SIZES + layer]), int(numbers[SIZES + layer + 1])
        bias = at + wide * out
        for j in range(out):
            room[0, j] = numbers[bias + j]
        for i in range(wide):  # column by column: no sum is reordered, and the inner loop uses vector instructions
            value = room[2, i]
            for j in range(out):
                room[0, j] += value * numbers[at + i * out + j]
        at = bias + out
        if layer < layers - 1:
            for j in range(out):
                room[2, j] = tanh(room[0, j]) if numbers[ACTIVATION] == TANH else max(room[0, j], 0.0)


@compiled
def widest(numbers):
    """Return the width of the widest layer, inputs and outputs included."""
    return int(numbers[SIZES : SIZES + int(numbers[LAYERS]) + 1].max())
