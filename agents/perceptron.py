"""The network of a learned team, computed row by row in compiled code.

A network lies in one flat array of numbers, so that kernels are compiled once for networks of every size:

    layers, kind and activation, mirror, action repeat, at once | sizes of all layers, the first layer's inputs in front
    | with attention its shape | signs of a mirror | with attention Q, W, b of both kinds | weights and biases

An action depends bit for bit on its own observation only, whatever else is played at the same time.
"""

from __future__ import annotations

from math import tanh
from typing import TYPE_CHECKING

import numpy as np

from soccer_env.agents.attention import SHAPE, attend, flat, layout_of, observed, shape_of
from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.observations.reflection import action_signs, observation_signs

if TYPE_CHECKING:
    from soccer_env.agents.policy import Policy

LAYERS, NETWORK, MIRROR, REPEAT, AT_ONCE, SIZES = range(6)  # places in the head of the array; SIZES: the first size
NETWORKS = (("slots", "tanh"), ("slots", "relu"), ("attention", "tanh"), ("attention", "relu"))
ATTENTION = 2  # from this index of NETWORKS on there is attention; even indices have tanh


def pack(policy: Policy, at_once: bool = False) -> np.ndarray:
    """Return the numbers (n,) float64 of a policy's network; `at_once`: it decides at the first step of an episode."""
    sizes = [policy.weights[0].shape[1], *(len(bias) for bias in policy.biases)]
    network = NETWORKS.index((policy.kind, policy.activation))
    head = [len(policy.weights), network, policy.mirror, policy.action_repeat, at_once, *sizes]
    if policy.attention:
        head += shape_of(layout_of(policy.entries), len(policy.attention[1]))
    signs = observation_signs(policy.entries) if policy.mirror else np.ones(len(policy.inputs))
    parts = [np.array(head, np.float64), signs, action_signs(sizes[-1])]
    parts += flat(policy.attention)
    for weight, bias in zip(policy.weights, policy.biases, strict=True):
        parts += [weight.T.astype(np.float64).ravel(), bias.astype(np.float64)]
    return np.concatenate(parts)


@compiled
def act(numbers, row, action, scratch):
    """Write the action (a,) for one observation (n,); scratch (3, widest) is working space.

    If the head of the array says so, the mean of the network and of its mirror image; clipped to [-1, 1].
    """
    layers = int(numbers[LAYERS])
    inputs, outputs = entries(numbers), int(numbers[SIZES + layers])
    signs = SIZES + layers + 1 + (SHAPE if numbers[NETWORK] >= ATTENTION else 0)
    start = signs + inputs + outputs
    for i in range(inputs):
        scratch[2, i] = row[i]
    forward(numbers, layers, start, scratch)
    for i in range(outputs):
        action[i] = scratch[0, i]
    if numbers[MIRROR] != 0.0:
        for i in range(inputs):
            scratch[2, i] = numbers[signs + i] * row[i]
        forward(numbers, layers, start, scratch)
        for i in range(outputs):
            action[i] = 0.5 * (action[i] + numbers[signs + inputs + i] * scratch[0, i])
    for i in range(outputs):
        action[i] = clip(action[i], -1.0, 1.0)


@compiled
def forward(numbers, layers, start, scratch):
    """Compute the network for the inputs in scratch[2]; the outputs come to lie in scratch[0]."""
    smooth, at = numbers[NETWORK] % 2.0 == 0.0, start
    if numbers[NETWORK] >= ATTENTION:
        at = attend(numbers, SIZES + layers + 1, start, smooth, scratch)
    for layer in range(layers):
        wide, out = int(numbers[SIZES + layer]), int(numbers[SIZES + layer + 1])
        bias = at + wide * out
        for j in range(out):
            scratch[0, j] = numbers[bias + j]
        for i in range(wide):  # column by column: no sum is reordered, and the inner loop uses vector instructions
            value = scratch[2, i]
            for j in range(out):
                scratch[0, j] += value * numbers[at + i * out + j]
        at = bias + out
        if layer < layers - 1:
            for j in range(out):
                scratch[2, j] = tanh(scratch[0, j]) if smooth else max(scratch[0, j], 0.0)


@compiled
def entries(numbers):
    """Return how many entries the observation has."""
    if numbers[NETWORK] >= ATTENTION:
        return observed(numbers, SIZES + int(numbers[LAYERS]) + 1)
    return int(numbers[SIZES])


@compiled
def widest(numbers):
    """Return the width of the widest layer, inputs, outputs and the observation included."""
    return max(entries(numbers), int(numbers[SIZES : SIZES + int(numbers[LAYERS]) + 1].max()))
