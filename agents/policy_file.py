"""Policy files: each is one safetensors file, and reading it never runs code.

    8 bytes    length of the header [bytes], little-endian
    header     JSON: {"__metadata__": {"soccer_env.policy": TEXT}, "layer0.weight": {"dtype": "F32", "shape": ...}, ...}
    tensors    float32, little-endian, one after the other without gaps

TEXT is JSON again: the fields of `Policy` without its arrays, and "version". The schema is strict: exactly these keys,
each once, with these types; anything else is a ValueError in one line that names the file. `inputs` names the entries
that the policy reads, "kind" is always "slots". A policy with a memory has four more tensors (`recurrent.TENSORS`).

Version 9 added the temperature; version 8 skills; version 7 the memory; version 6 actions of the kind "multi";
version 5 the senses of the training; version 4 discrete, squashed and normalised policies, and the step of the first
decision.

The safetensors library checks that the header fits into the file and is JSON, that sizes agree with shapes, and that
the tensors cover the file without holes and overlaps. It accepts duplicate names, unknown fields of a tensor and any
dtype, and returns no metadata of bytes, so the header is read here first.
"""

import json
import os
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from safetensors import SafetensorError
from safetensors.numpy import load as tensors_of
from safetensors.numpy import save

from soccer_env.agents.policy import MAX_INPUTS, MAX_LAYERS, Policy
from soccer_env.agents.recurrent import TENSORS
from soccer_env.guards import whole_files
from soccer_env.guards.checking import check_choice, short_repr
from soccer_env.match.arguments import version

VERSION = 9
KEY = "soccer_env.policy"
MAX_FILE = 16 * 2**20  # [bytes]
MAX_HEADER = 5 * 2**18  # [bytes] the largest policy needs about 1 MiB
MAX_DIGITS = 20  # of a whole number
PREFIX = 8  # [bytes] the header's length
SCHEMA: dict[str, type] = {
    "version": int, "name": str, "league": str, "family": str, "control_rate": int, "observe": str, "inputs": list,
    "actions": str, "action_repeat": int, "kind": str, "activation": str, "mirror": bool, "made": dict, "rules": dict,
    "squash": bool, "at_once": bool, "normalise": dict, "senses": str, "pose": str,
    "temperature": float,
}  # fmt: skip
NEWER: dict[int, dict[str, Any]] = {
    4: {"squash": False, "at_once": False, "normalise": {}},
    5: {"senses": "", "pose": ""},
    9: {"temperature": 0.0},
}
"""The keys that later versions added, and their values for older files."""
LATEST = NEWER[4] | NEWER[5] | NEWER[9]
LACKS = {old: tuple(key for new, keys in NEWER.items() if new > old for key in keys) for old in range(3, VERSION)}
"""The keys that older files lack, by version."""
KIND = "slots"  # the only kind of network
KINDS = {"discrete": 4, "multi": 6, "skills": 8}  # the versions that added kinds of actions
MEMORY = 7  # the version that added the memory
OLDEST = min(LACKS)  # older ones were of no release
TABLES = ("made", "rules", "normalise")
TENSOR = {"dtype", "shape", "data_offsets"}


def dump(policy: Policy) -> bytes:
    """Return the bytes of a policy's file; equal policies give equal bytes.

    The lowest version that can hold the policy is written, so that older versions of the package can read it.
    """
    fields = {key: getattr(policy, key) for key in SCHEMA if key not in ("version", "kind", "inputs", *TABLES)}
    tables = {key: dict(getattr(policy, key)) for key in TABLES}
    table = {"version": VERSION, "kind": KIND, **fields, "inputs": list(policy.inputs), **tables}
    needed = [version for version, keys in NEWER.items() if any(table[key] != usual for key, usual in keys.items())]
    table["version"] = max([OLDEST, *needed, KINDS.get(policy.actions, OLDEST), MEMORY if policy.memory else OLDEST])
    table = {key: value for key, value in table.items() if key not in LACKS.get(table["version"], ())}
    text = json.dumps(table, sort_keys=True, ensure_ascii=False, separators=(",", ":"))
    tensors = dict(zip(TENSORS, policy.memory))
    for number, (weight, bias) in enumerate(zip(policy.weights, policy.biases)):
        tensors |= {f"layer{number}.weight": weight, f"layer{number}.bias": bias}
    content: bytes = save(tensors, metadata={KEY: text})
    return content


