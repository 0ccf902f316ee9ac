"""Hostile and broken policy files: one plain line that names the file, no code run, the process alive."""

import json
import os
import pickle
import struct
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from soccer_env.agents.policy_file import KEY, MAX_FILE, MAX_HEADER, dump, load, parse
from tests.agents.staged_files import (
    BODY,
    GOOD,
    HEADER,
    TABLE,
    WHERE,
    assert_content_refused,
    pack_safetensors,
    with_fields,
    with_table,
    with_tensor,
    without_key,
)
from tests.agents.staged_policies import random_recurrent_policy
from tests.agents.staged_zips import Canary


def numbers(*values: float) -> bytes:
    """Return the body with its first numbers replaced."""
    return np.array(values, "<f4").tobytes() + BODY[4 * len(values) :]


def with_metadata(metadata: Any) -> bytes:
    return pack_safetensors(HEADER | {"__metadata__": metadata})


def test_the_corpus_starts_from_a_good_file() -> None:
    assert dump(parse(GOOD, WHERE)) == GOOD
    assert dump(parse(pack_safetensors(HEADER), WHERE)) == GOOD
    assert dump(parse(with_table(TABLE), WHERE)) == GOOD


SMALL_MEMORY = random_recurrent_policy(2, units=2, inputs=("ball_x", "active"))
FILES = {"slots": GOOD, "memory": dump(SMALL_MEMORY)}
all_kinds = pytest.mark.parametrize("good", FILES.values(), ids=FILES)


@all_kinds
def test_a_file_that_is_cut_off_anywhere_is_refused(good: bytes) -> None:
    for length in range(len(good)):
        assert_content_refused(good[:length])
    assert_content_refused(good + b"\0", "not fully covered")
    assert_content_refused(good + good)


@all_kinds
def test_a_flipped_bit_is_refused_or_harmless(good: bytes) -> None:
    for place in range(len(good)):
        for bit in (0, 3, 7):
            content = bytearray(good)
            content[place] ^= 1 << bit
            try:
                found = parse(bytes(content), WHERE)
            except ValueError as refusal:
                assert str(refusal).startswith(f"policy file {WHERE!r}: ") and str(refusal).isprintable()
            else:  # another word of free text, or another weight
                assert all(np.isfinite(array).all() for array in found.weights + found.biases + found.memory)


@settings(max_examples=100)
@given(st.binary(max_size=200), st.booleans())
def test_any_bytes_are_refused(noise: bytes, behind_a_length: bool) -> None:
    assert_content_refused(struct.pack("<Q", len(noise)) + noise if behind_a_length else noise)


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    max_leaves=8,
)


@settings(max_examples=100)
@given(st.sampled_from(sorted(TABLE)), JSON)
def test_any_json_in_a_field_is_refused_or_a_policy(key: str, value: Any) -> None:
    try:
        parse(with_fields(**{key: value}), WHERE)
    except ValueError as refusal:
        assert str(refusal).startswith(f"policy file {WHERE!r}: ") and str(refusal).isprintable()


@settings(max_examples=100)
@given(st.sampled_from(["dtype", "shape", "data_offsets", "more"]), JSON)
def test_any_json_in_a_tensor_is_refused(key: str, value: Any) -> None:
    if value != HEADER["layer0.weight"].get(key, None):
        assert_content_refused(with_tensor("layer0.weight", **{key: value}))


SHIFTED = {name: dict(entry) for name, entry in HEADER.items() if name != "__metadata__"}


OPEN = json.dumps(HEADER).encode()[:-1]  # to be closed
DEEP = "[" * 100_000 + "]" * 100_000


