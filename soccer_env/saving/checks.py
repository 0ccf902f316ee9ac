"""Whether the numbers of a save can come from a match: kernels trust what lies in the records."""

from __future__ import annotations

from typing import Any

import numpy as np

from soccer_env.leagues.robot_kind import Limits
from soccer_env.statistics.records import SHOTS, STATISTICS
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase

Match = Any  # soccer_env.match.Match, which stands above this file

FAR = 1e6  # no number of a match is larger; the length of a half may be infinite
RANGES = {  # of numbers in matches and robots, both ends allowed
    "half": (0, 1), "over": (0, 1), "phase": (0, max(Phase)), "placing": (0, 1), "restart_team": (NO_TEAM, AWAY),
    "kick_off_team": (HOME, AWAY), "last_touch_team": (NO_TEAM, AWAY), "active": (0, 1), "has_ball": (0, 1),
    "whistled": (NO_TEAM, AWAY), "kick_off_shot": (NO_TEAM, AWAY),
    "step": (0, 1 << 60), "episode": (0, 1 << 60), "gait_phase": (0, 1 << 20), "score": (0, 1 << 31),
    "indirect": (0, 1), "shoot_out": (0, 1 << 20), "shoot_out_score": (0, 1 << 20), "banned": (0, 1),
    "yellow": (0, 1 << 20), "fouls": (0, 1 << 20), "clock": (0.0, FAR), "pan": (-np.pi, np.pi), "tilt": (-np.pi, np.pi),
}  # fmt: skip
SENSED = ("percepts", "sensor_states", "pending", "beliefs", "tracks", "memories", "messages", "particles")
COMMON = Limits(  # of what all kinds of robots sense, believe and say
    greatest={"latest": 1, "known": 1, "fresh": 1, "flying": 1, "word": 15},
    endless=("age", "distance", "seconds_left"),  # never seen, nobody tells, no end
    ranges={"confidence": (0.0, 100.0), "weight": (0.0, 1e6), "fast": (0.0, 1.0), "slow": (0.0, 1.0)},
)
FIXED = ("team", "number", "keeper")  # of a robot: as the match lined up


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
        if not (arrays["robots"][field] == match.robots[field][:1]).all():  # all matches line up alike
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
    numbers = np.ascontiguousarray(statistics).view("f8").reshape(len(statistics), -1)[:, FLOATS]
    if not within(numbers, -FAR, FAR) or not within(statistics["maps"]["shots"]["place"], -FAR, FAR):
        raise ValueError("this save is damaged: a number of statistics is not finite or too large")
    trail, last = statistics["trail"], robots - 1
    for field, low, high in (
        ("player", -1, last), ("player_team", HOME, AWAY), ("flight", -1, last), ("flight_team", HOME, AWAY),
        ("kicker", -1, last), ("kicker_team", HOME, AWAY), ("kind", 0, max(Phase)), ("shot", -1, SHOTS - 1),
    ):  # fmt: skip
        if not within(trail[field], low, high):
            raise ValueError(f"this save is damaged: {field} of statistics is out of range")
    if not within(statistics["maps"]["shots_kept"], 0, SHOTS):
        raise ValueError("this save is damaged: shots_kept of statistics is out of range")


def floats_of(dtype: np.dtype, at: int = 0) -> list[int]:
    """Return which words of eight bytes of a record are numbers of 64 bits with a fraction."""
    found: list[int] = []
    for field, start in ((inner[0], at + inner[1]) for inner in (dtype.fields or {}).values()):
        base, size = field.base, field.base.itemsize
        for place in range(start, start + field.itemsize, size):
            found += floats_of(base, place) if base.names else [place // 8] * (base == np.float64)
    return found


FLOATS = np.array(floats_of(STATISTICS))


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
