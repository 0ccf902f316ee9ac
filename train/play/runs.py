"""How long something stays so: runs of a flag over time."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class Runs(NamedTuple):
    """Unbroken stretches of a flag (T, ...), column by column, in order of time."""

    columns: np.ndarray  # (N,) of the flag with all axes but time made one
    starts: np.ndarray  # (N,) first step
    ends: np.ndarray  # (N,) first step after it

    @property
    def steps(self) -> np.ndarray:
        """Return how many steps (N,) each lasts."""
        found: np.ndarray = self.ends - self.starts
        return found

    def where(self, chosen: np.ndarray) -> Runs:
        """Return those that are chosen (N,)."""
        return Runs(*(values[chosen] for values in self))


def runs_of(flags: np.ndarray) -> Runs:
    """Return the runs of a flag (T, ...)."""
    flat = flags.reshape(len(flags), -1).T.astype(np.int8)
    edge = np.diff(flat, axis=1, prepend=0, append=0)
    columns, starts = np.nonzero(edge == 1)
    _, ends = np.nonzero(edge == -1)
    return Runs(columns, starts, ends)


def bridged(flags: np.ndarray, steps: int) -> np.ndarray:
    """Return a flag (T, ...) with breaks of at most so many steps closed."""
    breaks = runs_of(~flags)
    inner = (breaks.starts > 0) & (breaks.ends < len(flags)) & (breaks.steps <= steps)
    flat = flags.reshape(len(flags), -1).copy()
    for column, first, last in zip(*breaks.where(inner), strict=True):
        flat[first:last, column] = True
    return flat.reshape(flags.shape)


def by_match(values: np.ndarray, columns: np.ndarray, matches: int, each: int) -> np.ndarray:
    """Return values (N,) of columns as an array (M,) of arrays; each match has so many columns."""
    found = np.empty(matches, object)
    for m in range(matches):
        found[m] = np.asarray(values[columns // each == m], np.float64)
    return found
