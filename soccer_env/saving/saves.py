"""Save, restore and hash matches: bytes with a checked header, nothing executable.

A save holds the records and the memories of the teams. Physics is rebuilt from the records (a rebuild), so a save has
one future.
"""

from __future__ import annotations

import hashlib
import json
import logging
from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np

from soccer_env.guards.interrupts import HeldBack
from soccer_env.guards.turns import GoBack, in_turn
from soccer_env.leagues.robot_kind import Limits
from soccer_env.match_settings import made_again, version
from soccer_env.names import Made
from soccer_env.scenes import is_own
from soccer_env.types import AWAY, GAZE, HOME, NO_TEAM, Phase, RobotStream

Match = Any  # soccer_env.match.Match, which stands above this file

# Streams that physics and the referee draw from: the play itself. Teams and senses draw from the others.
PLAYED = (RobotStream.SLIP, RobotStream.KICK, RobotStream.PLACEMENT, RobotStream.FALL)
THOUGHT = [int(stream) for stream in RobotStream if stream not in PLAYED]

T = TypeVar("T")
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


def header_of(match: Match, memory: bool) -> dict[str, Any]:
    """Return what a save must agree with to be loaded."""
    arrays = kept(match, memory)
    return {
        "settings": match.settings.fingerprint() if memory else "",
        "teams": [squad.describe() for squad in match.squads] if memory else [],
        "parts": [[name, str(array.dtype), list(array.shape), array.nbytes] for name, array in arrays.items()],
    }


def dump(match: Match, memory: bool = True) -> bytes:
    """Return a match as bytes: magic, length of the header, header, arrays, sha256 of all before."""
    header = json.dumps(header_of(match, memory)).encode()
    arrays = [array.tobytes() for array in kept(match, memory).values()]
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
    for name, array in kept(match, memory).items():
        if array.nbytes:  # a team may remember nothing
            found[name] = np.frombuffer(body, array.dtype, array.size, start).reshape(array.shape)
        start += array.nbytes
    if start != len(body):
        raise ValueError("this save is damaged: something follows its end")
    check_numbers(match, found)
    for name, values in found.items():
        kept(match, memory)[name][...] = values


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


RANGES = {  # of whole numbers in matches and robots, both ends allowed
    "half": (0, 1), "over": (0, 1), "phase": (0, max(Phase)), "placing": (0, 1), "restart_team": (NO_TEAM, AWAY),
    "kick_off_team": (HOME, AWAY), "last_touch_team": (NO_TEAM, AWAY), "active": (0, 1), "has_ball": (0, 1),
    "whistled": (NO_TEAM, AWAY), "kick_off_shot": (NO_TEAM, AWAY),
    "step": (0, 1 << 60), "episode": (0, 1 << 60), "gait_phase": (0, 1 << 20), "score": (0, 1 << 31),
    "indirect": (0, 1), "shoot_out": (0, 1 << 20), "shoot_out_score": (0, 1 << 20), "banned": (0, 1),
    "yellow": (0, 1 << 20), "fouls": (0, 1 << 20),
}  # fmt: skip
SENSED = ("percepts", "sensor_states", "pending", "beliefs", "tracks", "memories", "messages", "particles")
COMMON = Limits(  # of what all kinds of robots sense, believe and say
    greatest={"latest": 1, "known": 1, "fresh": 1, "flying": 1, "word": 15},
    endless=("age", "distance", "seconds_left"),  # never seen, nobody tells, no end
    ranges={"confidence": (0.0, 100.0), "weight": (0.0, 1e6)},
)
FIXED = ("team", "number", "keeper")  # of a robot: as the match lined up
FAR = 1e6  # no number of a match is larger; the length of a half may be infinite


def check_numbers(match: Match, arrays: dict[str, np.ndarray]) -> None:
    """Raise ValueError if a number of a save cannot come from a match: kernels trust what lies in the records."""
    for name in ("matches", "balls", "robots"):
        check_floats(name, arrays[name])
        for field, (low, high) in RANGES.items():
            if field in (arrays[name].dtype.names or ()) and not within(arrays[name][field], low, high):
                raise ValueError(f"this save is damaged: {field} of {name} is out of range")
    for name in SENSED:
        if name in arrays:
            check_sensed(name, arrays[name], COMMON | match.batch.senses.kind.limits)
    for field in FIXED:
        if not np.array_equal(arrays["robots"][field], match.robots[field]):
            raise ValueError(f"this save is damaged: {field} of robots is not that of the match")
    for field in ("last_touch_robot", "taker"):
        if not within(arrays["matches"][field], -1, len(match.agents) - 1):
            raise ValueError(f"this save is damaged: {field} of matches is out of range")
    if not (np.abs(arrays["matches"]["home_direction"]) == 1.0).all():
        raise ValueError("this save is damaged: home_direction of matches is neither 1 nor -1")
    if "statistics" in arrays:
        check_statistics(arrays["statistics"], len(match.agents))


