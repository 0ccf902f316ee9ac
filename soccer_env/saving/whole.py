"""Steps, resets and loads that happen whole or not at all, each in one thread at a time."""

from __future__ import annotations

from typing import Any, TypeVar

import numpy as np

from soccer_env.guards.interrupts import HeldBack
from soccer_env.guards.turns import GoBack, in_turn
from soccer_env.saving.saves import kept
from soccer_env.scenes import is_own

Match = Any  # soccer_env.match.Match, which stands above this file
T = TypeVar("T")
METHODS = ("reset", "step", "rebuild", "decide", "save", "load", "branch", "_take")


def whole(kind: type[T]) -> type[T]:
    """Let what changes a match be one thread's alone, and be undone if code of a user raises in it."""
    return in_turn(kind, METHODS, calls_python, undoing)


def undoing(match: Match, doing: str) -> GoBack | None:
    """Return what makes a match again what it is now; None where no code of a user is called, and at its first reset.

    The physics is left alone if it has not moved, else it is rebuilt as by a load.
    """
    begun = match.batch.physics.spaces[0] is not None
    if doing not in ("reset", "step", "load", "_take") or not begun:
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
