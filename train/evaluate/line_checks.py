"""Check the lines of matches.jsonl, which anybody can edit."""

from functools import cache
from math import isfinite
from typing import Any

import numpy as np

from soccer_env.guards.checking import check_whole_number, is_number, short_repr
from soccer_env.statistics.maps import OUTCOMES, maps_of_team
from soccer_env.statistics.records import FRESH, SHOTS
from soccer_env.train.evaluate.results import MatchLine
from soccer_env.train.evaluate.statistics import match_statistics

MOST = 1_000_000_000  # goals, control steps
SHOT = (0, 0, OUTCOMES[0], 0.0, 0.0)  # control step, player, outcome, x, y: as `maps_of_team` says


def check_line(line: MatchLine, players: tuple[int, int]) -> None:
    """Raise ValueError unless the fields of a result line have the right types; statistics and maps may be missing.

    `players`: the sizes of the first and the second team.
    """
    number = line.match
    for name in ("goals_for", "goals_against", "steps"):
        check_whole_number(f"{name} of match {number}", getattr(line, name), 0, MOST)
    both = (line.statistics, line.maps)
    for part, values, example in zip(("statistics", "maps"), both, example_statistics(players), strict=True):
        if values and values.keys() != example.keys():
            wrong = sorted(values.keys() ^ example.keys(), key=str)
            raise ValueError(f"{part} of match {number} lack or add {short_repr(wrong)}")
        for name, value in values.items():
            sound = (
                isinstance(value, list) and len(value) <= SHOTS and all(map(is_shot, value))
                if name.startswith("shots_") and part == "maps"
                else has_same_shape(value, example[name])
            )
            if not sound:
                raise ValueError(f"{name} in {part} of match {number} cannot be {short_repr(value)}")


@cache
def example_statistics(players: tuple[int, int]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return statistics and maps of a match that has not begun, as examples of the right types."""
    record = np.full(1, FRESH)[0]
    return match_statistics(record, 0), maps_of_team(record, 0, players)


def has_same_shape(value: Any, example: Any) -> bool:
    """Tell whether a value has the form of an example: a finite number, or nested lists of such numbers."""
    if isinstance(example, list):
        same = isinstance(value, list) and len(value) == len(example)
        return same and all(has_same_shape(one, other) for one, other in zip(value, example, strict=True))
    return is_number(value) and abs(value) < 1e15 and isfinite(value)


def is_shot(value: Any) -> bool:
    """Tell whether a value is a valid record of one shot."""
    if not isinstance(value, list) or len(value) != len(SHOT):
        return False
    return all(
        item in OUTCOMES if isinstance(example, str) else has_same_shape(item, example)
        for item, example in zip(value, SHOT, strict=True)
    )
