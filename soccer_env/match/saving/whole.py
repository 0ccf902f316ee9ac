"""Guards: steps, resets, loads and branches run in one thread at a time, and an error undoes them completely."""

from collections.abc import Iterator
from typing import Any, TypeVar

import numpy as np

from soccer_env.guards.turns import GoBack, guard_methods
from soccer_env.match.saving.saves import saved_arrays
from soccer_env.scenes import is_user_scene

Match = Any  # soccer_env.match.match.Match, which stands above this file
T = TypeVar("T")
CHANGING = ("reset", "step", "load", "_take")  # methods that change records
METHODS = (*CHANGING, "rebuild", "save", "branch")


def guard_match_methods(kind: type[T]) -> type[T]:
    """Guard the methods of the class Match: one thread at a time runs them, and an error undoes them."""
    return guard_methods(kind, METHODS, calls_python, make_undo)


def make_undo(match: Match, doing: str) -> GoBack | None:
    """Return a function that restores the present state of a match; None before the first reset.

    Physics that has moved is rebuilt as by a load; a step moves it only if a match's step or episode changes.
    """
    if match.batch.physics.spaces[0] is None:
        return None
    arrays = mutable_arrays(match) if doing in CHANGING else {"matches": match.matches}
    before = {name: array.copy() for name, array in arrays.items()}
    ended, final, recorder, started = match.ended, match.final, match.recorder, match.started
    written = recorder.length() if recorder is not None else None

    def go_back() -> None:
        record, old = arrays["matches"], before["matches"]
        moved = (record["step"] != old["step"]) | (record["episode"] != old["episode"]) | (doing != "step")
        for name, values in before.items():
            arrays[name][...] = values
        match.ended, match.final = ended, final
        if recorder is not None:
            recorder.cut(written)
        match.started = started
        if started and moved.any():
            match.rebuild(np.flatnonzero(moved).tolist())

    return go_back


def mutable_arrays(match: Match) -> dict[str, np.ndarray]:
    """Return by name the arrays of a match that a step, reset or load can change."""
    seen = dict(observation_arrays("observations", match.observations))
    return {**saved_arrays(match, True), "rewards": match.rewards, "terms": match.terms, **seen}


def observation_arrays(name: str, observations: Any) -> Iterator[tuple[str, np.ndarray]]:
    """Yield name and array for each array of the observations, which may be nested dicts of arrays."""
    if isinstance(observations, np.ndarray):
        yield name, observations
    else:
        for key, part in observations.items():
            yield from observation_arrays(f"{name} {key}", part)


def signals_wait(match: Match, doing: str) -> bool:
    """Tell whether signals such as Ctrl-C wait until a method ends: not if it calls users' code or may compile."""
    return doing in match._turn.sure


def calls_python(match: Match) -> bool:
    """Tell whether a match calls a team, an observation, a reward or a scene that is written in plain Python."""
    settings = match.settings
    own = not isinstance(settings.observe, str) or bool(settings.rewards.extra) or is_user_scene(settings.scene)
    return own or not all(squad.compiled for squad in match.squads)
