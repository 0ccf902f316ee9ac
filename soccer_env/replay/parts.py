"""Parts of a replay file: records as plain numbers and back, and the settings of a match as plain values."""

from dataclasses import fields, is_dataclass
from typing import Any, get_type_hints

import numpy as np

from soccer_env.guards.ranges import first_out_of_range
from soccer_env.match import Match
from soccer_env.match.arguments import REPLAYED
from soccer_env.match.settings import to_plain_types


def records_to_numbers(records: np.ndarray) -> np.ndarray:
    """Return records as numbers (..., fields); commands have 7 fields."""
    return np.stack([records[name] for name in records.dtype.names or ()], axis=-1)


def numbers_to_records(numbers: np.ndarray, dtype: np.dtype, what: str) -> np.ndarray:
    """Return numbers (T, M, R, fields) as records (T, M, R); ValueError for a wrong shape or range."""
    names = dtype.names or ()
    if numbers.ndim != 4 or numbers.shape[-1] != len(names) or numbers.dtype != np.float64:
        raise ValueError(f"its {what} are {numbers.dtype} {numbers.shape}, not (T, M, R, {len(names)}) float64")
    records = np.zeros(numbers.shape[:-1], dtype)
    for index, name in enumerate(names):
        records[name] = numbers[..., index]
    if field := first_out_of_range(records, robots=numbers.shape[2]):
        raise ValueError(f"{field} of its {what} is out of range")
    return records


def rebuild_settings(kind: type, values: dict[str, Any]) -> Any:
    """Return a settings record from the plain values that `settings.plain` made of it; its own checks apply."""
    types = get_type_hints(kind)
    known = {item.name for item in fields(kind)}
    if set(values) | {"faults"} != known | {"faults"}:  # replays of leagues without faults may lack them
        raise ValueError(f"{kind.__name__} has the fields {', '.join(sorted(known))}, got {', '.join(sorted(values))}")
    arguments = {}
    for name, value in values.items():
        if is_dataclass(types[name]):
            value = rebuild_settings(types[name], value)
        elif name in ("sensors", "memory"):
            value = None  # a replay repeats commands: no robot senses
        elif name == "corners":
            value = tuple(tuple(corner) for corner in value)
        arguments[name] = value
    return kind(**arguments)


def replay_settings(match: Match) -> dict[str, Any]:
    """Return the settings of a match that a replay needs."""
    settings, scene = match.settings, match.settings.scene
    success = scene.success if isinstance(scene.success, str) else "none"
    ranges = settings.variation.plain if settings.variation is not None else {}
    playing = [squad for squad in match.squads if squad.plays is None or squad.plays[0]]  # the present team of a lineup
    return {
        "league": to_plain_types(settings.league),
        **{name: getattr(settings, name) for name in REPLAYED},
        "variation": {name: both for name, both in ranges.items() if not name.startswith("sensors.")},
        "max_players": settings.max_players if settings.padded else None,
        "max_cycles": settings.max_cycles,
        "action_repeat": settings.action_repeat,
        "scene": {"name": scene.name, "success": success, "time_limit": str(scene.time_limit)},
        "matches": match.count,
        "teams": {match.agents[r]: squad.name for squad in playing for r in squad.players},
    }