def check_statistics(statistics: np.ndarray, robots: int) -> None:
    """Raise ValueError if the statistics of a save name a robot or a restart that there is not, or hold NaN."""
    check_floats("statistics", statistics)
    trail, last = statistics["trail"], robots - 1
    for field, low, high in (
        ("player", -1, last), ("player_team", HOME, AWAY), ("flight", -1, last), ("flight_team", HOME, AWAY),
        ("kicker", -1, last), ("kicker_team", HOME, AWAY), ("kind", 0, max(Phase)),
    ):  # fmt: skip
        if not within(trail[field], low, high):
            raise ValueError(f"this save is damaged: {field} of statistics is out of range")


def check_sensed(name: str, array: np.ndarray, limits: Limits) -> None:
    """Raise ValueError if a record of the senses holds NaN, an infinite number or an index out of range."""
    for field in array.dtype.names or ():
        values = array[field]
        if values.dtype.names:
            check_sensed(f"{field} of {name}", values, limits)
        elif values.dtype.kind == "f" and not sane(field, values, limits):
            raise ValueError(f"this save is damaged: {field} of {name} is not a number that can be")
        elif field in limits.greatest and not within(values, 0, limits.greatest[field]):
            raise ValueError(f"this save is damaged: {field} of {name} is out of range")


def sane(field: str, values: np.ndarray, limits: Limits) -> bool:
    """Return whether numbers of a field of the senses are possible: in range, and finite unless it may be endless."""
    if field in limits.endless:
        return not np.isnan(values).any() and within(values, 0.0, np.inf)
    return within(values, *limits.ranges.get(field, (-FAR, FAR)))


def check_floats(name: str, array: np.ndarray) -> None:
    """Raise ValueError for the first number of records that is not finite or absurdly large."""
    for field in array.dtype.names or ():
        values = array[field]
        if values.dtype.names:
            check_floats(f"{field} of {name}", values)
        elif values.dtype.kind == "f" and field != "half_length" and not within(values, -FAR, FAR):
            raise ValueError(f"this save is damaged: {field} of {name} is not finite or too large")
    if name == "matches" and not (array["half_length"] > 0.0).all():
        raise ValueError("this save is damaged: half_length of matches is not above zero")


def within(values: np.ndarray, low: float, high: float) -> bool:
    """Tell whether all values lie in a range; NaN does not."""
    return bool(((values >= low) & (values <= high)).all())


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


# Whole or not at all


def whole(kind: type[T]) -> type[T]:
    """Let what changes a match be one thread's alone, and be undone if code of a user raises in it."""
    return in_turn(kind, ("reset", "step", "rebuild", "decide", "save", "load"), calls_python, undoing)


def undoing(match: Match, doing: str) -> GoBack | None:
    """Return what makes a match again what it is now; None where no code of a user is called, and at its first reset.

    The physics is left alone if it has not moved, else it is rebuilt as by a load.
    """
    begun = match.batch.physics.spaces[0] is not None
    if doing not in ("reset", "step", "load") or not begun:
        return None
    arrays = shown(match)
    before = {name: array.copy() for name, array in arrays.items()}
    ended, final, recorder = match.ended, match.final, match.recorder
    written = recorder.length() if recorder is not None else None

    def go_back() -> None:
        record, old = arrays["matches"], before["matches"]
        moved = (record["step"] != old["step"]) | (record["episode"] != old["episode"]) | (doing != "step")
        with HeldBack():
            for name, values in before.items():
                arrays[name][...] = values
            match.ended, match.final = ended, final
            if recorder is not None:
                recorder.cut(written)
            if moved.any():
                match.rebuild(np.flatnonzero(moved).tolist())

    return go_back


def shown(match: Match) -> dict[str, np.ndarray]:
    """Return all arrays of a match that a step, reset or load changes, by name."""
    seen = {name: getattr(match, name) for name in ("rewards", "terms", "observations")}
    return kept(match, True) | seen


def calls_python(match: Match) -> bool:
    """Tell whether a match calls a team, an observation, a reward or a scene in Python."""
    settings = match.settings
    own = not isinstance(settings.observe, str) or bool(settings.rewards.extra) or is_own(settings.scene)
    return own or not all(squad.compiled for squad in match.squads)
