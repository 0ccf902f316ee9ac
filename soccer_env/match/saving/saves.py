"""Save, restore and hash matches: bytes with a checked header, nothing executable.

A save holds the records and the memories of the teams. Physics is rebuilt from the records (a rebuild), so a save has
one future.
"""

import functools
import hashlib
import json
import logging
from collections.abc import Callable
from typing import Any

import numpy as np

from soccer_env.guards.checking import brief, is_number
from soccer_env.guards.names import Made
from soccer_env.match.arguments import made_again, version
from soccer_env.match.saving.checks import check_numbers
from soccer_env.match.saving.fitting import differences
from soccer_env.types import GAZE, RobotStream

Match = Any  # soccer_env.match.match.Match, which stands above this file

# Streams that physics and the referee draw from: the play itself. Teams and senses draw from the others.
PLAYED = (RobotStream.SLIP, RobotStream.KICK, RobotStream.PLACEMENT, RobotStream.FALL)
THOUGHT = [int(stream) for stream in RobotStream if stream not in PLAYED]

LOG = logging.getLogger("soccer_env")
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
    if match.batch.senses is not None:
        arrays |= match.batch.senses.parts
    memories = {f"memory_{index}": squad.memory for index, squad in enumerate(match.squads)}
    chosen = {f"plays_{index}": squad.plays for index, squad in enumerate(match.squads) if squad.plays is not None}
    return {**arrays, **memories, **chosen}


def kept(match: Match, memory: bool) -> dict[str, np.ndarray]:
    """Return the arrays that a save holds: what the future depends on, and the statistics of play so far."""
    return parts(match, memory) | ({"statistics": match.statistics} if memory else {})


def header_of(match: Match, arrays: dict[str, np.ndarray], memory: bool) -> dict[str, Any]:
    """Return what a save of some arrays must agree with to be loaded."""
    settings, teams = match.played_by if memory else ("", [])
    return {
        "settings": settings,
        "teams": teams,
        "parts": [[name, words_of(array.dtype), list(array.shape), array.nbytes] for name, array in arrays.items()],
    }


@functools.cache
def words_of(dtype: np.dtype) -> str:
    """Return a dtype in words; numpy takes longer for those of all records than a save for all the rest."""
    return str(dtype)


def dump(match: Match, memory: bool = True, rows: np.ndarray | None = None) -> bytes:
    """Return all matches, or those of some rows, as bytes: magic, length of the header, header, arrays, sha256."""
    arrays = kept(match, memory)
    if rows is not None:
        arrays = {name: array[rows] for name, array in arrays.items()}
    told = {"told": match.told} if memory else {}
    header = json.dumps({**header_of(match, arrays, memory), **told}).encode()
    contents = [array.tobytes() for array in arrays.values()]
    body = b"".join([MAGIC, len(header).to_bytes(4, "little"), header, *contents])
    return body + hashlib.sha256(body).digest()


def restore(match: Match, saved: Any, memory: bool = True, rows: np.ndarray | None = None) -> None:
    """Fill the arrays of a match from a save; ValueError, and nothing changed, if it does not fit.

    rows: some matches alone; a save of one match fills every row.
    """
    fill(match, opened(match, saved, memory, rows), rows)


def opened(match: Match, saved: Any, memory: bool = True, rows: np.ndarray | None = None) -> dict[str, np.ndarray]:
    """Return the arrays of a save by name; ValueError if it does not fit the match."""
    body, start, header = open_save(saved)
    count = matches_in(header, match.count, rows)
    there = kept(match, memory)
    wanted = {name: np.empty((count, *array.shape[1:]), array.dtype) for name, array in there.items()}
    expected = json.loads(json.dumps(header_of(match, wanted, memory)))
    for name, value in expected.items():
        if header.get(name) != value:
            words = differences(header.get("told"), match.told, header.get("parts") != expected["parts"])
            raise ValueError(f"this save does not fit the match: {words or f'its {name} differ'}")
    found = {}
    for name, array in wanted.items():
        if array.nbytes:  # a team may remember nothing
            found[name] = np.frombuffer(body, array.dtype, array.size, start).reshape(array.shape)
        start += array.nbytes
    if start != len(body):
        raise ValueError("this save is damaged: something follows its end")
    check_numbers(match, found)
    return found


def fill(match: Match, found: dict[str, np.ndarray], rows: np.ndarray | None = None) -> None:
    """Write arrays of a save into a match."""
    there = kept(match, memory="statistics" in found)
    for name, values in found.items():
        as_bytes(there[name])[slice(None) if rows is None else rows] = as_bytes(values)


def as_bytes(records: np.ndarray) -> np.ndarray:
    """Return a view of records whose fields numpy does not know: it copies them in a tenth of the time."""
    return records.view(np.dtype((np.void, records.dtype.itemsize)))


def matches_in(header: dict[str, Any], there: int, rows: np.ndarray | None) -> int:
    """Return how many matches a save holds; ValueError unless it is one, or as many as there are rows."""
    try:
        count = header["parts"][0][2][0]
    except (KeyError, IndexError, TypeError) as error:
        raise ValueError("this save is damaged: its header lacks its parts") from error
    fits = is_number(count, whole=True) and (count == there if rows is None else count in (1, len(rows)))
    if fits:
        return int(count)
    if rows is None:
        raise ValueError(
            f"this save is of {brief(count)} matches, not {there}; a Match loads it into rows that are named"
        )
    raise ValueError(
        f"rows must be as many as the matches of the save, {brief(count)}, got {len(rows)}; one fits any number"
    )


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
    except (ValueError, RecursionError) as error:
        raise ValueError("this save is damaged: its header cannot be read") from error
    if not isinstance(header, dict):
        raise ValueError("this save is damaged: its header is not an object")
    return body, start + size, header


# Copies by pickle, cloudpickle and copy.deepcopy


def by_save(match: Any, make: Callable[..., Any], settings: dict[str, Any]) -> Made:
    """Return what to pickle of a match that `make` makes from settings; its physics is rebuilt."""
    LOG.info("a match is copied: its physics is rebuilt from its records, as by save()")
    return loaded_again, (version(), make, settings, match.save())


def loaded_again(made_by: str, make: Callable[..., Any], settings: dict[str, Any], saved: bytes) -> Any:
    """Return the match that was pickled, as `made_again` does."""

    def make_and_load(**settings: Any) -> Any:
        match = make(**settings)
        match.load(saved)
        return match

    return made_again(made_by, make_and_load, settings)


def state_hash(match: Match, m: int | None = None) -> str:
    """Return the hash (32 hex digits) of the state of all matches, or of match m alone."""
    if m is not None and not 0 <= m < match.count:
        raise ValueError(f"m must be 0 to {match.count - 1}, got {m}")
    at = slice(None) if m is None else slice(m, m + 1)
    digest = hashlib.blake2b(digest_size=16)
    for array in parts(match).values():
        digest.update(np.ascontiguousarray(array[at]).tobytes())
    return digest.hexdigest()


def play_hash(match: Match) -> str:
    """Return a hash of the play alone: what follows from commands, whoever gave them."""
    digest = hashlib.blake2b(digest_size=16)
    robots = match.robots.copy()
    robots["noise"][..., THOUGHT] = 0
    robots["gaze"] = np.zeros((), GAZE)  # what the head looks at is in its pan and tilt
    for array in (match.matches, match.balls, robots):
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()