def load(path: str | os.PathLike[str]) -> Policy:
    """Read a policy file; ValueError names the file and the reason."""
    return parse(read_limited_file(path, MAX_FILE), short_path(path))


def parse(data: bytes, where: str) -> Policy:
    """Return the policy in the bytes of a file; ValueError names the file (`where`) and the reason."""
    try:
        header = _header(data)
        table = _read_policy_fields(header)
        _check_tensors(header, _memory_tensor_names(table, header))
        tensors = tensors_of(data)
        more = _memory_tensor_names(table, tensors)
        layers = range((len(tensors) - len(more)) // 2)
        return Policy(
            **{key: table[key] for key in SCHEMA if key not in ("version", "kind", "inputs")},
            inputs=tuple(table["inputs"]),
            weights=tuple(tensors[f"layer{number}.weight"] for number in layers),
            biases=tuple(tensors[f"layer{number}.bias"] for number in layers),
            memory=tuple(tensors[name] for name in more),
        )
    except (ValueError, SafetensorError) as error:
        raise ValueError(f"policy file {where!r}: {one_line(error)}") from None


def read_limited_file(path: str | os.PathLike[str], limit: int) -> bytes:
    """Return the bytes of a regular file of at most `limit` bytes; otherwise ValueError names the file."""
    try:
        return whole_files.read_regular_file(path, limit)
    except (OSError, ValueError, TypeError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else error
        raise ValueError(f"policy file {short_path(path)!r}: {one_line(reason)}") from None


def one_line(reason: object) -> str:
    """Shorten an error's text to one line of at most 300 characters."""
    text = " ".join(str(reason).split())
    text = "".join(letter if letter.isprintable() else "?" for letter in text)
    return text if len(text) <= 300 else f"{text[:297]}..."


def strict_json(data: bytes | str, what: str, finite: bool = True) -> Any:
    """Parse JSON; ValueError for duplicate keys, long numbers, deep nesting and, if `finite`, NaN or infinity."""

    def once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        table = dict(pairs)
        if len(table) < len(pairs):
            twice = Counter(key for key, _ in pairs).most_common(1)[0][0]
            raise ValueError(f"{what} has the key {short_repr(twice)} twice")
        return table

    def whole(digits: str) -> int:
        if len(digits) > MAX_DIGITS:
            raise ValueError(f"{what} has a number of {len(digits)} digits")
        return int(digits)

    def other(constant: str) -> float:
        if finite:
            raise ValueError(f"{what} holds {constant}")
        return float(constant)

    try:
        text = data.decode("utf-8") if isinstance(data, bytes) else data
        return json.loads(text, object_pairs_hook=once, parse_int=whole, parse_constant=other)
    except RecursionError:
        raise ValueError(f"{what} is nested too deeply") from None
    except (json.JSONDecodeError, UnicodeDecodeError) as error:
        raise ValueError(f"{what} is not JSON: {error}") from None


def short_path(path: object) -> str:
    """Return a path as text, short enough for a message."""
    text = os.fsdecode(path) if isinstance(path, (str, bytes, Path)) else str(path)
    return text if len(text) <= 300 else f"...{text[-297:]}"


def _header(data: bytes) -> dict[str, Any]:
    """Return the JSON header of a safetensors file as a dict."""
    if len(data) > MAX_FILE:
        raise ValueError(f"has {len(data)} bytes, more than the limit of {MAX_FILE}")
    if len(data) < PREFIX:
        raise ValueError(f"is cut off or no policy file: {len(data)} bytes")
    length = int.from_bytes(data[:PREFIX], "little")
    if length > MAX_HEADER:
        raise ValueError(f"is no policy file: its header would have {length} bytes, the limit is {MAX_HEADER}")
    if length > len(data) - PREFIX:
        raise ValueError(f"is cut off: a header of {length} bytes in a file of {len(data)} bytes")
    header = strict_json(data[PREFIX : PREFIX + length], "the header")
    if not isinstance(header, dict):
        raise ValueError("the header must be a JSON object")
    return header


def _read_policy_fields(header: Mapping[str, Any]) -> dict[str, Any]:
    """Return the fields of the policy from a header, checked against the schema."""
    metadata = header.get("__metadata__")
    if not isinstance(metadata, dict) or set(metadata) != {KEY} or not isinstance(metadata[KEY], str):
        raise ValueError(f"is no policy file: its metadata must be a text {KEY!r} and nothing else")
    table = strict_json(metadata[KEY], KEY)
    if not isinstance(table, dict):
        raise ValueError(f"{KEY} must be a JSON object")
    version = table.get("version")
    if type(version) is not int or not OLDEST <= version <= VERSION:
        raise ValueError(
            f"is of format version {short_repr(version)}{describe_maker(table)} reads versions {OLDEST} to {VERSION}"
        )
    fields: dict[str, Any] = table if version == VERSION else _upgrade_table(table, version)
    missing = [key for key in SCHEMA if key not in fields]
    unknown = [key for key in fields if key not in SCHEMA]
    if missing:
        raise ValueError(f"{KEY} lacks {', '.join(missing)}")
    if unknown:
        raise ValueError(f"{KEY} has an unknown key {short_repr(unknown[0])}; known: {', '.join(SCHEMA)}")
    for key, kind in SCHEMA.items():
        if type(fields[key]) is not kind:
            raise ValueError(f"{key} must be of the JSON type of {kind.__name__}, got {short_repr(fields[key])}")
    check_choice("kind", fields["kind"], (KIND,))
    return fields


def _upgrade_table(table: dict[str, Any], version: int) -> dict[str, Any]:
    """Return the fields of an older file version, completed to the present version."""
    unexpected = [key for key in LACKS[version] if key in table]
    if unexpected:
        raise ValueError(f"{KEY} has an unknown key {unexpected[0]!r} for version {version}")
    return {**LATEST, **table}


def describe_maker(table: Mapping[str, Any]) -> str:
    """Describe the package version that made a policy, if its file names one, and the present version."""
    made = table.get("made")
    by = made.get("soccer_env") if isinstance(made, dict) else None
    origin = f", made by soccer_env {one_line(by)[:40]}" if isinstance(by, str) else ""
    return f"{origin}; this soccer_env ({version()})"


def _memory_tensor_names(table: Mapping[str, Any], tensors: Mapping[str, Any]) -> tuple[str, ...]:
    """Return the names of a policy's tensors that belong to its memory instead of layers."""
    return TENSORS if table["version"] >= MEMORY and any(name in tensors for name in TENSORS) else ()


def _check_tensors(header: Mapping[str, Any], more: tuple[str, ...]) -> None:
    """Raise ValueError unless the tensors are float32 layers, named from layer0 on, and those named in `more`."""
    entries = {name: entry for name, entry in header.items() if name != "__metadata__"}
    layers = min(max(0, len(entries) - len(more)) // 2, MAX_LAYERS)
    expected = {f"layer{number}.{part}" for number in range(layers) for part in ("weight", "bias")} | set(more)
    for name in sorted(expected - entries.keys()):
        raise ValueError(f"lacks the tensor {name!r}")
    for name in sorted(entries.keys() - expected):
        raise ValueError(f"has a tensor {short_repr(name)} that belongs to no complete layer of 1 to {MAX_LAYERS}")
    for name, entry in entries.items():
        if not isinstance(entry, dict) or set(entry) != TENSOR:
            raise ValueError(f"{name} must have {', '.join(sorted(TENSOR))} and nothing else")
        if entry["dtype"] != "F32":
            raise ValueError(f"{name} must be of dtype 'F32', got {short_repr(entry['dtype'])}")
        shape, axes = entry["shape"], 1 if name.endswith("bias") else 2
        sizes = isinstance(shape, list) and all(type(size) is int and 1 <= size <= MAX_INPUTS for size in shape)
        if not sizes or len(shape) != axes:
            raise ValueError(f"{name} must have {axes} axes of 1 to {MAX_INPUTS}, got the shape {short_repr(shape)}")
