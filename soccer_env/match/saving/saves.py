"""Save, restore and hash matches: a save is bytes with a checked header, and holds nothing executable.

A save holds the records and the memories of the teams. Physics is rebuilt from the records, so a save has one future.
"""

import hashlib
import json
import logging
from collections.abc import Callable
from math import inf
from typing import Any

import numpy as np

from soccer_env.guards.checking import is_number, short_repr
from soccer_env.guards.names import Made
from soccer_env.guards.ranges import first_out_of_range
from soccer_env.match.arguments import rebuild_from_settings, version
from soccer_env.match.saving.fitting import describe_differences
from soccer_env.records.save_file import check_caught_legs, check_world, describe_parts, join_save, open_save
from soccer_env.types import GAZE, WORLD, RobotStream

Match = Any  # soccer_env.match.match.Match, which stands above this file

# Random streams of physics and referee, which decide the play; teams and senses draw from the other streams.
PLAYED = (RobotStream.SLIP, RobotStream.KICK, RobotStream.PLACEMENT, RobotStream.FALL)
THOUGHT = [int(stream) for stream in RobotStream if stream not in PLAYED]

LOG = logging.getLogger("soccer_env")
LONGEST = 6e13  # [s] of a half with an end, in leagues and by `minutes`
FIXED = ("team", "number", "keeper")  # fields of a robot that never change


def parts(match: Match, memory: bool = True) -> dict[str, np.ndarray]:
    """Return by name the arrays that determine a match's future; `memory`: including the arrays of teams and senses."""
    names = ("seeds", "matches", "balls", "robots", "events", "robot_events", "terminated", "truncated")
    arrays = {name: getattr(match, name) for name in names}
    if not memory:
        return arrays
    if match.batch.senses is not None:
        arrays |= match.batch.senses.parts
    if match.skills is not None:
        arrays["skills"] = match.skills.memory
    memories = {f"memory_{index}": squad.memory for index, squad in enumerate(match.squads)}
    chosen = {f"plays_{index}": squad.plays for index, squad in enumerate(match.squads) if squad.plays is not None}
    return {**arrays, **memories, **chosen}


def saved_arrays(match: Match, memory: bool) -> dict[str, np.ndarray]:
    """Return the arrays of a save by name: all arrays that determine the future, and the statistics so far."""
    return parts(match, memory) | ({"statistics": match.statistics} if memory else {})


def save_header(match: Match, arrays: dict[str, np.ndarray], memory: bool) -> dict[str, Any]:
    """Return the header of a save; a save can be loaded only if its header equals that of the match."""
    settings, teams = match.play_fingerprint if memory else ("", [])
    return {
        "world": WORLD,
        "settings": settings,
        "teams": teams,
        "parts": describe_parts(arrays),
    }


def dump(match: Match, memory: bool = True, rows: np.ndarray | None = None) -> bytes:
    """Return a save of all matches, or of some rows, as bytes."""
    arrays = saved_arrays(match, memory)
    if rows is not None:
        arrays = {name: array[rows] for name, array in arrays.items()}
    described = {"told": match.described_settings} if memory else {}
    return join_save({**save_header(match, arrays, memory), **described}, arrays.values())


def restore(match: Match, saved: Any, memory: bool = True, rows: np.ndarray | None = None) -> None:
    """Fill the arrays of a match, or of some rows, from a save; if that fails, raise ValueError and change nothing."""
    fill_match(match, arrays_of_save(match, saved, memory, rows), rows)


