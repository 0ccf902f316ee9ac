"""Save, restore and hash matches: bytes with a checked header, nothing executable.

A save holds the records and the memories of the teams. Physics is rebuilt from the records (a reseat), so a save has one future.
"""

from __future__ import annotations

import hashlib
import json
from typing import TYPE_CHECKING, Any

import numpy as np

from soccer_env.types import RobotStream

if TYPE_CHECKING:
    from soccer_env.match import Match

MAGIC = b"soccer_env save 1\n"
HEADER_LIMIT = 1 << 20  # [bytes]


def parts(match: Match) -> dict[str, np.ndarray]:
    """Return the arrays that the future of a match depends on, by name."""
    arrays = {
        "seeds": match.seeds, "matches": match.matches, "balls": match.balls, "robots": match.robots,
        "events": match.events, "robot_events": match.robot_events, "terminated": match.terminated, "truncated": match.truncated,
    }
    return {**arrays, **{f"memory_{index}": squad.memory for index, squad in enumerate(match.squads)}}


def header_of(match: Match) -> dict[str, Any]:
    """Return what a save must agree with to be loaded."""
    return {
        "settings": match.settings.fingerprint(),
        "teams": [[squad.team.name, squad.players.tolist()] for squad in match.squads],
        "parts": [[name, str(array.dtype), list(array.shape), array.nbytes] for name, array in parts(match).items()],
    }


def dump(match: Match) -> bytes:
    """Return a match as bytes: magic, length of the header, header, arrays, sha256 of all before."""
    header = json.dumps(header_of(match)).encode()
    body = b"".join([MAGIC, len(header).to_bytes(4, "little"), header, *(a.tobytes() for a in parts(match).values())])
    return body + hashlib.sha256(body).digest()


def restore(match: Match, saved: Any) -> None:
    """Fill the arrays of a match from a save; ValueError, and nothing changed, if it does not fit."""
    if not isinstance(saved, (bytes, bytearray, memoryview)):
        raise ValueError(f"a save is bytes, got {type(saved).__name__}")
    data = bytes(saved)
    body, digest = data[:-32], data[-32:]
    if not data.startswith(MAGIC) or hashlib.sha256(body).digest() != digest:
        raise ValueError("this is not a save of soccer_env, or it is damaged")
    start = len(MAGIC) + 4
    size = int.from_bytes(data[len(MAGIC):start], "little")
    if size > HEADER_LIMIT:
        raise ValueError("this save is damaged: its header is too long")
    header = json.loads(data[start:start + size])
    expected = json.loads(json.dumps(header_of(match)))
    for name, value in expected.items():
        if header.get(name) != value:
            raise ValueError(f"this save does not fit the match: its {name} differ ({header.get(name)!r}, expected {value!r})")
    at = start + size
    for array in parts(match).values():
        array[...] = np.frombuffer(body, array.dtype, array.size, at).reshape(array.shape)
        at += array.nbytes


def state_hash(match: Match, m: int | None = None) -> str:
    """Return the hash (32 hex digits) of the state of all matches, or of match m alone."""
    at = slice(None) if m is None else slice(m, m + 1)
    digest = hashlib.blake2b(digest_size=16)
    for array in parts(match).values():
        digest.update(np.ascontiguousarray(array[at]).tobytes())
    return digest.hexdigest()


def play_hash(match: Match) -> str:
    """Return a hash of the play alone: what follows from commands, whoever gave them."""
    digest = hashlib.blake2b(digest_size=16)
    robots = match.robots.copy()
    robots["noise"][..., int(RobotStream.TEAM)] = 0
    for array in (match.matches, match.balls, robots):
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()
