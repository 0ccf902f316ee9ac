"""Whether a line of a file holds what a match writes there: anybody can change a file."""

from functools import cache
from math import isfinite
from typing import Any

import numpy as np

from soccer_env.guards.checking import brief, is_number, whole_number
from soccer_env.statistics.maps import OUTCOMES, maps_of
from soccer_env.statistics.records import FRESH, SHOTS
from soccer_env.train.evaluate.results import MatchLine
from soccer_env.train.evaluate.statistics import line_of_statistics

MOST = 1_000_000_000  # goals, control steps
SHOT = (0, 0, OUTCOMES[0], 0.0, 0.0)  # control step, player, outcome, x, y: as `maps_of` says


def check_line(line: MatchLine, players: tuple[int, int]) -> None:
    """Raise ValueError unless a line's numbers, statistics and maps are of the right kinds; the last two may lack.

    `players` are those of the first team and of the second.
    """
    number = line.match
    for name in ("goals_for", "goals_against", "steps"):
        whole_number(f"{name} of match {number}", getattr(line, name), 0, MOST)
    both = (line.statistics, line.maps)
    for what, found, example in zip(("statistics", "maps"), both, examples(players), strict=True):
        if found and found.keys() != example.keys():
            raise ValueError(
                f"{what} of match {number} lack or add {brief(sorted(found.keys() ^ example.keys(), key=str))}"
            )
        for name, value in found.items():
            sound = are_shots(value) if name.startswith("shots_") and what == "maps" else is_like(value, example[name])
            if not sound:
                raise ValueError(f"{name} in {what} of match {number} cannot be {brief(value)}")


@cache
def examples(players: tuple[int, int]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the statistics and maps of a match that has not begun."""
    record = np.full(1, FRESH)[0]
    return line_of_statistics(record, 0), maps_of(record, 0, players)


def is_like(value: Any, example: Any) -> bool:
    """Tell whether a value is a finite number, or lists of them of the same lengths, as an example is."""
    if isinstance(example, list):
        same = isinstance(value, list) and len(value) == len(example)
        return same and all(is_like(one, other) for one, other in zip(value, example, strict=True))
    return is_number(value) and abs(value) < 1e15 and isfinite(value)


def are_shots(value: Any) -> bool:
    """Tell whether a value is a list of shots."""
    return isinstance(value, list) and len(value) <= SHOTS and all(is_shot(shot) for shot in value)


def is_shot(value: Any) -> bool:
    """Tell whether a value is one shot."""
    if not isinstance(value, list) or len(value) != len(SHOT):
        return False
    return all(
        one in OUTCOMES if isinstance(example, str) else is_like(one, example)
        for one, example in zip(value, SHOT, strict=True)
    )
