"""Files of policies with attention, paths to no file, and files full of faults: read, or refused in one line."""

import json
import os
import socket
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.agents.attention import TENSORS
from soccer_env.agents.policy_file import KEY, dump, load, parse
from tests.agents.staged_files import WHERE, assert_content_refused, assert_refused_by, pack_safetensors, without_key
from tests.agents.staged_policies import SMALL_ATTENTION, random_policy

INPUTS = SMALL_ATTENTION.inputs
GOOD = dump(SMALL_ATTENTION)
LENGTH = int.from_bytes(GOOD[:8], "little")
HEADER: dict[str, Any] = json.loads(GOOD[8 : 8 + LENGTH])
TABLE: dict[str, Any] = json.loads(HEADER["__metadata__"][KEY])
BODY = GOOD[8 + LENGTH :]
QUERY = "opponent.query"


def with_fields(**changes: Any) -> bytes:
    return pack_safetensors({**HEADER, "__metadata__": {KEY: json.dumps({**TABLE, **changes})}}, BODY)


def with_tensor(name: str, **changes: Any) -> bytes:
    return pack_safetensors({**HEADER, name: {**HEADER[name], **changes}}, BODY)


def with_number(name: str, value: float) -> bytes:
    """Return the file with the first number of a tensor replaced."""
    at = HEADER[name]["data_offsets"][0]
    return pack_safetensors(HEADER, BODY[:at] + np.array([value], "<f4").tobytes() + BODY[at + 4 :])


def test_its_tensors_have_names_and_the_version_is_that_of_all() -> None:
    layers = {f"layer{n}.{part}" for n in (0, 1) for part in ("weight", "bias")}
    assert HEADER.keys() - {"__metadata__"} == layers | {*TENSORS}
    assert TABLE["kind"] == "attention" and TABLE["version"] == 3
    assert dump(parse(with_fields(), WHERE)) == GOOD


@pytest.mark.parametrize("name", TENSORS)
def test_every_tensor_is_needed_and_of_its_shape(name: str) -> None:
    assert_content_refused(pack_safetensors(without_key(HEADER, name), BODY), f"lacks the tensor '{name}'|has a tensor")
    axes = 1 if name.endswith("bias") else 2
    for shape in ([1] * (3 - axes), [0] * axes, [2.0] * axes, [2**40] * axes, [5000] * axes, "2"):
        assert_content_refused(with_tensor(name, shape=shape), f"{name} must have {axes} axes of 1 to 4096")
    assert_content_refused(with_tensor(name, dtype="F64"), f"{name} must be of dtype 'F32'")
    assert_content_refused(with_tensor(name, code="x"), f"{name} must have data_offsets, dtype, shape and nothing else")
    assert_content_refused(with_number(name, np.nan), f"{name} must be finite")
    assert_content_refused(with_number(name, -np.inf), f"{name} must be finite")
    assert_content_refused(with_number(name, 3e38), "must stay below")


def test_what_belongs_to_one_kind_is_refused_in_the_other() -> None:
    assert_content_refused(with_fields(kind="slots"), "lacks the tensor 'layer2.bias'|has a tensor")
    assert_content_refused(with_fields(kind="Attention"), "lacks the tensor|has a tensor")
    assert_content_refused(with_fields(kind=["attention"]), "kind must be of the JSON type of str")
    slots = dump(random_policy(3))
    length = int.from_bytes(slots[:8], "little")
    header = json.loads(slots[8 : 8 + length])
    text = header["__metadata__"][KEY].replace('"kind":"slots"', '"kind":"attention"')
    assert text != header["__metadata__"][KEY]
    content = pack_safetensors({**header, "__metadata__": {KEY: text}}, slots[8 + length :])
    assert_content_refused(content, "lacks the tensor 'opponent.bias'")
    only = {name: entry for name, entry in HEADER.items() if not name.startswith("layer")}
    assert_content_refused(pack_safetensors(only, BODY), "not fully covered|1 to 8 layers, got 0|Error")


def test_inputs_that_do_not_end_in_slots_are_refused() -> None:
    others = [("seen", 0, 0), ("present", 1, 1), ("present", 0, 9999)]
    wrong = [INPUTS[1:], INPUTS[::-1], ("ball_x", "a", "b", "c", "d"), ("ball_x", *INPUTS[3:], *INPUTS[1:3])]
    for inputs in (*wrong, *((*INPUTS[:3], f"opponent_{n}_{word}", f"opponent_{m}_x") for word, n, m in others)):
        assert_content_refused(with_fields(inputs=list(inputs)), "needs inputs that end in slots")


def test_sizes_that_do_not_agree_are_refused() -> None:
    longer = (*INPUTS, "opponent_1_present", "opponent_1_x")
    assert parse(with_fields(inputs=list(longer)), WHERE).inputs == longer, "shared weights fit any number of slots"
    said = r"teammate.query must have the shape \(2, 2\), got \(2, 1\)"
    assert_content_refused(with_fields(inputs=["ball_y", *INPUTS]), said)
    turned = [*reversed(HEADER["layer0.weight"]["shape"])]
    assert_content_refused(with_tensor("layer0.weight", shape=turned), r"layer0 must have a weight \(3, 5\)")
    assert_content_refused(with_tensor(QUERY, data_offsets=HEADER["teammate.query"]["data_offsets"]), "Error|offset")


def refuses(path: Any, reason: str) -> None:
    assert_refused_by(lambda: load(path), reason, "policy file ")


def test_what_is_no_file_is_refused(tmp_path: Path) -> None:
    refuses(tmp_path, "is a folder")
    refuses(tmp_path / "none", "No such file")
    refuses("a\0b", "null")
    refuses("a\n" * 5000, "name too long")
    refuses(0, "not int")  # no reading from standard input
    refuses(None, "not NoneType")
    (tmp_path / "empty").touch()
    refuses(tmp_path / "empty", "0 bytes")
    (tmp_path / "good").write_bytes(GOOD)
    load(str(tmp_path / "good"))


@pytest.mark.skipif(os.name != "posix", reason="links, pipes and devices of Unix")
def test_links_pipes_and_devices_do_not_hang(tmp_path: Path) -> None:
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    refuses(tmp_path / "a", "symbolic links")
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to("pipe")
    with socket.socket(socket.AF_UNIX) as server:
        server.bind(os.path.relpath(tmp_path / "socket"))
    for strange in (tmp_path / "pipe", tmp_path / "link", tmp_path / "socket", "/dev/zero"):
        refuses(strange, "is not a regular file")


def test_a_sparse_giant_is_not_read(tmp_path: Path) -> None:
    with (tmp_path / "giant").open("wb") as file:
        file.truncate(2**40)
    refuses(tmp_path / "giant", "has 1099511627776 bytes, more than the limit")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="children of Unix")
def test_faulty_files_are_refused_in_one_line_and_end_no_process() -> None:
    pytest.importorskip("onnx")
    pytest.importorskip("onnxruntime")
    from tests.agents.fuzzed_files import fuzz

    assert fuzz(500) == 0
