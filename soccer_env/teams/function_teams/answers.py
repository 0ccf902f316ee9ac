"""Checks of the actions and the memory that a user's function returns for a team's players."""

from collections.abc import Callable
from typing import Any

import numpy as np

from soccer_env.actions import BOX, DISCRETE, DISCRETE_TABLE, FULL
from soccer_env.guards.checking import short_repr

HEAD = FULL.index("head")
Who = Callable[[int, int], str]  # words for the robot of a match and a player


def as_array(returned: Any) -> np.ndarray:
    """Convert numbers of any library to a numpy array; a torch tensor is detached and moved to the CPU."""
    if hasattr(returned, "detach"):
        returned = returned.detach().cpu()
    try:
        return np.asarray(returned)
    except ValueError:  # rows of different lengths
        return np.asarray(None)


def as_actions(returned: Any, team: str, given: tuple[int, ...], players: int, who: Who) -> np.ndarray:
    """Convert the answer of a team's function to actions (D, P, 7); `given`: leading shape of its observations.

    ValueError names the robot, what was returned and what is allowed.
    """
    numbers = as_array(returned)
    discrete = numbers.dtype.kind in "iu" and numbers.shape in (given, (*given, 1))
    continuous = numbers.dtype.kind in "fiu" and numbers.shape in [(*given, size) for size in (len(BOX), len(FULL))]
    if not (discrete or continuous):
        last = who(given[0] // players - 1 if len(given) == 1 else given[0] - 1, players - 1)
        span = last if who(0, 0) == last else f"{who(0, 0)} to {last}"
        got = f"{numbers.dtype} of shape {numbers.shape}" if numbers.dtype != object else short_repr(returned)
        raise ValueError(
            f"team {team!r} must return actions of shape {(*given, len(BOX))} or {(*given, len(FULL))}, or discrete "
            f"ones of shape {given}, for {span}, got {got}"
        )
    rows = numbers.reshape(-1, 1 if discrete else numbers.shape[-1])
    with np.errstate(invalid="ignore"):
        good = (rows >= 0) & (rows < len(DISCRETE)) if discrete else np.isfinite(rows)
    check_rows(good, rows, team, f"0 to {len(DISCRETE) - 1}" if discrete else "finite", players, who)
    boxes = DISCRETE_TABLE[rows[:, 0]] if discrete else rows
    actions = np.zeros((len(rows), len(FULL)))
    actions[:, HEAD] = -1.0  # the head tracks the ball by itself
    actions[:, : boxes.shape[1]] = np.clip(boxes, -1.0, 1.0)
    return actions.reshape(-1, players, len(FULL))


def check_rows(good: np.ndarray, rows: np.ndarray, team: str, allowed: str, players: int, who: Who) -> None:
    """Raise ValueError for the first row of actions (D P, n) that has a False in `good`."""
    if not good.all():
        row = int(np.argmin(good.all(axis=1)))
        robot = who(*divmod(row, players))
        got = short_repr(rows[row].tolist() if rows.shape[1] > 1 else rows[row, 0].item())
        raise ValueError(f"action of {robot} by team {team!r} must be {allowed}, got {got}")


def check_remembered(memory: np.ndarray, before: tuple[Any, ...], team: str, who: Who) -> None:
    """Raise ValueError if a function changed the shape of its memory (D, P, ...), or left numbers not finite."""
    if (memory.shape, memory.dtype) != before:
        raise ValueError(f"memory of team {team!r} must stay {before[1]} of shape {before[0]}, got {memory.shape}")
    for name in memory.dtype.names or ():
        check_remembered(memory[name], (memory[name].shape, memory[name].dtype), team, who)
    if memory.dtype.kind == "f" and not np.isfinite(memory).all():
        at = np.argwhere(~np.isfinite(memory))[0]
        raise ValueError(f"memory of {who(int(at[0]), int(at[1]))} by team {team!r} must be finite")
