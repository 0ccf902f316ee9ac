"""Hostile ONNX files: one plain line that names the file, no other file read, no endless loop, no memory taken."""

import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.agents.onnx_checks import MAX_FILE
from soccer_env.agents.onnx_team import OnnxPolicy, from_onnx
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from tests.agents.staged_files import assert_refused_by
from tests.agents.staged_onnx import WIDE, array, exported, node, small
from tests.agents.staged_policies import random_policy

onnx = pytest.importorskip("onnx")
pytest.importorskip("onnxruntime")

WHERE = "odd\n\x1b[31m.onnx"  # a file's name is a stranger's too
ROWS = np.ones((3, WIDE), np.float32)


def refused(content: bytes, reason: str) -> None:
    """Check that a file is refused at once in one plain line that names it."""
    began = time.process_time()
    assert_refused_by(lambda: OnnxPolicy(content, WHERE)(ROWS), reason, f"policy file {WHERE!r}: ")
    assert time.process_time() - began < 5.0


def elsewhere(location: str, name: str = "w") -> Any:
    """Return weights (4, 4) that lie in another file."""
    tensor = onnx.TensorProto(name=name, data_type=onnx.TensorProto.FLOAT, dims=[WIDE, WIDE], data_location=1)
    tensor.external_data.add(key="location", value=location)
    return tensor


@pytest.mark.parametrize("where", ["secret.bin", "./secret.bin", "../o/secret.bin", "{folder}/o/secret.bin"])
@pytest.mark.parametrize("place", ["initializer", "attribute", "sparse", "inner graph", "function", "training"])
def test_weights_in_another_file_are_refused_anywhere(where: str, place: str, tmp_path: Path, monkeypatch: Any) -> None:
    (tmp_path / "o").mkdir()
    (tmp_path / "o" / "secret.bin").write_bytes(np.ones(WIDE * WIDE, np.float32).tobytes())
    monkeypatch.chdir(tmp_path / "o")
    tensor = elsewhere(where.format(folder=tmp_path))
    model = small(node("MatMul", "x w", "y"))
    constant = node("Constant", "", "w", value=tensor)
    if place == "initializer":
        model.graph.initializer.append(tensor)
    elif place == "attribute":
        model.graph.node.insert(0, constant)
    elif place == "sparse":
        model.graph.sparse_initializer.add().values.CopyFrom(tensor)
    elif place == "inner graph":
        inner = onnx.helper.make_graph([constant], "then", [], [onnx.helper.make_tensor_value_info("w", 1, None)])
        model.graph.node.append(node("If", "x", "z", then_branch=inner, else_branch=inner))
    elif place == "function":
        model.functions.add(name="f").node.append(constant)
    else:
        model.training_info.add().initialization.initializer.append(tensor)
    said = r"weights in another file, '.*secret.bin': export it with the weights inside, as"
    refused(model.SerializeToString(), said)


def body(name: str) -> Any:
    """Return the inner graph of a loop that goes on."""
    kinds = {"i": onnx.TensorProto.INT64, "on": onnx.TensorProto.BOOL, "still": onnx.TensorProto.BOOL}
    values = {key: onnx.helper.make_tensor_value_info(key, kind, []) for key, kind in kinds.items()}
    kept = [onnx.helper.make_tensor_value_info(key, onnx.TensorProto.FLOAT, ["B", WIDE]) for key in ("a", "b")]
    nodes = [node("Identity", "on", "still"), node("Add", "a a", "b")]
    return onnx.helper.make_graph(nodes, name, [values["i"], values["on"], kept[0]], [values["still"], kept[1]])


def forever() -> Any:
    constants = [array("rounds", 2**62), array("yes", True, kind=bool)]
    return small(node("Loop", "rounds yes x", "y", body=body("forever")), constants=constants)


def ones(*axes: int) -> Any:
    """Return the sum of a constant of ones of any size, added to x."""
    nodes = [node("ConstantOfShape", "n", "big"), node("ReduceSum", "big", "sum", keepdims=0)]
    return small(*nodes, node("Add", "x sum", "y"), constants=[array("n", *axes)])


def doubled(times: int) -> Any:
    """Return x beside itself, 2^times times as wide."""
    names = ["x", *(f"x{number}" for number in range(times - 1)), "y"]
    return small(*(node("Concat", f"{a} {a}", b, axis=1) for a, b in zip(names, names[1:])))


def multiplied(side: int) -> Any:
    """Return a chain of products of large matrices made of nothing."""
    nodes = [node("ConstantOfShape", "n", "m0"), *(node("MatMul", f"m{i} m{i}", f"m{i + 1}") for i in range(4))]
    return small(*nodes, node("ReduceMean", "m4", "one"), node("Add", "x one", "y"), constants=[array("n", side, side)])


