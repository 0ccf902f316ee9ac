"""A good policy file taken apart, so that tests can put it together wrong; and the line that refuses it."""

import json
import struct
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from soccer_env.agents.policy import Policy, training_fields
from soccer_env.agents.policy_file import KEY, dump, parse
from soccer_env.leagues import find_league

ONES = {"weights": (np.ones((3, 2), np.float32), np.ones((4, 3), np.float32))}
ONES["biases"] = (np.ones(3, np.float32), np.ones(4, np.float32))
FIELDS: dict[str, Any] = {
    "name": "tiny", **training_fields(find_league("legged-2001")), "observe": "truth", "inputs": ("ball_x", "ball_y"),
    "actions": "box", "action_repeat": 1, "activation": "tanh", "mirror": False, **ONES,
    "made": {"seed": "1"},
}  # fmt: skip
GOOD = dump(Policy(**FIELDS))
LENGTH = int.from_bytes(GOOD[:8], "little")
HEADER: dict[str, Any] = json.loads(GOOD[8 : 8 + LENGTH])
TABLE: dict[str, Any] = json.loads(HEADER["__metadata__"][KEY])
BODY = GOOD[8 + LENGTH :]
WHERE = "odd\n\x1b[31m.safetensors"  # a file's name is a stranger's too


def pack_safetensors(header: dict[str, Any] | bytes, body: bytes = BODY, length: int | None = None) -> bytes:
    """Return a safetensors file with this header, right or wrong."""
    text = header if isinstance(header, bytes) else json.dumps(header).encode()
    return struct.pack("<Q", len(text) if length is None else length) + text + body


def with_table(table: Any) -> bytes:
    text = table if isinstance(table, str) else json.dumps(table)
    return pack_safetensors({**HEADER, "__metadata__": {KEY: text}})


def with_fields(**changes: Any) -> bytes:
    return with_table({**TABLE, **changes})


def with_tensor(name: str, **changes: Any) -> bytes:
    return pack_safetensors({**HEADER, name: {**HEADER[name], **changes}})


def without_key(table: dict[str, Any], key: str) -> dict[str, Any]:
    return {other: value for other, value in table.items() if other != key}


def assert_content_refused(content: bytes, reason: str | None = None) -> None:
    assert_refused_by(lambda: parse(content, WHERE), reason)


def assert_refused_by(read: Callable[[], Any], reason: str | None, start: str = f"policy file {WHERE!r}: ") -> None:
    """Check that a file is refused in one plain line that names it."""
    with pytest.raises(ValueError, match=reason) as refusal:
        read()
    line = str(refusal.value)
    assert line.startswith(start) and line.isprintable() and len(line) < 700
