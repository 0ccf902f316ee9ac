"""Safety checks of untrusted ONNX files, so that running time and memory of the network are known before it plays.

    file         at most 16 MiB, all of its weights inside
    operators    those of OPERATORS, of the standard opset; so no loops, no random numbers, no code of other libraries
    sizes        the size of every array follows from that of the observations, within MAX_VALUES and MAX_WORK

onnxruntime trusts its files: it reads other files that they name, loops for ever and takes any amount of memory. So it
never gets the file itself, but a copy that the package `onnx` has parsed and written.
"""

from collections.abc import Iterator
from math import prod
from typing import Any, NoReturn

from soccer_env.guards.checking import short_repr

MAX_FILE = 16 * 2**20  # [bytes] as of our own policy files
MAX_PARTS = 50_000  # messages in a file; an export has a few for each operator
MAX_CONSTANT = 2**24  # numbers in arrays that do not grow with the rows: weights, and transposed weights
MAX_VALUES = 2**20  # numbers in all arrays together, for each row
MAX_WORK = 2**27  # multiplications of matrices for each row; a network of 4 million weights needs 2^22
OPERATORS = {
    *("Add", "Div", "Gemm", "MatMul", "Max", "Mean", "Min", "Mod", "Mul", "Pow", "Sub", "Sum"),
    *("Abs", "Atan", "Ceil", "Cos", "Erf", "Exp", "Floor", "Log", "Neg", "Reciprocal", "Round", "Sign", "Sin", "Sqrt"),
    *("Celu", "Clip", "Elu", "Gelu", "HardSigmoid", "HardSwish", "Hardmax", "LeakyRelu", "LogSoftmax", "Mish", "PRelu"),
    *("Relu", "Selu", "Sigmoid", "Softmax", "Softplus", "Softsign", "Swish", "Tan", "Tanh", "ThresholdedRelu"),
    *("BatchNormalization", "LayerNormalization", "RMSNormalization"),
    *("And", "Equal", "Greater", "GreaterOrEqual", "IsInf", "IsNaN", "Less", "LessOrEqual", "Not", "Or", "Where"),
    *("ArgMax", "ArgMin", "CumSum", "ReduceL2", "ReduceLogSumExp", "ReduceMax", "ReduceMean", "ReduceMin"),
    *("ReduceProd", "ReduceSum", "ReduceSumSquare"),
    *("Cast", "Concat", "Constant", "ConstantOfShape", "Expand", "Flatten", "Gather", "GatherElements", "Identity"),
    *("Range", "Reshape", "Shape", "Slice", "Split", "Squeeze", "Tile", "Transpose", "Trilu", "Unsqueeze"),
}
NUMBERS = (1, 2, 3, 6, 7, 9, 10, 11)  # of TensorProto: FLOAT, UINT8, INT8, INT32, INT64, BOOL, FLOAT16, DOUBLE
WHOLE = (2, 3, 6, 7)
INSIDE = "export it with the weights inside, as by torch.onnx.export(..., external_data=False)"


def checked_model(content: bytes) -> Any:
    """Parse an ONNX file and return its model without unneeded fields; ValueError if the model is unsafe."""
    import onnx

    try:
        model = onnx.ModelProto.FromString(content)
    except Exception:  # protobuf's own kinds of errors
        raise ValueError("is no ONNX file") from None
    for part in all_messages(model):
        if isinstance(part, onnx.TensorProto) and (part.external_data or part.data_location == part.EXTERNAL):
            name = next((entry.value for entry in part.external_data if entry.key == "location"), "")
            raise ValueError(f"has weights in another file, {short_repr(name)}: {INSIDE}")
    model.DiscardUnknownFields()
    graph = model.graph
    for what, extras in (("functions of its own", model.functions), ("sparse weights", graph.sparse_initializer)):
        if extras:
            raise ValueError(f"has {what}: export it with standard operators alone")
    for name in ("training_info", "metadata_props"):
        model.ClearField(name)
    for name in ("value_info", "quantization_annotation"):
        graph.ClearField(name)
    check_operators(graph.node)
    check_inputs(model)
    try:
        onnx.checker.check_model(model)
    except Exception as error:  # protobuf's, or the checker's
        raise ValueError(f"is not sound: {error}") from None
    return model


def all_messages(model: Any) -> Iterator[Any]:
    """Yield all protobuf messages inside a message, with inner graphs and functions; ValueError if too many."""
    waiting, count = [model], 0
    while waiting:
        message = waiting.pop()
        yield message
        for field, value in message.ListFields():
            if field.message_type is not None:
                parts = [value] if hasattr(value, "ListFields") else value
                count += len(parts)
                if count > MAX_PARTS:
                    raise ValueError(f"has more than {MAX_PARTS} parts")
                waiting.extend(parts)


def check_operators(nodes: Any) -> None:
    """Raise ValueError for an operator that is not in OPERATORS."""
    for node in nodes:
        if node.domain not in ("", "ai.onnx") or node.op_type not in OPERATORS:
            name = f"{node.domain}.{node.op_type}" if node.domain else node.op_type
            why = "it is not among those whose time and memory can be bounded (soccer_env.agents.onnx_checks.OPERATORS)"
            raise ValueError(f"has the operator {short_repr(name)}: {why}")