def claimed() -> Any:
    """Return weights that claim to be many more than there are bytes."""
    weights = onnx.TensorProto(name="w", data_type=onnx.TensorProto.FLOAT, dims=[WIDE, 2**40], raw_data=b"\0" * 16)
    return small(node("MatMul", "x w", "y"), constants=[weights])


def of_a_function() -> Any:
    """Return a model that calls a function of its own."""
    model = small(node("Add", "x x", "y"))
    function = onnx.helper.make_function("own", "Add", ["a", "b"], ["c"], [node("Mul", "a b", "c")], [])
    model.functions.append(function)
    return model


def data_dependent() -> Any:
    """Return ones, as many as the observation says."""
    nodes = [node("Cast", "x", "long", to=onnx.TensorProto.INT64), node("Slice", "long zero one", "some")]
    nodes += [node("ReduceMax", "some", "n", keepdims=0), node("Reshape", "n one", "flat")]
    nodes += [node("ConstantOfShape", "flat", "y")]
    return small(*nodes, constants=[array("zero", 0), array("one", 1)])


HUGE = {
    "a loop": (forever, r"has the operator 'Loop': it is not among those whose time and memory can be bounded"),
    "ones": (lambda: ones(2_000_000_000), r"computes 20000000\d\d numbers for 1 rows, the limit is 17825792"),
    "ones in many axes": (lambda: ones(*[2] * 40), "computes"),
    "ones beyond 64 bits": (lambda: ones(2**40, 2**40), "computes"),
    "as many as it is told": (data_dependent, "the size of 'y' is not known before it plays"),
    "doubled": (lambda: doubled(60), "computes|does not fit together"),
    "tiled": (lambda: small(node("Tile", "x n", "y"), constants=[array("n", 1, 2**30)]), "computes"),
    "expanded": (lambda: small(node("Expand", "x n", "y"), constants=[array("n", 2**31, 1, WIDE)]), "computes"),
    "outer": (
        lambda: small(node("Gather", "x many", "w", axis=1), node("Transpose", "w", "t"), node("MatMul", "t w", "y"),
                      constants=[array("many", *[0] * 50_000)]), "computes",
    ),
    "products": (lambda: multiplied(1500), r"computes 13500000000 multiplications for 1 rows, the limit is 134217728"),
    "claimed weights": (claimed, "computes|is not sound"),
    "negative weights": (lambda: ones(-1), "computes|does not fit|known"),
    "a function": (of_a_function, "has functions of its own: export it with standard operators alone"),
    "random": (lambda: small(node("RandomNormalLike", "x", "y")), "has the operator 'RandomNormalLike'"),
    "another library": (lambda: small(node("Gelu", "x", "y", domain="com.microsoft")), "operator 'com.microsoft.Gelu'"),
    "many operators": (lambda: small(*(node("Add", "x x", f"z{n}") for n in range(60_000))), "more than 50000 parts"),
    "a division that ends the process": (
        lambda: small(
            node("Cast", "x", "i", to=onnx.TensorProto.INT64), node("Mul", "i zero", "j"), node("Add", "j low", "k"),
            node("Div", "k minus", "l"), node("Cast", "l", "y", to=onnx.TensorProto.FLOAT),
            constants=[array("zero", 0), array("low", -(2**63)), array("minus", -1)],
        ), "'l' divides whole numbers by other than positive constants",
    ),
    "two inputs": (
        lambda: small(node("Add", "x z", "y"), inputs={"x": ["B", 4], "z": ["B", 4]}),
        "must return actions and the new state, of the type of the observations, if it takes a state",
    ),
    "three inputs": (
        lambda: small(node("Sum", "x z w", "y"), inputs=dict.fromkeys("xzw", ["B", 4])),
        r"must have one input \(B, n\), or a state \(B, m\) too, got x \['B', 4\], z \['B', 4\], w \['B', 4\]",
    ),
    "a state of any width": (
        lambda: small(node("Add", "x z", "y"), inputs={"x": ["B", 4], "z": ["B", "n"]}), "n is a number, got 'n'",
    ),
    "any width": (lambda: small(node("Tanh", "x", "y"), inputs={"x": ["B", "n"]}), "where n is a number, got 'n'"),
    "no input": (lambda: small(node("Constant", "", "y", value_float=1.0), inputs={"w": []}), r"got w \[\]"),
}  # fmt: skip