CORPUS = {
    "empty": (b"", "0 bytes"),
    "length only": (struct.pack("<Q", 0), "header is not JSON"),
    "header of 2^63 bytes": (pack_safetensors(HEADER, length=2**63), "limit is"),
    "header of 2^64 - 1 bytes": (pack_safetensors(HEADER, length=2**64 - 1), "limit is"),
    "header over the limit": (pack_safetensors(json.dumps(HEADER).encode() + b" " * MAX_HEADER), "limit is"),
    "header longer than the file": (pack_safetensors(HEADER, length=len(GOOD) + 100), "is cut off"),
    "more than 16 MiB": (pack_safetensors(HEADER, b"\0" * MAX_FILE), "more than the limit of 16777216"),
    "header of another encoding": (pack_safetensors(json.dumps(HEADER).encode("utf-16")), "header is not JSON"),
    "header is a list": (pack_safetensors(b"[1]"), "must be a JSON object"),
    "header is nothing": (pack_safetensors(b"null"), "must be a JSON object"),
    "deep header": (pack_safetensors(f'{{"a":{DEEP}}}'.encode()), "nested too deeply|unexpected|metadata"),
    "two names alike": (pack_safetensors(OPEN + b',"layer0.bias":{}}'), "'layer0.bias' twice"),
    "two metadata": (pack_safetensors(OPEN + b',"__metadata__":{}}'), "'__metadata__' twice"),
    "no metadata": (pack_safetensors(without_key(HEADER, "__metadata__")), "is no policy file"),
    "more metadata": (with_metadata(HEADER["__metadata__"] | {"format": "pt"}), "nothing else"),
    "metadata of numbers": (with_metadata({KEY: 1}), "is no policy file"),
    "metadata is a list": (with_metadata([KEY]), "is no policy file"),
    "table is no JSON": (with_table("{"), "is not JSON"),
    "table is code": (with_table("__import__('os').abort()"), "is not JSON"),
    "table is a list": (with_table([]), "must be a JSON object"),
    "deep table": (with_table(DEEP), "nested too deeply"),
    "deep field": (with_table(json.dumps(TABLE)[:-1] + f',"made":{DEEP}}}'), "nested too deeply|twice"),
    "key twice": (with_table(json.dumps(TABLE)[:-1] + ',"name":"b"}'), "the key 'name' twice"),
    "key twice in made": (with_table(json.dumps(TABLE).replace('{"seed": "1"}', '{"a":"","a":""}')), "'a' twice"),
    "NaN": (with_table(json.dumps(TABLE).replace('"action_repeat": 1', '"action_repeat": NaN')), "holds NaN"),
    "-Infinity": (with_table(json.dumps(TABLE).replace("false", "-Infinity")), "holds -Infinity"),
    "infinite number": (with_table(json.dumps(TABLE).replace('"action_repeat": 1', '"action_repeat": 1e999')), "inf"),
    "huge number": (with_table(json.dumps(TABLE).replace("false", "9" * 100_000, 1)), "number of 100000 digits"),
    "huge size": (pack_safetensors(json.dumps(HEADER).replace("[3, 2]", f"[{'9' * 5000}]").encode()), "5000 digits"),
    "other version": (
        with_fields(version=99),
        r"is of format version 99; this soccer_env \(0\.1\.0\) reads versions 3 ",
    ),
    "a later maker": (with_fields(version=99, made={"soccer_env": "9\n[red]"}), r"made by soccer_env 9 \[red\]; this"),
    "version in words": (with_fields(version="1"), "is of format version '1'"),
    "version is true": (with_fields(version=True), "is of format version True"),
    "no version": (with_table(without_key(TABLE, "version")), "is of format version None"),
    "unknown key": (with_fields(code="import os"), "unknown key 'code'"),
    "unknown long key": (with_fields(**{"x\n" * 10_000: 1}), "unknown key 'x"),
    "repeat is true": (with_fields(action_repeat=True), "action_repeat must be of the JSON type of int"),
    "other kind": (with_fields(kind="attention"), "kind must be one of slots, got 'attention'"),
    "mirror is 0": (with_fields(mirror=0), "mirror must be of the JSON type of bool"),
    "rules are a list": (with_fields(rules=[]), "rules must be of the JSON type of dict"),
    "rules without a name": (with_fields(rules={"pushing": True}), r"rules\['name'\] must be a text"),
    "a rule is a text": (with_fields(rules={"name": "league", "pushing": "on"}), r"rules\['pushing'\] must be True"),
    "a rule of code": (with_fields(rules={"name": "league", "a b": 1}), "a key of rules must be the name of a rule"),
    "too many rules": (with_fields(rules={"name": "", **{f"r{n}": 1 for n in range(200)}}), "at most 200 entries"),
    "letters that move": (with_fields(rules={"name": "league\x1b[31m"}), "must be plain text"),
    "inputs are a text": (with_fields(inputs="ab"), "inputs must be of the JSON type of list"),
    "inputs are lists": (with_fields(inputs=[["a"], ["b"]]), "input 0 must be"),
    "too many inputs": (with_fields(inputs=[f"i{n}" for n in range(5000)]), "got 5000"),
    "other width": (with_fields(inputs=["a", "b", "c"]), r"layer0 must have a weight \(3, 3\)"),
    "other actions": (with_fields(actions="full"), "layer1 must have a weight"),
    "lone surrogate": (with_table('{"a":"\ud800"}'), "no policy file|not JSON|version"),
    "NaN weight": (pack_safetensors(HEADER, numbers(np.nan)), "must be finite"),
    "infinite weight": (pack_safetensors(HEADER, numbers(1, np.inf)), "must be finite"),
    "overflowing weight": (pack_safetensors(HEADER, numbers(3e38, 3e38)), "must stay below"),
    "float64": (with_tensor("layer0.bias", dtype="F64"), "must be of dtype 'F32', got 'F64'"),
    "bfloat16": (with_tensor("layer0.bias", dtype="BF16"), "must be of dtype 'F32', got 'BF16'"),
    "int32": (with_tensor("layer0.bias", dtype="I32"), "must be of dtype 'F32', got 'I32'"),
    "dtype is a list": (with_tensor("layer0.bias", dtype=["F32"]), "must be of dtype"),
    "no dtype": (
        pack_safetensors(HEADER | {"layer0.bias": without_key(HEADER["layer0.bias"], "dtype")}),
        "nothing else",
    ),
    "field of a tensor": (with_tensor("layer0.bias", code="x"), "nothing else"),
    "tensor is a text": (pack_safetensors({**HEADER, "layer0.bias": "x"}), "nothing else"),
    "turned shape": (with_tensor("layer0.weight", shape=[2, 3]), r"layer0 must have a weight \(3, 2\)"),
    "flat shape": (with_tensor("layer0.weight", shape=[6]), "must have 2 axes"),
    "deep shape": (with_tensor("layer0.weight", shape=[1] * 1000), "must have 2 axes"),
    "negative shape": (with_tensor("layer0.weight", shape=[-3, -2]), "must have 2 axes of 1 to 4096"),
    "shape of floats": (with_tensor("layer0.weight", shape=[3.0, 2.0]), "must have 2 axes"),
    "shape of truth": (with_tensor("layer0.bias", shape=[True]), "must have 1 axes"),
    "huge shape": (with_tensor("layer0.weight", shape=[2**40, 2**40]), "must have 2 axes"),
    "empty shape": (with_tensor("layer0.weight", shape=[0, 2**60], data_offsets=[0, 0]), "must have 2 axes"),
    "larger shape": (with_tensor("layer0.weight", shape=[4, 2]), "invalid|Error"),
    "overlap": (with_tensor("layer1.bias", data_offsets=HEADER["layer0.weight"]["data_offsets"]), "Error|offset"),
    "hole": (pack_safetensors(HEADER, BODY + b"1234"), "not fully covered"),
    "offsets backwards": (with_tensor("layer0.bias", data_offsets=[12, 0]), "Error"),
    "negative offsets": (with_tensor("layer0.bias", data_offsets=[-12, 0]), "Error"),
    "offsets behind the end": (with_tensor("layer0.bias", data_offsets=[2**62, 2**62 + 12]), "Error"),
    "offsets are texts": (with_tensor("layer0.bias", data_offsets=["0", "12"]), "Error"),
    "missing tensor": (pack_safetensors(without_key(HEADER, "layer0.bias")), "lacks the tensor|has a tensor"),
    "missing layer": (
        pack_safetensors({n: x for n, x in HEADER.items() if "layer0" not in n}),
        "lacks the tensor 'layer0",
    ),
    "extra tensor": (pack_safetensors({**HEADER, "extra": HEADER["layer0.bias"]}), "has a tensor 'extra'"),
    "extra layers": (pack_safetensors(HEADER | {f"layer{n}.bias": SHIFTED["layer0.bias"] for n in range(9)}), "tensor"),
    "no tensors": (pack_safetensors({"__metadata__": HEADER["__metadata__"]}, b""), "1 to 8 layers, got 0"),
}