def check_inputs(model: Any) -> None:
    """Raise ValueError unless a model has one input or two of shape (B, n) with a fixed n, and an output for each.

    The second input and output are the state of a recurrent memory.
    """
    inputs = inputs_of(model)
    axes = {one.name: [axis.dim_param or axis.dim_value for axis in declared_axes(one)] for one in inputs}
    if [len(sizes) for sizes in axes.values()] not in ([2], [2, 2]):
        got = ", ".join(f"{name} {sizes}" for name, sizes in axes.items())
        raise ValueError(
            f"must have one input (B, n), or a state (B, m) too, got {got or 'none'}; see team_of_function"
        )
    for _, width in axes.values():
        if not isinstance(width, int) or width < 1:
            raise ValueError(f"must have inputs (B, n) where n is a number, got {short_repr(width)}")
    if len(inputs) == 2 and (len(model.graph.output) < 2 or element_type(inputs[0]) != element_type(inputs[1])):
        raise ValueError("must return actions and the new state, of the type of the observations, if it takes a state")


def inputs_of(model: Any) -> list[Any]:
    """Return the inputs of a model, leaving out weights."""
    weights = {tensor.name for tensor in model.graph.initializer}
    return [one for one in model.graph.input if one.name not in weights]


def declared_axes(value: Any) -> Any:
    """Return the axes that an ONNX file declares for an array."""
    return value.type.tensor_type.shape.dim


def check_sizes(model: Any, rows: int) -> None:
    """Raise ValueError unless all array sizes and all work of a model for `rows` rows are known and limited."""
    import onnx

    pinned = onnx.ModelProto()
    pinned.CopyFrom(model)
    for one in inputs_of(pinned):
        declared_axes(one)[0].dim_value = rows
    for output in pinned.graph.output:  # sizes in the file are not trusted
        output.type.tensor_type.ClearField("shape")
    try:
        graph = onnx.shape_inference.infer_shapes(pinned, check_type=True, strict_mode=True, data_prop=True).graph
    except Exception as error:
        raise ValueError(f"does not fit together: {error}") from None
    arrays = {
        one.name: (axis_sizes(one), element_type(one)) for one in (*graph.input, *graph.value_info, *graph.output)
    }
    arrays |= {weight.name: (tuple(weight.dims), weight.data_type) for weight in graph.initializer}
    for name in (name for node in graph.node for name in node.output if name and name not in arrays):
        raise_unknown_size(name)
    for name, (_, kind) in arrays.items():
        if kind not in NUMBERS:
            raise ValueError(f"{short_repr(name)} holds no numbers")
    check_divisions(graph, {name: kind for name, (_, kind) in arrays.items()})
    sizes = {name: size for name, (size, _) in arrays.items()}
    check_cost(sum(map(prod, sizes.values())), "numbers", MAX_CONSTANT, MAX_VALUES, rows)
    check_cost(sum(count_multiplications(node, sizes) for node in graph.node), "multiplications", 0, MAX_WORK, rows)


def check_cost(cost: int, what: str, once: int, each: int, rows: int) -> None:
    """Raise ValueError if a cost exceeds its limit: `once`, plus `each` per row."""
    if cost > once + each * rows:
        raise ValueError(f"computes {cost} {what} for {rows} rows, the limit is {once + each * rows}")


def check_divisions(graph: Any, kinds: dict[str, int]) -> None:
    """Raise ValueError for a division of whole numbers except by positive constants: 0 would end the process."""
    from onnx.numpy_helper import to_array

    constants = {weight.name: weight for weight in graph.initializer}
    constants |= {node.output[0]: node.attribute[0].t for node in graph.node if node.op_type == "Constant"}
    for node in graph.node:
        if node.op_type in ("Div", "Mod") and kinds[node.input[1]] in WHOLE:
            divisor = constants.get(node.input[1])
            if divisor is None or divisor.data_type not in WHOLE or not (to_array(divisor) > 0).all():
                raise ValueError(f"{short_repr(node.output[0])} divides whole numbers by other than positive constants")


def axis_sizes(value: Any) -> tuple[int, ...]:
    """Return the sizes of the axes of an array; ValueError if a size is unknown."""
    kind = value.type.tensor_type
    axes = tuple(axis.dim_value if axis.HasField("dim_value") else -1 for axis in kind.shape.dim)
    if not kind.HasField("shape") or min(axes, default=0) < 0:
        raise_unknown_size(value.name)
    return axes


def element_type(value: Any) -> int:
    """Return the type of an array's elements."""
    kind: int = value.type.tensor_type.elem_type
    return kind


def raise_unknown_size(name: str) -> NoReturn:
    """Raise ValueError for an array whose size does not follow from the size of the observations."""
    raise ValueError(
        f"the size of {short_repr(name)} is not known before it plays: export it for a fixed size, simplified (onnxsim)"
    )


def count_multiplications(node: Any, sizes: dict[str, tuple[int, ...]]) -> int:
    """Return the number of multiplications in a matrix product; 0 for other operators."""
    if node.op_type not in ("MatMul", "Gemm"):
        return 0
    first = sizes[node.input[0]]
    turned = any(one.name == "transA" and one.i for one in node.attribute)
    return prod(sizes[node.output[0]]) * (first[0] if turned else first[-1])
