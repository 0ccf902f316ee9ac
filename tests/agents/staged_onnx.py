"""ONNX files for tests: as libraries export them, and as strangers might; onnx is imported on first use."""

from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.agents.policy import Policy

WIDE = 4  # inputs and outputs of small ones


def exported(policy: Policy, path: Path, batch: Any = "B", double: bool = False, chosen: bool = False) -> str:
    """Write a policy's network as an ONNX file, as libraries export it; return its path."""
    import onnx

    kind = onnx.TensorProto.DOUBLE if double else onnx.TensorProto.FLOAT
    nodes, constants, last = [], [], "seen"
    for number, (weight, bias) in enumerate(zip(policy.weights, policy.biases, strict=True)):
        names = [f"w{number}", f"b{number}"]
        for name, array in zip(names, (weight, bias), strict=True):
            constants.append(onnx.numpy_helper.from_array(array.astype(np.float64 if double else np.float32), name))
        nodes.append(onnx.helper.make_node("Gemm", [last, *names], [f"h{number}"], transB=1))
        last = f"h{number}"
        if number < len(policy.weights) - 1:
            nodes.append(onnx.helper.make_node("Tanh", [last], [f"t{number}"]))
            last = f"t{number}"
    shape, out = [batch, len(policy.biases[-1])], kind
    if chosen:
        nodes.append(onnx.helper.make_node("ArgMax", [last], ["best"], axis=1, keepdims=0))
        last, shape, out = "best", [batch], onnx.TensorProto.INT64
    inputs = [onnx.helper.make_tensor_value_info("seen", kind, [batch, len(policy.inputs)])]
    outputs = [onnx.helper.make_tensor_value_info(last, out, shape)]
    graph = onnx.helper.make_graph(nodes, "policy", inputs, outputs, constants)
    model = onnx.helper.make_model(graph, opset_imports=[onnx.helper.make_opsetid("", 17)], ir_version=9)
    path.write_bytes(model.SerializeToString())
    return str(path)


def node(kind: str, inputs: str, outputs: str, **attributes: Any) -> Any:
    import onnx

    return onnx.helper.make_node(kind, inputs.split(), outputs.split(), **attributes)


def array(name: str, *numbers: Any, kind: Any = np.int64) -> Any:
    import onnx

    return onnx.numpy_helper.from_array(np.array(numbers, kind), name)


def small(*nodes: Any, constants: Any = (), inputs: dict[str, Any] | None = None, **more: Any) -> Any:
    """Return a model from x (B, 4) to y."""
    import onnx

    told, kind = onnx.helper.make_tensor_value_info, onnx.TensorProto.FLOAT
    given = [told(name, kind, axes) for name, axes in (inputs or {"x": ["B", WIDE]}).items()]
    out = [told("y", kind, ["rows", "columns"])]
    graph = onnx.helper.make_graph(nodes, "g", given, out, constants)
    return onnx.helper.make_model(graph, opset_imports=[onnx.helper.make_opsetid("", 17)], ir_version=9, **more)