@pytest.mark.parametrize("kind", CORPUS)
def test_a_wrong_file_is_refused_with_its_reason(kind: str) -> None:
    assert_content_refused(*CORPUS[kind])


@pytest.mark.parametrize("key", sorted(TABLE.keys() - {"version"}))
def test_every_key_is_needed_and_typed(key: str) -> None:
    assert_content_refused(with_table(without_key(TABLE, key)), f"lacks {key}")
    assert_content_refused(with_fields(**{key: None}), f"{key} must be of the JSON type of")


def test_a_pickle_with_another_name_is_not_run(tmp_path: Path) -> None:
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        content = pickle.dumps(Canary(tmp_path / "canary"), protocol)
        path = tmp_path / f"{protocol}.safetensors"
        inside = [pack_safetensors(content), pack_safetensors(HEADER, content + BODY)]
        for disguise in (content, *inside, with_table(content.decode("latin-1"))):
            path.write_bytes(disguise)
            with pytest.raises(ValueError, match=str(path)):
                load(path)
    assert not (tmp_path / "canary").exists()
    pickle.loads(content)  # the canary does sing
    assert (tmp_path / "canary").exists()


SURVIVING = """
import resource, sys
from pathlib import Path
from soccer_env.agents.policy_file import load
resource.setrlimit(resource.RLIMIT_AS, (2**32, 2**32))
refused = 0
for path in Path(sys.argv[1]).glob('*.safetensors'):
    try:
        load(path)
    except ValueError:
        refused += 1
print(refused)
"""


@pytest.mark.skipif(os.name != "posix", reason="limits of Unix")
def test_the_process_survives_the_corpus(tmp_path: Path) -> None:
    for number, (content, _) in enumerate(CORPUS.values()):
        (tmp_path / f"{number}.safetensors").write_bytes(content)
    command = [sys.executable, "-O", "-c", SURVIVING, str(tmp_path)]
    run = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert run.returncode == 0, run.stderr
    assert run.stdout.strip() == str(len(CORPUS))
