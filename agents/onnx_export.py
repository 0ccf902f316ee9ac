"""Write policies as ONNX files, which other programs compute: `save_onnx`.

    inputs    seen (B, n): the policy's inputs, in its order; with a memory also state (B, m), 0 at first
    outputs   actions (B, 4 or 7), or values of discrete actions; with a memory also the new state (B, m)

m is the number of units, or twice that with a mirror: the states of the observation and of its mirror image.
"""

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.actions import PARTS, action_mirror
from soccer_env.agents.policy import Policy
from soccer_env.agents.policy_file import load
from soccer_env.agents.recurrent import ACTIVE, memory_units
from soccer_env.guards.whole_files import write_atomically
from soccer_env.observations.reflection import observation_signs

ENDING = ".onnx"
OPSET, FORMAT = 17, 9  # versions of the operators and of the file


class Graph:
    """The nodes and constants of a network that is being written; arrays are known by name."""

    def __init__(self) -> None:
        self.nodes: list[Any] = []
        self.constants: list[Any] = []

    def constant(self, array: Any) -> str:
        """Add an array, of float32 unless it holds whole numbers, and return its name."""
        from onnx.numpy_helper import from_array

        values = np.asarray(array)
        name = f"constant{len(self.constants)}"
        self.constants.append(from_array(values if values.dtype.kind == "i" else values.astype(np.float32), name))
        return name

    def add(self, kind: str, *inputs: str, outputs: int = 1, **settings: Any) -> Any:
        """Add an operator and return the name of its output, or the names of several."""
        from onnx.helper import make_node

        names = [f"value{len(self.nodes)}_{index}" for index in range(outputs)]
        self.nodes.append(make_node(kind, inputs, names, **settings))
        return names[0] if outputs == 1 else names

    def layer(self, weight: np.ndarray, bias: np.ndarray, values: str) -> str:
        """Add a layer (out, in) without activation; return the name of its outputs."""
        name: str = self.add("Gemm", values, self.constant(weight), self.constant(bias), transB=1)
        return name


def save_onnx(policy: Policy | str | os.PathLike[str], path: str | os.PathLike[str]) -> None:
    """Write a policy, or that of a policy file, as an ONNX file.

    It plays as `FILE.onnx:observe=...,action_repeat=...,at_once=...` with the settings of the policy, in float32.
    """
    if Path(path).suffix != ENDING:
        raise ValueError(f"an ONNX file must end in {ENDING}, got {os.fspath(path)!r}")
    policy = policy if isinstance(policy, Policy) else load(policy)
    try:
        from onnx import TensorProto, helper
    except ImportError:
        raise ImportError("an ONNX file is written by onnx: pip install soccer_env[onnx]") from None
    if policy.actions == "skills":
        raise ValueError(f"policy {policy.name!r} chooses skills, which an ONNX file cannot carry out")
    graph, units = Graph(), memory_units(policy.memory) * (1 + policy.mirror)
    results = write_images(graph, policy)
    sizes = {"seen": len(policy.inputs), "state": units, results[-1]: units}
    sizes[results[0]] = len(policy.biases[-1])
    told = {name: helper.make_tensor_value_info(name, TensorProto.FLOAT, ["B", size]) for name, size in sizes.items()}
    inputs = [told["seen"], told["state"]][: len(results)]
    made = helper.make_graph(graph.nodes, policy.name, inputs, [told[name] for name in results], graph.constants)
    model = helper.make_model(made, opset_imports=[helper.make_opsetid("", OPSET)], ir_version=FORMAT)
    write_atomically(Path(path), model.SerializeToString())


def write_images(graph: Graph, policy: Policy) -> Sequence[str]:
    """Write the network for the observation and, with a mirror, for its image; return the names of all results."""
    images, states = ["seen"], [""]
    if policy.mirror:
        images.append(graph.add("Mul", "seen", graph.constant(observation_signs(policy.entries))))
        states.append("")
    if policy.memory:
        states = awake_states(graph, policy, len(images))
    found = [write_network(graph, policy, *pair) for pair in zip(images, states, strict=True)]
    actions = found[0][0]
    if policy.mirror:
        turned = graph.add("Mul", found[1][0], graph.constant(action_mirror(policy.actions)[1]))
        actions = graph.add("Mean", actions, turned)
    if policy.actions not in PARTS:
        limits = graph.constant(np.float32(-1.0)), graph.constant(np.float32(1.0))
        actions = graph.add("Tanh", actions) if policy.squash else graph.add("Clip", actions, *limits)
    after = [state for _, state in found]
    return (actions, graph.add("Concat", *after, axis=1)) if policy.memory else (actions,)


def awake_states(graph: Graph, policy: Policy, images: int) -> list[str]:
    """Write the states of all images, which are 0 where the robot is sent off; return their names."""
    state = "state"
    if ACTIVE in policy.inputs:
        active = graph.add("Gather", "seen", graph.constant(np.array([policy.inputs.index(ACTIVE)])), axis=1)
        plays = graph.add("GreaterOrEqual", active, graph.constant(np.float32(0.0)))
        state = graph.add("Mul", state, graph.add("Cast", plays, to=1))  # to float32
    return graph.add("Split", state, outputs=images, axis=1) if images > 1 else [state]


def write_network(graph: Graph, policy: Policy, seen: str, state: str) -> tuple[str, str]:
    """Write normalisation, memory and layers for one image; return the names of outputs and new state."""
    values, table = seen, policy.normalise
    if table:
        centred = graph.add("Sub", values, graph.constant(table["mean"]))
        limits = (graph.constant(np.float32(sign * min(table["limit"], 3e38))) for sign in (-1.0, 1.0))
        values = graph.add("Clip", graph.add("Div", centred, graph.constant(table["deviation"])), *limits)
    if policy.memory:
        state = write_memory(graph, policy.memory, values, state)
        values = graph.add("Concat", values, state, axis=1)
    for number, (weight, bias) in enumerate(zip(policy.weights, policy.biases, strict=True)):
        values = graph.layer(weight, bias, values)
        if number < len(policy.weights) - 1:
            values = graph.add("Tanh" if policy.activation == "tanh" else "Relu", values)
    return values, state


def write_memory(graph: Graph, tensors: Sequence[np.ndarray], values: str, state: str) -> str:
    """Write a step of the memory, the equations of `recurrent.py`; return the name of the new state."""
    weight, bias, state_weight, state_bias = tensors
    read = graph.add("Split", graph.layer(weight, bias, values), outputs=3, axis=1)
    kept = graph.add("Split", graph.layer(state_weight, state_bias, state), outputs=3, axis=1)
    reset, update = (graph.add("Sigmoid", graph.add("Add", read[gate], kept[gate])) for gate in (0, 1))
    new = graph.add("Tanh", graph.add("Add", read[2], graph.add("Mul", reset, kept[2])))
    change = graph.add("Mul", update, graph.add("Sub", state, new))
    name: str = graph.add("Add", new, change)
    return name
