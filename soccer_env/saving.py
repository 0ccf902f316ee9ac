"""Save, restore and hash matches: bytes with a checked header, nothing executable.

A save holds the records and the memories of the teams. Physics is rebuilt from the records (a reseat), so a save has
one future.
"""

from __future__ import annotations

import hashlib
import json
from typing import Any

import numpy as np

from soccer_env.types import RobotStream

Match = Any  # soccer_env.match.Match, which stands above this file

MAGIC = b"soccer_env save 1\n"


def parts(match: Match, memory: bool = True) -> dict[str, np.ndarray]:
    """Return the arrays that the future of a match depends on, by name; without the teams' memory for replays."""
    arrays = {
        "seeds": match.seeds,
        "matches": match.matches,
        "balls": match.balls,
        "robots": match.robots,
        "events": match.events,
        "robot_events": match.robot_events,
        "terminated": match.terminated,
        "truncated": match.truncated,
    }
    if not memory:
        return arrays
    return {**arrays, **{f"memory_{index}": squad.memory for index, squad in enumerate(match.squads)}}


def header_of(match: Match, memory: bool) -> dict[str, Any]:
    """Return what a save must agree with to be loaded."""
    arrays = parts(match, memory)
    return {
        "settings": match.settings.fingerprint() if memory else "",
        "teams": [[squad.team.name, squad.players.tolist()] for squad in match.squads] if memory else [],
        "parts": [[name, str(array.dtype), list(array.shape), array.nbytes] for name, array in arrays.items()],
    }


def dump(match: Match, memory: bool = True) -> bytes:
    """Return a match as bytes: magic, length of the header, header, arrays, sha256 of all before."""
    header = json.dumps(header_of(match, memory)).encode()
    arrays = [array.tobytes() for array in parts(match, memory).values()]
    body = b"".join([MAGIC, len(header).to_bytes(4, "little"), header, *arrays])
    return body + hashlib.sha256(body).digest()


def restore(match: Match, saved: Any, memory: bool = True) -> None:
    """Fill the arrays of a match from a save; ValueError, and nothing changed, if it does not fit."""
    body, start, header = open_save(saved)
    expected = json.loads(json.dumps(header_of(match, memory)))
    for name, value in expected.items():
        if header.get(name) != value:
            raise ValueError(f"this save does not fit the match: its {name} differ")
    found = {}
    for name, array in parts(match, memory).items():
        found[name] = np.frombuffer(body, array.dtype, array.size, start).reshape(array.shape)
        start += array.nbytes
    check_numbers(found)
    for name, array in parts(match, memory).items():
        array[...] = found[name]


def open_save(saved: Any) -> tuple[bytes, int, dict[str, Any]]:
    """Return the body of a save, where its arrays start, and its header; ValueError if it is damaged."""
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
    except ValueError as error:
        raise ValueError("this save is damaged: its header cannot be read") from error
    if not isinstance(header, dict):
        raise ValueError("this save is damaged: its header is not an object")
    return body, start + size, header


def check_numbers(arrays: dict[str, np.ndarray]) -> None:
    """Raise ValueError if a pose or speed of a save is not finite: the physics must never see it."""
    for name, fields in (
        ("balls", ("x", "y", "vx", "vy", "spin")),
        ("robots", ("x", "y", "heading", "vx", "vy", "omega")),
    ):
        for field in fields:
            if not np.isfinite(arrays[name][field]).all():
                raise ValueError(f"this save is damaged: {field} of {name} is not finite")


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
