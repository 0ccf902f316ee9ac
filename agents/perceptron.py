"""The network of a learned team, computed for one observation at a time in compiled code.

A network lies in one flat array of numbers, so that kernels are compiled once for networks of every size:

    layers, memory and activation, mirror, action repeat, at once, output, normalised, temperature | sizes of all
    layers, the first layer's inputs in front | with a memory its units, and which input says that the robot is
    active | places of the inputs in an observation | a mirror: signs of the inputs, places and signs of the outputs |
    normalised: limit, means, deviations | with a memory W, b, U, c | weights and biases

An action depends bit for bit on its own observation and state of memory alone, and not on other rows.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import tanh
from typing import TYPE_CHECKING

import numpy as np

from soccer_env.actions import BOX, DISCRETE_TABLE, FULL, KICK_TABLE, LEVEL_TABLE, WALK, action_mirror
from soccer_env.agents.normalising import pack_table
from soccer_env.agents.recurrent import ACTIVE, GATES, memory_units, multiply, remember
from soccer_env.compiled import compiled
from soccer_env.geometry import clip
from soccer_env.observations.reflection import observation_signs

if TYPE_CHECKING:
    from soccer_env.agents.policy import Policy

LAYERS, NETWORK, MIRROR, REPEAT, AT_ONCE, OUTPUT, NORMALISED, TEMPERATURE, SIZES = range(9)  # places; the first size
# Use of the outputs: clipped, tanh, the largest, the largest of each part, as they are.
CLIPPED, SQUASHED, CHOSEN, PARTS_CHOSEN, VALUES = range(5)
OUTPUTS = {"discrete": CHOSEN, "multi": PARTS_CHOSEN, "skills": VALUES}
CHOICE, CHOICES = len(BOX), len(FULL)  # numbers of an action of the kind "discrete", and of "multi"
RELU, RECURRENT = 1, 2  # added up at NETWORK; without RELU the activation is tanh
MEMORY_SHAPE = 2  # numbers: units, and the input ACTIVE, or -1


def pack_policy(policy: Policy, at_once: bool = False, columns: Sequence[int] | None = None) -> np.ndarray:
    """Return the network of a policy as numbers (n,) float64; `at_once`: decide in an episode's first step.

    columns: the place of each input in an observation; None: the policy's inputs are the observation.
    """
    sizes = [policy.weights[0].shape[1], *(len(bias) for bias in policy.biases)]
    network = RELU * (policy.activation == "relu") + (RECURRENT if policy.memory else 0)
    output = OUTPUTS.get(policy.actions, SQUASHED if policy.squash else CLIPPED)
    scaled = pack_table(policy.normalise)
    use = policy.action_repeat, at_once, output, len(scaled) > 0, policy.temperature
    head = [len(policy.weights), network, policy.mirror, *use, *sizes]
    if policy.memory:
        head += memory_units(policy.memory), policy.inputs.index(ACTIVE) if ACTIVE in policy.inputs else -1
    signs = observation_signs(policy.entries) if policy.mirror else np.ones(len(policy.inputs))
    turned = action_mirror(policy.actions) if policy.mirror else np.ones((2, sizes[-1]))
    places = np.arange(len(policy.inputs)) if columns is None else np.array(columns)
    parts = [np.array(head, np.float64), places.astype(np.float64), signs, *turned, scaled]
    layers = (*zip(policy.memory[::2], policy.memory[1::2]), *zip(policy.weights, policy.biases))
    for weight, bias in layers:
        parts += [weight.T.astype(np.float64).ravel(), bias.astype(np.float64)]
    return np.concatenate(parts)


@compiled
def act(numbers, row, action, states, scratch):
    """Write the action (a,) for one observation (n,), in [-1, 1], and update the states (2, units) of its memory.

    A chooser of skills writes the values of all. Without memory: states (2, 0). scratch (3, widest) is working space.
    Entries that the network does not read have no effect. With MIRROR the action is the mean of the outputs for the
    observation and, mirrored back, for its mirror image.
    """
    layers, inputs = int(numbers[LAYERS]), input_size(numbers)
    outputs = int(numbers[SIZES + layers])
    places = memory_shape(numbers) + (MEMORY_SHAPE if numbers[NETWORK] >= RECURRENT else 0)
    forget_if_sent_off(numbers, row, places, states)
    signs = places + inputs
    scale = signs + inputs + 2 * outputs
    start = scale + (1 + 2 * inputs if numbers[NORMALISED] != 0.0 else 0)
    for i in range(inputs):
        scratch[2, i] = row[int(numbers[places + i])]
    normalise(numbers, scale, inputs, scratch)
    forward(numbers, layers, start, states[0], scratch)
    if numbers[OUTPUT] == CHOSEN or numbers[OUTPUT] == PARTS_CHOSEN:
        choose(numbers[OUTPUT], outputs, action, scratch)
        return
    for i in range(outputs):
        action[i] = scratch[0, i]
    if numbers[MIRROR] != 0.0:
        for i in range(inputs):
            scratch[2, i] = numbers[signs + i] * row[int(numbers[places + i])]
        normalise(numbers, scale, inputs, scratch)
        forward(numbers, layers, start, states[1], scratch)
        for i in range(outputs):
            place, sign = int(numbers[signs + inputs + i]), numbers[signs + inputs + outputs + i]
            action[i] = 0.5 * (action[i] + sign * scratch[0, place])
    for i in range(0 if numbers[OUTPUT] == VALUES else outputs):
        action[i] = tanh(action[i]) if numbers[OUTPUT] == SQUASHED else clip(action[i], -1.0, 1.0)


@compiled
def normalise(numbers, scale, inputs, scratch):
    """Normalise the inputs in scratch[2]: subtract means, divide by deviations, clip at the limit."""
    if numbers[NORMALISED] == 0.0:
        return
    limit = numbers[scale]
    for i in range(inputs):
        value = (scratch[2, i] - numbers[scale + 1 + i]) / numbers[scale + 1 + inputs + i]
        scratch[2, i] = clip(value, -limit, limit)


@compiled
def choose(use, outputs, action, scratch):
    """Write the action that the outputs in scratch[0] choose."""
    if use == CHOSEN:
        choose_action(outputs, action, scratch)
    else:
        choose_parts(action, scratch)


@compiled
def choose_action(outputs, action, scratch):
    """Write the discrete action with the largest output in scratch[0]."""
    best = index_of_largest(scratch, 0, outputs)
    for i in range(CHOICE):
        action[i] = DISCRETE_TABLE[best, i]


@compiled
def choose_parts(action, scratch):
    """Write the action of the kind "multi" whose parts have the largest outputs in scratch[0]."""
    levels, kicks = len(LEVEL_TABLE), len(KICK_TABLE)
    for part in range(WALK):
        action[part] = LEVEL_TABLE[index_of_largest(scratch, part * levels, levels)]
    kick = index_of_largest(scratch, WALK * levels, kicks)
    action[WALK], action[WALK + 1], action[WALK + 2] = KICK_TABLE[kick, 0], KICK_TABLE[kick, 1], KICK_TABLE[kick, 2]
    action[WALK + 3] = 0.0


@compiled
def index_of_largest(scratch, first, count):
    """Return the index, from `first` on, of the largest of `count` outputs in scratch[0]; the first of equal ones."""
    best = first
    for i in range(first + 1, first + count):
        if scratch[0, i] > scratch[0, best]:
            best = i
    return best - first


@compiled
def forget_if_sent_off(numbers, row, places, states):
    """Set the states (2, units) of a memory to 0 if the observation says that the robot is sent off."""
    if numbers[NETWORK] >= RECURRENT:
        active = int(numbers[memory_shape(numbers) + 1])
        if active >= 0 and row[int(numbers[places + active])] < 0.0:
            states[:] = 0.0


@compiled
def forward(numbers, layers, start, state, scratch):
    """Compute the network's outputs for the inputs in scratch[2], write them into scratch[0], and update `state`."""
    smooth, at = numbers[NETWORK] % RECURRENT == 0.0, start
    units = memory_size(numbers)
    if units > 0:
        at = remember(numbers, at, int(numbers[SIZES]) - units, units, state, scratch)
    for layer in range(layers):
        wide, out = int(numbers[SIZES + layer]), int(numbers[SIZES + layer + 1])
        at = multiply(numbers, at, wide, out, scratch[2], scratch[0])
        if layer < layers - 1:
            for j in range(out):
                scratch[2, j] = tanh(scratch[0, j]) if smooth else max(scratch[0, j], 0.0)


@compiled
def memory_shape(numbers):
    """Return the index at which the shape of a memory begins, if there is one."""
    return SIZES + int(numbers[LAYERS]) + 1


@compiled
def memory_size(numbers):
    """Return the number of units of this network's memory, 0 without."""
    return int(numbers[memory_shape(numbers)]) if numbers[NETWORK] >= RECURRENT else 0


@compiled
def input_size(numbers):
    """Return the number of entries of an observation that this network reads."""
    return int(numbers[SIZES]) - memory_size(numbers)


@compiled
def action_size(numbers):
    """Return the length of an action of this network."""
    if numbers[OUTPUT] == PARTS_CHOSEN:
        return CHOICES
    return CHOICE if numbers[OUTPUT] == CHOSEN else int(numbers[SIZES + int(numbers[LAYERS])])


@compiled
def widest_layer(numbers):
    """Return the width of the widest layer, including inputs, outputs and the gates of a memory."""
    widest = int(numbers[SIZES : SIZES + int(numbers[LAYERS]) + 1].max())
    return max(input_size(numbers), widest, GATES * memory_size(numbers))
