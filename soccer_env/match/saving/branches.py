"""Matches of one Match copied over matches of another, in memory: what planning and search step from.

A record is a row of an array, so a branch is a row copied in each array that a save holds; the physics of both sides is
rebuilt, as by a save, so that a branch and what it was taken from have one future.
"""

from collections.abc import Iterable
from typing import Any

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.guards.checking import brief, is_number, refuse
from soccer_env.match.saving.fitting import differences
from soccer_env.match.saving.saves import as_bytes, kept
from soccer_env.random_numbers import seeds_for, start_streams

Match = Any  # soccer_env.match.match.Match, which stands above this file

SEARCH = 1 << 40  # an episode's number that no match reaches: streams drawn anew are not those of an episode


def check_rows(what: str, rows: Any, count: int, once: bool = False) -> np.ndarray:
    """Return rows of matches (n,): one number or several; ValueError names the first that is none of `count`."""
    listed = [rows] if is_number(rows) else rows
    if isinstance(listed, (str, bytes)) or not isinstance(listed, (Iterable, np.ndarray)) or not np.iterable(listed):
        refuse(what, "a match's number, or several", rows)
    found = list(listed)
    for row in found:
        if not is_number(row, whole=True) or not 0 <= row < count:
            raise ValueError(f"{what} must be whole numbers from 0 to {count - 1}, got {brief(row)}")
    if not found:
        raise ValueError(f"{what} must name at least one match, got none")
    if once and len(set(found)) < len(found):
        raise ValueError(f"{what} must be different matches, got {brief(found)}")
    return np.array(found, np.int64)


def check_fits(source: Match, target: Any) -> None:
    """Raise ValueError unless matches of one Match can be played on by another."""
    if not isinstance(target, type(source)) and not isinstance(source, type(target)):
        refuse("into", "a Match or None", target)
    if source.played_by != target.played_by or layout(source) != layout(target):
        found = differences(target.told, source.told, kinds_differ=layout(source) != layout(target))
        raise ValueError(f"into does not fit this match: {found or 'the senses that somebody uses differ'}")


def layout(match: Match) -> list[tuple[str, np.dtype, tuple[int, ...]]]:
    """Return name, dtype and shape of one match's share of each array."""
    return [(name, array.dtype, array.shape[1:]) for name, array in kept(match, memory=True).items()]


def copy_rows(source: Match, rows: np.ndarray, target: Match, at: np.ndarray) -> None:
    """Copy the records of matches `rows` of one Match over matches `at` of another, or of the same."""
    there = kept(target, memory=True)
    for name, array in kept(source, memory=True).items():
        if array.nbytes:
            as_bytes(there[name])[at] = as_bytes(array)[rows]


def draw_anew(match: Match, rows: np.ndarray, seed: Any) -> None:
    """Let matches draw all that is left to chance anew from a seed, each something else; episodes to come do not."""
    draw_streams(match.matches, match.robots, rows, seeds_for(seed, len(rows)))


@compiled
def draw_streams(matches, robots, rows, seeds):
    """Start the streams of some matches and their robots anew."""
    for i in range(len(rows)):
        m = rows[i]
        start_streams(matches[m].noise, seeds[i], SEARCH, 0)
        for r in range(robots.shape[1]):
            start_streams(robots[m, r].noise, seeds[i], SEARCH, 1 + 2 * robots[m, r].number + robots[m, r].team)