def arrays_of_save(
    match: Match, saved: Any, memory: bool = True, rows: np.ndarray | None = None
) -> dict[str, np.ndarray]:
    """Read the arrays of a save by name; ValueError if the save does not fit the match."""
    body, start, header = open_save(saved)
    check_world(header)
    count = count_saved_matches(header, match.count, rows)
    there = saved_arrays(match, memory)
    wanted = {name: np.empty((count, *array.shape[1:]), array.dtype) for name, array in there.items()}
    expected = json.loads(json.dumps(save_header(match, wanted, memory)))
    for name, value in expected.items():
        if header.get(name) != value:
            words = describe_differences(
                header.get("told"), match.described_settings, header.get("parts") != expected["parts"]
            )
            raise ValueError(f"this save does not fit the match: {words or f'its {name} differ'}")
    loaded = {}
    for name, array in wanted.items():
        if array.nbytes:  # a team may remember nothing
            loaded[name] = np.frombuffer(body, array.dtype, array.size, start).reshape(array.shape)
        start += array.nbytes
    if start != len(body):
        raise ValueError("this save is damaged: something follows its end")
    check_numbers(match, loaded)
    return loaded


def fill_match(match: Match, arrays: dict[str, np.ndarray], rows: np.ndarray | None = None) -> None:
    """Write the arrays of a save into a match."""
    there = saved_arrays(match, memory="statistics" in arrays)
    for name, values in arrays.items():
        as_bytes(there[name])[slice(None) if rows is None else rows] = as_bytes(values)


def as_bytes(records: np.ndarray) -> np.ndarray:
    """Return a view of records as plain bytes, which numpy copies ten times as fast as fields."""
    return records.view(np.dtype((np.void, records.dtype.itemsize)))


def count_saved_matches(header: dict[str, Any], there: int, rows: np.ndarray | None) -> int:
    """Return the number of matches in a save; ValueError unless it is 1 or equals the number of rows."""
    try:
        count = header["parts"][0][2][0]
    except (KeyError, IndexError, TypeError) as error:
        raise ValueError("this save is damaged: its header lacks its parts") from error
    fits = is_number(count, whole=True) and (count == there if rows is None else count in (1, len(rows)))
    if fits:
        return int(count)
    if rows is None:
        raise ValueError(f"this save is of {short_repr(count)} matches, not {there}; name the rows to load it into")
    raise ValueError(
        f"rows must be as many as the matches of the save, {short_repr(count)}, got {len(rows)}; one fits any number"
    )


# Checks of the numbers: kernels trust the numbers in the records


def check_numbers(match: Match, arrays: dict[str, np.ndarray]) -> None:
    """Raise ValueError if a number in a save is outside the range that this match can produce."""
    for name, array in arrays.items():
        field = first_out_of_range(array, len(match.agents))
        if field:
            raise ValueError(f"this save is damaged: {field} of {name} is out of range")
    robots = arrays["robots"]
    for field in FIXED:
        if not (robots[field] == match.robots[field][:1]).all():  # all matches line up alike
            raise ValueError(f"this save is damaged: {field} of robots is not that of the match")
    length = arrays["matches"]["half_length"]
    if ((length > LONGEST) & (length < inf)).any():
        raise ValueError("this save is damaged: half_length of matches is out of range")
    check_caught_legs(robots, bool(match.batch.constants["legs"][0]))


# Copies by pickle, cloudpickle and copy.deepcopy


def reduce_by_save(match: Any, make: Callable[..., Any], settings: dict[str, Any]) -> Made:
    """Return the value of `__reduce__` that pickles a match as its settings and a save; this rebuilds its physics."""
    LOG.info("a match is copied: its physics is rebuilt from its records, as by save()")
    return rebuild_from_save, (version(), make, settings, match.save())


def rebuild_from_save(made_by: str, make: Callable[..., Any], settings: dict[str, Any], saved: bytes) -> Any:
    """Rebuild a pickled match from settings and a save; errors as in `rebuild_from_settings`."""

    def make_and_load(**settings: Any) -> Any:
        match = make(**settings)
        match.load(saved)
        return match

    return rebuild_from_settings(made_by, make_and_load, settings)


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
    """Return a hash of the records that follow from the commands alone; memories of teams and sensors do not count."""
    digest = hashlib.blake2b(digest_size=16)
    robots = match.robots.copy()
    robots["noise"][..., THOUGHT] = 0
    robots["gaze"] = np.zeros((), GAZE)  # pan and tilt of the head show the effect of the gaze
    for array in (match.matches, match.balls, robots):
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()