@pytest.mark.parametrize("kind", HUGE)
def test_what_could_take_all_time_or_memory_is_refused_before_it_is_computed(kind: str) -> None:
    make: Callable[[], Any]
    make, reason = HUGE[kind]
    refused(make().SerializeToString(), reason)


def test_a_state_of_another_shape_is_refused() -> None:
    model = small(node("Tanh", "x", "y"), node("Concat", "h x", "g", axis=1), inputs={"x": ["B", 4], "h": ["B", 3]})
    model.graph.output.append(onnx.helper.make_tensor_value_info("g", onnx.TensorProto.FLOAT, ["B", "m"]))
    refused(model.SerializeToString(), r"takes a state of shape \(3, 3\), and returns one of \(3, 7\)")
    model.graph.input[1].type.tensor_type.elem_type = onnx.TensorProto.DOUBLE
    refused(model.SerializeToString(), "new state, of the type of the observations")


def test_what_the_file_says_of_sizes_is_not_believed() -> None:
    model = data_dependent()
    model.graph.value_info.append(onnx.helper.make_tensor_value_info("flat", onnx.TensorProto.INT64, [1]))
    model.graph.output[0].CopyFrom(onnx.helper.make_tensor_value_info("y", onnx.TensorProto.FLOAT, ["B", 4]))
    refused(model.SerializeToString(), "the size of 'y' is not known")


def test_sizes_are_checked_anew_for_each_number_of_rows() -> None:
    nodes = [node("Shape", "x", "s"), node("Gather", "s zero", "b"), node("Sub", "b one", "c")]
    nodes += [node("Mul", "c huge", "n"), node("ConstantOfShape", "n", "z"), node("ReduceSum", "z", "sum", keepdims=0)]
    nodes += [node("Add", "x sum", "y")]
    model = small(*nodes, constants=[array("zero", 0), array("one", 1), array("huge", 2**28)])
    policy = OnnxPolicy(model.SerializeToString(), WHERE)
    assert policy(ROWS[:1]).shape == (1, 4)
    with pytest.raises(ValueError, match="computes 536870.* numbers for 3 rows"):
        policy(ROWS)


def test_broken_files_are_refused(tmp_path: Path) -> None:
    content = Path(exported(random_policy(8), tmp_path / "mine.onnx")).read_bytes()
    for length in (0, 1, 10, 100, len(content) - 1):
        refused(content[:length], "is no ONNX file|must have one input|is not sound")
    with (tmp_path / "large.onnx").open("wb") as file:
        file.truncate(MAX_FILE + 1)
    with pytest.raises(ValueError, match="more than the limit of 16777216"):
        from_onnx(tmp_path / "large.onnx")


def test_a_file_of_millions_of_empty_parts_takes_less_than_two_gigabytes(tmp_path: Path) -> None:
    """Two bytes of a file become 150 in memory: the limit on its size bounds what reading takes."""
    size = MAX_FILE - 8
    length = bytes([size & 127 | 128, size >> 7 & 127 | 128, size >> 14 & 127 | 128, size >> 21])
    (tmp_path / "parts.onnx").write_bytes(b"\x3a" + length + b"\x0a\0" * (size // 2))  # a graph of operators
    code = f"""
import resource
from soccer_env import make_team
try:
    make_team({str(tmp_path / "parts.onnx")!r})
except ValueError as error:
    print(error)
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    said, peak = ran.stdout.splitlines()
    assert "has more than 50000 parts" in said
    assert int(peak) < 2 * 2**20 * (2**10 if sys.platform == "darwin" else 1)


def test_an_evaluation_goes_on_only_as_the_same_file(tmp_path: Path) -> None:
    path = exported(random_policy(8), tmp_path / "mine.onnx")
    team = f"{path}:action_repeat=8"
    settings = EvaluateSettings(home=team, away="still", players=1, matches=2, minutes=0.05, out=tmp_path / "run")
    first = evaluate(settings)
    assert first.conditions.home.endswith("mine.onnx:action_repeat=8")
    assert evaluate(settings).lines == first.lines
    exported(random_policy(8, seed=2), tmp_path / "mine.onnx")
    with pytest.raises(ValueError, match="home_team"):
        evaluate(settings)
    (tmp_path / "w").write_bytes(np.ones(WIDE * WIDE, np.float32).tobytes())
    model = small(node("MatMul", "x w", "y"))
    model.graph.initializer.append(elsewhere("w"))
    (tmp_path / "mine.onnx").write_bytes(model.SerializeToString())
    with pytest.raises(ValueError, match=r"mine.onnx': has weights in another file, 'w': export"):
        evaluate(settings)
