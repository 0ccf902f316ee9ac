"""The bytes of a save: a checked header and arrays of records, and nothing executable.

magic | length of the header, 4 bytes little-endian | header, JSON | arrays one after the other | SHA-256
"""

import functools
import hashlib
import json
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from soccer_env.guards.checking import is_number
from soccer_env.types import OTHER_WORLD, WORLD

MAGIC = b"soccer_env save 1\n"


def join_save(header: Mapping[str, Any], arrays: Iterable[np.ndarray]) -> bytes:
    """Return the bytes of a save."""
    text = json.dumps(header).encode()
    contents = [array.tobytes() for array in arrays]
    body = b"".join([MAGIC, len(text).to_bytes(4, "little"), text, *contents])
    return body + hashlib.sha256(body).digest()


def open_save(saved: Any) -> tuple[bytes, int, dict[str, Any]]:
    """Return the body of a save, the offset of its arrays, and its header; ValueError if the save is damaged."""
    if not isinstance(saved, (bytes, bytearray, memoryview)):
        raise ValueError(f"a save is bytes, got {type(saved).__name__}")
    data = bytes(saved)
    body, digest = data[:-32], data[-32:]
    if not data.startswith(MAGIC) or hashlib.sha256(body).digest() != digest:
        raise ValueError("this is not a save of soccer_env, or it is damaged")
    start = len(MAGIC) + 4
    size = int.from_bytes(data[len(MAGIC) : start], "little")
    try:
        header = json.loads(body[start : start + size])
    except (ValueError, RecursionError) as error:
        raise ValueError("this save is damaged: its header cannot be read") from error
    if not isinstance(header, dict):
        raise ValueError("this save is damaged: its header is not an object")
    return body, start + size, header


def check_world(header: Mapping[str, Any]) -> None:
    """Raise ValueError unless a save is of this world."""
    if header.get("world", 1) != WORLD:
        raise ValueError(
            f"this save is of world {str(header.get('world', 1))[:9]}, this is world {WORLD}: {OTHER_WORLD}"
        )


def describe_parts(arrays: Mapping[str, np.ndarray]) -> list[list[Any]]:
    """Return name, dtype, shape and size [bytes] of the arrays, for the header of a save."""
    return [[name, dtype_text(array.dtype), list(array.shape), array.nbytes] for name, array in arrays.items()]


@functools.cache
def dtype_text(dtype: np.dtype) -> str:
    """Return a dtype as text, from a cache: numpy would need longer for this text than for the rest of a save."""
    return str(dtype)


def read_parts(saved: Any, wanted: Mapping[str, np.dtype]) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """Return the header of a save, and its arrays of these names and dtypes; ValueError if one is missing."""
    body, start, header = open_save(saved)
    check_world(header)
    found: dict[str, np.ndarray] = {}
    parts = header.get("parts")
    for part in parts if isinstance(parts, list) else []:
        name, dtype, shape, size = part if isinstance(part, list) and len(part) == 4 else ("", "", [], None)
        if not is_number(size, whole=True) or size < 0 or not isinstance(shape, list):
            raise ValueError("this save is damaged: its header lacks its parts")
        if name in wanted and dtype == dtype_text(wanted[name]):
            count, left = divmod(size, wanted[name].itemsize)
            if left or start + size > len(body) or not all(is_number(one, whole=True) and one > 0 for one in shape):
                raise ValueError(f"this save is damaged: {name} has another size")
            found[name] = np.frombuffer(body, wanted[name], count, start).reshape(shape)
        start += size
    if found.keys() != wanted.keys():
        raise ValueError(f"this save lacks {', '.join(name for name in wanted if name not in found)} of this version")
    return header, found


def check_caught_legs(robots: np.ndarray, legs: bool) -> None:
    """Raise ValueError unless each caught leg of robots (M, R) is held by another robot, with both on the pitch."""
    if not robots["caught_by"].any():
        return
    holder, active = robots["caught_by"] - 1, robots["active"] == 1
    held = active & np.take_along_axis(active, np.maximum(holder, 0), axis=1) & (holder != np.arange(robots.shape[1]))
    if not legs or not (held | (holder < 0)).all():
        raise ValueError("this save is damaged: caught_by of robots names a robot that cannot hold a leg")
