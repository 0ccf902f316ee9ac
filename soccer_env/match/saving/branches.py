"""Copy matches of one Match over matches of another, in memory, for planning and search.

A branch is one row copied in each array that a save holds. The physics of both matches is rebuilt, as by a save, so
that branch and original have one future.
"""

from collections.abc import Iterable
from typing import Any

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.guards.checking import is_number, raise_not_allowed, short_repr
from soccer_env.match.saving.fitting import describe_differences
from soccer_env.match.saving.saves import as_bytes, saved_arrays
from soccer_env.random_numbers import seeds_for, start_streams

Match = Any  # soccer_env.match.match.Match, which stands above this file
SEARCH = 1 << 40  # number of an episode that no match reaches: its random streams belong to branches alone


def check_rows(what: str, rows: Any, count: int, once: bool = False) -> np.ndarray:
    """Return one match number, or several, as an array (n,); ValueError names the first number out of range."""
    listed = [rows] if is_number(rows) else rows
    if isinstance(listed, (str, bytes)) or not isinstance(listed, (Iterable, np.ndarray)) or not np.iterable(listed):
        raise_not_allowed(what, "a match's number, or several", rows)
    numbers = list(listed)
    for row in numbers:
        if not is_number(row, whole=True) or not 0 <= row < count:
            raise ValueError(f"{what} must be whole numbers from 0 to {count - 1}, got {short_repr(row)}")
    if not numbers:
        raise ValueError(f"{what} must name at least one match, got none")
    if once and len(set(numbers)) < len(numbers):
        raise ValueError(f"{what} must be different matches, got {short_repr(numbers)}")
    return np.array(numbers, np.int64)


def check_fits(source: Match, target: Any) -> None:
    """Raise ValueError unless matches of `source` can be continued in `target`."""
    if not isinstance(target, type(source)) and not isinstance(source, type(target)):
        raise_not_allowed("into", "a Match or None", target)
    if source.play_fingerprint != target.play_fingerprint or saved_layout(source) != saved_layout(target):
        differing = describe_differences(
            target.described_settings,
            source.described_settings,
            kinds_differ=saved_layout(source) != saved_layout(target),
        )
        raise ValueError(f"into does not fit this match: {differing or 'the senses that somebody uses differ'}")


def saved_layout(match: Match) -> list[tuple[str, np.dtype, tuple[int, ...]]]:
    """Return name, dtype and shape per match of each saved array."""
    return [(name, array.dtype, array.shape[1:]) for name, array in saved_arrays(match, memory=True).items()]


def copy_rows(source: Match, rows: np.ndarray, target: Match, at: np.ndarray) -> None:
    """Copy the records of matches `rows` of `source` over matches `at` of `target`, which may be the same Match."""
    there = saved_arrays(target, memory=True)
    for name, array in saved_arrays(source, memory=True).items():
        if array.nbytes:
            as_bytes(there[name])[at] = as_bytes(array)[rows]


def renew_random_streams(match: Match, rows: np.ndarray, seed: Any) -> None:
    """Replace the random streams of the matches `rows` by new streams from a seed, until the end of their episodes."""
    draw_streams(match.matches, match.robots, rows, seeds_for(seed, len(rows)))


@compiled
def draw_streams(matches, robots, rows, seeds):
    """Restart the random streams of the matches `rows` and of their robots, with one seed for each match."""
    for i in range(len(rows)):
        m = rows[i]
        start_streams(matches[m].noise, seeds[i], SEARCH, 0)
        for r in range(robots.shape[1]):
            start_streams(robots[m, r].noise, seeds[i], SEARCH, 1 + 2 * robots[m, r].number + robots[m, r].team)
